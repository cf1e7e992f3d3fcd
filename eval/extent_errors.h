// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far a detection's extent is from what is seen of the true shape.
#pragma once

#include <array>
#include <optional>

#include "primitect/primitives.h"

namespace primitect::eval {

/// Kinds that have no such measure leave it empty, as do outlines without an area.
struct ExtentErrors {
  /// Cylinder and cone: how far each end, at -z and at +z of the detection, lies beyond the last point seen of the true
  /// shape, along the true axis (m); negative: so much of it is missing.
  std::optional<std::array<double, 2>> beyond_ends;
  /// Plane: area that its outline and the convex outline of what is seen of the true one share, over the area of both
  /// together, in the true plane; [0, 1].
  std::optional<double> outline_overlap;
};

/// seen: the extent of what is seen of the true shape. Throws std::invalid_argument when the kinds differ.
ExtentErrors extentErrors(const Shape& truth, const Extent& seen, const Detection& found);

}  // namespace primitect::eval
