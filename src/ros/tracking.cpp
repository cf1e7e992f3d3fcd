// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From primitives to sightings; see tracking.h.
#include "tracking.h"

#include "messages.h"
#include "primitect/steady_pose.h"

namespace primitect::ros_layer {

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
    turnAsBefore(kind, tracks[k].direction_before, extents_[k]);
    writePose(extents_[k], primitive);
    tracker_.turned(k, waveringDirection(kind, extents_[k]));
  }
}

void PrimitiveTracker::update(double patience, PrimitiveArray& message) {
  forgetAnotherFrame(message);
  sightings_.clear();
  if (extents_.size() < message.primitives.size()) extents_.resize(message.primitives.size());
  for (std::size_t k = 0; k < message.primitives.size(); ++k) {
    const Primitive& primitive = message.primitives[k];
    readExtent(primitive, extents_[k]);
    sightings_.push_back(sightingOf(static_cast<Kind>(primitive.type), primitive.concave != 0, extents_[k]));
  }
  tracker_.setPatience(patience);
  const std::vector<Track>& tracks = tracker_.update(sightings_, message.header.stamp.toSec());
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    message.primitives[k].track_id = tracks[k].id;
    message.primitives[k].age = tracks[k].age;
  }
  turn(tracks, message);
}

}  // namespace primitect::ros_layer
