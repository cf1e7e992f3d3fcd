// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The cloud as every stage reads it: structure of arrays, converted once from a message or a file.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "primitect/depth_range.h"

namespace primitect {

/// Points of one frame, in metres. A missing point is NaN in x, y and z, with the sign bit of z where it lay beyond the
/// far bound of the depth range; a missing normal is NaN in nx, ny and nz.
struct Cloud {
  std::vector<float> x, y, z;     ///< width * height points, row by row
  std::vector<float> nx, ny, nz;  ///< unit normals as long as x, or empty when the source brought none
  std::uint32_t width = 0;
  std::uint32_t height = 0;  ///< where both are above 1: organized, a pixel's neighbours are its neighbours in space
  std::uint32_t valid_count = 0;   ///< points that are not missing; who writes x, y and z keeps it (countPoints)
  std::uint32_t behind_count = 0;  ///< of these, points with z <= 0, where no depth camera measures
  std::uint32_t step = 1;          ///< of what was an image every so many-th column and row is here (image_step.h)

  std::size_t size() const { return x.size(); }
  bool organized() const { return width > 1 && height > 1; }
  bool hasNormals() const { return !nx.empty() && nx.size() == x.size(); }
  /// Its lists are as long as its sides say, and of normals there are as many as of points; who fills them sees to it.
  bool isConsistent() const {
    const auto fits = [this](const std::vector<float>& values) { return values.size() == x.size(); };
    const bool no_normals = nx.empty() && ny.empty() && nz.empty();
    return x.size() == static_cast<std::size_t>(width) * height && fits(y) && fits(z) &&
           (no_normals || (fits(nx) && fits(ny) && fits(nz)));
  }
  void dropNormals() {
    for (auto* values : {&nx, &ny, &nz}) values->clear();
  }
  Eigen::Vector3d point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  /// Of clouds that have normals.
  Eigen::Vector3d normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
  bool valid(std::size_t i) const { return !std::isnan(z[i]); }
  /// Something was measured there, or nothing up to there (+inf, REP 117), but beyond the far bound: nothing is nearer.
  bool isBeyond(std::size_t i) const { return !valid(i) && std::signbit(z[i]); }

  /// More than strays lie where a sensor at the origin that looks along z measures nothing: the cloud is in the frame
  /// of something else.
  bool liesBehind() const {
    constexpr double kStrays = 0.01;  // of the points
    return behind_count > kStrays * valid_count;
  }

  /// Makes room for width * height points, all missing; keeps the memory of earlier frames.
  void reset(std::uint32_t new_width, std::uint32_t new_height, bool with_normals);

  /// The same without making them missing: every point must be set or checked, and with normals every normal set.
  void prepare(std::uint32_t new_width, std::uint32_t new_height, bool with_normals);

  /// Sets both counts from the points, for those who wrote x, y and z themselves: with a z of +NaN where nothing is
  /// known.
  void countPoints();

  /// Farther than this (m) in x, y or z is no measurement: squares would leave the range of float.
  static constexpr float kFarthest = 1e6f;

  /// Stores a point; (0, 0, 0), anything not finite or beyond kFarthest, and depths outside the range become missing.
  void setPoint(std::size_t i, float px, float py, float pz, const DepthRange& range) {
    const bool measured = std::fabs(px) <= kFarthest && std::fabs(py) <= kFarthest && std::fabs(pz) <= kFarthest &&
                          !(px == 0.0f && py == 0.0f && pz == 0.0f) && range.contains(pz);
    constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
    x[i] = measured ? px : kMissing;
    y[i] = measured ? py : kMissing;
    z[i] = measured ? pz : range.max > 0.0f && pz > range.max ? -kMissing : kMissing;
    valid_count += measured ? 1u : 0u;
    behind_count += measured && pz <= 0.0f ? 1u : 0u;
  }

  /// Points [begin, end) were written to x, y and z as they came: those that setPoint() would make missing become so.
  void checkPoints(std::size_t begin, std::size_t end, const DepthRange& range);

  /// Stores `count` points from index `begin` on, as setPoint() would: floats x, y, z that follow each other in memory,
  /// `step` bytes from one point to the next, the first at `first`; they need not be aligned.
  void setPoints(std::size_t begin, std::size_t count, const std::uint8_t* first, std::size_t step,
                 const DepthRange& range);

  /// One place that some hundredths of the points share exactly is what a driver fills in where nothing was measured:
  /// these points become missing, unless they are all. Clouds of fewer than 256 points stay as they are.
  void dropFilledIn();

  /// Into another frame. Points that setPoint() would make missing there become so.
  void move(const Eigen::Isometry3d& target_from_source, const DepthRange& range);

  /// Stores a normal, scaled to unit length; one that is not finite or shorter than 1e-6 becomes missing.
  void setNormal(std::size_t i, float px, float py, float pz);
};

}  // namespace primitect
