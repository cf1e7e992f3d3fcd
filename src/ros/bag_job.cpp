// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The clouds of a recording through a CloudSequence, as the nodelet does it with those of a topic.
#include "bag_job.h"

#include <optional>

#include "bag_clouds.h"
#include "bag_transforms.h"
#include "cloud_sequence.h"
#include "markers.h"
#include "messages.h"
#include "result_bag.h"

namespace primitect::ros_layer {
namespace {

/// For a cloud that the bag does not give.
PrimitiveArray unreadable(const RecordedCloud& cloud) {
  PrimitiveArray message;
  message.header = cloud.header.value_or(std_msgs::Header());
  message.status = PrimitiveArray::REJECTED_INPUT;
  message.seen_from_origin = true;
  message.depth_waves = -1.0f;
  return message;
}

/// In the frame of the last cloud, where its points told that it is elsewhere.
std::optional<io::SensorPose> foundSensor(const FramePipeline& pipeline) {
  if (!pipeline.foundCamera()) return std::nullopt;
  return io::SensorPose::of(*pipeline.foundCamera());
}

}  // namespace

BagOutcome detectInBags(const BagJob& job, const std::function<void(const io::FrameReport&)>& use,
                        const ShowPoints& show) {
  const BagClouds clouds(job);
  std::optional<BagTransforms> transforms;
  if (!job.params.sensor_frame.empty() || !job.params.target_frame.empty()) transforms.emplace(clouds.bags());
  CloudSequence sequence(job.params,
                         [&transforms](const std::string& target, const std::string& source, const ros::Time& stamp) {
                           return transforms->lookup(target, source, stamp);
                         });
  MarkerWriter markers;
  std::optional<ResultBag> output;
  if (!job.output.empty()) output.emplace(job.output);
  std::optional<ros::Time> first;
  std::size_t unpaired_images = 0;
  clouds.forEach([&](const RecordedCloud& recorded) {
    if (recorded.header && sequence.begin(recorded.header->stamp)) markers.startAnew();
    const PrimitiveArray message =
        recorded.cloud ? sequence.process(*recorded.cloud, bool{show}) : unreadable(recorded);
    if (output) output->write(recorded.recorded, message, markers.update(message, sequence.markerStyle()));
    if (recorded.cloud) sequence.pipeline().published();
    if (!first) first = recorded.recorded;
    unpaired_images += recorded.camera_of_other_stamp ? 1 : 0;
    const std::string& refused = recorded.cloud ? sequence.problem() : recorded.problem;
    Detections detections = fromMessage(message);
    if (recorded.cloud) detections.refusals = sequence.pipeline().refusals();
    const io::FrameReport report = {recorded.recorded.toSec() - first->toSec(),
                                    message.header.stamp.sec,
                                    message.header.stamp.nsec,
                                    message.header.frame_id,
                                    detections,
                                    refused.empty() ? sequence.frameProblem() : refused,
                                    recorded.damaged,
                                    1000.0 * message.processing_time,
                                    recorded.cloud ? sequence.pipeline().shareBeyond() : 0.0,
                                    recorded.cloud && sequence.originIsAssumed(),
                                    recorded.cloud ? foundSensor(sequence.pipeline()) : std::nullopt};
    use(report);
    if (!show || message.status != PrimitiveArray::OK) return;
    FramePipeline& pipeline = sequence.pipeline();
    const Cloud seen = pipeline.seen(*recorded.cloud);
    show(report, {seen, depthRangeOf(job.params), pipeline.pointLabels(), pipeline.detections()});
  });
  if (output) output->finish();
  return {clouds.topic(), transforms ? transforms->unusable() : 0, unpaired_images};
}

}  // namespace primitect::ros_layer
