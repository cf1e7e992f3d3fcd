// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The final fit on points of the cloud.
#include "core/dense_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <set>

#include "core/fitting.h"
#include "test/support/hypotheses.h"

namespace primitect::dense_fit_test {
namespace {

using test::kDegree;
using test::kNoise;
using test::kNoiseModel;
using test::measured;
using test::noisySamples;
using test::patchOf;
using test::samplesWith;
using test::SurfacePoint;

/// A cylinder of 5 cm around the height 0, and the cone of this angle that touches it there.
const Cylinder kCan = {Vec3(0, 0, 1), Vec3(0, 1, 0), 0.05};
Cone taperedCan(double half_angle) {
  return {kCan.point - kCan.radius / std::tan(half_angle) * kCan.axis, kCan.axis, half_angle};
}
Samples samplesOfTapered(double half_angle, int count, std::uint64_t seed) {
  Random random(seed);
  const double middle = kCan.radius / std::tan(half_angle);
  const auto points = patchOf(taperedCan(half_angle), count, middle - 0.05, middle + 0.05, random);
  return noisySamples(points, 0.0, random);
}
Samples samplesOfCan(int count, std::uint64_t seed) {
  Random random(seed);
  return noisySamples(patchOf(kCan, count, -0.05, 0.05, random), 0.0, random);
}

std::vector<SurfacePoint> pointsOfCan() {
  Random random(55);
  return patchOf(kCan, 100, -0.05, 0.05, random);
}

Shape refined(const Shape& shape, const Samples& points, const Params& params = Params()) {
  return refineOnPoints(shape, test::fitPointsOf(points), {params, 0.4}).shape;
}

TEST(RefineOnPoints, TurnsACylinderOnASlightlyTaperedConeIntoTheCone) {
  for (const bool upside_down : {false, true}) {
    const Samples points = samplesOfTapered(10.0 * kDegree, 3000, 51);
    const Cylinder proposal = {kCan.point, upside_down ? Vec3(-kCan.axis) : kCan.axis, kCan.radius};
    const Shape found = refined(proposal, points);
    ASSERT_EQ(kindOf(found), Kind::cone);
    // sigma over half the length of 10 cm by sqrt(3000), times about 4 for what the other parameters take away.
    EXPECT_NEAR(std::get<Cone>(found).half_angle, 10.0 * kDegree, 3.0 * 4.0 * kNoise / 0.05 / std::sqrt(3000.0));
    EXPECT_GT(std::get<Cone>(found).axis.dot(kCan.axis), 0.999);
  }
}

TEST(RefineOnPoints, TurnsACylinderThatLeansAlongTheSeenSideOfAConeIntoTheCone) {
  // Of a cone that stands upright the camera sees one side; the cylinder that fits it best lies along that side.
  constexpr double kHalfAngle = 9.0 * kDegree, kRadius = 0.2, kReach = 0.2;
  const double height = kRadius / std::tan(kHalfAngle);
  const Cone cone = {Vec3(0, -height, 2), Vec3(0, 1, 0), kHalfAngle};
  Random random(56);
  const Samples points = noisySamples(patchOf(cone, 3000, height - kReach, height + kReach, random), 0.0, random);
  const SurfacePoint seen = test::pointOn(cone, height, -0.5 * M_PI);
  ASSERT_LT(seen.normal.z(), -0.9);
  const Vec3 along = (seen.point - cone.apex).normalized();
  const double radius = kRadius / std::cos(kHalfAngle);
  const Shape found = refined(Cylinder{seen.point - radius * seen.normal, along, radius}, points);
  ASSERT_EQ(kindOf(found), Kind::cone);
  EXPECT_NEAR(std::get<Cone>(found).half_angle, kHalfAngle, 3.0 * 4.0 * kNoise / kReach / std::sqrt(3000.0));
}

TEST(RefineOnPoints, LeavesACylinderACylinder) {
  Params params;
  params.min_half_angle_deg = 0.0;  // so that it is the fit that decides, not the limit
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Shape found = refined(kCan, samplesOfCan(3000, seed), params);
    ASSERT_EQ(kindOf(found), Kind::cylinder) << seed;
    EXPECT_NEAR(std::get<Cylinder>(found).radius, kCan.radius, 3.0 * 4.0 * kNoise / std::sqrt(3000.0)) << seed;
  }
}

TEST(RefineOnPoints, TurnsAConeOnACylinderIntoTheCylinder) {
  Params params;
  params.min_half_angle_deg = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Shape found = refined(taperedCan(2.0 * kDegree), samplesOfCan(3000, seed), params);
    ASSERT_EQ(kindOf(found), Kind::cylinder) << seed;
    EXPECT_NEAR(std::get<Cylinder>(found).radius, kCan.radius, 3.0 * 4.0 * kNoise / std::sqrt(3000.0));
  }
}

