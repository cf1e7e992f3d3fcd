// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Every kernel that this machine can run casts the votes of the readable one.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "core/accumulators.h"
#include "core/sample_boxes.h"
#include "test/support/exact_shapes.h"
#include "test/support/noisy_points.h"

namespace primitect::kernels_agree_test {
namespace {

using kernels::Kernels;
using test::SurfacePoint;

constexpr double kDiameter = 2.0;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The votes of one reference, all kinds and both sides, a number for each bin.
struct Votes {
  std::vector<float> bins;
  float plane = 0.0f;
  std::vector<float> most, total;

  double mass() const {
    double sum = plane;
    for (const float votes : bins) sum += votes;
    return sum;
  }
  bool operator==(const Votes& other) const {
    return bins == other.bins && plane == other.plane && most == other.most && total == other.total;
  }
};

Params everything(const std::string& preset = "paper") {
  Params params = presetParams(preset);
  params.convexity = "both";
  params.convex_planes = false;
  return params;
}

Votes votesOf(const Kernels& kernel, const Samples& samples, std::size_t reference, const Params& params,
              bool with_boxes = true) {
  Accumulators accumulators(params);
  accumulators.prepare(params.radius_bin * kDiameter, samples.size());
  SampleBoxes boxes;
  boxes.enclose(samples);
  const kernels::Boxes box_view = boxes.view();
  kernels::Samples view = samples.view();
  if (with_boxes) view.boxes = &box_view;
  kernels::Accumulators& a = accumulators.bins();
  kernel.vote(referenceAt(samples, reference), view, votingRules(params, kDiameter), a);
  Votes votes;
  votes.plane = a.plane;
  for (const kernels::CurvedBins* side : {&a.convex, &a.concave}) {
    const std::size_t row = a.radius_stride;
    const auto add = [&](const kernels::Bins& kind, std::size_t rows) {
      if (kind.votes) votes.bins.insert(votes.bins.end(), kind.votes, kind.votes + rows * row);
      votes.most.push_back(kind.most);
      votes.total.push_back(kind.total);
      if (kind.most > 0.0f) {
        EXPECT_EQ(kind.votes[kind.strongest], kind.most);
      }
    };
    add(side->sphere, 1);
    add(side->cylinder, a.phi_bins);
    add(side->cone, AxisBall(params.angle_bin_deg * M_PI / 180.0).binCount());
  }
  return votes;
}

/// Noisy points of all four kinds, seen from either side, around one place, and others without any order.
Samples clutter(std::size_t count, Random& random) {
  const Sphere sphere = {Vec3(0.0, 0.0, 1.0), 0.12};
  const Cylinder cylinder = {Vec3(0.0, 0.0, 1.1), Vec3(0.2, 1.0, 0.1).normalized(), 0.1};
  const Cone cone = {Vec3(0.0, -0.1, 1.0), Vec3(0.0, 1.0, 0.2).normalized(), 0.4};
  const Plane plane = {Vec3(0.0, 0.0, 1.0), Vec3(0.1, 0.2, -1.0).normalized()};
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    SurfacePoint p = {test::randomPoint(random, 0.2) + Vec3::UnitZ(), test::randomDirection(random)};
    if (i % 5 == 1) p = test::pointOn(sphere, test::randomDirection(random));
    if (i % 5 == 2) p = test::pointOn(cylinder, {random.uniform(-0.2, 0.2), random.uniform(0.0, 6.3)});
    if (i % 5 == 3) p = test::pointOn(cone, {random.uniform(0.05, 0.4), random.uniform(0.0, 6.3)});
    if (i % 5 == 4) p = test::pointOn(plane, {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)});
    if (i % 2 == 1) p.normal = -p.normal;
    points.push_back(p);
  }
  return test::samplesOf(test::measured(points, 0.002, 0.05, random));
}

