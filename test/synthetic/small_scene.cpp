// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of small objects keep what their header promises.
#include "synthetic/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace small_scene_test {
namespace {

using namespace primitect;
using namespace primitect::synthetic;

constexpr std::uint64_t kSeeds = 12;

/// The scenes of the seeds from 1 to kSeeds without noise, made once for all tests.
const PaperScene& noiseless(std::uint64_t seed) {
  static const std::vector<PaperScene> scenes = [] {
    std::vector<PaperScene> made;
    for (std::uint64_t s = 1; s <= kSeeds; ++s) made.push_back(makeSmallScene(s, 0.0));
    return made;
  }();
  return scenes.at(seed - 1);
}

TEST(SmallScene, HoldsSixToTenObjectsThatOwnAtMostTwoPercentEach) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const PaperScene& scene = noiseless(seed);
    EXPECT_GE(scene.truth.size(), 6u) << seed;  // one of them may be hidden as a whole
    EXPECT_LE(scene.truth.size(), 11u) << seed;
    for (std::size_t t = 1; t < scene.truth.size(); ++t) EXPECT_LE(scene.owned[t], 0.02 * 160801) << seed;
    EXPECT_NEAR(distance(scene.truth[0], Vec3(1.0, 0.0, 0.1)), 0.0, 1e-12) << "the background comes first";
  }
}

TEST(SmallScene, HasAboutEquallyManyOfEachKindAndOfEachSize) {
  std::array<int, kKindCount> of_kind = {};
  int objects = 0, below_the_middle = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const PaperScene& scene = noiseless(seed);
    for (std::size_t t = 1; t < scene.truth.size(); ++t) {
      ++of_kind[static_cast<std::size_t>(kindOf(scene.truth[t]))];
      ++objects;
      below_the_middle += scene.owned[t] < 160801 * std::sqrt(kSmallestShare * kSmallShareLimit) ? 1 : 0;
    }
  }
  // Kinds take turns: a scene has at most one more of a kind than of another.
  for (const int count : of_kind) EXPECT_NEAR(count, objects / 4.0, 0.75 * kSeeds);
  // Binomial of about 96 with standard deviation 5; hiding one another makes some smaller.
  EXPECT_NEAR(below_the_middle, 0.5 * objects, 25.0);
}

TEST(SmallScene, PutsNoiselessPointsOnTheUppermostShape) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const PaperScene& scene = noiseless(seed);
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      const Shape& shape = scene.truth[scene.surface[i]];
      // Coordinates up to 2 m in single precision, on slopes up to vertical.
      ASSERT_NEAR(distance(shape, scene.cloud.point(i)), 0.0, 1e-6) << seed;
      ASSERT_GE(normalAt(shape, scene.cloud.point(i)).z(), -1e-3) << seed;
    }
  }
}

TEST(SmallScene, EndsItsCylindersAndCones) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PaperScene& scene = noiseless(seed);
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      const Shape& shape = scene.truth[scene.surface[i]];
      if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
        const double along = (scene.cloud.point(i) - cylinder->point).dot(cylinder->axis);
        ASSERT_LE(std::abs(along), 3.0 * cylinder->radius + 1e-6);
      }
    }
  }
}

TEST(SmallScene, CountsPointsBeforeOutliersAreThrown) {
  const PaperScene scene = makeSmallScene(2, 0.01, 0.3);
  EXPECT_EQ(scene.owned, makeSmallScene(2, 0.01).owned);
  int left = 0;
  for (const int t : scene.surface) left += t == 0 ? 1 : 0;
  EXPECT_NEAR(left, 0.7 * scene.owned[0], 0.01 * scene.owned[0]);
}

TEST(SmallScene, IsTheSameForTheSameSeed) {
  EXPECT_EQ(makeSmallScene(7, 0.01).cloud.nz, makeSmallScene(7, 0.01).cloud.nz);
  EXPECT_NE(makeSmallScene(7, 0.01).cloud.z, makeSmallScene(8, 0.01).cloud.z);
}

TEST(SmallScene, RefusesNumbersOutOfRange) {
  EXPECT_THROW(makeSmallScene(1, -0.01), std::invalid_argument);
  EXPECT_THROW(makeSmallScene(1, 0.01, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace small_scene_test
