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

using kernels::kPointsPerRun;
/// So that no point of a ball is left out.
constexpr float kRounding = 1.001f;

}  // namespace

void Labeling::begin(const Cloud& cloud) {
  cloud_ = &cloud;
  findSomeRuns(cloud, some_);
  has_all_ = false;
}

const PointRuns& Labeling::allRuns() {
  if (some_.size() * kPointsPerRun >= cloud_->size()) return some_;
  if (!has_all_) findRuns(*cloud_, all_);
  has_all_ = true;
  return all_;
}

/// The most that a point of a run may be away: what is allowed has no maximum between two depths.
void Labeling::findAllowed(const PointRuns& runs, const kernels::FlatTolerance& tolerance) {
  const std::size_t count = runs.size();
  for (List<float>* values : {&distance_, &depth_, &allowed_}) values->resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    distance_[k] = runs.z[k] - runs.radius[k], depth_[k] = runs.z[k] + runs.radius[k];
  }
  kernels::loops().tolerances(tolerance, distance_.data(), count, allowed_.data());
  kernels::loops().tolerances(tolerance, depth_.data(), count, distance_.data());
  for (std::size_t k = 0; k < count; ++k) allowed_[k] = std::max(allowed_[k], distance_[k]);
}

/// Distances to a surface, and depths within a part, differ by no more than the points are apart.
void Labeling::findNear(const PointRuns& runs, std::size_t target) {
  const std::size_t count = runs.size(), word = target / kTargetsPerWord * count;
  const float *const x = runs.x.data(), *const y = runs.y.data(), *const z = runs.z.data();
  const kernels::Loops& loops = kernels::loops();
  loops.distances(targets_[target].shape, x, y, z, count, distance_.data());
  loops.depths(targets_[target].part.view(), x, y, z, count, depth_.data());
  const std::uint32_t bit = 1u << (target % kTargetsPerWord);
  std::uint32_t *const near = near_.data() + word, *const border = border_.data() + word;
  for (std::size_t k = 0; k < count; ++k) {
    const float radius = kRounding * runs.radius[k], reach = radius + kRounding * allowed_[k];
    const float away = std::fabs(distance_[k]);
    const bool far = (radius < 0.0f) | (away > reach) | (depth_[k] < -reach);
    near[k] |= far ? 0u : bit;
    border[k] |= depth_[k] > radius ? 0u : bit;
  }
}

/// A run amid the same surfaces as the one before needs nothing else.
bool Labeling::hasTargetsOfRunBefore(const PointRuns& runs, std::size_t k) const {
  if (k == 0) return false;
  std::uint32_t other = 0;
  for (std::size_t at = k; at < near_.size(); at += runs.size()) {
    other |= (near_[at] ^ near_[at - 1]) | (near_[at] & (border_[at] | border_[at - 1]));
  }
  return other == 0;
}

/// Of a part only the sides that pass through the ball around a run: one or two of the forty that an outline may have.
void Labeling::gatherTargets(const PointRuns& runs, std::size_t k) {
  if (hasTargetsOfRunBefore(runs, k)) return;
  of_run_.clear();
  sides_.clear();
  for (std::size_t first = 0, at = k; first < targets_.size(); first += kTargetsPerWord, at += runs.size()) {
    for (std::uint32_t near = near_[at]; near != 0; near &= near - 1) {
      const auto bit = static_cast<std::uint32_t>(__builtin_ctz(near));
      const Target& target = targets_[first + bit];
      const std::size_t before = sides_.size();
      if ((border_[at] >> bit & 1u) != 0) {
        target.part.addSidesNear(runs.x[k], runs.y[k], runs.z[k], kRounding * runs.radius[k], sides_);
      }
      const kernels::FlatPart here = {sides_.data() + before, sides_.size() - before};
      of_run_.push_back({&target.shape, here, static_cast<std::uint32_t>(first + bit + 1)});
    }
  }
}

void Labeling::labelRun(std::size_t run, const kernels::FlatTolerance& tolerance, std::uint32_t* labels) const {
  const std::size_t begin = some_.layout.firstPointOf(run);
  const kernels::RunOfPoints points = pointsFrom(begin);
  if (cloud_->size() - begin < kPointsPerRun) {
    std::uint32_t last_labels[kPointsPerRun] = {};
    if (!of_run_.empty()) {
      const LastRun last(points, cloud_->size() - begin);
      kernels::loops().label(tolerance, of_run_.data(), of_run_.size(), last.points(), last_labels);
    }
    std::copy_n(last_labels, cloud_->size() - begin, labels + begin);
  } else if (of_run_.empty()) {
    for (std::size_t place = 0; place < kPointsPerRun; place += kernels::kPointsPerRow) {
      std::fill_n(labels + some_.layout.point(run, place), kernels::kPointsPerRow, 0u);
    }
  } else {
    kernels::loops().label(tolerance, of_run_.data(), of_run_.size(), points, labels + begin);
  }
}

