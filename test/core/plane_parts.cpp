// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts of a plane's samples by touch and by height.
#include "core/plane_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "test/support/exact_shapes.h"

namespace primitect::plane_parts_test {
namespace {

using test::SurfacePoint;

constexpr std::size_t kLeast = 25;

/// Two squares of 10 cm that face the sensor, beside each other with a gap of 2 cm, the second farther by `step` (m).
Samples twoTops(int count_each, double step, Random& random) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count_each; ++i)
    points.push_back({Vec3{random.uniform(-0.11, -0.01), random.uniform(-0.05, 0.05), 1.0}, -Vec3::UnitZ()});
  for (int i = 0; i < count_each; ++i)
    points.push_back({Vec3{random.uniform(0.01, 0.11), random.uniform(-0.05, 0.05), 1.0 + step}, -Vec3::UnitZ()});
  return test::samplesOf(points);
}

/// Through the middles of both tops.
Plane leaningOver(double step) {
  const double tilt = std::atan2(step, 0.12);
  return {Vec3(0, 0, 1.0 + 0.5 * step), Vec3(std::sin(tilt), 0, -std::cos(tilt))};
}

TEST(StepParts, ArePartsAtTheTwoHeightsThatAPlaneLeansOver) {
  Random random(71);
  const Samples samples = twoTops(60, 0.01, random);
  const SampleParts parts = stepParts(samples, leaningOver(0.01), test::allOf(samples), kLeast);
  ASSERT_EQ(parts.size(), 2u);
  // Along the mean normal, towards the sensor, the farther top is the lower one.
  for (const std::uint32_t i : parts[0]) EXPECT_GE(i, 60u);
  for (const std::uint32_t i : parts[1]) EXPECT_LT(i, 60u);
  EXPECT_EQ(parts[0].size() + parts[1].size(), samples.size());
}

TEST(StepParts, AreNoneWhereThePlaneLiesAsItsSamplesDo) {
  Random random(72);
  const Samples samples = twoTops(60, 0.01, random);
  const Plane between = {Vec3(0, 0, 1.005), -Vec3::UnitZ()};
  EXPECT_TRUE(stepParts(samples, between, test::allOf(samples), kLeast).empty());
}

TEST(StepParts, AreNoneWhereTwoWouldBeTooSmall) {
  Random random(73);
  const Samples samples = twoTops(24, 0.01, random);
  EXPECT_TRUE(stepParts(samples, leaningOver(0.01), test::allOf(samples), kLeast).empty());
}

TEST(SeparateParts, AreThoseThatDoNotTouch) {
  Random random(74);
  // 400 samples on 100 cm^2 are 5 mm apart: the gap is four times as wide.
  const Samples samples = twoTops(400, 0.0, random);
  SampleGraph graph;
  graph.build(samples);
  const SampleParts parts = separateParts(test::allOf(samples), kLeast, graph);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].size(), 400u);
  EXPECT_EQ(parts[1].front(), 400u);
}

TEST(SeparateParts, AreNoneWhereAllTouch) {
  Random random(75);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  const Samples samples = test::samplesOf(test::patchOf(plane, 500, 0.1, random));
  SampleGraph graph;
  graph.build(samples);
  EXPECT_TRUE(separateParts(test::allOf(samples), kLeast, graph).empty());
}

/// With this noise (m), which the points themselves do not have.
Samples withNoise(double sigma, Samples samples) {
  applyNoise(NoiseModel{sigma}, samples);
  return samples;
}

List<std::uint32_t> range(std::uint32_t begin, std::uint32_t end) {
  List<std::uint32_t> indices;
  for (std::uint32_t i = begin; i < end; ++i) indices.push_back(i);
  return indices;
}

/// Of two tops of 120 samples each.
SampleParts groupsOfTops(double step, std::uint64_t seed) {
  Random random(seed);
  return coplanarGroups(withNoise(0.002, twoTops(120, step, random)), {range(0, 120), range(120, 240)});
}

TEST(CoplanarGroups, AreTwoTopsThatATiltedPlaneWouldLeadOver) {
  // The tilted plane is at most 2.6 mm off, 1.3 times the noise, where three times the noise make an inlier.
  const SampleParts groups = groupsOfTops(0.006, 76);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0], range(0, 120));
  EXPECT_EQ(groups[1], range(120, 240));
}

