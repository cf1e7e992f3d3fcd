// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labelled points against the view; see far_sides.h.
#include "core/far_sides.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/seen_points.h"

namespace primitect {
namespace {

/// Points that are looked at together.
constexpr std::size_t kAtOnce = 256;

/// Calls use(i) for the points of this run [begin, end) on the far side.
template <class Use>
void forFarSide(const Cloud& cloud, const Detection& detection, std::size_t begin, std::size_t end, const Use& use) {
  const float *x = cloud.x.data(), *y = cloud.y.data(), *z = cloud.z.data();
  for (; begin < end; begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, end - begin);
    const Feet<kAtOnce> feet(detection.shape, Vec3::Zero(), x + begin, y + begin, z + begin, count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = begin + k;
      const bool inside = feet.nx[k] * x[i] + feet.ny[k] * y[i] + feet.nz[k] * z[i] > 0.0f;
      if (inside != detection.concave) use(i);
    }
  }
}

}  // namespace

std::vector<std::uint32_t> dropFarSides(const Cloud& cloud, const std::vector<Detection>& detections,
                                        std::vector<std::uint32_t>& labels) {
  std::vector<std::uint32_t> taken;
  for (std::size_t begin = 0, end = 0; begin < labels.size(); begin = end) {
    const std::uint32_t label = labels[begin];
    while (end < labels.size() && labels[end] == label) ++end;
    if (label == 0 || kindOf(detections[label - 1].shape) == Kind::plane) continue;
    forFarSide(cloud, detections[label - 1], begin, end, [&taken, &labels](std::size_t i) {
      taken.resize(labels.size());
      std::swap(taken[i], labels[i]);
    });
  }
  return taken;
}

}  // namespace primitect
