// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labelled points against the view; see far_sides.h.
#include "core/far_sides.h"

#include <algorithm>
#include <cstddef>

#include "core/flat.h"
#include "core/label_runs.h"
#include "kernels/loops.h"

namespace primitect {
namespace {

/// Calls use(i) for the points of this run on the far side.
template <class Use>
void forFarSide(const Cloud& cloud, const kernels::FlatShape& shape, bool concave, const LabelRun& run,
                const Use& use) {
  constexpr std::size_t kAtOnce = 256;
  float distance[kAtOnce], nx[kAtOnce], ny[kAtOnce], nz[kAtOnce];
  const float *x = cloud.x.data(), *y = cloud.y.data(), *z = cloud.z.data();
  for (std::size_t begin = run.begin; begin < run.end; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, run.end - begin);
    kernels::loops().feet(shape, x + begin, y + begin, z + begin, count, {distance, nx, ny, nz});
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = begin + k;
      const bool inside = nx[k] * x[i] + ny[k] * y[i] + nz[k] * z[i] > 0.0f;
      if (inside != concave) use(i);
    }
  }
}

}  // namespace

List<bool> markFarSides(const Cloud& cloud, const std::vector<Detection>& detections,
                        std::vector<std::uint32_t>& labels) {
  List<kernels::FlatShape> shapes;
  for (const Detection& detection : detections) shapes.push_back(flattened(detection.shape, Vec3::Zero()));
  List<bool> found(detections.size(), false);
  forLabelRuns(labels, [&](const LabelRun& run) {
    const std::size_t k = run.label - 1;
    if (kindOf(detections[k].shape) == Kind::plane) return;
    forFarSide(cloud, shapes[k], detections[k].concave, run, [&](std::size_t i) {
      labels[i] |= kFarSide;
      found[k] = true;
    });
  });
  return found;
}

void dropFarSides(const Cloud& cloud, const std::vector<Detection>& detections, std::vector<std::uint32_t>& labels) {
  markFarSides(cloud, detections, labels);
  for (std::uint32_t& label : labels) label = label < kFarSide ? label : 0;
}

}  // namespace primitect
