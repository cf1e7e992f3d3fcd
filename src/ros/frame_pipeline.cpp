// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Read, detect, write: each once a frame.
#include "frame_pipeline.h"

#include "cloud_reader.h"
#include "messages.h"
#include "output_clouds.h"

namespace primitect::ros_layer {

FramePipeline::FramePipeline(const Params& params) : detector_(makeDetector(params)) {}

Detector FramePipeline::makeDetector(const Params& params) {
  Detector detector(params);
  detector.onStageDone([this](const char* stage) { times_.stageDone(stage); });
  return detector;
}

void FramePipeline::setParams(const Params& params) { detector_ = makeDetector(params); }

PrimitiveArray FramePipeline::process(const sensor_msgs::PointCloud2& message) {
  const DepthRange range{static_cast<float>(params().min_depth), static_cast<float>(params().max_depth)};
  error_ = readCloud(message, range, params().use_cloud_normals, cloud_);
  times_.stageDone("read");
  if (error_.empty()) {
    detections_ = detector_.detect(cloud_);
  } else {
    detections_ = Detections();
    detections_.status = Status::rejected_input;
  }
  return toMessage(detections_, message.header);
}

sensor_msgs::PointCloud2 FramePipeline::labels(const std_msgs::Header& header) {
  detector_.label(cloud_, labels_);
  return labelCloud(header, cloud_, labels_, detections_);
}

sensor_msgs::PointCloud2 FramePipeline::normals(const std_msgs::Header& header) const {
  return normalCloud(header, detector_.samples());
}

}  // namespace primitect::ros_layer
