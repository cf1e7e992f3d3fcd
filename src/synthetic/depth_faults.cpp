// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Mixed and bent depths, shadows, blots; see depth_faults.h.
#include "synthetic/depth_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthetic/noise_field.h"

namespace primitect::synthetic {

void mixNeighbors(int width, const PinholeCamera& camera, std::vector<float>& depth) {
  const int half = width / 2;
  const std::vector<float> seen = depth;
  const auto meanAround = [&](int u, int v) {
    double sum = 0.0, count = 0.0;
    for (int row = std::max(v - half, 0); row <= std::min(v + half, camera.height - 1); ++row) {
      for (int column = std::max(u - half, 0); column <= std::min(u + half, camera.width - 1); ++column) {
        const float z = seen[static_cast<std::size_t>(row) * camera.width + column];
        if (z > 0.0f) sum += z, count += 1.0;
      }
    }
    return static_cast<float>(sum / count);
  };
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      float& own = depth[static_cast<std::size_t>(v) * camera.width + u];
      if (own > 0.0f) own = meanAround(u, v);
    }
  }
}

void removeShadows(double baseline, const PinholeCamera& camera, std::vector<float>& depth) {
  constexpr float kBehind =
      0.02f;  // of the depth: neighbours on a slanted surface may fall into one pixel of the other
  const double shift = camera.fx * baseline;
  std::vector<float> nearest;  // that the other camera sees, from its column that sees what is far at our first one
  for (int v = 0; v < camera.height; ++v) {
    float* const row = &depth[static_cast<std::size_t>(v) * camera.width];
    nearest.assign(2 * static_cast<std::size_t>(camera.width), std::numeric_limits<float>::infinity());
    const auto columnOf = [&](int u) { return static_cast<std::size_t>(std::min(u + shift / row[u], 2e9)); };
    for (int u = 0; u < camera.width; ++u) {
      if (!(row[u] > 0.0f)) continue;
      // Between two columns it hides a part of both.
      const std::size_t first = columnOf(u);
      for (std::size_t c = first; c < std::min(first + 2, nearest.size()); ++c) {
        nearest[c] = std::min(nearest[c], row[u]);
      }
    }
    for (int u = 0; u < camera.width; ++u) {
      if (!(row[u] > 0.0f) || columnOf(u) >= nearest.size()) continue;
      if (nearest[columnOf(u)] < (1.0f - kBehind) * row[u]) row[u] = kMissing;
    }
  }
}

void bend(double share, int length, const PinholeCamera& camera, std::uint64_t seed, std::vector<float>& depth) {
  const std::vector<float> waves = waveField(length, camera, seed);
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] *= 1.0f + static_cast<float>(share) * waves[i];
}

void removeBlots(double share, int grain, const PinholeCamera& camera, std::uint64_t seed, std::vector<float>& depth) {
  const std::vector<float> field = waveField(grain, camera, seed);
  std::vector<float> sorted = field;
  const auto count = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size()));
  const auto limit = sorted.begin() + std::min(count, static_cast<std::ptrdiff_t>(sorted.size()) - 1);
  std::nth_element(sorted.begin(), limit, sorted.end());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (field[i] < *limit) depth[i] = kMissing;
  }
}

}  // namespace primitect::synthetic
