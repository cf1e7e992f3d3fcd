// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From primitives to sightings; see tracking.h.
#include "tracking.h"

#include <algorithm>

#include "geometry_messages.h"

namespace primitect::ros_layer {
namespace {

Sighting sightingOf(const Primitive& primitive) {
  const Body body(primitive);
  const double longest = *std::max_element(primitive.size.begin(), primitive.size.end());
  return {static_cast<Kind>(primitive.type),
          primitive.concave != 0,
          body.origin,
          body.axis,
          primitive.radius,
          0.5 * longest};
}

}  // namespace

void PrimitiveTracker::update(double patience, PrimitiveArray& message) {
  sightings_.clear();
  for (const Primitive& primitive : message.primitives) sightings_.push_back(sightingOf(primitive));
  tracker_.setPatience(patience);
  const std::vector<Track>& tracks = tracker_.update(sightings_, message.header.stamp.toSec());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    message.primitives[k].track_id = tracks[k].id;
    message.primitives[k].age = tracks[k].age;
  }
}

}  // namespace primitect::ros_layer
