// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks again and again until the time is over.
#include "late_transform.h"

#include <tf2/exceptions.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "steady_time.h"

namespace primitect::ros_layer {

Eigen::Isometry3d isometryOf(const geometry_msgs::Transform& transform) {
  constexpr double kShortest = 1e-6;  // what is left of a direction below is rounding
  const geometry_msgs::Vector3& p = transform.translation;
  const geometry_msgs::Quaternion& q = transform.rotation;
  const Eigen::Translation3d place(p.x, p.y, p.z);
  const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
  std::ostringstream problem;
  if (!place.translation().allFinite()) {
    problem << "its translation is (" << p.x << ", " << p.y << ", " << p.z << "), expected are finite numbers";
  } else if (const double length = turn.norm(); !(kShortest < length && std::isfinite(length))) {
    problem << "its rotation is (" << q.x << ", " << q.y << ", " << q.z << ", " << q.w
            << "), expected is a quaternion of length 1";
  } else {
    return place * turn.normalized();
  }
  throw std::invalid_argument(problem.str());
}

Eigen::Isometry3d lookupLateTransform(const tf2::BufferCore& transforms, const std::string& target,
                                      const std::string& source, const ros::Time& stamp) {
  const SteadyClock::time_point begin = SteadyClock::now();
  while (true) {
    try {
      return isometryOf(transforms.lookupTransform(frameName(target), frameName(source), stamp).transform);
    } catch (const tf2::TransformException&) {
      if (secondsSince(begin) >= kTransformPatienceSeconds) throw;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace primitect::ros_layer
