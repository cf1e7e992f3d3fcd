// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The text beside a primitive in RViz: what it says and where it stands.
#pragma once

#include <primitect/Primitive.h>

#include <cstddef>
#include <string>

#include "primitect/primitives.h"

namespace primitect::ros_layer {

/// Kind and size in one line: "cylinder r 39 mm, 120 mm", "cone 22 deg, 100 mm", "plane 1.40 x 0.82 m"; and a
/// confidence below 90 %: "sphere r 39 mm 73 %".
std::string describe(const Primitive& primitive);

/// How a text is seen, in the header's frame: a unit vector upwards, where the sensor is, how high its letters are (m)
/// and how many there are.
struct TextView {
  Vec3 up, viewpoint;
  double height;
  std::size_t letters;
};

/// Planes carry their text near the lower edge, where nothing stands on them. Those that are narrower than it and turn
/// to a side, as the faces of a box, have it on that side, beside the text of the next face. Bodies have it on top.
Vec3 textPosition(const Primitive& primitive, const TextView& view);

}  // namespace primitect::ros_layer
