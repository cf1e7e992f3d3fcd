// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes and cones that go over into another part, and some that only end.
#include "core/bent_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/extent.h"
#include "core/random.h"
#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::bent_ends_test {
namespace {

using test::kDegree;

constexpr double kNoise = 0.0015, kRadius = 0.04;  // m
const Vec3 kFoot(0.1, 0.2, 1.0), kAxis(0.6, 0.0, 0.8);
const Cylinder kTube = {kFoot, kAxis, kRadius};

/// Of the half of a body around the axis that is seen, from this height (m, from the foot) to that one, and within
/// three deviations of the noise of the shape.
SeenPoints seen(const Shape& shape, double low, double high, const std::function<double(double)>& radius_at,
                std::uint64_t seed) {
  Random random(seed);
  const Vec3 x = kAxis.unitOrthogonal(), y = kAxis.cross(x);
  std::vector<Vec3> points;
  for (int i = 0; i < 3000; ++i) {
    const double height = random.uniform(low, high), turn = random.uniform(0.0, M_PI);
    const double radius = radius_at(height) + kNoise * random.gaussian();
    const Vec3 point = kFoot + height * kAxis + radius * (std::cos(turn) * x + std::sin(turn) * y);
    if (std::abs(distance(shape, point)) < 3.0 * kNoise) points.push_back(point);
  }
  return points;
}

/// Where the axis ends, before and after.
struct BothEnds {
  Extent before, after;
  double share;  ///< of the points that is left

  BothEnds(const Shape& shape, const SeenPoints& points) {
    measureToTheEnds(shape, points, before);
    after = before;
    share = endWhereItBends(
        points, [](const Vec3&) { return kNoise; }, shape, after);
  }
  /// m, from the foot; side: 1 where the axis points to.
  static double endOf(const Extent& extent, double side) {
    return (extent.origin - kFoot).dot(kAxis) + 0.5 * side * extent.size.z();
  }
  bool moved() const { return before.size.z() != after.size.z() || before.origin != after.origin; }
};

TEST(BentEnds, LieWhereTheShoulderOfABottleBegins) {
  const double slope = std::tan(30.0 * kDegree);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto bottle = [&](double height) { return kRadius - std::max(0.0, height - 0.1) * slope; };
    const BothEnds ends(kTube, seen(kTube, 0.0, 0.15, bottle, seed));
    EXPECT_GT(BothEnds::endOf(ends.before, 1.0), 0.104) << "or there is nothing to mend";
    EXPECT_NEAR(BothEnds::endOf(ends.after, 1.0), 0.1, 0.003) << seed;
    EXPECT_NEAR(BothEnds::endOf(ends.after, -1.0), 0.0, 0.001) << seed;
    const auto upside_down = [&](double height) { return bottle(0.15 - height); };
    const BothEnds other(kTube, seen(kTube, 0.0, 0.15, upside_down, seed));
    EXPECT_NEAR(BothEnds::endOf(other.after, -1.0), 0.05, 0.003) << seed;
    EXPECT_NEAR(BothEnds::endOf(other.after, 1.0), 0.15, 0.001) << seed;
  }
}

TEST(BentEnds, LieWhereALidBegins) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const double off : {0.0, -kNoise}) {  // of the whole fit
      const auto jar = [off](double height) { return kRadius + off + (height > 0.1 ? 2.5 * kNoise : 0.0); };
      const BothEnds ends(kTube, seen(kTube, 0.0, 0.115, jar, seed));
      EXPECT_NEAR(BothEnds::endOf(ends.after, 1.0), 0.1, 0.003) << seed;
    }
  }
}

TEST(BentEnds, OfAConeLieWhereItsTubeBegins) {
  const double half_angle = 30.0 * kDegree, slope = std::tan(half_angle);
  const Cone cone = {kFoot, kAxis, half_angle};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto funnel = [&](double height) { return slope * std::max(height, 0.04); };
    const BothEnds ends(cone, seen(cone, 0.02, 0.12, funnel, seed));
    EXPECT_LT(BothEnds::endOf(ends.before, -1.0), 0.036) << "or there is nothing to mend";
    EXPECT_NEAR(BothEnds::endOf(ends.after, -1.0), 0.04, 0.004) << seed;
    EXPECT_NEAR(ends.after.radius_small, BothEnds::endOf(ends.after, -1.0) * slope, 1e-9);
    EXPECT_EQ(ends.after.radius, ends.before.radius);
  }
}

TEST(BentEnds, StayWhereNothingBends) {
  const Cone cone = {kFoot, kAxis, 30.0 * kDegree};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto tube = [](double) { return kRadius; };
    EXPECT_FALSE(BothEnds(kTube, seen(kTube, 0.0, 0.12, tube, seed)).moved()) << seed;
    const auto on_cone = [&](double height) { return std::tan(cone.half_angle) * height; };
    EXPECT_FALSE(BothEnds(cone, seen(cone, 0.0, 0.12, on_cone, seed)).moved()) << seed;
    const auto step = [](double height) { return kRadius + (height > 0.1 ? kNoise : 0.0); };
    EXPECT_FALSE(BothEnds(kTube, seen(kTube, 0.0, 0.12, step, seed)).moved()) << seed << ": less than two deviations";
  }
}

TEST(BentEnds, StayWhereTheWholeShapeDoesNotFit) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto step = [](double height) { return kRadius + (height > 0.08 ? 2.5 * kNoise : 0.0); };
    EXPECT_FALSE(BothEnds(kTube, seen(kTube, 0.0, 0.12, step, seed)).moved()) << seed << ": a third of it";
    // Two cans, one on the other, for which one leaning tube was taken.
    const auto stacked = [](double height) { return kRadius + 2.0 * kNoise * (std::fmod(height, 0.06) / 0.03 - 1.0); };
    EXPECT_FALSE(BothEnds(kTube, seen(kTube, 0.0, 0.12, stacked, seed)).moved()) << seed;
  }
}

