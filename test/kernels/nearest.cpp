// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours leaf by leaf, of every instruction set, against all distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "core/leaf_tree.h"
#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using kernels::kLeafSize;
using kernels::Loops;
using kernels::NearestKeys;

Samples scattered(int count) {
  Random random(61);
  std::vector<test::SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back({test::randomPoint(random), Vec3::UnitZ()});
  return test::samplesOf(points);
}

NearestKeys nearestOf(const Loops& loops, const LeafTree& tree, std::size_t leaf, std::size_t count) {
  NearestKeys keys;
  for (auto& row : keys.of) std::fill(std::begin(row), std::end(row), kernels::kNoNeighbor);
  loops.nearest(tree.view(), leaf, count, 0, tree.leaves(), keys);
  return keys;
}

std::uint32_t sampleIn(double key) {
  std::int64_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return static_cast<std::uint32_t>(bits & kernels::kPlaceBits);
}

TEST(Nearest, AreThoseOfAllDistances) {
  // 301: the last leaf is not full.
  const Samples samples = scattered(301);
  LeafTree tree;
  tree.update(samples);
  const auto distanceSq = [&](std::uint32_t a, std::uint32_t b) {
    return (samples.point(a) - samples.point(b)).squaredNorm();
  };
  for (const Loops* loops : kernels::allLoops()) {
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      const std::size_t leaf = i / kLeafSize;
      const NearestKeys keys = nearestOf(*loops, tree, leaf, tree.batches()[0].samplesOf(leaf));
      std::vector<std::uint32_t> others;
      for (std::uint32_t j = 0; j < samples.size(); ++j) {
        if (j != i) others.push_back(j);
      }
      std::sort(others.begin(), others.end(),
                [&](std::uint32_t a, std::uint32_t b) { return distanceSq(i, a) < distanceSq(i, b); });
      for (std::size_t k = 0; k < kLeafSize; ++k) {
        EXPECT_EQ(sampleIn(keys.of[k][i % kLeafSize]), others[k]) << loops->name << " of " << i;
      }
    }
  }
}

TEST(Nearest, AreNoneOfASingleSample) {
  LeafTree tree;
  tree.update(scattered(1));
  for (const Loops* loops : kernels::allLoops()) {
    const NearestKeys keys = nearestOf(*loops, tree, 0, 1);
    for (const auto& row : keys.of) EXPECT_GE(row[0], kernels::kNoNeighbor) << loops->name;
  }
}

}  // namespace
}  // namespace primitect
