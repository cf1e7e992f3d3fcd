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
          0.5 * longest,
          primitive.type == Primitive::PLANE ? Vec3(body.rotation.col(0)) : Vec3::Zero()};
}

/// What is told in the frame of the message, outline and covariance, stays as it is.
void turnRound(Primitive& primitive) {
  const Body body(primitive);
  const Eigen::Quaterniond turn = halfTurn(static_cast<Kind>(primitive.type));
  primitive.pose.pose.orientation = quaternionMessage(body.rotation * turn.toRotationMatrix());
}

}  // namespace

void PrimitiveTracker::update(double patience, PrimitiveArray& message) {
  sightings_.clear();
  for (const Primitive& primitive : message.primitives) sightings_.push_back(sightingOf(primitive));
  tracker_.setPatience(patience);
  const std::vector<Track>& tracks = tracker_.update(sightings_, message.header.stamp.toSec());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    Primitive& primitive = message.primitives[k];
    primitive.track_id = tracks[k].id;
    primitive.age = tracks[k].age;
    if (tracks[k].reversed) turnRound(primitive);
  }
}

}  // namespace primitect::ros_layer
