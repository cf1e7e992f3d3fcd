// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The text beside a primitive in RViz: what it says and where it stands.
#pragma once

#include <primitect/Primitive.h>

#include <string>

#include "primitect/primitives.h"

namespace primitect::ros_layer {

/// Kind, size and confidence in one or two lines: "cylinder r 39 mm 97 %", "length 120 mm"; "plane 99 %",
/// "0.62 x 0.41 m"; ... Nothing stands in the place of an unknown confidence.
std::string describe(const Primitive& primitive);

/// Planes carry their text near the lower edge, where nothing stands on them; bodies on top.
/// up: unit vector of the header's frame; height: of the letters (m).
Vec3 textPosition(const Primitive& primitive, const Vec3& up, double height);

}  // namespace primitect::ros_layer
