// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labelled points against the view; see far_sides.h.
#include "core/far_sides.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/flat.h"
#include "core/observed_part.h"
#include "core/point_noise.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

constexpr std::size_t kPointsAtOnce = 256;

/// Places of some points of the cloud.
struct PlacesOfPoints {
  std::size_t count = 0;
  std::uint32_t index[kPointsAtOnce];
  float x[kPointsAtOnce], y[kPointsAtOnce], z[kPointsAtOnce];

  void add(const Cloud& cloud, std::uint32_t i) {
    index[count] = i, x[count] = cloud.x[i], y[count] = cloud.y[i], z[count] = cloud.z[i];
    ++count;
  }

  /// Keeps those of which `left` says so, of each by its place here.
  template <class Left>
  void keep(const Left& left) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (!left(k)) continue;
      index[kept] = index[k], x[kept] = x[k], y[kept] = y[k], z[kept] = z[k];
      ++kept;
    }
    count = kept;
  }
};

/// A curved detection, and the side from which it was seen.
struct Wall {
  kernels::FlatShape shape;
  bool concave;

  Wall(const Shape& of, bool seen_from_inside) : shape(flattened(of, Vec3::Zero())), concave(seen_from_inside) {}

  /// Marks the points where the camera cannot see this side by 1, the others by 0; returns whether there are any.
  bool findHidden(const float* x, const float* y, const float* z, std::size_t count, std::uint32_t* hidden) const {
    float distance[kPointsAtOnce], nx[kPointsAtOnce], ny[kPointsAtOnce], nz[kPointsAtOnce];
    kernels::loops().feet(shape, x, y, z, count, {distance, nx, ny, nz});
    const std::uint32_t seen_from_inside = concave ? 1 : 0;
    std::uint32_t any = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const float along_ray = nx[k] * x[k] + ny[k] * y[k] + nz[k] * z[k];
      hidden[k] = (along_ray > 0.0f ? 1u : 0u) ^ seen_from_inside;
      any |= hidden[k];
    }
    return any != 0;
  }

  /// Calls use(k, distance) for each point, distance: m, infinite where the camera cannot see this side.
  template <class Use>
  void forDistances(const float* x, const float* y, const float* z, std::size_t count, const Use& use) const {
    float distance[kPointsAtOnce], nx[kPointsAtOnce], ny[kPointsAtOnce], nz[kPointsAtOnce];
    kernels::loops().feet(shape, x, y, z, count, {distance, nx, ny, nz});
    for (std::size_t k = 0; k < count; ++k) {
      const bool inside = nx[k] * x[k] + ny[k] * y[k] + nz[k] * z[k] > 0.0f;
      use(k, inside == concave ? distance[k] : std::numeric_limits<float>::infinity());
    }
  }
};

/// The walls of one frame.
class Walls {
 public:
  Walls(const Cloud& cloud, const std::vector<Detection>& detections, const List<bool>& kept,
        const Tolerance& tolerance)
      : cloud_(cloud), tolerance_(flattened(tolerance.noise, tolerance.deviations)) {
    for (const Detection& detection : detections) {
      const bool has_say = kept.empty() || kept[curved_.size()];
      curved_.push_back(has_say && kindOf(detection.shape) != Kind::plane);
      walls_.emplace_back(detection.shape, detection.concave);
      parts_.emplace_back(detection.shape, detection.extent);
    }
  }

  bool curved(std::size_t k) const { return curved_[k]; }

  /// Those of a run, at most kPointsAtOnce points, that the camera cannot see on their wall.
  void findFar(const LabelRun& run, PlacesOfPoints& far) const {
    const float *x = cloud_.x.data() + run.begin, *y = cloud_.y.data() + run.begin, *z = cloud_.z.data() + run.begin;
    const std::uint32_t count = run.end - run.begin;
    std::uint32_t hidden[kPointsAtOnce];
    far.count = 0;
    if (!walls_[run.label - 1].findHidden(x, y, z, count, hidden)) return;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (hidden[k] != 0) far.add(cloud_, run.begin + k);
    }
  }

  /// Takes those from the points of wall k that lie on a wall which is seen from the other side, and labels them.
  void moveToOtherSides(std::size_t k, PlacesOfPoints& points, std::vector<std::uint32_t>& labels) const {
    for (std::size_t other = 0; other < walls_.size() && points.count > 0; ++other) {
      if (curved_[other] && walls_[other].concave != walls_[k].concave) move(other, points, labels);
    }
  }

 private:
  void move(std::size_t to, PlacesOfPoints& points, std::vector<std::uint32_t>& labels) const {
    float allowed[kPointsAtOnce], depth[kPointsAtOnce];
    bool moved[kPointsAtOnce];
    kernels::loops().tolerances(tolerance_, points.z, points.count, allowed);
    kernels::loops().depths(parts_[to].view(), points.x, points.y, points.z, points.count, depth);
    walls_[to].forDistances(points.x, points.y, points.z, points.count, [&](std::size_t k, float distance) {
      moved[k] = std::fabs(distance) < allowed[k] && depth[k] > -allowed[k];
    });
    for (std::size_t k = 0; k < points.count; ++k) {
      if (moved[k]) labels[points.index[k]] = static_cast<std::uint32_t>(to + 1);
    }
    points.keep([&](std::size_t k) { return !moved[k]; });
  }

  const Cloud& cloud_;
  kernels::FlatTolerance tolerance_;
  List<bool> curved_;  ///< and kept
  List<Wall> walls_;   ///< of each detection, also of planes
  List<ObservedPart> parts_;
};

}  // namespace

List<bool> markFarSides(const Cloud& cloud, const std::vector<Detection>& detections, const List<bool>& kept,
                        const Tolerance& tolerance, const List<LabelRun>& runs, std::vector<std::uint32_t>& labels) {
  const Walls walls(cloud, detections, kept, tolerance);
  List<bool> found(detections.size(), false);
  PlacesOfPoints far;
  for (const LabelRun& run : runs) {
    const std::size_t k = run.label - 1;
    if (!walls.curved(k)) continue;
    for (std::uint32_t begin = run.begin; begin < run.end; begin += kPointsAtOnce) {
      walls.findFar({run.label, begin, std::min(begin + static_cast<std::uint32_t>(kPointsAtOnce), run.end)}, far);
      walls.moveToOtherSides(k, far, labels);
      for (std::size_t i = 0; i < far.count; ++i) labels[far.index[i]] |= kFarSide;
      if (far.count > 0) found[k] = true;
    }
  }
  return found;
}

void dropFarSides(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                  std::vector<std::uint32_t>& labels) {
  markFarSides(cloud, detections, {}, tolerance, labelRuns(labels), labels);
  for (std::uint32_t& label : labels) label = label < kFarSide ? label : 0;
}

}  // namespace primitect
