// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Does a detection know how far it is off? Normalised estimation error squared (NEES) against the true shape.
#pragma once

#include <optional>

#include "primitect/primitives.h"

namespace primitect::eval {

/// e' C^-1 e of an error e with the covariance C that the detection claims: `degrees` in the mean if that is right.
struct NormalisedError {
  double value = 0.0;
  int degrees = 0;
};

/// What is published, each against its own part of the published covariance; of an unknown covariance none. Directions
/// that the detection calls unobservable are left out. Correlations between these parts are not published, but the mean
/// of a sum does not depend on them.
///   origin  of the pose: plane: along the normal (1 degree); sphere: centre (3); cylinder: across the axis (2);
///           cone: the point of the true axis as high above its apex (3)
///   axis    turn of the normal or the axis (2)
///   pose    both together (plane 3, sphere 3, cylinder 4, cone 5)
///   radius  sphere, cylinder; cone: at the wide end of the observed part (1)
///   half_angle  cone (1)
struct NormalisedErrors {
  std::optional<NormalisedError> origin, axis, pose, radius, half_angle;

  /// Over all parameters of the kind: pose and radius, of a cone pose and half angle (plane 3, sphere 4, cylinder 5,
  /// cone 6). None when one of them is.
  std::optional<NormalisedError> total(Kind kind) const;
};

/// Variances (m^2, rad^2) from here on stand for "unobservable"; messages carry 1e6.
constexpr double kLeastUnobservable = 1e5;

/// Throws std::invalid_argument when the kinds differ.
NormalisedErrors normalisedErrors(const Shape& truth, const Detection& found);

}  // namespace primitect::eval
