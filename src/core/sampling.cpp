// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Stratified random draw in one pass over the cloud; see sampling.h.
#include "core/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/random.h"

namespace primitect {
namespace {

struct Box {
  std::array<float, 3> low, high;
};

Box boundingBox(const Samples& samples) {
  const auto range = [](const std::vector<float>& values) { return std::minmax_element(values.begin(), values.end()); };
  const auto x = range(samples.x), y = range(samples.y), z = range(samples.z);
  return {{*x.first, *y.first, *z.first}, {*x.second, *y.second, *z.second}};
}

/// Spreads the lower ten bits of a number to every third bit.
std::uint32_t everyThirdBit(std::uint32_t bits) {
  bits = (bits | (bits << 16)) & 0x030000ffu;
  bits = (bits | (bits << 8)) & 0x0300f00fu;
  bits = (bits | (bits << 4)) & 0x030c30c3u;
  return (bits | (bits << 2)) & 0x09249249u;
}

/// Place of a point on the Z curve (Morton order) through a cube of 1024^3 cells around the box.
std::uint32_t zCurvePlace(const Box& box, float x, float y, float z) {
  const float longest = std::max({box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2], 1e-9f});
  const auto cell = [&](float value, float low) {
    return static_cast<std::uint32_t>(std::min((value - low) / longest * 1024.0f, 1023.0f));
  };
  return everyThirdBit(cell(x, box.low[0])) | (everyThirdBit(cell(y, box.low[1])) << 1) |
         (everyThirdBit(cell(z, box.low[2])) << 2);
}

/// Which points can be drawn.
struct FreePoints {
  const Cloud& cloud;
  const std::vector<std::uint32_t>& labels;

  bool operator()(std::size_t i) const { return cloud.valid(i) && (labels.empty() || labels[i] == 0); }
  std::size_t count() const {
    if (labels.empty()) return cloud.valid_count;
    std::size_t free_count = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) free_count += (*this)(i) ? 1 : 0;
    return free_count;
  }
};

/// Cloud indices of the drawn points, in the cloud's order; count is at most free_count.
void drawIndices(const FreePoints& is_free, std::size_t free_count, std::size_t count, std::uint64_t seed,
                 std::vector<std::uint32_t>& indices) {
  Random random(seed);
  indices.clear();
  const auto drawRank = [&](std::uint64_t run) {
    const std::uint64_t first = run * free_count / count;
    const std::uint64_t end = (run + 1) * free_count / count;
    return first + random.below(end - first);
  };
  std::uint64_t rank = 0;  // of the free point being looked at
  std::uint64_t wanted = drawRank(0);
  for (std::size_t i = 0; i < is_free.cloud.size() && indices.size() < count; ++i) {
    if (!is_free(i) || rank++ != wanted) continue;
    indices.push_back(static_cast<std::uint32_t>(i));
    if (indices.size() < count) wanted = drawRank(indices.size());
  }
}

}  // namespace

void drawSamples(const Cloud& cloud, const std::vector<std::uint32_t>& labels, std::size_t count, std::uint64_t seed,
                 Samples& samples) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  samples.clear();
  const FreePoints is_free = {cloud, labels};
  const std::size_t free_count = is_free.count();
  count = std::min(count, free_count);
  if (count == 0) return;
  drawIndices(is_free, free_count, count, seed, samples.index);
  const auto gather = [&] {
    samples.resize(samples.index.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples.x[i] = cloud.x[samples.index[i]];
      samples.y[i] = cloud.y[samples.index[i]];
      samples.z[i] = cloud.z[samples.index[i]];
      samples.nx[i] = samples.ny[i] = samples.nz[i] = kMissing;
      samples.normal_sigma[i] = 0.0f;
    }
  };
  gather();
  const Box box = boundingBox(samples);
  std::sort(samples.index.begin(), samples.index.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t place_a = zCurvePlace(box, cloud.x[a], cloud.y[a], cloud.z[a]);
    const std::uint32_t place_b = zCurvePlace(box, cloud.x[b], cloud.y[b], cloud.z[b]);
    return place_a != place_b ? place_a < place_b : a < b;
  });
  gather();
}

double boundingBoxDiagonal(const Samples& samples) {
  if (samples.size() == 0) return 0.0;
  const Box box = boundingBox(samples);
  return std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

}  // namespace primitect