/// Features are rounded alike. The rest is not: a pair whose AS or VT lies within rounding (1e-6) of its threshold, one
/// in many thousands, may vote in one kernel and not in the other. Its weight is then nearly 0 with spreading, but 1
/// without.
void expectSame(const Votes& expected, const Votes& found, double different_votes, const std::string& what) {
  ASSERT_EQ(found.bins.size(), expected.bins.size()) << what;
  EXPECT_NEAR(found.plane, expected.plane, 1e-3 + 1e-3 * expected.plane) << what;
  double difference = 0.0;
  for (std::size_t i = 0; i < expected.bins.size(); ++i) difference += std::abs(found.bins[i] - expected.bins[i]);
  // Weights within 1e-4 of each other; acos of floats near 1, in scalar.cpp, is off by up to 4e-4 rad of the 10 deg.
  EXPECT_LE(difference, 2e-3 * expected.mass() + different_votes) << what;
  for (std::size_t k = 0; k < expected.most.size(); ++k) {
    EXPECT_NEAR(found.most[k], expected.most[k], 1e-2 + 2e-3 * expected.most[k] + different_votes) << what;
    EXPECT_NEAR(found.total[k], expected.total[k], 1e-2 + 2e-3 * expected.total[k] + different_votes) << what;
  }
}

class EachKernel : public ::testing::TestWithParam<const Kernels*> {
 protected:
  const Kernels& kernel() const { return *GetParam(); }

  /// The scalar one is what the others are compared with. By its name: of what lies in a library a program may have a copy.
  bool isOther() const { return std::string(kernel().name) != kernels::kScalar.name; }

  void expectSameVotes(const Samples& samples, const Params& params, double different_votes, const std::string& what,
                       std::size_t references = 20) {
    const std::size_t step = samples.size() / references + 1;
    double mass = 0.0;
    for (std::size_t reference = 0; reference < samples.size(); reference += step) {
      if (!samples.hasNormal(reference)) continue;
      const Votes expected = votesOf(kernels::kScalar, samples, reference, params);
      if (isOther()) {
        expectSame(expected, votesOf(kernel(), samples, reference, params), different_votes, what);
      }
      mass += expected.mass();
    }
    voted_ = mass > 0.0;
  }

  bool voted_ = false;
};

TEST_P(EachKernel, CastsTheVotesOfTheScalarOneOnClutter) {
  for (const char* preset : {"paper", "default"}) {
    Random random(41);
    expectSameVotes(clutter(2047, random), everything(preset), 0.0, preset);
    EXPECT_TRUE(voted_);
  }
}

TEST_P(EachKernel, CastsTheSameVotesForAnyNumberOfSamples) {
  for (const std::size_t count : {1, 2, 7, 8, 9, 15, 16, 17, 31, 33, 127, 128, 129, 300}) {
    Random random(42 + count);
    expectSameVotes(clutter(count, random), everything(), 0.0, std::to_string(count));
    EXPECT_EQ(voted_, count > 1);
  }
}

TEST_P(EachKernel, CastsNoVotesForNoSamples) {
  Random random(43);
  const Samples one = clutter(1, random);
  Accumulators accumulators(everything());
  accumulators.prepare(0.01, 0);
  kernels::Samples none = one.view();
  none.count = 0;
  kernel().vote(referenceAt(one, 0), none, votingRules(everything(), kDiameter), accumulators.bins());
  EXPECT_EQ(accumulators.bins().plane, 0.0f);
  EXPECT_EQ(accumulators.bins().convex.cone.cell_count, 0u);
}

TEST_P(EachKernel, FollowsEverySwitch) {
  Random random(44);
  const Samples samples = clutter(1000, random);
  for (int switches = 0; switches < 16; ++switches) {
    for (const char* side : {"convex", "concave", "both"}) {
      Params params = presetParams("paper");
      params.convexity = side;
      params.detect_planes = params.convex_planes = switches & 1;
      params.detect_spheres = switches & 2;
      params.detect_cylinders = switches & 4;
      params.detect_cones = switches & 8;
      expectSameVotes(samples, params, 0.0, std::to_string(switches) + side, 10);  // of each kind one from either side
      EXPECT_EQ(voted_, switches != 0);
    }
  }
}

TEST_P(EachKernel, CastsWholeVotesWithoutSpreading) {
  Random random(45);
  Params params = everything();
  params.spread_votes = false;
  const Samples samples = clutter(2000, random);
  // A vote whose value lies within rounding of the border of two bins falls into the other one: twice one vote each.
  expectSameVotes(samples, params, 6.0, "no spreading");
  const Votes votes = votesOf(kernel(), samples, 0, params);
  for (const float bin : votes.bins) EXPECT_EQ(bin, std::round(bin));
}