TEST(RefineOnPoints, TurnsACylinderOnABandOfABallIntoTheBall) {
  // As of a bowl from outside: from a little above the equator to 30 deg below it, what faces the sensor.
  const Sphere bowl = {Vec3(0, 0, 1), 0.09};
  Random random(57);
  std::vector<SurfacePoint> points;
  for (int k = 0; k < 1500; ++k) {
    const double below = random.uniform(-5.0, 30.0) * kDegree, aside = random.uniform(-60.0, 60.0) * kDegree;
    const Vec3 normal(std::cos(below) * std::sin(aside), std::sin(below), -std::cos(below) * std::cos(aside));
    points.push_back({bowl.center + bowl.radius * normal, normal});
  }
  // The tube that lies along the middle of the band.
  const Vec3 middle(0, std::sin(12.0 * kDegree), -std::cos(12.0 * kDegree));
  const Cylinder proposal = {bowl.center, middle.cross(Vec3::UnitX()), bowl.radius};
  const Shape found = refined(proposal, noisySamples(points, 0.0, random));
  ASSERT_EQ(kindOf(found), Kind::sphere);
  EXPECT_LT((std::get<Sphere>(found).center - bowl.center).norm(), 0.002);
}

/// The front of a ball of 25 mm, seen from below in z, its points up to 60 deg from the nearest one, and the cone that
/// touches it all around.
TEST(RefineOnPoints, TurnsAConeAroundTheFrontOfABallIntoTheBall) {
  constexpr double kRadius = 0.025, kHalfAngle = 48.0 * kDegree;
  const Sphere ball = {Vec3(0.01, -0.02, 1.0), kRadius};
  const Cone cone = {ball.center - kRadius / std::sin(kHalfAngle) * Vec3::UnitZ(), Vec3::UnitZ(), kHalfAngle};
  for (const std::uint64_t seed : {71, 72, 73}) {
    Random random(seed);
    std::vector<SurfacePoint> points, on_cone;
    while (points.size() < 500) {
      const double polar = std::acos(random.uniform(0.5, 1.0)), turn = random.uniform(0.0, 2.0 * M_PI);
      const Vec3 normal(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), -std::cos(polar));
      points.push_back({ball.center + kRadius * normal, normal});
    }
    const Shape found = refined(cone, noisySamples(points, 0.0, random));
    ASSERT_EQ(kindOf(found), Kind::sphere);
    EXPECT_NEAR(std::get<Sphere>(found).radius, kRadius, 0.001);
    on_cone = patchOf(cone, 500, 0.005, 0.03, random);
    EXPECT_EQ(kindOf(refined(cone, noisySamples(on_cone, 0.0, random))), Kind::cone);
  }
}

TEST(RefineOnPoints, LeavesAShortTubeATube) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const Samples points = noisySamples(patchOf(kCan, 1500, -0.008, 0.008, random), 0.0, random);
    EXPECT_EQ(kindOf(refined(kCan, points)), Kind::cylinder) << seed;
  }
}

