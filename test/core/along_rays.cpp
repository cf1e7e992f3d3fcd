// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits to points whose depth is wrong, and nothing else.
#include "core/along_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/fitting.h"
#include "core/residuals.h"
#include "test/support/exact_shapes.h"
#include "test/support/scenes.h"

namespace primitect {
namespace {

using test::patchOf;
using test::SurfacePoint;

constexpr double kSigma = 0.002;  // m

FitPoints gathered(const std::vector<Vec3>& points) {
  FitPoints gathered;
  gathered.gather(SeenPoints(points), NoiseModel{kSigma});
  return gathered;
}

/// Pointing away from the camera, 0.9 m in front of it, as what stands on a table below.
const Cone kStanding = {Vec3(0.1, 0.05, 0.85), Vec3(0.0, 0.76, 0.65).normalized(), 0.4};

/// A patch of it, away from its border, that the camera sees: `count` points.
std::vector<SurfacePoint> patchOfCone(int count, Random& random) {
  const Vec3 out = -kStanding.apex.normalized(), x = kStanding.axis.unitOrthogonal();
  const double towards = std::atan2(out.dot(kStanding.axis.cross(x)), out.dot(x));
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i)
    points.push_back(
        test::pointOn(kStanding, random.uniform(0.03, 0.085), towards + 50.0 * test::kDegree * random.uniform(-1, 1)));
  return points;
}

TEST(AlongRays, PointsKeepTheirFootAndWhatTheErrorMakesAcrossTheSurface) {
  Random random(1);
  const Sphere ball = {Vec3(0.1, -0.1, 1.0), 0.05};
  const Cylinder can = {Vec3(0.0, 0.1, 0.9), Vec3(1.0, 2.0, 0.5).normalized(), 0.04};
  const std::pair<Shape, std::vector<SurfacePoint>> patches[] = {{ball, patchOf(ball, 400, random)},
                                                                 {can, patchOf(can, 400, -0.1, 0.1, random)},
                                                                 {kStanding, patchOfCone(400, random)}};
  for (const auto& [shape, patch] : patches) {
    std::vector<Vec3> measured, places;
    for (const SurfacePoint& p : patch) {
      if (p.normal.dot(p.point.normalized()) > -0.3) continue;  // not seen, or hardly
      places.push_back(p.point);
      measured.push_back(p.point * (1.0 + 0.003 * random.uniform(-1, 1)));
    }
    ASSERT_GE(measured.size(), 50u);
    const FitPoints points = gathered(measured);
    const SeenPoints moved = AlongRays(points).seenFor(shape);
    ASSERT_EQ(moved.size(), measured.size());
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const Vec3 normal = normalAt(shape, places[k]);
      const double across = (measured[k] - places[k]).dot(normal);
      EXPECT_LT((moved.point(k) - (places[k] + across * normal)).norm(), 2e-6) << kindName(kindOf(shape)) << " " << k;
    }
  }
}

TEST(AlongRays, PointsBesideTheSurfaceStayWhereTheyAre) {
  const Sphere ball{Vec3(0.0, 0.0, 1.0), 0.05};
  const std::vector<Vec3> beside = {{0.052, 0.0, 1.0}, {0.0, -0.0515, 0.99}};
  const SeenPoints seen = AlongRays(gathered(beside)).seenFor(ball);
  for (std::size_t k = 0; k < beside.size(); ++k) EXPECT_LT((seen.point(k) - beside[k]).norm(), 1e-7);
}

TEST(AlongRays, ASmallPatchOfAConeHasNoBias) {
  constexpr int kTimes = 60, kPoints = 600;
  Random random(2);
  double along = 0.0, along_sq = 0.0, across = 0.0;
  for (int time = 0; time < kTimes; ++time) {
    std::vector<Vec3> measured;
    for (const SurfacePoint& p : patchOfCone(kPoints, random))
      measured.push_back(p.point * (1.0 + kSigma * random.gaussian() / p.point.z()));
    const FitPoints points = gathered(measured);
    const auto by_rays = refineAlongRays(kStanding, points), by_distance = refine(kStanding, points);
    ASSERT_TRUE(by_rays && by_distance) << time;
    const double error = std::get<Cone>(*by_rays).half_angle - kStanding.half_angle;
    along += error / kTimes, along_sq += error * error / kTimes;
    across += (std::get<Cone>(*by_distance).half_angle - kStanding.half_angle) / kTimes;
  }
  const double of_mean = std::sqrt((along_sq - along * along) / kTimes);
  EXPECT_LT(std::abs(along), 3.0 * of_mean);
  EXPECT_LT(of_mean, 0.4 * test::kDegree) << "or this says nothing";
  EXPECT_GT(across, 0.6 * test::kDegree) << "or there was nothing to mend";
}

}  // namespace
}  // namespace primitect
