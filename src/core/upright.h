// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cups: from one side, a cone that stands on a face and a cylinder that leans on it look nearly alike.
#pragma once

#include <optional>

#include "core/competition.h"
#include "core/fit_points.h"
#include "primitect/primitives.h"

namespace primitect {

/// How far (rad) what stands on a face is off upright, with all that a depth camera bends: 1 deg. Measured: of 23 cans,
/// jars and tubes of recorded frames, which all stand, the fits lean by .4 to 3.6 deg, half of them by less than 1.6.
constexpr double kUprightDeviation = 0.0175;

/// Whether what hardly leans is asked about, too.
enum class Leaning { any, clear };

/// The cylinder or cone about the normal of the face that a leaning one stands on, or has for its top, where it
/// explains the points nearly as well: half of a cup of 7 deg, seen from above, is within the noise of a cylinder that
/// leans by 8 deg, and cups are more common than cylinders that lean. Nothing where it is clearly worse, and with
/// Leaning::clear for what leans by no more than the noise makes it.
std::optional<Shape> uprightShape(const Shape& found, const Vec3& face_normal, Leaning leaning, const FitPoints& points,
                                  const Limits& limits);

}  // namespace primitect
