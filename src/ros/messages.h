// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Detections to messages and back: pure functions.
#pragma once

#include <primitect/PrimitiveArray.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "primitect/primitives.h"

namespace primitect::ros_layer {

/// One detection; id is its index in the array.
Primitive toMessage(const Detection& detection, std::uint32_t id);

/// All detections of one cloud under its header (stamp and frame).
/// processing_time (s) is left 0: whoever calls this knows when the work began.
PrimitiveArray toMessage(const Detections& detections, const std_msgs::Header& header);

/// The same for frame after frame in the same memory, outlines included.
class MessageWriter {
 public:
  /// Valid until the next.
  PrimitiveArray& write(const Detections& detections, const std_msgs::Header& header);

 private:
  PrimitiveArray message_;
  std::vector<Primitive> spare_;  ///< of messages that had more
};

/// The detections of a message, in the float precision of its fields; scene_diameter is not in the message: 0.
/// Throws std::invalid_argument naming the number of an unknown type.
Detections fromMessage(const PrimitiveArray& message);

/// Pose, sizes and outline of a primitive; keeps the memory of extent.hull.
void readExtent(const Primitive& message, Extent& extent);

/// Where the body of a primitive is, how long, and what is at its ends; pose without covariance.
void writePose(const Extent& extent, Primitive& message);

/// Moves poses, apexes, outlines and covariances to another frame; the header's frame_id is the caller's business.
void transformPrimitives(const Eigen::Isometry3d& target_from_source, PrimitiveArray& message);

}  // namespace primitect::ros_layer
