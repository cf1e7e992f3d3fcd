// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The points that were seen of one shape, as the loops over many points take them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/flat.h"
#include "core/frame_memory.h"
#include "kernels/loops.h"
#include "primitect/primitives.h"

namespace primitect {

/// The next multiple of the lanes that loops work in.
constexpr std::size_t wholeLanes(std::size_t count) {
  return (count + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes;
}

/// In float around one of them, so that no digits are lost.
struct SeenPoints {
  Vec3 origin = Vec3::Zero();
  List<float> x, y, z;  ///< m, from the origin

  SeenPoints() = default;
  /// Not explicit: a list of points is one of those that were seen.
  SeenPoints(const std::vector<Vec3>& points);

  /// Those of a cloud, or of samples, with these indices.
  template <class Source>
  void gather(const Source& source, const List<std::uint32_t>& index) {
    for (List<float>* values : {&x, &y, &z}) values->resize(index.size());
    if (index.empty()) return;
    const std::uint32_t middle = index[index.size() / 2];
    const float from[3] = {source.x[middle], source.y[middle], source.z[middle]};
    origin = Vec3(from[0], from[1], from[2]);
    for (std::size_t k = 0; k < index.size(); ++k) {
      const std::uint32_t i = index[k];
      x[k] = source.x[i] - from[0], y[k] = source.y[i] - from[1], z[k] = source.z[i] - from[2];
    }
  }

  /// Of all points those number k for which is_kept(k) is true, in their order. It is asked in between: it must not look
  /// at these points.
  template <class IsKept>
  void keep(const IsKept& is_kept) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < size(); ++k) {
      x[kept] = x[k], y[kept] = y[k], z[kept] = z[k];
      kept += is_kept(k) ? 1 : 0;
    }
    for (List<float>* values : {&x, &y, &z}) values->resize(kept);
  }

  std::size_t size() const { return x.size(); }
  bool empty() const { return x.empty(); }
  Vec3 point(std::size_t i) const { return origin + Vec3(x[i], y[i], z[i]); }
};

/// Where points lie along an axis (m, from what they are from).
inline void heightsAlong(const Vec3& axis, const float* x, const float* y, const float* z, std::size_t count,
                         float* heights) {
  const Eigen::Vector3f along = axis.cast<float>();
  for (std::size_t k = 0; k < count; ++k) heights[k] = along.x() * x[k] + along.y() * y[k] + along.z() * z[k];
}

/// Some of them, at most `wanted`, evenly taken: for what is a mean over all. Filled up to whole lanes with copies of
/// the last.
template <std::size_t most>
struct SomePoints {
  static constexpr std::size_t kRoom = wholeLanes(most);

  Vec3 origin;
  std::size_t count;  ///< without what fills up
  double share;       ///< of all points
  float x[kRoom], y[kRoom], z[kRoom];

  explicit SomePoints(const SeenPoints& all, std::size_t wanted = most)
      : origin(all.origin),
        count(std::min({all.size(), wanted, most})),
        share(count > 0 ? static_cast<double>(count) / static_cast<double>(all.size()) : 1.0) {
    if (count == 0) return;
    // Number k is at k * all.size() / count, without a division for each.
    const std::size_t step = all.size() / count, rest = all.size() % count;
    for (std::size_t k = 0, i = 0, part = 0; k < filled(); ++k) {
      x[k] = all.x[i], y[k] = all.y[i], z[k] = all.z[i];
      if (k + 1 >= count) continue;
      i += step, part += rest;
      if (part >= count) part -= count, ++i;
    }
  }
  /// With what fills up.
  std::size_t filled() const { return wholeLanes(count); }
  Vec3 point(std::size_t k) const { return origin + Vec3(x[k], y[k], z[k]); }
  Vec3 mean() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < count; ++k) sum += Vec3(x[k], y[k], z[k]);
    return origin + sum / static_cast<double>(count);
  }
};

/// Distances to a shape and its outward normals at so many points.
template <std::size_t room>
struct Feet {
  float distance[room], nx[room], ny[room], nz[room];

  Feet(const Shape& shape, const Vec3& origin, const float* x, const float* y, const float* z, std::size_t count) {
    kernels::loops().feet(flattened(shape, origin), x, y, z, count, {distance, nx, ny, nz});
  }
  template <std::size_t most>
  Feet(const Shape& shape, const SomePoints<most>& points)
      : Feet(shape, points.origin, points.x, points.y, points.z, points.filled()) {}
};

/// Root mean square of the distances (m); of at least one point.
float rmsDistance(const Shape& shape, const SeenPoints& points);

}  // namespace primitect
