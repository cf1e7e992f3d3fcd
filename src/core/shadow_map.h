// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether shadows that fall on a plane are the holes that it has.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/ground.h"

namespace primitect {

/// The plane in cells of which each is seen, or not though others around it are; and what stands on it. In the frame of
/// the plane, z up.
class ShadowMap {
 public:
  /// Of the points that stand on the plane, so many are kept.
  static constexpr std::size_t kMostStanding = 16384;

  ShadowMap(const Ground& ground, const std::vector<Eigen::Vector3f>& points);

  bool isWorthASearch() const {
    constexpr int kFewestHoles = 50;
    constexpr std::size_t kFewestStanding = 100;
    return holes_ >= kFewestHoles && standing_.size() >= kFewestStanding;
  }

  /// What is wrong with a lamp there: holes that are lit, and cells in the shadow that are seen, over the holes. Of
  /// about so many of the points that stand.
  float misfit(const Eigen::Vector3f& lamp, std::size_t point_count);

  /// Of a place from the middle of the ground.
  float distance(const Eigen::Vector3f& place) const { return (place - middle_of_ground_).norm(); }
  Eigen::Vector3f middleOfGround() const { return middle_of_ground_; }
  Eigen::Vector3f middleOfStanding() const { return middle_of_standing_; }
  Eigen::Vector3f inFrameOfGround(const Eigen::Vector3f& point) const {
    return axes_ * point - Eigen::Vector3f(0.0f, 0.0f, offset_);
  }
  Eigen::Vector3f inFrameOfCloud(const Eigen::Vector3f& point) const {
    return axes_.transpose() * (point + Eigen::Vector3f(0.0f, 0.0f, offset_));
  }

 private:
  /// The lower two bits of a cell; above them the number of the lamp whose shadow fell there last.
  enum State : std::uint32_t { kOutside = 0, kSeen = 1, kHole = 2, kEither = 3 };
  static constexpr std::uint32_t kStateBits = 2, kStates = (1u << kStateBits) - 1;
  /// Over what is seen of the plane, not a wall behind it, whose shadow nobody sees.
  bool isOver(const Eigen::Vector3f& point) const {
    const float u = (point.x() - left_) * per_cell_, v = (point.y() - bottom_) * per_cell_;
    return u >= 0.0f && v >= 0.0f && u < static_cast<float>(columns_) && v < static_cast<float>(rows_) &&
           cells_[at(static_cast<int>(u), static_cast<int>(v))] != kOutside;
  }
  void keepSome(const std::vector<Eigen::Vector3f>& above);
  void draw(const std::vector<Eigen::Vector3f>& near);
  void findHoles(const std::vector<std::uint8_t>& seen);
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  Eigen::Matrix3f axes_;  // rows: x and y along the plane, z up
  float offset_;
  std::vector<Eigen::Vector3f> standing_;
  Eigen::Vector3f middle_of_ground_ = Eigen::Vector3f::Zero(), middle_of_standing_ = Eigen::Vector3f::Zero();
  float left_ = 0.0f, bottom_ = 0.0f, per_cell_ = 0.0f;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cells_;
  std::uint32_t lamp_ = 0;
  int holes_ = 0;
};

}  // namespace primitect
