// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Detecting in a recording without a ROS master: what to do, and what comes of each cloud. No ROS header is needed to
// call it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/point_raster.h"
#include "io/report.h"
#include "primitect/params.h"

namespace primitect::ros_layer {

struct BagJob {
  std::vector<std::string> bags;  ///< the parts of one recording
  std::string topic;              ///< of clouds or depth images; empty: the only one that there is
  std::string camera_info;        ///< of depth images; empty: the topic beside theirs
  double start = 0.0;             ///< s after the beginning of the recording
  double duration = 0.0;          ///< s; 0: to its end
  std::string output;             ///< a bag that gets primitives and markers; empty: none
  Params params;
};

/// Of a whole job.
struct BagOutcome {
  std::string topic;                    ///< that was read
  std::size_t unusable_transforms = 0;  ///< that could not be read, or are none
  /// Depth images without a camera_info of their stamp: nodes, which pair them by that, hear none of them.
  std::size_t unpaired_images = 0;
};

/// What the sensor saw in a frame that was searched, and what was found there, in the sensor's frame.
using ShowPoints = std::function<void(const io::FrameReport&, const io::LabelledPoints&)>;

/// Calls use with each frame, in the order of recording, and show after it, where one is given. The same as the nodelet
/// makes of the same clouds and parameters, if it misses none; but transforms are known from the beginning. Throws
/// std::runtime_error naming bag and cause, std::invalid_argument as Detector does, and what these throw; then there is
/// no output.
BagOutcome detectInBags(const BagJob& job, const std::function<void(const io::FrameReport&)>& use,
                        const ShowPoints& show = nullptr);

}  // namespace primitect::ros_layer
