// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cups that taper by a few degrees, of which a camera sees one side: cones, or cylinders that lean along that side.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/extent.h"
#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::tapered_cups_test {
namespace {

using test::kDegree;

struct Setting {
  Params params;
  synthetic::FrameParams frame;
  /// How the camera looks. Level it sees neither the table nor the tops: nothing tells what stands upright.
  double down = 35.0 * kDegree;
  double lean = 0.0;  ///< rad, of all of them, towards the camera
};

Eigen::Isometry3d tableAt(double distance, const Setting& setting = {}) {
  return test::tableBeforeCamera(distance, setting.down);
}

/// Three cups of 12 cm on a table, 8 cm wide at half of their height; every other one stands on its rim.
std::vector<Detection> cupsOf(double half_angle_deg, std::uint64_t seed, double size = 1.0, double distance = 0.8,
                              const Setting& setting = {}) {
  const double radius = 0.04 * size, height = 0.12 * size;
  const Eigen::Isometry3d table = tableAt(distance, setting);
  const double half_angle = half_angle_deg * kDegree;
  const double middle = radius / std::tan(half_angle), begin = middle - 0.5 * height, end = middle + 0.5 * height;
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  for (int k = 0; k < 3; ++k) {
    const bool on_rim = (seed + static_cast<std::uint64_t>(k)) % 2 == 0;
    const Eigen::Isometry3d place = table * Eigen::Translation3d(0.2 * (k - 1), 0.05 * k, 0.5 * height) *
                                    Eigen::AngleAxisd((on_rim ? M_PI : 0.0) + setting.lean, Vec3::UnitX()) *
                                    Eigen::Translation3d(0.0, 0.0, -middle);
    world.add("cup" + std::to_string(k), synthetic::Frustum{half_angle, begin, end}, place);
  }
  std::vector<Detection> cups;
  Detector detector{setting.params};
  for (const Detection& item : detector.detect(test::renderedCloud(world, setting.frame, seed)).items) {
    if (hasAxis(kindOf(item.shape))) cups.push_back(item);
  }
  return cups;
}

/// As cylinders their axes are off by as much as they taper, with a confidence of .99.
TEST(TaperedCups, AreConesThatStandUpright) {
  const Vec3 up = tableAt(0.8).linear().col(2);
  int cones = 0;
  for (const double half_angle_deg : {5.0, 6.0, 8.0}) {
    for (const std::uint64_t seed : {1, 2}) {
      const std::vector<Detection> cups = cupsOf(half_angle_deg, seed);
      ASSERT_EQ(cups.size(), 3u) << half_angle_deg;
      for (const Detection& cup : cups) {
        const Cone* cone = std::get_if<Cone>(&cup.shape);
        if (!cone) continue;
        ++cones;
        EXPECT_NEAR(cone->half_angle, half_angle_deg * kDegree, 1.0 * kDegree) << seed;
        EXPECT_GT(std::abs(cone->axis.dot(up)), std::cos(1.0 * kDegree)) << half_angle_deg << " " << seed;
      }
    }
  }
  EXPECT_GE(cones, 17) << "of 18";
}

void expectCylinders(double half_angle_deg, const std::optional<Kind>& rival) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<Detection> cups = cupsOf(half_angle_deg, seed);
    ASSERT_EQ(cups.size(), 3u);
    for (const Detection& cup : cups) {
      EXPECT_EQ(kindOf(cup.shape), Kind::cylinder);
      EXPECT_EQ(cup.rival, rival);
    }
  }
}

TEST(TaperedCups, AreConesWhereTheyAreSmall) {
  int cones = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const Detection& cup : cupsOf(6.0, seed, 0.6, 1.0)) cones += kindOf(cup.shape) == Kind::cone ? 1 : 0;
  }
  EXPECT_GE(cones, 25) << "of 30; 20 where an angle costs .003 of the points";
}

/// Of 12 cups 1.8 m away, how many are called cylinders, doubted because they may be cones.
int doubtedCylinders(double half_angle_deg) {
  constexpr double kFar = 1.8, kTrustInEither = 0.7;
  Setting level;
  level.down = 0.0;
  int doubted = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    for (const Detection& cup : cupsOf(half_angle_deg, seed, 1.0, kFar, level)) {
      const bool either = kindOf(cup.shape) == Kind::cylinder && cup.rival == Kind::cone;
      doubted += either && cup.confidence <= kTrustInEither ? 1 : 0;
    }
  }
  return doubted;
}

