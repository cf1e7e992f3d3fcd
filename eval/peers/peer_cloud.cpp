// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals for peers; see peer_cloud.h.
#include "eval/peers/peer_cloud.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "eval/measured_normals.h"

namespace primitect::eval {
namespace {

Cloud withNormals(const Cloud& cloud) {
  std::vector<std::uint32_t> measured;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) measured.push_back(i);
  }
  Cloud result = cloud;
  clearNormals(result);
  measureNormals(measured, result);
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
