// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Asks again and again until the time is over, where that may help.
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

std::optional<ros::Time> LateTransforms::newest(const Frames& frames) const try {
  return transforms_.lookupTransform(frames.first, frames.second, ros::Time(0)).header.stamp;
} catch (const tf2::TransformException&) {
  return std::nullopt;
}

Eigen::Isometry3d LateTransforms::at(const Frames& frames, const ros::Time& stamp) const {
  return isometryOf(transforms_.lookupTransform(frames.first, frames.second, stamp).transform);
}

/// Not when both frames are known at a later time: then the stamp is older than what is remembered of one of them.
bool LateTransforms::mayStillCome(const Frames& frames, const ros::Time& stamp) const {
  const std::optional<ros::Time> known = newest(frames);
  if (known && *known >= stamp) return false;
  const auto last = in_vain_.find(frames);
  return last == in_vain_.end() || last->second.times < kWaitsInVain || last->second.newest != known;
}

void LateTransforms::waitedInVain(const Frames& frames) {
  const std::optional<ros::Time> known = newest(frames);
  Wait& last = in_vain_[frames];
  last.times = last.newest == known ? last.times + 1 : 1;
  last.newest = known;
}

Eigen::Isometry3d LateTransforms::lookup(const std::string& target, const std::string& source, const ros::Time& stamp) {
  const Frames frames = {frameName(target), frameName(source)};
  if (listen_) listen_();
  const bool waits = mayStillCome(frames, stamp);
  const SteadyClock::time_point begin = SteadyClock::now();
  while (true) {
    try {
      return at(frames, stamp);
    } catch (const tf2::TransformException&) {
      if (!waits) throw;
      if (secondsSince(begin) >= patience_) {
        waitedInVain(frames);
        throw;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (listen_) listen_();
  }
}

}  // namespace primitect::ros_layer
