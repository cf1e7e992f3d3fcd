// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The planes that most of a cloud's points lie in: a table, a floor, a wall.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace primitect {

/// Noise of a depth camera within 2 m; of one that is noisier no plane holds enough points.
constexpr float kNearGround = 0.012f;   ///< m; points within are the plane's
constexpr float kAboveGround = 0.024f;  ///< m; points beyond stand on it

/// The plane n.p = offset (m).
struct Ground {
  Eigen::Vector3f normal;
  float offset;
  float height(const Eigen::Vector3f& point) const { return normal.dot(point) - offset; }
  bool isNear(const Eigen::Vector3f& point) const { return std::abs(height(point)) < kNearGround; }
  Ground turnedRound() const { return {-normal, -offset}; }
};

/// The one or two planes near which most of the points lie, a fifth of all at least (RANSAC, Fischler and Bolles 1981),
/// with their normals to the side on which more of the others are. The same points, the same planes.
std::vector<Ground> findGrounds(const std::vector<Eigen::Vector3f>& points);

}  // namespace primitect
