// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of machined parts: exact without noise, as noisy as asked for, and varied.
#include "synthetic/mechanical_part.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace primitect::synthetic::mechanical_part_test {
namespace {

constexpr int kSeeds = 12;

TEST(MechanicalPart, HasTheSizeAskedForAndNoMissingPoints) {
  for (const std::size_t points : {std::size_t(8096), std::size_t(1000)}) {
    const MechanicalPart part = makeMechanicalPart(1, 0.01, points);
    EXPECT_EQ(part.cloud.size(), points);
    EXPECT_EQ(part.cloud.valid_count, points);
    EXPECT_FALSE(part.cloud.organized());
    EXPECT_TRUE(part.cloud.hasNormals());
    EXPECT_EQ(part.surface.size(), points);
    EXPECT_EQ(part.normals.size(), points);
    EXPECT_EQ(part.concave.size(), part.truth.size());
  }
}

TEST(MechanicalPart, PutsNoiselessPointsOnTheirShapesWithTheSideOfTheMaterialRight) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.0, 4000);
    for (std::size_t i = 0; i < part.cloud.size(); ++i) {
      if (part.surface[i] < 0) continue;
      const Shape& shape = part.truth[part.surface[i]];
      ASSERT_NEAR(distance(shape, part.cloud.point(i)), 0.0, 1e-6) << "seed " << seed;
      // Near the apex of a drill point single precision turns the normal of the shape.
      const double side = normalAt(shape, part.cloud.point(i)).dot(part.normals[i]);
      ASSERT_NEAR(side, part.concave[part.surface[i]] ? -1.0 : 1.0, 1e-5) << "seed " << seed;
      ASSERT_GE(part.normals[i].dot(part.cloud.normal(i)), -1e-6) << "turned like the exact one";
    }
  }
}

TEST(MechanicalPart, IsClosedSoThatOutwardNormalsCancel) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.0, 4000);
    Vec3 sum = Vec3::Zero();
    double flux = 0.0;
    for (std::size_t i = 0; i < part.normals.size(); ++i) {
      sum += part.normals[i];
      flux += part.normals[i].dot(part.cloud.point(i));
    }
    // The integral of the normal over a closed surface is 0; of 4000 draws the mean of a component errs by 0.016.
    EXPECT_LT((sum / 4000.0).norm(), 0.06) << seed;
    EXPECT_GT(flux / 4000.0, 0.02) << "three times volume over area, positive only if normals point outward";
  }
}

TEST(MechanicalPart, FillsTheUnitCube) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.0, 2000);
    double farthest = 0.0;
    for (std::size_t i = 0; i < part.cloud.size(); ++i) farthest = std::max(farthest, part.cloud.point(i).norm());
    // From the middle of a box with largest side 1: half a side to half the diagonal of the cube.
    EXPECT_TRUE(farthest >= 0.499 && farthest <= 0.8661) << farthest;
  }
}

TEST(MechanicalPart, HasUniformNoiseAcrossItsSurfaces) {
  constexpr double kHalfWidth = 0.01;
  const MechanicalPart part = makeMechanicalPart(2, kHalfWidth);
  double squares = 0.0;
  int counted = 0;
  for (std::size_t i = 0; i < part.cloud.size(); ++i) {
    if (part.surface[i] < 0) continue;
    const double away = distance(part.truth[part.surface[i]], part.cloud.point(i));
    ASSERT_LE(std::abs(away), kHalfWidth + 1e-6);
    squares += away * away;
    ++counted;
  }
  // About 8000 draws: the standard deviation is known to better than 1 %.
  EXPECT_NEAR(std::sqrt(squares / counted), kHalfWidth / std::sqrt(3.0), 0.03 * kHalfWidth);
}

