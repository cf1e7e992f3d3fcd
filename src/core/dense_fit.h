// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The final fit: on the points of the cloud themselves, of which the samples are a small part.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/competition.h"
#include "core/covariance.h"
#include "core/fit_points.h"
#include "core/frame_memory.h"
#include "core/label_runs.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Points of one label.
struct LabelledPoints {
  List<std::uint32_t> index;  ///< in the cloud, rising: those that are wanted
  /// The outermost in each row of an image: all that its outline needs. Of a few pixels in a row none is.
  List<std::uint32_t> row_ends;
  std::size_t all = 0;  ///< how many carry the label, or how many points of the whole cloud these stand for
};

/// At most so many of a label, one at random of every so many; in images also the up to four outermost of all, where
/// these are wanted.
struct WantedPoints {
  std::size_t most;
  bool outermost = false;
};

/// Points of the labels 1, 2, ..., as wanted of each; other labels are none. width: of the image, 0 for a list, which
/// has no rows.
void pointsOfLabels(const List<LabelRun>& runs, std::uint32_t width, const List<WantedPoints>& wanted,
                    List<LabelledPoints>& points);

/// Which way points err.
enum class PointErrors {
  across,     ///< the surface
  along_rays  ///< of a depth camera at the origin, see along_rays.h
};

/// refine() (fitting.h) on many points: some of them show the way, and all of them take the last steps. Along
/// the rays a cone takes these from narrower. hold_axis: see RefineRules.
std::optional<Shape> refineDense(const Shape& start, const FitPoints& points, PointErrors errors = PointErrors::across,
                                 bool hold_axis = false);

/// What points make of a shape.
struct PointsChoice {
  Shape shape;
  /// It is a cylinder, and a cone explains them nearly as well, or better but is sharper than the limits.
  bool or_cone = false;
  /// It is a cylinder, and a cone of 4 deg or more within the limits explains them nearly as well: which of the two
  /// it is nobody can tell.
  bool either = false;
  /// Finite: its axis is the normal of a face (upright.h), as well as that is known, and stays.
  HeldAxis axis = {};

  bool upright() const { return std::isfinite(axis.by_noise); }
};

/// The shape fitted to its points, whose noise is known; the old one when that fails or breaks the limits. On many
/// points a cylinder and a cone that tapers little can be told apart: both are tried for either, and a ball for both.
PointsChoice refineOnPoints(const Shape& shape, const FitPoints& points, const Limits& limits);

/// The cylinder that a cylinder is, or that touches a cone along the line that its points lie around. middle: of the
/// points (m). Nothing of other kinds.
std::optional<Cylinder> asCylinder(const Shape& shape, const Vec3& middle);

}  // namespace primitect
