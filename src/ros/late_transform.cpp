// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks again and again until the time is over.
#include "late_transform.h"

#include <tf2/exceptions.h>

#include <chrono>
#include <thread>

#include "steady_time.h"

namespace primitect::ros_layer {

geometry_msgs::TransformStamped lookupLateTransform(const tf2::BufferCore& transforms, const std::string& target,
                                                    const std::string& source, const ros::Time& stamp) {
  const SteadyClock::time_point begin = SteadyClock::now();
  while (true) {
    try {
      return transforms.lookupTransform(frameName(target), frameName(source), stamp);
    } catch (const tf2::TransformException&) {
      if (secondsSince(begin) >= kTransformPatienceSeconds) throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace primitect::ros_layer
