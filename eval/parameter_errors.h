// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far the numbers of a detection are from those of the true shape.
#pragma once

#include <vector>

#include "primitect/primitives.h"

namespace primitect::eval {

/// One entry a pair; a measure that a kind does not have stays empty.
struct ParameterErrors {
  std::vector<double> position;        ///< m; plane: along its normal; sphere: centre; cylinder: sideways of the axis
  std::vector<double> radius;          ///< m; spheres and cylinders
  std::vector<double> axis_deg;        ///< plane normals (sign ignored) and axes (the cone's with its sign)
  std::vector<double> apex;            ///< m
  std::vector<double> half_angle_deg;  ///< cones
};

/// Adds the errors of a detection of the right kind. place (m): a point in the middle of the true shape's own points;
/// planes and cylinders have no end, so their positions are compared there.
/// Throws std::invalid_argument when the kinds differ.
void addErrors(const Shape& truth, const Shape& found, const Vec3& place, ParameterErrors& errors);

}  // namespace primitect::eval
