// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The plane that most of a cloud's points lie in: a table, a floor.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace primitect {

constexpr float kNearGround = 0.012f;   ///< m; points within are the plane's
constexpr float kAboveGround = 0.024f;  ///< m; points beyond stand on it

/// The plane n.p = offset (m).
struct Ground {
  Eigen::Vector3f normal;
  float offset;
  float height(const Eigen::Vector3f& point) const { return normal.dot(point) - offset; }
  Ground turnedRound() const { return {-normal, -offset}; }
};

/// The plane near which most of the points lie (RANSAC, Fischler and Bolles 1981), with its normal to the side on which
/// more of the others are. Nothing where it would be fewer than a third of the points, or there are none. The same
/// points, the same plane.
std::optional<Ground> findGround(const std::vector<Eigen::Vector3f>& points);

}  // namespace primitect