kernels::RunOfPoints Labeling::pointsFrom(std::size_t begin) const {
  return {cloud_->x.data() + begin, cloud_->y.data() + begin, cloud_->z.data() + begin, some_.layout.stride()};
}

std::uint64_t Labeling::unexplainedOf(std::size_t run, const kernels::FlatTolerance& tolerance, Rows rows) const {
  if (of_run_.empty()) return rows == Rows::all ? ~std::uint64_t{0} : kernels::kEverySecondRow;
  const auto inRows = [&](const kernels::RunOfPoints& p) {
    constexpr std::size_t kRow = kernels::kPointsPerRow;
    const auto from = [&](const kernels::RunOfPoints& first) {
      return kernels::loops().unexplained(tolerance, of_run_.data(), of_run_.size(), first);
    };
    if (rows == Rows::every_second) return from(p);
    return from(p) | from({p.x + p.stride, p.y + p.stride, p.z + p.stride, p.stride}) << kRow;
  };
  const std::size_t begin = some_.layout.firstPointOf(run);
  const kernels::RunOfPoints points = pointsFrom(begin);
  if (cloud_->size() - begin >= kPointsPerRun) return inRows(points);
  const LastRun last(points, cloud_->size() - begin);
  return inRows(last.points());
}

/// wanted: by each detection; none: all are. Runs are near no other.
void Labeling::prepare(const std::vector<Detection>& detections, const List<bool>& wanted, const PointRuns& runs,
                       const kernels::FlatTolerance& tolerance) {
  const std::size_t words = (detections.size() + kTargetsPerWord - 1) / kTargetsPerWord;
  findAllowed(runs, tolerance);
  near_.assign(words * runs.size(), 0), border_.assign(words * runs.size(), 0);
  targets_.clear();
  std::size_t sides = 0;
  for (const Detection& detection : detections) {
    targets_.push_back({flattened(detection.shape, Vec3::Zero()), ObservedPart(detection.shape, detection.extent)});
    if (wanted.empty() || wanted[targets_.size() - 1]) findNear(runs, targets_.size() - 1);
    sides += targets_.back().part.view().count;
  }
  // What belongs to a run stays where it is while the rest is gathered.
  sides_.reserve(sides);
}

void Labeling::labelWithin(const PointRuns& runs, const kernels::FlatTolerance& tolerance, std::uint32_t* labels) {
  for (std::size_t k = 0; k < runs.size(); ++k) {
    gatherTargets(runs, k);
    labelRun(runs.number[k], tolerance, labels);
  }
}

void Labeling::label(const std::vector<Detection>& detections, const Tolerance& tolerance, const PointRuns& runs,
                     std::vector<std::uint32_t>& labels) {
  const kernels::FlatTolerance flat = flattened(tolerance.noise, tolerance.deviations);
  labels.resize(cloud_->size());
  prepare(detections, {}, runs, flat);
  labelWithin(runs, flat, labels.data());
}

void Labeling::labelWithout(const std::vector<Detection>& detections, const List<bool>& wanted,
                            const Tolerance& tolerance, const PointRuns& runs, const List<LabelRun>& labelled,
                            std::vector<std::uint32_t>& labels) {
  const RunLayout& layout = some_.layout;
  List<bool> concerned(numberOfRuns(*cloud_), false);
  for (const LabelRun& run : labelled) {
    if (wanted[run.label - 1]) continue;
    // Sixteen points from a multiple of sixteen on are one row of one run.
    constexpr std::uint32_t kStep = kernels::kPointsPerRow;
    for (std::uint32_t k = run.begin; k < run.end; k = (k / kStep + 1) * kStep) concerned[layout.runOf(k)] = true;
  }
  PointRuns again;
  again.layout = layout;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (!concerned[runs.number[k]]) continue;
    again.number.push_back(runs.number[k]), again.measured.push_back(runs.measured[k]);
    again.x.push_back(runs.x[k]), again.y.push_back(runs.y[k]), again.z.push_back(runs.z[k]);
    again.radius.push_back(runs.radius[k]);
  }
  const kernels::FlatTolerance flat = flattened(tolerance.noise, tolerance.deviations);
  prepare(detections, wanted, again, flat);
  labelWithin(again, flat, labels.data());
}

void Labeling::findUnexplained(const std::vector<Detection>& detections, const Tolerance& tolerance,
                               const PointRuns& runs, Rows rows, List<std::uint64_t>& unexplained) {
  const kernels::FlatTolerance flat = flattened(tolerance.noise, tolerance.deviations);
  unexplained.resize(runs.size());
  prepare(detections, {}, runs, flat);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    gatherTargets(runs, k);
    unexplained[k] = unexplainedOf(runs.number[k], flat, rows);
  }
}

void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels) {
  Labeling labeling;
  labeling.begin(cloud);
  labeling.label(detections, tolerance, labeling.allRuns(), labels);
}

}  // namespace primitect