TEST(TaperedCups, ThatAreTooFarToTellAreDoubted) {
  EXPECT_GE(doubtedCylinders(4.5), 5);
  EXPECT_LE(doubtedCylinders(0.05), 2) << "they do not taper";
}

/// Their wide ends have 48 mm; of cylinders of 40 mm through their middle none takes their place.
TEST(TaperedCups, AreNothingWhereTheirWideEndIsAboveTheLargestRadius) {
  Setting setting;
  for (const double max_radius : {0.052, 0.044}) {
    setting.params.max_radius = max_radius;
    EXPECT_EQ(cupsOf(8.0, 1, 1.0, 0.8, setting).size(), max_radius > 0.05 ? 3u : 0u) << max_radius;
  }
}

TEST(TaperedCups, AreCylindersWithAConeForRivalBelowTheLeastHalfAngle) { expectCylinders(3.0, Kind::cone); }

/// As cones their points do not determine all of them: without falling back to the cylinder 51 are left.
TEST(TaperedCups, AreNotLostWhereTheyAreSmallAndFar) {
  constexpr std::uint64_t kFew = 3;  // seeds that are looked at both ways
  Setting without;
  without.params.left_out.add(Step::undetermined_cones);
  std::size_t found = 0, in_few = 0, in_few_without = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const std::size_t cups = cupsOf(7.0, seed, 0.6, 1.3).size();
    found += cups;
    if (seed > kFew) continue;
    in_few += cups;
    in_few_without += cupsOf(7.0, seed, 0.6, 1.3, without).size();
  }
  EXPECT_GE(found, 57u) << "of 90, of which a quarter has too few points";
  EXPECT_GT(in_few, in_few_without);
}

TEST(TaperedCups, AreCylindersWithAConeForRivalWhereFewPointsAreSeen) {
  Setting level;
  level.down = 0.0;
  int cylinders = 0, doubtful = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Detection& cup : cupsOf(5.0, seed, 0.7, 1.5, level)) {
      if (kindOf(cup.shape) != Kind::cylinder) continue;
      ++cylinders;
      doubtful += cup.rival == Kind::cone ? 1 : 0;
    }
  }
  EXPECT_GE(cylinders, 20);
  EXPECT_GE(doubtful, 0.82 * cylinders);
}

/// Noise that pixels share, as that of real cameras, turns fits by degrees.
TEST(TaperedCups, AreConesThatStandUprightWithSharedNoise) {
  Setting setting;
  setting.frame.noise.grain = 5;
  const Vec3 up = tableAt(1.2).linear().col(2);
  int cones = 0, near = 0, cans = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const Detection& cup : cupsOf(6.0, seed, 0.7, 1.2, setting)) {
      const Cone* cone = std::get_if<Cone>(&cup.shape);
      if (!cone) continue;
      ++cones;
      EXPECT_GT(std::abs(cone->axis.dot(up)), std::cos(8.0 * kDegree)) << seed;
      near += std::abs(cone->half_angle - 6.0 * kDegree) < 2.0 * kDegree ? 1 : 0;
    }
    for (const Detection& can : cupsOf(0.05, seed, 0.7, 1.2, setting)) {
      cans += kindOf(can.shape) == Kind::cylinder ? 1 : 0;
    }
  }
  EXPECT_GE(cones, 22) << "of 24; 8 where cylinders that lean by as much are not asked whether they stand on something";
  EXPECT_GE(near, 18) << "half angles";
  EXPECT_GE(cans, 23) << "of 24";
}

/// What leans must not be made upright where its points tell.
TEST(TaperedCups, AreNotWhereCansLean) {
  for (const double lean : {-8.0, -6.0, 6.0, 8.0}) {
    Setting setting;
    setting.lean = lean * kDegree;
    const Vec3 axis = Eigen::AngleAxisd(setting.lean, tableAt(0.8).linear().col(0)) * tableAt(0.8).linear().col(2);
    int leaning = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      for (const Detection& can : cupsOf(0.05, seed, 1.0, 0.8, setting)) {
        const Cylinder* cylinder = std::get_if<Cylinder>(&can.shape);
        leaning += cylinder && std::abs(cylinder->axis.dot(axis)) > std::cos(2.0 * kDegree) ? 1 : 0;
      }
    }
    EXPECT_GE(leaning, 13) << "of 15, by " << lean << " deg";
  }
}

TEST(TaperedCups, AreNotWhereCansStandStraight) { expectCylinders(0.05, std::nullopt); }

}  // namespace
}  // namespace primitect::tapered_cups_test
