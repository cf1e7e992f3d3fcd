// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One cloud message after the other to primitive messages, in the wanted frame and with tracks: what the nodelet and
// detect_bag do with their clouds.
#pragma once

#include <primitect/PrimitiveArray.h>
#include <sensor_msgs/PointCloud2.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>

#include "frame_pipeline.h"
#include "marker_shapes.h"
#include "tracking.h"

namespace primitect::ros_layer {

/// target_from_source at a stamp. Throws what derives from std::exception, and says why there is none.
using TransformLookup =
    std::function<Eigen::Isometry3d(const std::string& target, const std::string& source, const ros::Time& stamp)>;

class CloudSequence {
 public:
  /// lookup is asked where sensor_frame or target_frame is another frame than the cloud's. Throws
  /// std::invalid_argument as Detector does.
  CloudSequence(const Params& params, TransformLookup lookup) : pipeline_(params), lookup_(std::move(lookup)) {}

  /// The next cloud has this stamp. Seconds by which time went back, as where a bag starts again: tracks and times have
  /// begun anew then.
  std::optional<double> begin(const ros::Time& stamp);

  /// Primitives of the cloud in target_frame, or in its own where that is empty, or none and a status that says why.
  /// with_labels: as in FramePipeline. The result is valid until the next call.
  PrimitiveArray& process(const sensor_msgs::PointCloud2& cloud, bool with_labels = false);

  /// Why the last cloud was not searched; empty: it was.
  const std::string& problem() const { return pipeline_.problem(); }

  /// Why what was found in it could not be told in the wanted frame; empty: it could.
  const std::string& frameProblem() const { return frame_problem_; }

  /// Of the last cloud, in the frame where it was searched.
  const std_msgs::Header& sensorHeader() const { return sensor_header_; }

  /// The last cloud was a list of points, of which nothing tells that a sensor at the origin of their frame saw them:
  /// nobody named one, nor is the frame called an optical one.
  bool originIsAssumed() const;

  /// Where the sensor was, in the frame of the last message.
  const Eigen::Isometry3d& sensorPose() const { return message_from_sensor_; }

  /// Of markers of the last message: as they can be read from the sensor.
  MarkerStyle markerStyle() const;

  FramePipeline& pipeline() { return pipeline_; }
  const FramePipeline& pipeline() const { return pipeline_; }

 private:
  PrimitiveArray& detect(const sensor_msgs::PointCloud2& cloud, bool with_labels);
  void toTargetFrame(const std::string& cloud_frame, PrimitiveArray& message);
  void track(PrimitiveArray& message);

  FramePipeline pipeline_;
  TransformLookup lookup_;
  PrimitiveTracker tracker_;
  ros::Time last_stamp_;
  std_msgs::Header sensor_header_;
  std::string frame_problem_;
  std::string wanted_frame_;  ///< target_frame as tf2 knows it; keeps its memory
  Eigen::Isometry3d message_from_sensor_ = Eigen::Isometry3d::Identity();
};

}  // namespace primitect::ros_layer
