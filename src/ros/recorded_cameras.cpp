// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Read once, before the images: one may be recorded after the image that has its stamp.
#include "recorded_cameras.h"

#include <rosbag/view.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "recorded_messages.h"

namespace primitect::ros_layer {
namespace {

/// But for their headers.
bool areAlike(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b) {
  const auto roi = [](const sensor_msgs::CameraInfo& camera) {
    return std::vector<std::uint32_t>{camera.roi.x_offset, camera.roi.y_offset, camera.roi.width, camera.roi.height,
                                      camera.roi.do_rectify};
  };
  return a.width == b.width && a.height == b.height && a.distortion_model == b.distortion_model && a.D == b.D &&
         a.K == b.K && a.R == b.R && a.P == b.P && a.binning_x == b.binning_x && a.binning_y == b.binning_y &&
         roi(a) == roi(b);
}

}  // namespace

RecordedCameras::RecordedCameras(const std::vector<std::unique_ptr<rosbag::Bag>>& bags, const std::string& topic) {
  rosbag::View view;
  for (const auto& bag : bags) view.addQuery(*bag, rosbag::TopicQuery(topic));
  for (const rosbag::MessageInstance& recorded : view) add(recorded);
}

void RecordedCameras::add(const rosbag::MessageInstance& recorded) {
  Entry entry = {recorded.getTime(), nullptr, nullptr};
  try {
    entry.info = messageOf<sensor_msgs::CameraInfo>(recorded);
    of_stamp_.emplace(entry.info->header.stamp, entries_.size());
    const bool known = !entries_.empty() && entries_.back().info && areAlike(*entries_.back().info, *entry.info);
    if (known) entry.info = entries_.back().info;
  } catch (const std::exception&) {
    entry.problem = std::current_exception();
  }
  entries_.push_back(entry);
}

RecordedCameras::Camera RecordedCameras::of(const ros::Time& stamp, const ros::Time& recorded) const {
  if (entries_.empty()) throw std::runtime_error("there is no camera_info");
  const auto [first, last] = of_stamp_.equal_range(stamp);
  if (first != last) {
    const auto apart = [&](const auto& entry) {
      return std::abs(entries_[entry.second].recorded.toSec() - recorded.toSec());
    };
    const auto nearest =
        std::min_element(first, last, [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
    return {entries_[nearest->second].info, true};
  }
  const auto after = std::upper_bound(entries_.begin(), entries_.end(), recorded,
                                      [](const ros::Time& time, const Entry& entry) { return time < entry.recorded; });
  const Entry& entry = after == entries_.begin() ? *after : *(after - 1);
  if (entry.problem) std::rethrow_exception(entry.problem);
  return {entry.info, false};
}

}  // namespace primitect::ros_layer
