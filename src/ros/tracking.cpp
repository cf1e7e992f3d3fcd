// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From primitives to sightings; see tracking.h.
#include "tracking.h"

#include <algorithm>

#include "geometry_messages.h"
#include "messages.h"
#include "primitect/steady_pose.h"

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

}  // namespace

/// One without any may be in the cloud's frame as the wanted one was not reached.
void PrimitiveTracker::forgetAnotherFrame(const PrimitiveArray& message) {
  if (message.primitives.empty() || message.header.frame_id == frame_) return;
  frame_ = message.header.frame_id;
  tracker_.forget();
}

/// What is told in the frame of the message, outline and covariance, stays as it is. (The middle of another rectangle
/// around a round lid lies some millimetres aside: what a tilt moves it by along the normal is little beside its
/// noise.)
void PrimitiveTracker::turn(const std::vector<Track>& tracks, PrimitiveArray& message) {
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    if (tracks[k].direction_before.isZero()) continue;
    Primitive& primitive = message.primitives[k];
    const Kind kind = static_cast<Kind>(primitive.type);
    readExtent(primitive, extent_);
    turnAsBefore(kind, tracks[k].direction_before, extent_);
    writePose(extent_, primitive);
    tracker_.turned(k, waveringDirection(kind, extent_));
  }
}

void PrimitiveTracker::update(double patience, PrimitiveArray& message) {
  forgetAnotherFrame(message);
  sightings_.clear();
  for (const Primitive& primitive : message.primitives) sightings_.push_back(sightingOf(primitive));
  tracker_.setPatience(patience);
  const std::vector<Track>& tracks = tracker_.update(sightings_, message.header.stamp.toSec());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    message.primitives[k].track_id = tracks[k].id;
    message.primitives[k].age = tracks[k].age;
  }
  turn(tracks, message);
}

}  // namespace primitect::ros_layer