TEST(RefineOnPoints, KeepsLimits) {
  Params params;
  params.detect_cones = false;
  EXPECT_NE(kindOf(refined(kCan, samplesOfTapered(10.0 * kDegree, 1000, 52), params)), Kind::cone);
  params.detect_cones = true;
  params.min_half_angle_deg = 12.0;
  EXPECT_NE(kindOf(refined(kCan, samplesOfTapered(10.0 * kDegree, 1000, 52), params)), Kind::cone);
  // The fit is beyond the limit: the shape stays what it was.
  params.max_radius = 0.0495;
  const Cylinder smaller = {kCan.point, kCan.axis, 0.049};
  EXPECT_EQ(std::get<Cylinder>(refined(smaller, samplesOfCan(1000, 53), params)).radius, 0.049);
}

TEST(RefineOnPoints, SaysWhereAConeThatIsSharperThanTheLimitsWouldBeBetter) {
  Params params;
  params.min_half_angle_deg = 12.0;
  const auto choice = [&params](const Samples& points) {
    return refineOnPoints(kCan, test::fitPointsOf(points), {params, 0.4});
  };
  const PointsChoice of_tapered = choice(samplesOfTapered(10.0 * kDegree, 1000, 52));
  EXPECT_EQ(kindOf(of_tapered.shape), Kind::cylinder);
  EXPECT_TRUE(of_tapered.or_cone);
  EXPECT_FALSE(of_tapered.either) << "that cone is not within the limits";
  EXPECT_FALSE(choice(samplesOfCan(1000, 53)).or_cone);
  params.max_radius = 0.0495;  // the fit of the can is beyond: that is no cone
  EXPECT_FALSE(choice(samplesOfCan(1000, 53)).or_cone);
  params.max_radius = 0.0;
  params.min_half_angle_deg = 4.0, params.max_half_angle_deg = 8.0;
  EXPECT_FALSE(choice(samplesOfTapered(10.0 * kDegree, 1000, 52)).or_cone) << "it is blunter";
  params.min_half_angle_deg = 12.0, params.max_half_angle_deg = 65.0;
  params.detect_cones = false;  // nobody asks
  EXPECT_FALSE(choice(samplesOfTapered(10.0 * kDegree, 1000, 52)).or_cone);
}

/// What is chosen for 2000 points on a strip of a cone, a seventh of the way around where its radius is 10 cm, this
/// long (m), which was taken for the cylinder that touches it.
PointsChoice choiceOnStrip(double half_angle, double length, std::uint64_t seed) {
  constexpr double kRadius = 0.1, kAround = 50.0 * kDegree;
  const double middle = kRadius / std::tan(half_angle);
  const Cone cone = {Vec3(0, -middle, 1), Vec3(0, 1, 0), half_angle};
  Random random(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 2000; ++i) {
    const double height = middle + length * random.uniform(-0.5, 0.5);
    const double around = -0.5 * M_PI + kAround * random.uniform(-0.5, 0.5);
    points.push_back(test::pointOn(cone, height, around));
  }
  const Params params;
  return refineOnPoints(*asCylinder(cone, test::pointOn(cone, middle, -0.5 * M_PI).point),
                        test::fitPointsOf(noisySamples(points, 0.0, random)), {params, 0.4});
}

struct OfTenStrips {
  int cones = 0, either = 0;
};
OfTenStrips choicesOnStrips(double half_angle) {
  constexpr double kLength = 0.1;
  OfTenStrips result;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const PointsChoice choice = choiceOnStrip(half_angle, kLength, seed);
    result.cones += kindOf(choice.shape) == Kind::cone ? 1 : 0;
    result.either += choice.either ? 1 : 0;
  }
  return result;
}

TEST(RefineOnPoints, StripsOfConesAtABorderAreCones) {
  EXPECT_GE(choicesOnStrips(11.0 * kDegree).cones, 8) << "2 where the angle has the price of any parameter, .003";
  EXPECT_EQ(choicesOnStrips(0.1 * kDegree).cones, 0) << "as good as cylinders";
}