TEST(CoplanarGroups, AreOneWhereTheStepIsNoMoreThanTheWavesOfADepthCamera) {
  const SampleParts groups = groupsOfTops(0.001, 77);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0], range(0, 240));
}

TEST(CoplanarGroups, AreTwoTopsThatATiltedPlaneLiesAskewTo) {
  // 1.4 mm off at most, less than the noise; but 1.6 deg off all normals, each of which is good to 1.5.
  Random random(79);
  Samples samples = withNoise(0.002, twoTops(120, 0.0034, random));
  const SampleParts parts = {range(0, 120), range(120, 240)};
  EXPECT_EQ(coplanarGroups(samples, parts).size(), 1u);
  std::fill(samples.normal_sigma.begin(), samples.normal_sigma.end(), 0.026f);
  EXPECT_EQ(coplanarGroups(samples, parts).size(), 2u);
}

/// Two tops of 120 samples each, one as much farther (m) than the other, with normals that are good to so much (rad).
struct Tops {
  double step, normal_sigma;
  double gap = 0.0;   ///< m, more than 2 cm
  double turn = 0.0;  ///< rad, of both about the line between them

  std::size_t groups(const std::optional<Vec3>& level) const {
    Random random(80);
    Samples samples = withNoise(0.002, twoTops(120, step, random));
    const Eigen::AngleAxisd rotation(turn, Vec3::UnitX());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const Vec3 aside(i < 120 ? 0.0 : gap, 0, 0), middle(0, 0, 1);
      const Vec3 p = middle + rotation * (samples.point(i) + aside - middle), n = rotation * samples.normal(i);
      samples.x[i] = static_cast<float>(p.x()), samples.y[i] = static_cast<float>(p.y());
      samples.z[i] = static_cast<float>(p.z());
      samples.nx[i] = static_cast<float>(n.x()), samples.ny[i] = static_cast<float>(n.y());
      samples.nz[i] = static_cast<float>(n.z());
    }
    std::fill(samples.normal_sigma.begin(), samples.normal_sigma.end(), static_cast<float>(normal_sigma));
    return coplanarGroups(samples, {range(0, 120), range(120, 240)}, level).size();
  }
};

const Vec3 kLevel = -Vec3::UnitZ();

TEST(CoplanarGroups, AreTwoTopsThatLieAsWhatTheyStandOn) {
  const Tops tops = {0.0042, 0.05};
  EXPECT_EQ(tops.groups(std::nullopt), 1u);  // too little to tell by themselves
  EXPECT_EQ(tops.groups(kLevel), 2u);
}

TEST(CoplanarGroups, AreOneWhereLevelTopsAreAtOneHeight) {
  // By its normals alone no plane leads over both; what the level may be off does, half a metre away.
  const Tops tops = {0.0035, 0.003, 0.4};
  EXPECT_EQ(tops.groups(std::nullopt), 2u);
  EXPECT_EQ(tops.groups(kLevel), 1u);
}

TEST(CoplanarGroups, AreJudgedByThemselvesWhereTheyDoNotLieLevel) {
  EXPECT_EQ((Tops{0.0042, 0.05, 0.0, 0.3}).groups(kLevel), 1u);
  EXPECT_EQ((Tops{0.0035, 0.003, 0.4, 0.3}).groups(kLevel), 2u);
}

TEST(CoplanarGroups, JoinPartsOfOneHeightAcrossThatOfAnother) {
  Random random(78);
  Samples samples = twoTops(120, 0.008, random);
  // A third top, on the far side of the second one, as high as the first.
  for (int i = 0; i < 120; ++i) {
    const Vec3 point{random.uniform(0.13, 0.23), random.uniform(-0.05, 0.05), 1.0};
    samples.append(test::samplesOf({{point, -Vec3::UnitZ()}}));
  }
  samples = withNoise(0.002, samples);
  const SampleParts groups = coplanarGroups(samples, {range(0, 120), range(120, 240), range(240, 360)});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].size(), 240u);
  EXPECT_EQ(groups[1], range(120, 240));
}

TEST(PlaneParts, OfAFewHundredthsNeedNoCloserLookAndSupportNothing) {
  EXPECT_FALSE(isLargePlane(80, 1000));
  EXPECT_TRUE(isLargePlane(81, 1000));
  EXPECT_FALSE(maySupport(100, 1000));
  EXPECT_TRUE(maySupport(101, 1000));
}

}  // namespace
}  // namespace primitect::plane_parts_test
