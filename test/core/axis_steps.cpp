// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where samples of one tube step from one radius to another.
#include "core/axis_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "test/support/exact_shapes.h"

namespace primitect::axis_steps_test {
namespace {

constexpr std::size_t kLeast = 25;
constexpr double kSigma = 0.002;                              // m, of the samples
const Cylinder kTube = {Vec3(0, 0, 1), Vec3::UnitY(), 0.04};  // 0.2 m long around its point

/// Samples of the seen half of the tube, with this noise (m); above the middle it is wider by `step` (m).
Samples tubeWithStep(int count, double step, double noise, Random& random) {
  Samples samples;
  for (int i = 0; i < count; ++i) {
    const double height = random.uniform(-0.1, 0.1), angle = random.uniform(-1.2, 1.2);
    const double radius = kTube.radius + (height > 0.0 ? step : 0.0) + noise * random.gaussian();
    const Vec3 out(std::sin(angle), 0.0, -std::cos(angle));
    test::append(samples, {kTube.point + height * kTube.axis + radius * out, out});
  }
  samples.sigma.assign(samples.size(), static_cast<float>(kSigma));
  return samples;
}

/// Of these parts, whether each has the samples of one side of the middle, but for what one of 32 slices holds.
void expectSides(const Samples& samples, const SampleParts& parts) {
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].size() + parts[1].size(), samples.size());
  for (const std::uint32_t i : parts[0]) EXPECT_LT(samples.y[i], 0.2 / 32);
  for (const std::uint32_t i : parts[1]) EXPECT_GT(samples.y[i], -0.2 / 32);
}

TEST(AxisSteps, PartSamplesOfTwoRadiiOnOneAxis) {
  Random random(81);
  for (const double step : {0.006, -0.006}) {
    const Samples samples = tubeWithStep(200, step, kSigma, random);
    Cylinder between = kTube;
    between.radius += 0.5 * step;
    expectSides(samples, axisStepParts(samples, between, test::allOf(samples), kLeast));
  }
}

TEST(AxisSteps, AreSeenBehindALeaningTubeAndACone) {
  Random random(82);
  const double step = 0.006;
  const Samples samples = tubeWithStep(300, step, kSigma, random);
  // As least squares lean: of the step of +-3 mm, 1.5 times that at the ends.
  const double slope = 1.5 * 0.5 * step / 0.1;
  Cylinder leaning = kTube;
  leaning.radius += 0.5 * step;
  leaning.axis = Vec3(0.0, 1.0, -slope).normalized();
  expectSides(samples, axisStepParts(samples, leaning, test::allOf(samples), kLeast));
  const double half_angle = std::atan(slope);
  const Cone cone = {kTube.point - (kTube.radius + 0.5 * step) / slope * kTube.axis, kTube.axis, half_angle};
  expectSides(samples, axisStepParts(samples, cone, test::allOf(samples), kLeast));
}

TEST(AxisSteps, AreNoneInATubeWhereverItLeans) {
  Random random(83);
  for (int time = 0; time < 50; ++time) {
    const Samples samples = tubeWithStep(200, 0.0, kSigma, random);
    Cylinder leaning = kTube;
    leaning.axis = Vec3(0.0, 1.0, random.uniform(-0.05, 0.05)).normalized();
    EXPECT_TRUE(axisStepParts(samples, leaning, test::allOf(samples), kLeast).empty());
  }
}

/// Samples of the seen half of a barrel, wider by `bulge` (m) in its middle.
Samples barrel(int count, double bulge, Random& random) {
  Samples samples;
  for (int i = 0; i < count; ++i) {
    const double height = random.uniform(-0.1, 0.1), angle = random.uniform(-1.2, 1.2), share = height / 0.1;
    const double radius = kTube.radius + bulge * (1.0 - share * share) + kSigma * random.gaussian();
    const Vec3 out(std::sin(angle), 0.0, -std::cos(angle));
    test::append(samples, {kTube.point + height * kTube.axis + radius * out, out});
  }
  samples.sigma.assign(samples.size(), static_cast<float>(kSigma));
  return samples;
}

TEST(AxisSteps, AreNoneInABarrel) {
  Random random(87);
  int parted = 0;
  for (int time = 0; time < 100; ++time) {
    const double bulge = 0.002 * (1 + time % 5);
    Cylinder between = kTube;
    between.radius += 0.67 * bulge;
    const Samples samples = barrel(200, bulge, random);
    parted += axisStepParts(samples, between, test::allOf(samples), kLeast).empty() ? 0 : 1;
  }
  EXPECT_LE(parted, 8) << "of 100; where bends are not asked for, nearly all";
}

TEST(AxisSteps, AreNoneBelowTheNoise) {
  Random random(84);
  const Samples samples = tubeWithStep(2000, 0.6 * kSigma, 0.1 * kSigma, random);
  EXPECT_TRUE(axisStepParts(samples, kTube, test::allOf(samples), kLeast).empty());
}

TEST(AxisSteps, LeaveEnoughOnEitherSide) {
  Random random(85);
  const Samples samples = tubeWithStep(200, 0.006, kSigma, random);
  List<std::uint32_t> few_above;
  std::size_t above = 0;
  for (const std::uint32_t i : test::allOf(samples)) {
    if (samples.y[i] < 0.0f || ++above < kLeast) few_above.push_back(i);
  }
  EXPECT_TRUE(axisStepParts(samples, kTube, few_above, kLeast).empty()) << "the part above would be too small";
  const SampleParts parts = axisStepParts(samples, kTube, few_above, kLeast / 2);
  expectSides(samples.part(few_above), [&] {
    SampleParts places(parts.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      for (const std::uint32_t i : parts[k]) {
        places[k].push_back(
            static_cast<std::uint32_t>(std::find(few_above.begin(), few_above.end(), i) - few_above.begin()));
      }
    }
    return places;
  }());
}

TEST(AxisSteps, AreNoneWithoutAnAxisOrALength) {
  Random random(86);
  const Samples samples = tubeWithStep(200, 0.006, kSigma, random);
  const List<std::uint32_t> all = test::allOf(samples);
  EXPECT_TRUE(axisStepParts(samples, Plane{Vec3(0, 0, 1), -Vec3::UnitZ()}, all, kLeast).empty());
  EXPECT_TRUE(axisStepParts(samples, Sphere{Vec3(0, 0, 1), 0.04}, all, kLeast).empty());
  // Two rings at one place along the axis.
  Samples ring;
  for (int i = 0; i < 100; ++i) {
    test::append(ring, test::pointOn(kTube, 0.0, random.uniform(0.0, 6.0)));
    if (i % 2 == 0) ring.x.back() *= 1.2f;
  }
  ring.sigma.assign(ring.size(), static_cast<float>(kSigma));
  EXPECT_TRUE(axisStepParts(ring, kTube, test::allOf(ring), kLeast).empty());
  EXPECT_TRUE(axisStepParts(samples, kTube, {}, kLeast).empty());
}

}  // namespace
}  // namespace primitect::axis_steps_test