TEST(RefineOnPoints, SaysWhereNobodyCanTellAConeFromACylinder) {
  EXPECT_GE(choicesOnStrips(6.0 * kDegree).either, 5);
  EXPECT_EQ(choicesOnStrips(0.1 * kDegree).either, 0);
  EXPECT_LE(choicesOnStrips(2.0 * kDegree).either, 3) << "most cones that fit are sharper than 4 deg";
}

TEST(AsCylinder, TouchesAConeAlongTheLineThatThePointsLieAround) {
  const Cone cone = taperedCan(6.0 * kDegree);
  const test::SurfacePoint seen = test::pointOn(cone, kCan.radius / std::tan(cone.half_angle), 0.7);
  const std::optional<Cylinder> cylinder = asCylinder(cone, seen.point + 0.003 * seen.normal);
  ASSERT_TRUE(cylinder);
  EXPECT_LT(std::abs(distance(*cylinder, seen.point)), 0.001);
  EXPECT_GT(normalAt(*cylinder, seen.point).dot(seen.normal), std::cos(0.1 * kDegree));
  EXPECT_GT(cylinder->axis.dot((seen.point - cone.apex).normalized()), std::cos(0.1 * kDegree));
  EXPECT_NEAR(cylinder->radius, kCan.radius / std::cos(cone.half_angle), 0.001);
  EXPECT_EQ(asCylinder(kCan, seen.point)->radius, kCan.radius);
  EXPECT_FALSE(asCylinder(Sphere{Vec3::Zero(), 0.1}, seen.point));
}

TEST(RefineOnPoints, KeepsAShapeThatCannotBeFitted) {
  const Sphere ball = {Vec3(0, 0, 1), 0.1};
  for (const std::size_t count : {0, 1, 2}) {
    const std::vector<SurfacePoint> same(count, {Vec3(0, 0, 0.9), Vec3(0, 0, -1)});
    const Shape found = refined(ball, samplesWith(kNoiseModel, same));
    ASSERT_EQ(kindOf(found), Kind::sphere);
    EXPECT_LT((std::get<Sphere>(found).center - ball.center).norm(), 1e-3) << count;
  }
}

TEST(RefineOnPoints, LeavesOutPointsBeyondTheNoise) {
  Random random(54);
  const Plane wall = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  std::vector<SurfacePoint> points = measured(patchOf(wall, 1000, 0.1, random), kNoise, 0.0, random);
  for (int k = 0; k < 200; ++k) points[k].point.z() -= 0.02;  // twenty standard deviations, all to one side
  const Shape found = refined(wall, samplesWith(kNoiseModel, points));
  EXPECT_LT(std::abs(distance(found, wall.point)), 3.0 * kNoise / std::sqrt(800.0));
}

TEST(RefineDense, EndsWhereAllPointsSay) {
  constexpr int kPoints = 4096;
  // A fifth of what so many points leave open of six parameters.
  const double most = 0.2 * kNoise * std::sqrt(6.0 / kPoints);
  for (const std::uint64_t seed : {57u, 58u, 59u}) {
    const FitPoints points = test::fitPointsOf(samplesOfTapered(10.0 * kDegree, kPoints, seed));
    Cone start = taperedCan(12.0 * kDegree);
    start.apex.x() += 0.002;
    RefineRules to_the_end;
    to_the_end.most_steps = 30, to_the_end.small_step = 1e-6;
    Random random(seed);
    const auto found = refineDense(start, points), wanted = refine(start, points, to_the_end);
    ASSERT_TRUE(found && wanted);
    double sum_sq = 0.0;
    for (const SurfacePoint& p : patchOf(std::get<Cone>(*wanted), 100, 0.235, 0.335, random))
      sum_sq += std::pow(distance(*found, p.point), 2) / 100.0;
    EXPECT_LT(std::sqrt(sum_sq), most) << seed;
  }
}

