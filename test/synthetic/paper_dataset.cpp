// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The paper's data set: sizes, surfaces, noise and normals against geometry and against a plain search.
#include "synthetic/paper_dataset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.h"
#include "synthetic/neighbor_grid.h"

namespace paper_dataset_test {
namespace {

using namespace primitect;
using namespace primitect::synthetic;

constexpr double kRadToDeg = 57.29577951308232;
const std::vector<SceneKind> kKinds = {SceneKind::spheres, SceneKind::cylinders, SceneKind::cones, SceneKind::planes,
                                       SceneKind::mixed};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Angles in degrees between the estimated normals and those of the true shapes nearest to the noisy points.
double medianNormalError(const PaperScene& scene) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    const Vec3 normal = normalAt(scene.truth[scene.surface[i]], scene.cloud.point(i));
    errors.push_back(kRadToDeg * std::acos(std::min(1.0, std::abs(normal.dot(scene.cloud.normal(i))))));
  }
  return median(errors);
}

TEST(PaperScene, HasTheSizeOfThePapersClouds) {
  for (const SceneKind kind : kKinds) {
    const PaperScene scene = makePaperScene(kind, 3, 0.01);
    EXPECT_EQ(scene.cloud.size(), 160801u);
    EXPECT_EQ(scene.cloud.valid_count, 160801u);
    EXPECT_FALSE(scene.cloud.organized());
    EXPECT_TRUE(scene.cloud.hasNormals());
    EXPECT_EQ(scene.surface.size(), 160801u);
  }
}

TEST(PaperScene, PutsNoiselessPointsOnTheirShapes) {
  for (const SceneKind kind : kKinds) {
    const PaperScene scene = makePaperScene(kind, 4, 0.0);
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      // Coordinates up to 2 m in single precision, on slopes up to vertical.
      ASSERT_NEAR(distance(scene.truth[scene.surface[i]], scene.cloud.point(i)), 0.0, 1e-6) << sceneKindName(kind);
    }
  }
}

TEST(PaperScene, ShowsOuterSurfacesFromAbove) {
  for (const SceneKind kind : kKinds) {
    const PaperScene scene = makePaperScene(kind, 5, 0.0);
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      ASSERT_GE(normalAt(scene.truth[scene.surface[i]], scene.cloud.point(i)).z(), -1e-3) << sceneKindName(kind);
    }
  }
}

TEST(PaperScene, SeesTheUppermostSurface) {
  const PaperScene scene = makePaperScene(SceneKind::spheres, 6, 0.0);
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    for (const Shape& shape : scene.truth) {
      // Nothing sticks out: no point of the cloud is inside a sphere or below the background.
      ASSERT_GE(distance(shape, scene.cloud.point(i)), -1e-6);
    }
  }
}

TEST(PaperScene, DropsObjectsUnderTwoPercent) {
  for (const SceneKind kind : kKinds) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const PaperScene scene = makePaperScene(kind, seed, 0.0);
      std::vector<int> owned(scene.truth.size(), 0);
      for (const int surface : scene.surface) ++owned.at(surface);
      const bool background_first = std::abs(distance(scene.truth[0], Vec3(1.0, 0.0, 0.1))) < 1e-12;
      for (std::size_t k = background_first ? 1 : 0; k < owned.size(); ++k) EXPECT_GE(owned[k], 3217);
      EXPECT_GT(owned[0], 0);
    }
  }
}

TEST(PaperScene, HoldsOnlyTheKindAskedForAndTheBackground) {
  const PaperScene scene = makePaperScene(SceneKind::cones, 2, 0.0);
  ASSERT_GT(scene.truth.size(), 3u);
  for (std::size_t k = 1; k < scene.truth.size(); ++k) EXPECT_EQ(kindOf(scene.truth[k]), Kind::cone);
}

TEST(PaperScene, HasTheNoiseAskedFor) {
  const PaperScene scene = makePaperScene(SceneKind::planes, 1, 0.01);
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    const double away = distance(scene.truth[scene.surface[i]], scene.cloud.point(i));
    sum += away * away;
  }
  // 160,801 draws: the standard deviation is known to 0.2 %.
  EXPECT_NEAR(std::sqrt(sum / scene.cloud.size()), 0.01, 0.0001);
}

TEST(PaperScene, HasNormalErrorsAsThePapersData) {
  const PaperScene scene = makePaperScene(SceneKind::mixed, 1, 0.01);
  EXPECT_NEAR(medianNormalError(scene), 6.0, 0.7);
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) ASSERT_NEAR(scene.cloud.normal(i).norm(), 1.0, 1e-5);
}

TEST(PaperScene, IsTheSameForTheSameSeed) {
  const PaperScene first = makePaperScene(SceneKind::mixed, 7, 0.01),
                   second = makePaperScene(SceneKind::mixed, 7, 0.01);
  EXPECT_EQ(first.cloud.x, second.cloud.x);
  EXPECT_EQ(first.cloud.nz, second.cloud.nz);
  EXPECT_EQ(first.surface, second.surface);
  EXPECT_NE(first.cloud.z, makePaperScene(SceneKind::mixed, 8, 0.01).cloud.z);
}

TEST(PaperScene, KeepsItsShapesAtEveryNoise) {
  EXPECT_EQ(makePaperScene(SceneKind::mixed, 7, 0.005).surface, makePaperScene(SceneKind::mixed, 7, 0.025).surface);
}

TEST(PaperScene, ThrowsAShareOfThePointsAnywhere) {
  const PaperScene scene = makePaperScene(SceneKind::planes, 1, 0.005, 0.1);
  const auto outliers = std::count(scene.surface.begin(), scene.surface.end(), -1);
  EXPECT_NEAR(outliers / 160801.0, 0.1, 0.004);
}

TEST(PaperScene, RefusesNumbersOutOfRange) {
  EXPECT_THROW(makePaperScene(SceneKind::planes, 1, -0.01), std::invalid_argument);
  EXPECT_THROW(makePaperScene(SceneKind::planes, 1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(makePaperScene(SceneKind::planes, 1, 0.01, 1.0), std::invalid_argument);
  EXPECT_THROW(sceneKindFromName("cubes"), std::invalid_argument);
}

TEST(PaperScene, HasNamesForItsKinds) {
  for (const SceneKind kind : kKinds) EXPECT_EQ(sceneKindFromName(sceneKindName(kind)), kind);
}

TEST(NeighborGrid, FindsWhatAPlainSearchFinds) {
  const PaperScene scene = makePaperScene(SceneKind::cones, 2, 0.02, 0.05);
  const Cloud& cloud = scene.cloud;
  NeighborGrid grid(cloud, 0.01f);
  Random random(1);
  std::vector<std::uint32_t> found, all(cloud.size());
  for (int k = 0; k < 200; ++k) {
    const auto i = static_cast<std::uint32_t>(random.below(cloud.size()));
    grid.nearest(i, 41, found);
    const auto distanceSq = [&](std::uint32_t j) {
      const float dx = cloud.x[j] - cloud.x[i], dy = cloud.y[j] - cloud.y[i], dz = cloud.z[j] - cloud.z[i];
      return std::make_pair(dx * dx + dy * dy + dz * dz, j);
    };
    std::iota(all.begin(), all.end(), 0u);
    std::nth_element(all.begin(), all.begin() + 41, all.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return distanceSq(a) < distanceSq(b); });
    std::sort(all.begin(), all.begin() + 41);
    std::sort(found.begin(), found.end());
    ASSERT_TRUE(std::equal(found.begin(), found.end(), all.begin())) << "point " << i;
  }
}

}  // namespace
}  // namespace paper_dataset_test
