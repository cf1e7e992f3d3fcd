// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Transforms that may arrive a little later than the clouds they belong to.
#pragma once

#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "primitect/params.h"

namespace primitect::ros_layer {

/// So often in a row, as transforms may come more seldom than clouds; what is not there then is silent.
constexpr int kWaitsInVain = 3;

/// Where the name of a frame begins as tf2 knows it: behind the slash that tf put in front of it.
inline std::size_t frameBegin(const std::string& frame) { return frame.rfind('/', 0) == 0 ? 1 : 0; }
inline std::string frameName(const std::string& frame) { return frame.substr(frameBegin(frame)); }

/// With the rotation that the quaternion means, whatever its length: not all publishers normalise theirs, and tf2 takes
/// those that are a little off. Throws std::invalid_argument where it has no direction, or where the place is no
/// number.
Eigen::Isometry3d isometryOf(const geometry_msgs::Transform& transform);

/// Of a buffer that another thread fills, or this one by listen().
class LateTransforms {
 public:
  /// The buffer must outlive this. patience (s): how long lookup() waits. listen: called before each look, if any.
  explicit LateTransforms(const tf2::BufferCore& transforms, double patience = Params().transform_patience,
                          std::function<void()> listen = nullptr)
      : transforms_(transforms), patience_(patience), listen_(std::move(listen)) {}

  void setPatience(double patience) { patience_ = patience; }

  /// target_from_source at that stamp. Waits by the steady clock, at most as long as its patience, so that a simulated
  /// time that stands still blocks nothing; and after kWaitsInVain not again until anything new is known of
  /// these two frames, so that clouds without a transform hold up neither other callbacks nor other nodelets.
  /// Throws what BufferCore::lookupTransform() throws when there is none by then, and what isometryOf() throws.
  Eigen::Isometry3d lookup(const std::string& target, const std::string& source, const ros::Time& stamp);

 private:
  using Frames = std::pair<std::string, std::string>;  ///< target, source

  /// The newest stamp that both frames are known at; empty: nothing connects them.
  std::optional<ros::Time> newest(const Frames& frames) const;
  Eigen::Isometry3d at(const Frames& frames, const ros::Time& stamp) const;
  bool mayStillCome(const Frames& frames, const ros::Time& stamp) const;

  void waitedInVain(const Frames& frames);

  struct Wait {
    std::optional<ros::Time> newest;  ///< when it was over
    int times = 0;                    ///< so many in a row, with nothing new in between
  };
  const tf2::BufferCore& transforms_;
  double patience_;  ///< s
  std::function<void()> listen_;
  std::map<Frames, Wait> in_vain_;
};

}  // namespace primitect::ros_layer