TEST(MechanicalPart, GivesEveryTrueShapeEnoughPointsAndOnlyOnce) {
  for (int seed = 0; seed < kSeeds; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.0, 8096);
    std::vector<int> owned(part.truth.size(), 0);
    int unnamed = 0;
    for (const int surface : part.surface) ++(surface < 0 ? unnamed : owned.at(surface));
    for (const int count : owned) EXPECT_GE(count, kMinPartPoints);
    EXPECT_LT(unnamed, 300) << seed;
    for (std::size_t a = 0; a < part.truth.size(); ++a) {
      const Plane* plane_a = std::get_if<Plane>(&part.truth[a]);
      for (std::size_t b = a + 1; plane_a && b < part.truth.size(); ++b) {
        const Plane* plane_b = std::get_if<Plane>(&part.truth[b]);
        if (!plane_b || plane_a->normal.cross(plane_b->normal).norm() > 1e-6) continue;
        EXPECT_GT(std::abs(distance(*plane_a, plane_b->point)), 1e-6) << "seed " << seed << ": the same plane twice";
      }
    }
  }
}

TEST(MechanicalPart, ShowsEveryKindConvexAndConcave) {
  int convex[kKindCount] = {}, concave[kKindCount] = {};
  for (int seed = 0; seed < 50; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.0, 3000);
    for (std::size_t k = 0; k < part.truth.size(); ++k) {
      ++(part.concave[k] ? concave : convex)[part.truth[k].index()];
    }
  }
  EXPECT_EQ(concave[0], 0);
  for (std::size_t kind = 0; kind < kKindCount; ++kind) EXPECT_GE(convex[kind], 5) << kind;
  for (std::size_t kind = 1; kind < kKindCount; ++kind) EXPECT_GE(concave[kind], 5) << kind;
}

TEST(MechanicalPart, EstimatesNormalsFromTheNoisyPoints) {
  std::vector<double> cosines;
  for (int seed = 0; seed < 6; ++seed) {
    const MechanicalPart part = makeMechanicalPart(seed, 0.005);
    for (std::size_t i = 0; i < part.cloud.size(); ++i) {
      ASSERT_NEAR(part.cloud.normal(i).norm(), 1.0, 1e-5);
      cosines.push_back(part.normals[i].dot(part.cloud.normal(i)));
    }
  }
  std::nth_element(cosines.begin(), cosines.begin() + cosines.size() / 2, cosines.end());
  EXPECT_GT(cosines[cosines.size() / 2], std::cos(8.0 * M_PI / 180.0));
  const auto off = std::count_if(cosines.begin(), cosines.end(), [](double c) { return c < 0.96; });
  EXPECT_GT(off, 0.05 * cosines.size()) << "near edges PCA errs: these are no exact normals";
  EXPECT_LT(off, 0.35 * cosines.size());
}

TEST(MechanicalPart, IsTheSameForTheSameSeedAndTheSamePartAtEveryNoise) {
  const MechanicalPart first = makeMechanicalPart(5, 0.01), again = makeMechanicalPart(5, 0.01);
  EXPECT_EQ(first.cloud.x, again.cloud.x);
  EXPECT_EQ(first.cloud.nz, again.cloud.nz);
  EXPECT_EQ(first.surface, again.surface);
  EXPECT_NE(first.cloud.x, makeMechanicalPart(6, 0.01).cloud.x);
  const MechanicalPart exact = makeMechanicalPart(5, 0.0);
  EXPECT_EQ(first.surface, exact.surface);
  EXPECT_EQ(first.normals, exact.normals);
}

TEST(MechanicalPart, RefusesNumbersOutOfRange) {
  EXPECT_THROW(makeMechanicalPart(1, -0.01), std::invalid_argument);
  EXPECT_THROW(makeMechanicalPart(1, 0.2), std::invalid_argument);
  EXPECT_THROW(makeMechanicalPart(1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(makeMechanicalPart(1, 0.01, 10), std::invalid_argument);
}

}  // namespace
}  // namespace primitect::synthetic::mechanical_part_test