TEST(RefineDense, AlongRaysStartsNoNarrowerAtAConeThatIsSeenAllAround) {
  // A spike whose tip points at the sensor. Beside a narrower one along one line of it most points are too far away to
  // show the way back: fits from there end up to 1 deg off.
  constexpr double kHalfAngle = 10.0 * kDegree;
  const Cone spike = {Vec3(0, 0, 0.9), Vec3(0, 0, 1), kHalfAngle};
  for (const std::uint64_t seed : {61u, 62u, 63u}) {
    Random random(seed);
    std::vector<SurfacePoint> points = patchOf(spike, 2000, 0.05, 0.35, random);
    for (SurfacePoint& p : points) p.point += kNoise * random.gaussian() * p.point.normalized();
    const auto found = refineDense(spike, test::fitPointsOf(samplesWith(kNoiseModel, points)), PointErrors::along_rays);
    ASSERT_TRUE(found);
    // The noise over a third of the length by sqrt(2000) is 0.013 deg; no more than ten times as much.
    EXPECT_NEAR(std::get<Cone>(*found).half_angle, kHalfAngle, 0.1 * kDegree) << seed;
  }
}

TEST(PointsOfLabels, KnowsTheOutermostInEachRowOfAnImage) {
  const std::vector<std::uint32_t> labels = {0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,   // one run
                                             1, 1, 1, 1, 0, 2, 2, 0, 1, 1, 1, 1,   // something between two; on to
                                             1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1};  // the next row; too few
  List<LabelledPoints> points;
  pointsOfLabels(labelRuns(labels), 12, {{100}, {100}}, points);
  EXPECT_EQ(points[0].row_ends, (List<std::uint32_t>{1, 4, 12, 23, 24, 28}));
  EXPECT_TRUE(points[1].row_ends.empty());
  EXPECT_EQ(points[0].all, 20u);
  pointsOfLabels(labelRuns(labels), 0, {{100}, {100}}, points);
  EXPECT_TRUE(points[0].row_ends.empty());
}

TEST(PointsOfLabels, CountsAllAndTakesSomeEvenly) {
  std::vector<std::uint32_t> labels(10000, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = i < 9000 ? i % 2 : 2;
  List<LabelledPoints> points;
  pointsOfLabels(labelRuns(labels), 0, {{1000}, {300}, {1000}}, points);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].all, 4500u);
  EXPECT_EQ(points[1].all, 1000u);
  EXPECT_EQ(points[2].all, 0u);
  EXPECT_TRUE(points[2].index.empty());
  for (std::uint32_t k = 0; k < 2; ++k) {
    EXPECT_LE(points[k].index.size(), k == 0 ? 1000u : 300u);
    EXPECT_GE(points[k].index.size(), k == 0 ? 500u : 150u);
    for (const std::uint32_t i : points[k].index) EXPECT_EQ(labels[i], k + 1);
  }
  // Evenly: the mean place is the middle of all of them.
  const List<std::uint32_t>& first = points[0].index;
  const double mean = std::accumulate(first.begin(), first.end(), 0.0) / static_cast<double>(first.size());
  EXPECT_NEAR(mean, 4500.0, 50.0);
}

TEST(PointsOfLabels, TakesSomeOfAllColumnsWhateverTheWidth) {
  for (const std::uint32_t width : {99u, 100u, 101u, 200u, 512u}) {
    const std::vector<std::uint32_t> labels(100u * width, 1);
    List<LabelledPoints> points;
    pointsOfLabels(labelRuns(labels), width, {{101}}, points);  // every 100th of 100 columns
    std::set<std::uint32_t> columns;
    for (const std::uint32_t i : points[0].index) columns.insert(i % width);
    EXPECT_GT(columns.size(), 50u) << width;
    EXPECT_TRUE(std::is_sorted(points[0].index.begin(), points[0].index.end())) << width;
  }
}

