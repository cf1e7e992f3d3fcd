// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points of an image as a list: as they are, shuffled, averaged in voxels, moved.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/random.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::test {

inline std::vector<Vec3> pointsOf(const Cloud& image) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (image.valid(i)) points.push_back(image.point(i));
  }
  return points;
}

inline Cloud listOf(const std::vector<Vec3>& points, const Eigen::Isometry3d& frame_from_camera) {
  Cloud list;
  list.reset(static_cast<std::uint32_t>(points.size()), 1, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = (frame_from_camera * points[i]).cast<float>();
    list.setPoint(i, p.x(), p.y(), p.z(), {});
  }
  return list;
}

inline std::vector<Vec3> shuffled(std::vector<Vec3> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size() - 1; i > 0; --i) std::swap(points[i], points[random.below(i + 1)]);
  return points;
}

/// Means of the points in cubes, in the order of these.
inline std::vector<Vec3> averaged(const std::vector<Vec3>& points, double side) {
  struct Sum {
    long place;
    Vec3 sum;
    double count;
  };
  std::vector<Sum> sums;
  for (const Vec3& p : points) {
    const Eigen::Vector3i cube = (p / side).array().floor().cast<int>();
    sums.push_back({(cube.z() * 4096L + cube.y()) * 4096L + cube.x(), p, 1.0});
  }
  std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) { return a.place < b.place; });
  std::vector<Vec3> means;
  for (std::size_t i = 0; i < sums.size();) {
    Sum mean = sums[i];
    for (++i; i < sums.size() && sums[i].place == mean.place; ++i) mean.sum += sums[i].sum, mean.count += 1.0;
    means.push_back(mean.sum / mean.count);
  }
  return means;
}

}  // namespace primitect::test