TEST_P(EachKernel, TakesCoarseAndFineBins) {
  Random random(46);
  const Samples samples = clutter(100, random);
  const std::pair<double, int> bins[] = {{2.0, 16}, {5.0, 4}, {10.0, 256}, {17.0, 15}, {30.0, 17}};
  for (const auto& [angle, radius_bins] : bins) {
    Params params = everything();
    params.angle_bin_deg = params.epsilon_deg = angle;
    params.radius_bins = radius_bins;
    const std::string what = std::to_string(angle) + " deg, bins " + std::to_string(radius_bins);
    const Votes expected = votesOf(kernels::kScalar, samples, 0, params);
    if (isOther()) expectSame(expected, votesOf(kernel(), samples, 0, params), 0.0, what);
    EXPECT_GT(expected.mass(), 1.0) << what;
  }
}

TEST_P(EachKernel, PassesOverMissingSamples) {
  Random random(47);
  Samples samples = clutter(200, random);
  for (std::size_t i = 0; i < samples.size(); i += 3) samples.x[i] = samples.y[i] = samples.z[i] = kNan;
  for (std::size_t i = 1; i < samples.size(); i += 3) samples.nx[i] = samples.ny[i] = samples.nz[i] = kNan;
  expectSameVotes(samples, everything(), 0.0, "missing samples");
  EXPECT_TRUE(voted_);
  // Whole boxes without a place, the last one of few samples among them.
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i / kernels::kBoxSamples % 3 != 0 || i >= 192) samples.x[i] = samples.y[i] = samples.z[i] = kNan;
  }
  expectSameVotes(samples, everything(), 0.0, "missing boxes");
  EXPECT_TRUE(voted_);
  const std::size_t good = 2;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i != good) samples.nx[i] = samples.ny[i] = samples.nz[i] = kNan;
  }
  EXPECT_EQ(votesOf(kernel(), samples, good, everything()).mass(), 0.0);
}

/// Points of one plane, exact but for float rounding: C2 and C3 are 0 but for rounding, which has to be the same.
TEST_P(EachKernel, DecidesAsTheScalarOneOnTheThresholdOfConvexity) {
  Random random(48);
  const Plane plane = {Vec3(0.0, 0.2, 1.0), Vec3(0.1, -0.9, -0.3).normalized()};
  const Samples samples = test::samplesOf(test::patchOf(plane, 500, 0.1, random));
  for (const char* side : {"convex", "concave"}) {
    Params params = presetParams("paper");
    params.convexity = side;
    expectSameVotes(samples, params, 0.0, side);
    EXPECT_TRUE(voted_);
  }
}

/// Points of a grid: many pairs are exactly as far apart as is allowed, or have normals exactly epsilon apart.
TEST_P(EachKernel, DecidesAsTheScalarOneOnTheThresholdsOfDistanceAndParallelNormals) {
  Params params = everything();
  const float epsilon = static_cast<float>(params.epsilon_deg * M_PI / 180.0);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 400; ++i) {
    const double angle = (i % 3) * epsilon;
    points.push_back({0.1 * Vec3(i % 20, i / 20, 0.0), Vec3(std::sin(angle), 0.0, -std::cos(angle))});
  }
  expectSameVotes(test::samplesOf(points), params, 0.0, "grid");
  EXPECT_TRUE(voted_);
}

/// How many whole votes a reference at (0, 0, 1) with the normal z casts for spheres and cylinders seen from outside.
std::pair<float, float> wholeVotes(const Kernels& kernel, std::vector<SurfacePoint> others) {
  others.insert(others.begin(), {Vec3::UnitZ(), Vec3::UnitZ()});
  Params params = everything();
  params.spread_votes = false;
  const Votes votes = votesOf(kernel, test::samplesOf(others), 0, params);
  return {votes.total[0], votes.total[1]};
}

/// On a ball of this radius below the reference, `turn` (rad) away from it.
SurfacePoint onBallBelow(double radius, double turn) {
  return test::pointOn(Sphere{Vec3(0.0, 0.0, 1.0 - radius), radius}, Vec3(std::sin(turn), 0.0, std::cos(turn)));
}

/// What is that little below the threshold votes, what is above it does not; both are far from rounding (1e-6).
constexpr double kBeside[] = {-1e-2, -1e-3, -1e-4, -2e-5, 2e-5, 1e-4, 1e-3, 1e-2};
constexpr float kBelow = 4.0f, kAll = 8.0f;  ///< of them

template <class PointAt>
std::vector<SurfacePoint> besideThreshold(const PointAt& point_at) {
  std::vector<SurfacePoint> points;
  for (const double beside : kBeside) points.push_back(point_at(beside));
  return points;
}

