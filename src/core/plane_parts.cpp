// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts by touch and by height; see plane_parts.h.
#include "core/plane_parts.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace primitect {
namespace {

struct Height {
  double height;  ///< m, along the mean normal
  std::uint32_t sample;
};

Vec3 meanNormal(const Samples& samples, const std::vector<std::uint32_t>& indices) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t i : indices) sum += samples.normal(i);
  return sum.normalized();
}

/// How many of the lowest make the two classes whose means differ most against their sizes (Otsu 1979).
std::size_t bestCut(const std::vector<Height>& heights, std::size_t least) {
  double total = 0.0;
  for (const Height& h : heights) total += h.height;
  const double count = static_cast<double>(heights.size());
  double below = 0.0, most = -1.0;
  std::size_t best = least;
  for (std::size_t k = 1; k + least <= heights.size(); ++k) {
    below += heights[k - 1].height;
    if (k < least) continue;
    const double low = static_cast<double>(k), high = count - low;
    const double difference = below / low - (total - below) / high;
    const double between = low * high * difference * difference;
    if (!(between > most)) continue;
    most = between;
    best = k;
  }
  return best;
}

}  // namespace

SampleParts separateParts(const std::vector<std::uint32_t>& inliers, std::size_t least, SampleGraph& graph) {
  SampleParts parts = graph.parts(inliers, least);
  const bool all_touch = parts.size() == 1 && parts.front().size() == inliers.size();
  return all_touch ? SampleParts() : parts;
}

SampleParts stepParts(const Samples& samples, const Plane& plane, const std::vector<std::uint32_t>& inliers,
                      std::size_t least) {
  constexpr double kLeastTilt = 0.02;  // rad: ten times what the noise of fifty normals leaves
  if (inliers.size() < 2 * least) return {};
  const Vec3 up = meanNormal(samples, inliers);
  if (!(up.cross(plane.normal).norm() > kLeastTilt)) return {};
  std::vector<Height> heights;
  for (const std::uint32_t i : inliers) heights.push_back({up.dot(samples.point(i)), i});
  std::sort(heights.begin(), heights.end(), [](const Height& a, const Height& b) {
    return a.height != b.height ? a.height < b.height : a.sample < b.sample;
  });
  const std::size_t cut = bestCut(heights, least);
  SampleParts parts(2);
  for (std::size_t k = 0; k < heights.size(); ++k) parts[k < cut ? 0 : 1].push_back(heights[k].sample);
  for (std::vector<std::uint32_t>& part : parts) std::sort(part.begin(), part.end());
  return parts;
}

}  // namespace primitect