TEST(BentEnds, OfTheWideSideOfAConeTakeItsRadiusAlong) {
  const Cone cone = {kFoot, kAxis, 30.0 * kDegree};
  const double slope = std::tan(cone.half_angle);
  const auto skirt = [&](double height) { return slope * height + std::max(0.0, height - 0.1); };
  const BothEnds ends(cone, seen(cone, 0.02, 0.13, skirt, 1));
  EXPECT_NEAR(BothEnds::endOf(ends.after, 1.0), 0.1, 0.003);
  EXPECT_NEAR(ends.after.radius, BothEnds::endOf(ends.after, 1.0) * slope, 1e-9);
  EXPECT_EQ(ends.after.radius_small, ends.before.radius_small);
}

TEST(BentEnds, ChangeNothingOfOtherShapesOrWithoutPoints) {
  const auto noise = [](const Vec3&) { return kNoise; };
  const auto lid = [](double height) { return kRadius + (height > 0.1 ? 2.5 * kNoise : 0.0); };
  const SeenPoints jar = seen(kTube, 0.0, 0.115, lid, 1);
  Extent before;
  measureToTheEnds(kTube, jar, before);
  Extent ball = before, nothing = before, point = before;
  endWhereItBends(jar, noise, Sphere{Vec3(0, 0, 2), 1.0}, ball);
  endWhereItBends(SeenPoints(), noise, kTube, nothing);
  point.size.z() = 0.0;
  endWhereItBends(jar, noise, kTube, point);
  EXPECT_EQ(ball.size, before.size);
  EXPECT_EQ(nothing.size, before.size);
  EXPECT_EQ(point.size.z(), 0.0);
}

TEST(BentEnds, TellTheShareOfThePointsBetweenThem) {
  const auto lid = [](double height) { return kRadius + (height > 0.1 ? 2.5 * kNoise : 0.0); };
  // Denser at the lid.
  std::vector<Vec3> points;
  for (const double low : {0.0, 0.08}) {
    const SeenPoints some = seen(kTube, low, 0.115, lid, 1);
    for (std::size_t k = 0; k < some.size(); ++k) points.push_back(some.point(k));
  }
  double below = 0.0;
  for (const Vec3& point : points) below += (point - kFoot).dot(kAxis) < 0.1 ? 1.0 : 0.0;
  EXPECT_NEAR(BothEnds(kTube, points).share, below / static_cast<double>(points.size()), 0.03);
  const auto straight = [](double) { return kRadius; };
  EXPECT_EQ(BothEnds(kTube, seen(kTube, 0.0, 0.115, straight, 1)).share, 1.0);
}

TEST(BentEnds, StayWhereThereIsNothingBetweenThem) {
  const auto off = [](double) { return kRadius + 2.5 * kNoise; };
  SeenPoints rings = seen(kTube, 0.0, 0.02, off, 1);
  const Eigen::Vector3f along = (0.1 * kAxis).cast<float>();
  for (std::size_t k = 0; k < rings.size(); k += 2) {
    rings.x[k] += along.x(), rings.y[k] += along.y(), rings.z[k] += along.z();
  }
  const BothEnds ends(kTube, rings);
  EXPECT_FALSE(ends.moved());
  EXPECT_EQ(ends.share, 1.0);
}

/// How much too long (m) the bodies of three bottles on a table are, as a depth camera sees them; 1: not found.
std::vector<double> bottlesTooLong(std::uint64_t seed) {
  constexpr double kBody = 0.12, kNeck = 0.012, kShoulder = 35.0 * kDegree;
  const double begin = kNeck / std::tan(kShoulder), end = kRadius / std::tan(kShoulder);
  const Eigen::Isometry3d table = test::tableBeforeCamera(0.9, 35.0 * kDegree);
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  std::vector<Vec3> middles;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Isometry3d foot = table * Eigen::Translation3d(0.2 * (k - 1), 0.05 * k, 0.0);
    const std::string name = std::to_string(k);
    world.add("body" + name, synthetic::Rod{kRadius, 0.5 * kBody}, foot * Eigen::Translation3d(0.0, 0.0, 0.5 * kBody));
    const Eigen::Isometry3d apex =
        foot * Eigen::Translation3d(0.0, 0.0, kBody + end) * Eigen::AngleAxisd(M_PI, Vec3::UnitX());
    world.add("shoulder" + name, synthetic::Frustum{kShoulder, begin, end}, apex);
    middles.push_back(foot * Vec3(0.0, 0.0, 0.5 * kBody));
  }
  std::vector<double> too_long(middles.size(), 1.0);
  Detector detector{Params()};
  for (const Detection& item : detector.detect(test::renderedCloud(world, {}, seed)).items) {
    if (kindOf(item.shape) != Kind::cylinder) continue;
    for (std::size_t k = 0; k < middles.size(); ++k) {
      if ((item.extent.origin - middles[k]).norm() < 0.03) too_long[k] = item.extent.size.z() - kBody;
    }
  }
  return too_long;
}

/// One in thirty is 7.9 mm too long. Without it those that are 7 to 11 mm too long are two in five of them.
TEST(BentEnds, OfBottlesOnATableLieNearTheirShoulders) {
  int longer = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const double too_long : bottlesTooLong(seed)) {
      longer += too_long > 0.0075 ? 1 : 0;
      EXPECT_LT(too_long, 0.009) << seed;
      EXPECT_GT(too_long, -0.005) << seed;
    }
  }
  EXPECT_LE(longer, 1);
}

}  // namespace
}  // namespace primitect::bent_ends_test
