// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames and tracks around a FramePipeline.
#include "cloud_sequence.h"

#include "late_transform.h"
#include "messages.h"

namespace primitect::ros_layer {

std::optional<double> CloudSequence::begin(const ros::Time& stamp) {
  // Clouds of one sensor may arrive a little out of order; a bag that starts again jumps farther.
  constexpr double kTimeJumpSeconds = 0.1;
  // Not (last_stamp_ - stamp): a ros::Duration has 32 bits and throws beyond 68 years.
  const double backwards = last_stamp_.toSec() - stamp.toSec();
  last_stamp_ = stamp;
  if (backwards <= kTimeJumpSeconds) return std::nullopt;
  tracker_.startAnew();
  pipeline_.startAnew();
  return backwards;
}

PrimitiveArray& CloudSequence::process(const sensor_msgs::PointCloud2& cloud, bool with_labels) {
  pipeline_.times().begin();
  PrimitiveArray& message = detect(cloud, with_labels);
  toTargetFrame(cloud.header.frame_id, message);
  track(message);
  pipeline_.times().stageDone("message");
  message.processing_time = static_cast<float>(pipeline_.times().end());
  return message;
}

bool CloudSequence::originIsAssumed() const {
  const bool named =
      !pipeline_.params().sensor_frame.empty() || sensor_header_.frame_id.find("optical") != std::string::npos;
  return !named && pipeline_.isListFromOrigin();
}

MarkerStyle CloudSequence::markerStyle() const {
  const Params& params = pipeline_.params();
  return {params.marker_alpha, params.marker_lifetime, message_from_sensor_.linear() * -Vec3::UnitY(),
          message_from_sensor_.translation()};
}

/// Primitives in sensor_frame, or none and why that is not possible.
PrimitiveArray& CloudSequence::detect(const sensor_msgs::PointCloud2& cloud, bool with_labels) {
  const std::string sensor = frameName(pipeline_.params().sensor_frame);
  const std::string& source = cloud.header.frame_id;
  sensor_header_ = cloud.header;
  if (sensor.empty()) return pipeline_.process(cloud, with_labels);
  if (sensor == frameName(source)) return pipeline_.process(cloud, with_labels, std::nullopt, CameraPlace::said);
  sensor_header_.frame_id = sensor;
  Eigen::Isometry3d sensor_from_cloud;
  try {
    sensor_from_cloud = lookup_(sensor, source, cloud.header.stamp);
  } catch (const std::exception& error) {  // tf2 has its own, ros::Duration another
    const std::string from_to = "from '" + source + "' to sensor_frame '" + sensor + "'";
    return pipeline_.withoutTransform(cloud, "no transform " + from_to + ": " + error.what());
  }
  PrimitiveArray& message = pipeline_.process(cloud, with_labels, sensor_from_cloud);
  message.header.frame_id = sensor;
  return message;
}

/// From the sensor's frame. A message without search stays in the cloud's: whether another can be reached was not
/// asked.
void CloudSequence::toTargetFrame(const std::string& cloud_frame, PrimitiveArray& message) {
  frame_problem_.clear();
  // tf2 refuses frames with a slash before them.
  const std::string& said = pipeline_.params().target_frame;
  wanted_frame_.assign(said, frameBegin(said), std::string::npos);
  const std::string& target = wanted_frame_.empty() ? cloud_frame : wanted_frame_;
  const std::string& source = message.header.frame_id;
  Eigen::Isometry3d target_from_source = Eigen::Isometry3d::Identity();
  const bool something_to_move = message.status == PrimitiveArray::OK;
  if (something_to_move && frameName(target) != frameName(source)) {
    try {
      target_from_source = lookup_(target, source, message.header.stamp);
    } catch (const std::exception& error) {  // tf2 has its own, ros::Duration another
      const std::string name = wanted_frame_.empty() ? "the cloud's frame '" : "target_frame '";
      frame_problem_ = "no transform from '" + source + "' to " + name + target + "': " + error.what();
      message.primitives.clear();
      message.status = PrimitiveArray::NO_TRANSFORM;
    }
    transformPrimitives(target_from_source, message);
  }
  message.header.frame_id = message.status == PrimitiveArray::OK ? target : cloud_frame;
  message_from_sensor_ = target_from_source * pipeline_.foundCamera().value_or(Eigen::Isometry3d::Identity());
}

void CloudSequence::track(PrimitiveArray& message) {
  if (!pipeline_.params().track) return tracker_.startAnew();
  tracker_.update(pipeline_.params().track_patience, message);
}

}  // namespace primitect::ros_layer
