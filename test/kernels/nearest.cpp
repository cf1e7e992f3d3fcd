// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours leaf by leaf, of every instruction set, against all distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "core/leaf_tree.h"
#include "test/support/exact_shapes.h"

namespace primitect::nearest_test {
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

std::uint32_t sampleIn(float key, const LeafTree& tree) {
  std::int32_t bits;
  std::memcpy(&bits, &key, sizeof(bits));
  return static_cast<std::uint32_t>(bits & tree.placeBits());
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
      std::vector<double> distances;
      for (std::uint32_t j = 0; j < samples.size(); ++j) {
        if (j != i) distances.push_back(distanceSq(i, j));
      }
      std::sort(distances.begin(), distances.end());
      std::set<std::uint32_t> found;
      for (std::size_t k = 0; k < kLeafSize; ++k) {
        const std::uint32_t j = sampleIn(keys.of[k][i % kLeafSize], tree);
        found.insert(j);
        // Ten bits of the square are left beside the place.
        EXPECT_NEAR(distanceSq(i, j), distances[k], 1e-3 * distances[k]) << loops->name << " of " << i;
      }
      EXPECT_EQ(found.size(), kLeafSize) << loops->name << " of " << i;
      EXPECT_EQ(found.count(i), 0u) << loops->name << " of " << i;
    }
  }
}

TEST(Nearest, AreTheSameOnEveryInstructionSet) {
  LeafTree tree;
  tree.update(scattered(301));
  for (std::size_t leaf = 0; leaf < 301 / kLeafSize; ++leaf) {
    const NearestKeys first = nearestOf(**kernels::allLoops().begin(), tree, leaf, kLeafSize);
    for (const Loops* loops : kernels::allLoops()) {
      const NearestKeys keys = nearestOf(*loops, tree, leaf, kLeafSize);
      EXPECT_EQ(std::memcmp(&keys, &first, sizeof(keys)), 0) << loops->name << " of leaf " << leaf;
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
}  // namespace primitect::nearest_test