TEST_P(EachKernel, DecidesOnTheThresholdOfSymmetricAngles) {
  const double epsilon = everything().epsilon_deg * M_PI / 180.0;
  for (const double turn : {0.5, 0.9, 1.3}) {
    const auto others = besideThreshold([&](double beside) {
      SurfacePoint p = onBallBelow(0.1, turn);
      p.normal = Eigen::AngleAxisd(epsilon + beside, Vec3::UnitY()) * p.normal;
      return p;
    });
    EXPECT_EQ(wholeVotes(kernel(), others).second, kBelow) << turn;
  }
}

TEST_P(EachKernel, DecidesOnTheThresholdOfTriangles) {
  const double epsilon = everything().epsilon_deg * M_PI / 180.0;
  for (const double turn : {0.5, 0.9, 1.3}) {
    const auto others = besideThreshold([&](double beside) {
      // Turned about the way to it until the normals are so far apart; to both ends of the way they stay symmetric.
      SurfacePoint p = onBallBelow(0.1, turn);
      const double f2 = 0.5 * (M_PI + turn), f3 = 0.5 * (M_PI - turn), f4 = turn + epsilon + beside;
      const double about = std::acos((std::cos(f4) - std::cos(f2) * std::cos(f3)) / (std::sin(f2) * std::sin(f3)));
      p.normal = Eigen::AngleAxisd(about, (p.point - Vec3::UnitZ()).normalized()) * p.normal;
      return p;
    });
    const auto [spheres, cylinders] = wholeVotes(kernel(), others);
    EXPECT_EQ(spheres, kBelow) << turn;
    EXPECT_EQ(cylinders, kAll) << turn;
  }
}

TEST_P(EachKernel, DecidesOnTheLargestRadius) {
  const Params params = everything();
  const double largest = params.radius_bin * kDiameter * params.radius_bins;
  const auto others = besideThreshold([&](double beside) { return onBallBelow(largest * (1.0 + beside), 0.5); });
  const auto [spheres, cylinders] = wholeVotes(kernel(), others);
  EXPECT_EQ(spheres, kBelow);
  EXPECT_EQ(cylinders, kBelow);
}

TEST_P(EachKernel, CastsTheSameVotesWithAndWithoutBoxes) {
  Random random(49);
  Samples samples = clutter(700, random);
  Params params = everything();
  params.pair_distance = 0.03;  // so that most boxes are out of reach
  for (const std::size_t reference : {0, 100, 699}) {
    const Votes with = votesOf(kernel(), samples, reference, params);
    EXPECT_TRUE(with == votesOf(kernel(), samples, reference, params, false));
  }
}

/// In layers along x, as samples are in runs along a curve, so that some boxes are nearer than others.
Samples layers(std::size_t count, Random& random) {
  const Samples samples = clutter(count, random);
  List<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return samples.x[a] < samples.x[b]; });
  return samples.part(order);
}

TEST_P(EachKernel, TakesTheSameBoxesWhereManyAreWithinReach) {
  Random random(51);
  // More than are counted at a time, in the last box fewer samples.
  const Samples samples = layers(9001, random);
  ASSERT_GT(votingRules(everything("default"), kDiameter).most_boxes, 0);
  expectSameVotes(samples, everything("default"), 0.0, "nearest boxes");
  EXPECT_TRUE(voted_);
  const double nearest = votesOf(kernel(), samples, 4000, everything("default")).mass();
  EXPECT_LT(nearest, 0.5 * votesOf(kernel(), samples, 4000, everything("default"), false).mass());
}

TEST_P(EachKernel, CastsTheSameVotesAgainBitForBit) {
  Random random(50);
  const Samples samples = clutter(2000, random);
  for (const std::size_t reference : {3, 999}) {
    const Votes first = votesOf(kernel(), samples, reference, everything());
    EXPECT_TRUE(first == votesOf(kernel(), samples, reference, everything()));
  }
}

std::vector<const Kernels*> available() {
  const kernels::Available all = kernels::availableKernels();
  return {all.kernels, all.kernels + all.count};
}

INSTANTIATE_TEST_SUITE_P(Available, EachKernel, ::testing::ValuesIn(available()),
                         [](const auto& info) { return std::string(info.param->name); });

}  // namespace
}  // namespace primitect::kernels_agree_test
