// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What one primitive looks like in RViz: pure functions of its message.
#pragma once

#include <primitect/PrimitiveArray.h>
#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "primitect/primitives.h"

namespace primitect::ros_layer {

struct MarkerStyle {
  double alpha = 0.55;            ///< opacity of the surfaces, [0, 1]
  double lifetime = 0.5;          ///< s; 0 = for ever
  Vec3 up = -Vec3::UnitY();       ///< texts stand above in this direction of the header's frame
  Vec3 viewpoint = Vec3::Zero();  ///< the sensor (m): texts are as large as they can be read from there
};

/// Surface, outline, axis and text. Namespaces: the kind, and the kind with _outline, _axis, _text;
/// id: the track's number, or the index where it is untracked. Parts without an extent are left out.
std::vector<visualization_msgs::Marker> primitiveMarkers(const std_msgs::Header& header, const Primitive& primitive,
                                                         const MarkerStyle& style);

}  // namespace primitect::ros_layer
