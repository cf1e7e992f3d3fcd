// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Pinhole intrinsics of a depth image: given by the user, or estimated from an organized cloud.
#pragma once

#include <optional>
#include <string>

#include "primitect/cloud.h"

namespace primitect::io {

/// u = fx x / z + cx, v = fy y / z + cy, in pixels; the middle of the first pixel is (0, 0).
struct Intrinsics {
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
};

/// "fx,fy,cx,cy" as on a command line; throws std::invalid_argument naming value and range:
/// four finite numbers, the focal lengths above 0.
Intrinsics parseIntrinsics(const std::string& text);

/// Least squares of u over x / z and of v over y / z. Nothing when the cloud is not the image of a pinhole camera:
/// not organized, too few points, or more than 3 px (rms) off.
std::optional<Intrinsics> estimateIntrinsics(const Cloud& cloud);

}  // namespace primitect::io
