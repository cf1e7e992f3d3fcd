// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The box around one true shape; see cut_out.h.
#include "eval/cut_out.h"

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "core/random.h"

namespace primitect::eval {
namespace {

/// Indices of true shapes.
std::vector<int> choices(const LabelledCloud& frame) {
  std::vector<int> curved, planes;
  for (std::size_t t = 0; t < frame.truth.size(); ++t) {
    if (!frame.truth[t].must) continue;
    (kindOf(frame.truth[t].shape) == Kind::plane ? planes : curved).push_back(static_cast<int>(t));
  }
  return curved.empty() ? planes : curved;
}

Eigen::Vector3f measuredAt(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }

Eigen::AlignedBox3f boxAround(const LabelledCloud& frame, int shape) {
  constexpr float kMargin = 0.03f;  // m
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < frame.surface.size(); ++i) {
    if (frame.surface[i] == shape && frame.cloud.valid(i)) box.extend(measuredAt(frame.cloud, i));
  }
  const Eigen::Vector3f margin = Eigen::Vector3f::Constant(kMargin);
  return {box.min() - margin, box.max() + margin};
}

void takeAway(std::size_t i, Cloud& cloud) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  cloud.x[i] = cloud.y[i] = cloud.z[i] = kMissing;
  if (cloud.hasNormals()) cloud.nx[i] = cloud.ny[i] = cloud.nz[i] = kMissing;
}

}  // namespace

void cutOut(std::uint64_t seed, LabelledCloud& frame) {
  const std::vector<int> shapes = choices(frame);
  if (shapes.empty()) return;
  Random random(seed ^ 0x637574U);
  const Eigen::AlignedBox3f box = boxAround(frame, shapes[random.below(shapes.size())]);
  for (std::size_t i = 0; i < frame.cloud.size(); ++i) {
    if (frame.cloud.valid(i) && box.contains(measuredAt(frame.cloud, i))) continue;
    takeAway(i, frame.cloud);
    takeAway(i, frame.scored);
    frame.surface[i] = kNoShape;
  }
  frame.cloud.countPoints();
  frame.scored.countPoints();
}

}  // namespace primitect::eval
