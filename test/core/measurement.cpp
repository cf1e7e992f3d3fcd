// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a detection says about itself, measured on the points of the cloud.
#include "core/measurement.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/axis_extent.h"
#include "core/extent.h"
#include "core/frame_around.h"
#include "primitect/detector.h"
#include "test/support/hypotheses.h"
#include "test/support/linear_algebra.h"
#include "test/support/scenes.h"
#include "test/support/tube_points.h"

namespace primitect::measurement_test {
namespace {

using test::kBall;
using test::kCan;
using test::kDegree;
using test::kHat;
using test::kNoise;
using test::kNoiseModel;
using test::measured;
using test::patchOf;

/// All clear points lie on the shape that was fitted to them.
Measurement::OnSurface allOf(const List<std::uint32_t>& clear) {
  return [clear](const Shape&) { return clear; };
}

/// 40,000 points, more than anything draws.
constexpr std::array<int, kKindCount> kPointsOf = {20000, 6000, 7000, 7000};
Cloud noisyTabletop() {
  Random random(41);
  return test::cloudOf(measured(test::tabletop(kPointsOf, random), kNoise, 0.05, random));
}

/// Of the preset's detections one of each kind, found once for all tests.
const std::vector<Detection>& detectionsOf(const char* preset) {
  static const std::vector<Detection> kVerified = Detector(presetParams("default")).detect(noisyTabletop()).items;
  static const std::vector<Detection> kByVotes = Detector(presetParams("paper")).detect(noisyTabletop()).items;
  return std::string(preset) == "paper" ? kByVotes : kVerified;
}

TEST(Detections, OfTheDefaultSayAllThatTheyCan) {
  ASSERT_EQ(detectionsOf("default").size(), 4u);
  for (const Detection& detection : detectionsOf("default")) {
    const Kind kind = kindOf(detection.shape);
    EXPECT_GT(detection.confidence, 0.5f) << kindName(kind);
    EXPECT_LE(detection.confidence, 1.0f) << kindName(kind);
    EXPECT_GT(detection.coverage, 0.0f) << kindName(kind);
    EXPECT_LE(detection.coverage, 1.0f) << kindName(kind);
    EXPECT_GT(detection.covariance[0], 0.0) << kindName(kind);
    EXPECT_EQ(detection.truncated, kTruncationUnknown) << kindName(kind);  // no image
    EXPECT_EQ(detection.radius_stddev > 0.0f, kind != Kind::plane) << kindName(kind);
    EXPECT_EQ(detection.half_angle_stddev > 0.0f, kind == Kind::cone) << kindName(kind);
    EXPECT_GT(detection.evidence.inliers, 0.0f) << kindName(kind);
  }
}

TEST(Detections, OfThePaperLeaveUnknownWhatNobodyMeasured) {
  ASSERT_FALSE(detectionsOf("paper").empty());
  for (const Detection& detection : detectionsOf("paper")) {
    EXPECT_EQ(detection.confidence, kUnknown);
    EXPECT_EQ(detection.coverage, kUnknown);
    EXPECT_EQ(detection.covariance[0], -1.0);
    EXPECT_EQ(detection.radius_stddev, kUnknown);
    EXPECT_EQ(detection.half_angle_stddev, kUnknown);
    EXPECT_EQ(detection.truncated, kTruncationUnknown);
    EXPECT_FALSE(detection.rival);
    EXPECT_EQ(detection.evidence.inliers, 0.0f);
    EXPECT_GE(detection.rms_error, 0.0f);
  }
}

TEST(Detections, CountPointsOfTheCloud) {
  for (const Detection& detection : detectionsOf("default")) {
    // 3 standard deviations hold 99.7 %; where surfaces pass close by each other, some go to the other.
    const double all = kPointsOf[detection.shape.index()];
    EXPECT_GT(detection.inlier_count, 0.93 * all) << kindName(kindOf(detection.shape));
    EXPECT_LT(detection.inlier_count, 1.07 * all) << kindName(kindOf(detection.shape));
  }
}

TEST(Detections, ErrByTheNoiseOfThePoints) {
  for (const Detection& detection : detectionsOf("default")) {
    // Cut off at three standard deviations, 1.3 % are missing; cut where the noise was measured wrong by 10 %, 3 %.
    EXPECT_NEAR(detection.rms_error, kNoise, 0.08 * kNoise) << kindName(kindOf(detection.shape));
  }
}

TEST(Detections, CoverWhatWasSeen) {
  for (const Detection& detection : detectionsOf("default")) {
    switch (kindOf(detection.shape)) {
      case Kind::plane:
        EXPECT_GT(detection.coverage, 0.85f);
        break;
      case Kind::sphere:
        // A cap down to a tenth of the radius above the equator: (1 - 0.1) / 2.
        EXPECT_NEAR(detection.coverage, 0.45f, 0.05f);
        break;
      case Kind::cylinder:
        // Seen from a distance d across the axis: acos(r / d) to either side.
        EXPECT_NEAR(detection.coverage, 0.478f, 0.02f);
        break;
      case Kind::cone:
        // The apex is nearer than the base: more than half, pi - acos(tan(half angle) a / d) to either side, the apex
        // being a along the axis and d across it.
        EXPECT_NEAR(detection.coverage, 0.583f, 0.02f);
    }
  }
}

TEST(Detections, HavePoseCovariancesThatAreSymmetricAndPositive) {
  for (const Detection& detection : detectionsOf("default")) {
    const auto covariance = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(detection.covariance.data());
    EXPECT_LT((covariance - covariance.transpose()).norm(), 1e-9 * covariance.norm());
    // The trace is at least the largest eigenvalue, and at most six times that.
    EXPECT_GT(test::leastEigenvalue(covariance), -1e-9 / 6.0 * covariance.trace());
  }
}

TEST(Detections, AreAsNearToTheTruthAsThePointsOfTheLastFitAllow) {
  for (const Detection& detection : detectionsOf("default")) {
    if (const Sphere* sphere = std::get_if<Sphere>(&detection.shape)) {
      // Every third of 6000 points is taken. Noise / sqrt(2000), times 3 as less than half is seen; three of these.
      EXPECT_NEAR(sphere->radius, kBall.radius, 3.0 * 3.0 * kNoise / std::sqrt(2000.0));
    }
    if (const Cylinder* cylinder = std::get_if<Cylinder>(&detection.shape)) {
      // Every fourth of 7000.
      EXPECT_NEAR(cylinder->radius, kCan.radius, 3.0 * 4.0 * kNoise / std::sqrt(1750.0));
      EXPECT_LT(test::lineAngle(cylinder->axis, kCan.axis), 0.2 * kDegree);
    }
    if (const Cone* cone = std::get_if<Cone>(&detection.shape)) {
      EXPECT_NEAR(cone->half_angle, kHat.half_angle, 0.2 * kDegree);
    }
  }
}

TEST(Measurement, KeepsTheShapeWhenItsFitBreaksTheLimits) {
  Random random(42);
  const Cloud cloud = test::cloudOf(measured(patchOf(kBall, 1000, random), kNoise, 0.05, random));
  List<std::uint32_t> all(1000);
  std::iota(all.begin(), all.end(), 0u);
  Params params;
  params.max_radius = 0.0795;
  Detection detection;
  detection.shape = Sphere{kBall.center, 0.079};
  Detection kept = detection;
  Measurement(cloud, findRays(cloud), params, {kNoiseModel, kNoiseModel}, {params, 1.0})
      .measure({all, {}, 4000}, all, allOf(all), kept);
  EXPECT_NEAR(std::get<Sphere>(kept.shape).radius, 0.079, 0.0001);
  EXPECT_EQ(kept.inlier_count, 4000u);  // all, not those of the fit
  params.max_radius = 0.0;
  Detection fitted = detection;
  Measurement(cloud, findRays(cloud), params, {kNoiseModel, kNoiseModel}, {params, 1.0})
      .measure({all, {}, 4000}, all, allOf(all), fitted);
  EXPECT_NEAR(std::get<Sphere>(fitted.shape).radius, kBall.radius, 0.0004);
}

/// The detection, measured on all points of the cloud.
Detection measuredOn(const Cloud& cloud, const NoiseModel& noise, Detection detection,
                     const Params& params = Params()) {
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  Measurement(cloud, findRays(cloud), params, {noise, noise}, {params, 10.0})
      .measure({all, {}, all.size()}, all, allOf(all), detection);
  return detection;
}

/// Measured, where samples saw kCan `reach` (m) far either way.
Detection measuredTube(std::initializer_list<test::TubePart> parts, const NoiseModel& noise, double reach) {
  Random random(45);
  Detection found;
  found.shape = kCan;
  found.extent.origin = kCan.point;
  found.extent.rotation = frameAround(kCan.axis, kCan.axis.unitOrthogonal());
  found.extent.size.z() = 2.0 * reach;
  found.extent.radius = kCan.radius;
  return measuredOn(test::cloudOf(measured(test::tubeOf(kCan, parts, random), kNoise, 0.0, random)), noise, found);
}

TEST(Measurement, LeavesOutWhereATubeOfAListGoesOnAsALine) {
  const auto tube = {test::TubePart{1200, -0.1, 0.1}, test::TubePart{700, -0.5, 0.5, true}};
  const Detection of_list = measuredTube(tube, kNoiseModel, 0.5);
  EXPECT_NEAR(of_list.extent.size.z(), 0.2, 0.008);
  EXPECT_NEAR(of_list.inlier_count, 1200 + 0.2 * 700, 60);
  const NoiseModel of_camera = {kNoise, kNoise, kNoiseModel.angle};
  EXPECT_GT(measuredTube(tube, of_camera, 0.5).extent.size.z(), 0.9) << "an image tells what was seen";
}

TEST(Measurement, FitsATubeOfAListToWhatItsSamplesSaw) {
  constexpr double kAstray = kNoise;  // with more the tube would end before it (bent_ends.h)
  const auto tube = {test::TubePart{1500, -0.1, 0.1}, test::TubePart{500, 0.12, 0.16, false, kAstray}};
  const Detection measured_tube = measuredTube(tube, kNoiseModel, 0.1);
  EXPECT_NEAR(std::get<Cylinder>(measured_tube.shape).radius, kCan.radius, 0.1 * kAstray);
  EXPECT_GT(measured_tube.extent.size.z(), 0.25) << "but what was seen is longer";
}

/// What lies beyond what was tolerated where the ball was looked for counts, too: or its radius would pass for too
/// sure.
TEST(Measurement, FitsWithAllOfTheNoise) {
  constexpr double kStrong = 0.003;
  Random random(46);
  const Cloud cloud = test::cloudOf(measured(patchOf(kBall, 2000, random), kStrong, 0.05, random));
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto deviation = [&](double tolerated, double full) {
    const Params params;
    Detection detection;
    detection.shape = kBall;
    Measurement(cloud, findRays(cloud), params, {NoiseModel{tolerated}, NoiseModel{full}}, {params, 10.0})
        .measure({all, {}, all.size()}, all, allOf(all), detection);
    return detection.radius_stddev;
  };
  const float exact = deviation(kStrong, kStrong);
  EXPECT_NEAR(deviation(kStrong / 3.0, kStrong), exact, 0.05 * exact);
  EXPECT_GT(std::abs(deviation(kStrong / 3.0, kStrong / 3.0) - exact), 0.2 * exact) << "as it would be without it";
}

/// How much of its confidence is left to a ball of which this many points are seen, this far (rad) around one place.
float confidenceInCap(double reach, double radius) {
  Random random(44);
  std::vector<test::SurfacePoint> points;
  const Sphere ball = {Vec3(0.0, 0.0, 1.0), radius};
  while (points.size() < 400) {
    const test::SurfacePoint p = patchOf(ball, 1, random).front();
    if (-p.normal.z() > std::cos(reach)) points.push_back(p);
  }
  Detection detection;
  detection.shape = ball;
  detection.confidence = 0.8f;
  return measuredOn(test::cloudOf(measured(points, kNoise, 0.05, random)), kNoiseModel, detection).confidence;
}

TEST(Measurement, DoubtsAShapeWhoseSizeItsPointsLeaveOpen) {
  EXPECT_EQ(confidenceInCap(1.0, 0.08), 0.8f);
  // 400 points with noise of one radius in thirty, none farther than 17 deg around its middle.
  EXPECT_LT(confidenceInCap(0.3, 30.0 * kNoise), 0.4f);
}

TEST(Measurement, TrustsASizeNoMoreForLeavingOutWhatContradictsIt) {
  Random random(47);
  const Sphere ball = {Vec3(0, 0, 1), 30.0 * kNoise};
  const Cloud cloud = test::cloudOf(measured(patchOf(ball, 4000, random), kNoise, 0.05, random));
  List<std::uint32_t> all(4000), cap;
  std::iota(all.begin(), all.end(), 0u);
  const auto in_cap = [&cloud, &ball](std::uint32_t i) {
    return Vec3(cloud.x[i], cloud.y[i], cloud.z[i] - 1.0f).head<2>().norm() < 0.3 * ball.radius;
  };
  std::copy_if(all.begin(), all.end(), std::back_inserter(cap), in_cap);
  ASSERT_GT(cap.size(), 100u);
  const auto confidence = [&](const List<std::uint32_t>& clear, const List<std::uint32_t>& rest) {
    const Params params;
    Detection detection;
    detection.shape = ball;
    detection.confidence = 0.8f;
    const auto on_surface = [&rest](const Shape&) { return rest; };
    Measurement(cloud, findRays(cloud), params, {kNoiseModel, kNoiseModel}, {params, 1.0})
        .measure({all, {}, all.size()}, clear, on_surface, detection);
    return detection.confidence;
  };
  const float of_all = confidence(all, all), of_cap = confidence(cap, cap);
  ASSERT_LT(of_cap, 0.5f * of_all);
  EXPECT_FLOAT_EQ(confidence(cap, all), of_cap);
}

/// How much of its confidence is left to a strip of 40 cm by 2 cm that runs into others all along its border.
float confidenceInStrip(const NoiseModel& noise) {
  Random random(45);
  std::vector<test::SurfacePoint> points;
  for (int k = 0; k < 400; ++k) {
    const Vec3 place{random.uniform(-0.2, 0.2), random.uniform(-0.01, 0.01), 1.0};
    points.push_back({place, -Vec3::UnitZ()});
  }
  Detection detection;
  detection.shape = Plane{Vec3(0, 0, 1), -Vec3::UnitZ()};
  detection.confidence = 0.8f;
  detection.evidence.runs_into = 2.0f;
  return measuredOn(test::cloudOf(measured(points, kNoise, 0.05, random)), noise, detection).confidence;
}

TEST(Measurement, DoubtsAStripThatRunsIntoOthersBeforeADepthCamera) {
  EXPECT_EQ(confidenceInStrip({kNoise, 0.002, 0.5}), 0.0f);
  EXPECT_EQ(confidenceInStrip({kNoise, 0.0, 0.5}), 0.8f);
}

TEST(Measurement, NamesWhatAShapeWasTakenForAsItsRival) {
  Random random(46);
  const Cloud cloud = test::cloudOf(measured(patchOf(kHat, 3000, 0.03, 0.25, random), kNoise, 0.05, random));
  const test::SurfacePoint seen = test::pointOn(kHat, 0.14, 0.0);
  const Vec3 along = (seen.point - kHat.apex).normalized();
  const double radius = (seen.point - kHat.apex).norm() * std::tan(kHat.half_angle);
  Detection detection;
  detection.shape = Cylinder{seen.point - radius * seen.normal, along, radius};
  detection.rival = Kind::cone;
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  SeenPoints points;
  points.gather(cloud, all);
  detection.extent = measureExtent(detection.shape, points);
  const double wide = 0.02;  // m: all of the cone's points are within reach of the cylinder
  const Detection cone = measuredOn(cloud, {wide, 0.0, 0.5}, detection);
  ASSERT_EQ(kindOf(cone.shape), Kind::cone);
  EXPECT_EQ(cone.rival, Kind::cylinder);
  // Where nobody wants cones as sharp as this.
  Params params;
  params.min_half_angle_deg = kHat.half_angle / kDegree + 3.0;
  detection.rival.reset();
  const Detection cylinder = measuredOn(cloud, {wide, 0.0, 0.5}, detection, params);
  ASSERT_EQ(kindOf(cylinder.shape), Kind::cylinder);
  EXPECT_EQ(cylinder.rival, Kind::cone);
}

TEST(Measurement, KeepsTheShapeWhenItsClearPointsAreElsewhere) {
  Random random(43);
  std::vector<test::SurfacePoint> points = patchOf(kBall, 1000, random);
  const Vec3 away(0.015, 0, 0);
  for (const test::SurfacePoint& p : patchOf(Sphere{kBall.center + away, kBall.radius}, 200, random))
    points.push_back(p);
  const Cloud cloud = test::cloudOf(measured(points, kNoise, 0.05, random));
  List<std::uint32_t> own(1000), clear(200);
  std::iota(own.begin(), own.end(), 0u);
  std::iota(clear.begin(), clear.end(), 1000u);
  const Params params;
  Detection kept;
  kept.shape = kBall;
  Measurement(cloud, findRays(cloud), params, {kNoiseModel, kNoiseModel}, {params, 1.0})
      .measure({own, {}, 1000}, clear, allOf(clear), kept);
  EXPECT_LT((std::get<Sphere>(kept.shape).center - kBall.center).norm(), 0.001);
  EXPECT_LT(kept.rms_error, 2.0 * kNoise);
}

/// Others of its points may be of another surface, which the better fit is far from.
TEST(Measurement, FollowsItsClearPointsAwayFromAFewOthers) {
  Random random(48);
  const Sphere ball = {Vec3(0, 0, 1), 0.08}, larger = {ball.center + Vec3(0, 0, 0.02), 0.1};  // they touch at the front
  std::vector<test::SurfacePoint> points;
  const auto add = [&](const Sphere& of, std::size_t count, double least, double most) {
    while (count > 0) {
      const test::SurfacePoint p = patchOf(of, 1, random).front();
      const double turn = std::acos(-p.normal.z());
      if (turn < least || turn > most) continue;
      points.push_back(p), --count;
    }
  };
  add(ball, 1000, 0.0, 0.4);
  add(larger, 60, 1.2, 1.5);
  const Cloud cloud = test::cloudOf(measured(points, kNoise, 0.05, random));
  List<std::uint32_t> own(1060), clear(1000);
  std::iota(own.begin(), own.end(), 0u);
  std::iota(clear.begin(), clear.end(), 0u);
  const Params params;
  Detection detection;
  detection.shape = larger;
  Measurement(cloud, findRays(cloud), params, {kNoiseModel, kNoiseModel}, {params, 1.0})
      .measure({own, {}, 1060}, clear, allOf(clear), detection);
  const double deviation = detection.radius_stddev;
  EXPECT_LT(deviation, 0.005);
  EXPECT_NEAR(std::get<Sphere>(detection.shape).radius, ball.radius, 3.0 * deviation);
}

/// A cone that touches another one along the line where its points are, as round there, but narrower: hard to tell
/// apart.
Cone narrowedTo(double half_angle, const Cone& cone, double height) {
  const test::SurfacePoint seen = test::pointOn(cone, height, 0.0);
  const Vec3 along = (seen.point - cone.apex).normalized();
  const double radius = (seen.point - cone.apex).norm() * std::tan(cone.half_angle);
  const Vec3 axis = std::cos(half_angle) * along - std::sin(half_angle) * seen.normal;
  return {seen.point - radius / std::tan(half_angle) * along, axis, half_angle};
}

/// A narrower cone that was found on some points of a cone, far from its apex, and on one point near its own: by how
/// many of its deviations the measured half angle is off.
double errorWithALonePointAtTheTip(std::uint64_t seed) {
  const Cone cone = {Vec3(0, -0.2, 1), Vec3(0, 1, 0), 0.3};
  const Cone narrower = narrowedTo(0.27, cone, 0.155);
  Random random(seed);
  std::vector<test::SurfacePoint> points;
  for (int k = 0; k < 500; ++k) {
    const double height = random.uniform(0.11, 0.2), angle = random.uniform(-1.0, 1.0);
    points.push_back(test::pointOn(cone, height, angle));
  }
  points.push_back(test::pointOn(narrower, 0.02, random.uniform(0.0, 2.0 * M_PI)));
  const Cloud cloud = test::cloudOf(measured(points, kNoise, 0.05, random));
  List<std::uint32_t> all(cloud.size());
  std::iota(all.begin(), all.end(), 0u);
  SeenPoints seen;
  seen.gather(cloud, all);
  Detection found;
  found.shape = narrower;
  found.extent = measureExtent(narrower, seen);
  moveEnds(-found.extent.radius_small / std::tan(narrower.half_angle), 0.0, narrower, found.extent);
  const Detection detection = measuredOn(cloud, kNoiseModel, found);
  return (std::get<Cone>(detection.shape).half_angle - cone.half_angle) / detection.half_angle_stddev;
}

TEST(Measurement, DoesNotBelieveALonePointAtTheTipOfACone) {
  constexpr int kSeeds = 20;
  double sum = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const double error = errorWithALonePointAtTheTip(static_cast<std::uint64_t>(seed));
    sum += error * error;
  }
  EXPECT_LT(sum / kSeeds, 2.0) << "20 and more with that point";
}

}  // namespace
}  // namespace primitect::measurement_test
