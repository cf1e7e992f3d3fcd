// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals for peers; see peer_cloud.h.
#include "eval/peers/peer_cloud.h"

#include <cstring>
#include <limits>
#include <memory>

#include "core/normals.h"

namespace primitect::eval {
namespace {

/// All measured points as samples without normals.
Samples allPoints(const Cloud& cloud) {
  Samples samples;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    samples.x.push_back(cloud.x[i]);
    samples.y.push_back(cloud.y[i]);
    samples.z.push_back(cloud.z[i]);
    samples.index.push_back(i);
  }
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  for (std::vector<float>* values : {&samples.nx, &samples.ny, &samples.nz}) values->assign(samples.size(), kMissing);
  return samples;
}

Cloud withNormals(const Cloud& cloud) {
  Samples samples = allPoints(cloud);
  std::unique_ptr<NeighborSearch> neighbors;
  estimateNormals(cloud, Params(), neighbors, samples);
  Cloud result = cloud;
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  for (std::vector<float>* values : {&result.nx, &result.ny, &result.nz}) values->assign(cloud.size(), kMissing);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples.hasNormal(i)) result.setNormal(samples.index[i], samples.nx[i], samples.ny[i], samples.nz[i]);
  }
  return result;
}

/// Bit for bit, so that a missing point equals a missing point.
bool sameNumbers(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

bool samePoints(const Cloud& a, const Cloud& b) {
  return a.width == b.width && a.height == b.height && sameNumbers(a.x, b.x) && sameNumbers(a.y, b.y) &&
         sameNumbers(a.z, b.z);
}

}  // namespace

const Cloud& peerCloud(const LabelledCloud& input) {
  if (input.cloud.hasNormals()) return input.cloud;
  static Cloud last;
  if (!samePoints(last, input.cloud) || !last.hasNormals()) last = withNormals(input.cloud);
  return last;
}

}  // namespace primitect::eval