TEST(PointsOfLabels, TakesTheOutermostPixels) {
  constexpr std::uint32_t kWidth = 101;
  std::vector<std::uint32_t> labels(kWidth * kWidth, 0);  // a square on its corner
  for (int row = 0; row < 101; ++row) {
    for (int column = 0; column < 101; ++column) {
      if (std::abs(row - 50) + std::abs(column - 50) <= 40) labels[kWidth * row + column] = 1;
    }
  }
  List<LabelledPoints> points;
  for (const bool wanted : {true, false}) {
    pointsOfLabels(labelRuns(labels), kWidth, {{100, wanted}}, points);
    const List<std::uint32_t>& index = points[0].index;
    EXPECT_LE(index.size(), wanted ? 104u : 100u);
    std::ptrdiff_t corners = 0;
    for (const std::uint32_t corner : {10 * kWidth + 50, 50 * kWidth + 10, 50 * kWidth + 90, 90 * kWidth + 50}) {
      corners += std::count(index.begin(), index.end(), corner);
    }
    EXPECT_EQ(corners, wanted ? 4 : 0) << "one in 33 is taken by chance";
  }
}

TEST(FitPoints, ThinnedAreSomeOfThemFromAllOver) {
  const Samples samples = samplesWith(kNoiseModel, pointsOfCan());
  const FitPoints all = test::fitPointsOf(samples), some = all.thinned(37);
  ASSERT_EQ(some.size(), 37u);
  EXPECT_EQ(some.view().count % kernels::kLanes, 0u);
  EXPECT_EQ(some.middle(), all.middle());
  std::size_t last = 0;
  for (std::size_t k = 0; k < some.view().count; ++k) {
    if (k >= some.size()) {
      EXPECT_EQ(some.view().inverse_tolerance[k], std::numeric_limits<float>::infinity());
      continue;
    }
    const std::size_t i = k * all.size() / some.size();
    EXPECT_EQ(some.view().x[k], all.view().x[i]);
    EXPECT_EQ(some.view().inverse_tolerance[k], all.view().inverse_tolerance[i]);
    last = i;
  }
  EXPECT_GE(last, all.size() - 3);
}

TEST(FitPoints, ReachFromTheMiddleToTheFarthest) {
  const Samples samples = samplesWith(kNoiseModel, pointsOfCan());
  const FitPoints points = test::fitPointsOf(samples);
  double farthest = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    farthest = std::max(farthest, (samples.point(k) - points.middle()).norm());
  }
  EXPECT_NEAR(points.reach(), farthest, 1e-6);  // in float
}

TEST(FitPoints, OfWhatWasSeenAreThoseOfSamplesThere) {
  for (const NoiseModel& noise : {kNoiseModel, NoiseModel{0.0, 0.01, 0.5}}) {
    const Samples samples = samplesWith(noise, pointsOfCan());
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < samples.size(); ++k) places.push_back(samples.point(k));
    const List<std::uint32_t> all = test::allOf(samples);
    FitPoints expected, found;
    expected.gather({samples, all});
    found.gather(places, noise);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_EQ(found.view().count, expected.view().count);
    EXPECT_NEAR(found.meanSigma(), expected.meanSigma(), 1e-6 * expected.meanSigma());  // float
    for (std::size_t k = 0; k < found.view().count; ++k) {
      const float wanted = expected.view().inverse_tolerance[k];
      if (k >= found.size()) {
        EXPECT_EQ(found.view().inverse_tolerance[k], wanted);
        continue;
      }
      EXPECT_NEAR(found.view().inverse_tolerance[k], wanted, 1e-5 * wanted);
      const Vec3 place = found.origin() + Vec3(found.view().x[k], found.view().y[k], found.view().z[k]);
      EXPECT_LT((place - samples.point(k)).norm(), 1e-7);
    }
  }
}

}  // namespace
}  // namespace primitect::dense_fit_test
