// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs of points against each shape; see labeling.h.
#include "core/labeling.h"

#include <algorithm>
#include <cmath>

#include "core/flat.h"
#include "core/point_noise.h"

namespace primitect {
namespace {

/// Points of a run: short enough to lie close together, long enough that what is done once for each costs little.
constexpr std::size_t kRun = 64;
/// Runs whose points are labelled by all shapes before the next ones, so that they stay in the cache.
constexpr std::size_t kRunsAtOnce = 16;
/// So that no point of a ball is left out.
constexpr float kRounding = 1.001f;

}  // namespace

void Labeling::begin(const Cloud& cloud) {
  cloud_ = &cloud;
  const std::size_t runs = (cloud.size() + kRun - 1) / kRun;
  for (std::vector<float>* values : {&x_, &y_, &z_, &radius_, &distance_, &depth_, &allowed_}) values->resize(runs);
  point_allowed_.resize(kRunsAtOnce * kRun);
  nearest_.resize(kRunsAtOnce * kRun);
  const kernels::Balls balls = {x_.data(), y_.data(), z_.data(), radius_.data()};
  kernels::loops().balls(cloud.x.data(), cloud.y.data(), cloud.z.data(), cloud.size(), kRun, balls);
}

/// The most that a point of a run may be away: what is allowed has no maximum between two depths.
void Labeling::findAllowed(const kernels::FlatTolerance& tolerance) {
  const std::size_t runs = x_.size();
  for (std::size_t k = 0; k < runs; ++k) distance_[k] = z_[k] - radius_[k], depth_[k] = z_[k] + radius_[k];
  kernels::loops().tolerances(tolerance, distance_.data(), runs, allowed_.data());
  kernels::loops().tolerances(tolerance, depth_.data(), runs, distance_.data());
  for (std::size_t k = 0; k < runs; ++k) allowed_[k] = std::max(allowed_[k], distance_[k]);
}

/// Distances to a surface, and depths within a part, differ by no more than the points are apart.
void Labeling::findNear(const Target& target, Near* near) {
  const std::size_t runs = x_.size();
  const kernels::Loops& loops = kernels::loops();
  loops.distances(target.shape, x_.data(), y_.data(), z_.data(), runs, distance_.data());
  loops.depths(target.part.view(), x_.data(), y_.data(), z_.data(), runs, depth_.data());
  for (std::size_t k = 0; k < runs; ++k) {
    const float radius = kRounding * radius_[k], reach = radius + kRounding * allowed_[k];
    const bool far = radius < 0.0f || std::fabs(distance_[k]) > reach || depth_[k] < -reach;
    near[k] = far ? Near::no : depth_[k] > radius ? Near::within : Near::border;
  }
}

/// The sides that pass through the ball around a run: one or two of the forty that an outline may have.
kernels::FlatPart Labeling::sidesNear(const kernels::FlatPart& part, std::size_t run) {
  sides_.clear();
  for (std::size_t k = 0; k < part.count; ++k) {
    const kernels::FlatSide& side = part.sides[k];
    const float depth = side.x * x_[run] + side.y * y_[run] + side.z * z_[run] - side.offset;
    if (depth <= kRounding * radius_[run]) sides_.push_back(side);
  }
  return {sides_.data(), sides_.size()};
}

void Labeling::labelRuns(std::size_t first, std::size_t last, const kernels::FlatTolerance& tolerance,
                         std::uint32_t* labels) {
  const std::size_t begin = first * kRun, count = std::min(last * kRun, cloud_->size()) - begin;
  const float* z = cloud_->z.data() + begin;
  const kernels::Loops& loops = kernels::loops();
  loops.tolerances(tolerance, z, count, point_allowed_.data());
  std::copy_n(point_allowed_.begin(), count, nearest_.begin());
  std::fill_n(labels + begin, count, 0u);
  const kernels::LabelledCloud points = {cloud_->x.data() + begin, cloud_->y.data() + begin, z,
                                         point_allowed_.data(),    nearest_.data(),          labels + begin};
  for (std::size_t k = 0; k < targets_.size(); ++k) {
    const Near* near = near_.data() + k * x_.size();
    for (std::size_t run = first, next = first; run < last; run = next) {
      // Runs at the border are bounded by sides of their own.
      const bool border = near[run] == Near::border;
      do {
        ++next;
      } while (!border && next < last && near[next] == near[run]);
      if (near[run] == Near::no) continue;
      const kernels::FlatPart part = border ? sidesNear(targets_[k].part.view(), run) : kernels::FlatPart{nullptr, 0};
      loops.label(targets_[k].shape, part, points, run * kRun - begin, std::min(next * kRun - begin, count),
                  static_cast<std::uint32_t>(k + 1));
    }
  }
}

void Labeling::label(const std::vector<Detection>& detections, const Tolerance& tolerance,
                     std::vector<std::uint32_t>& labels) {
  const std::size_t runs = x_.size();
  const kernels::FlatTolerance flat = flattened(tolerance.noise, tolerance.deviations);
  labels.resize(cloud_->size());
  findAllowed(flat);
  targets_.clear();
  near_.resize(detections.size() * runs);
  for (const Detection& detection : detections) {
    const std::size_t k = targets_.size();
    targets_.push_back({flattened(detection.shape, Vec3::Zero()), ObservedPart(detection.shape, detection.extent)});
    findNear(targets_[k], near_.data() + k * runs);
  }
  for (std::size_t first = 0; first < runs; first += kRunsAtOnce) {
    labelRuns(first, std::min(first + kRunsAtOnce, runs), flat, labels.data());
  }
}

void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels) {
  Labeling labeling;
  labeling.begin(cloud);
  labeling.label(detections, tolerance, labels);
}

}  // namespace primitect
