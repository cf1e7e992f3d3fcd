// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Depths that are off in waves over the image: how large these are said to be, and what covariances make of them.
#include "core/depth_waves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/random.h"
#include "primitect/detector.h"
#include "synthetic/depth_faults.h"
#include "synthetic/noise_field.h"
#include "synthetic/sensors.h"
#include "test/support/fit_errors.h"
#include "test/support/rendered_cloud.h"

namespace primitect::depth_waves_test {
namespace {

using synthetic::PinholeCamera;

constexpr int kLength = 71;  // px

/// A plane as a camera sees it that errs in waves of this share of the depth, and by noise of this one in every pixel.
struct SeenPlane {
  Vec3 normal = Vec3(0.1, -0.6, -0.8).normalized();
  double share = 0.0025, noise = 0.002;
  int rows = 480, columns = 640;  ///< of the image, in its upper left corner
  std::size_t count = 2048;       ///< of its pixels, evenly taken

  SeenPoints points(std::uint64_t seed) const {
    const PinholeCamera camera;
    const Vec3 place(0.0, 0.0, 1.0);
    std::vector<float> depth(camera.pixelCount());
    for (std::size_t i = 0; i < depth.size(); ++i) {
      depth[i] = static_cast<float>(normal.dot(place) / normal.dot(rayOf(i, camera)));
    }
    if (share > 0.0) synthetic::bend(share, kLength, camera, seed, depth);
    Random random(seed + 1000);
    std::vector<Vec3> points;
    const std::size_t all = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t number = k * all / count, width = static_cast<std::size_t>(columns);
      const std::size_t i = number / width * static_cast<std::size_t>(camera.width) + number % width;
      points.push_back(static_cast<double>(depth[i]) * (1.0 + noise * random.gaussian()) * rayOf(i, camera));
    }
    return points;
  }

  DepthWaves found(std::uint64_t seed) const {
    WaveFinder finder;
    finder.see(points(seed));
    return finder.waves();
  }

  static Vec3 rayOf(std::size_t i, const PinholeCamera& camera) {
    const auto width = static_cast<std::size_t>(camera.width);
    return {(static_cast<double>(i % width) - camera.cx) / camera.fx,
            (static_cast<double>(i / width) - camera.cy) / camera.fy, 1.0};
  }
};

/// Where they are half as much alike, in x / z.
double reachOf(const DepthWaves& waves) {
  double reach = 0.0;
  while (waves.covariance(reach * reach) > 0.5 * waves.covariance(0.0)) reach += 0.001;
  return reach;
}

TEST(DepthWaves, AreAsLargeAndAsLongAsTheyAre) {
  constexpr int kSeeds = 12;
  double logarithms = 0.0, reaches = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const SeenPlane plane;
    const DepthWaves waves = plane.found(seed);
    ASSERT_GT(waves.share(), 0.5 * plane.share) << seed;
    EXPECT_LT(waves.share(), 2.0 * plane.share) << seed;
    logarithms += std::log(waves.share() / plane.share) / kSeeds;
    reaches += reachOf(waves) / kSeeds;
  }
  EXPECT_NEAR(std::exp(logarithms), 1.0, 0.25);
  // That of waveField is Gaussian, with half of the likeness at its length.
  EXPECT_NEAR(reaches, kLength / PinholeCamera().fx, 0.25 * kLength / PinholeCamera().fx);
}

TEST(DepthWaves, ShowOnPlanesOfAnySlant) {
  for (const Vec3& normal : {Vec3(0, 0, -1), Vec3(0.8, 0.0, -0.6), Vec3(0.0, -0.9, -0.44)}) {
    SeenPlane plane;
    plane.normal = normal.normalized();
    double shares_sq = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) shares_sq += std::pow(plane.found(seed).share(), 2) / 8.0;
    EXPECT_NEAR(std::sqrt(shares_sq), plane.share, 0.45 * plane.share) << normal.transpose();
  }
}

TEST(DepthWaves, AreNoneWhereThereIsOnlyNoise) {
  for (const double noise : {0.0005, 0.002, 0.008}) {
    SeenPlane plane;
    plane.share = 0.0;
    plane.noise = noise;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) EXPECT_EQ(plane.found(seed).share(), 0.0) << noise << " " << seed;
  }
}

/// What only the points of one cell share, all distances show alike.
TEST(DepthWaves, AreNoGrains) {
  const PinholeCamera camera;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const std::vector<float> field = synthetic::noiseField(15, camera, seed);
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < 2048; ++k) {
      const std::size_t i = k * field.size() / 2048;
      points.push_back((1.0 + 0.005 * static_cast<double>(field[i])) * SeenPlane::rayOf(i, camera));
    }
    WaveFinder finder;
    finder.see(points);
    EXPECT_LT(finder.waves().share(), 0.0005) << seed;
  }
}

TEST(DepthWaves, AreNoneThatNoiseHides) {
  SeenPlane plane;
  plane.share = 0.0002;
  plane.noise = 0.008;
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) found += plane.found(seed).share() > 0.0 ? 1 : 0;
  EXPECT_LE(found, 1);
}

TEST(DepthWaves, NeedALargePlane) {
  SeenPlane few, small;
  few.count = 255;
  few.rows = few.columns = 200;     // twelve cells by twelve
  small.rows = small.columns = 90;  // six by six
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(few.found(seed).share(), 0.0) << seed;
    EXPECT_EQ(small.found(seed).share(), 0.0) << seed;
  }
  WaveFinder nothing;
  nothing.see({});
  nothing.see(std::vector<Vec3>(2048, Vec3(0, 0, 1)));
  EXPECT_EQ(nothing.waves().share(), 0.0);
  EXPECT_FALSE(nothing.hasSeen());
  nothing.see(SeenPlane().points(1));
  EXPECT_TRUE(nothing.hasSeen());
}

TEST(DepthWaves, OfSeveralPlanesAreTakenTogether) {
  SeenPlane plane;
  plane.share = 0.001;
  plane.noise = 0.005;
  plane.columns = 300;
  int alone = 0, together = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    WaveFinder finder;
    for (const std::uint64_t part : {0, 100, 200, 300}) finder.see(plane.points(seed + part));
    together += finder.waves().share() > 0.0 ? 1 : 0;
    alone += plane.found(seed).share() > 0.0 ? 1 : 0;
  }
  EXPECT_GE(together, alone + 4) << alone;
}

/// Of patches whose points err by waves and by noise; waves are said to be as they are found on a plane.
struct Errors {
  double alone = 0.0, with_waves = 0.0;
};

Errors normalisedErrors(Kind kind) {
  constexpr int kSeeds = 30;
  constexpr double kNoise = 0.002, kShare = 0.0025;
  const PinholeCamera camera;
  SeenPlane plane;
  plane.share = kShare;
  Errors mean;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    const test::Patch patch = test::randomPatch(kind, 2000, random);
    const std::vector<float> field = synthetic::waveField(kLength, camera, seed);
    std::vector<test::SurfacePoint> points = patch.points;
    std::vector<Vec3> measured;
    for (test::SurfacePoint& p : points) {
      const int column = static_cast<int>(camera.cx + camera.fx * p.point.x() / p.point.z());
      const int row = static_cast<int>(camera.cy + camera.fy * p.point.y() / p.point.z());
      const int inside = std::clamp(row, 0, camera.height - 1) * camera.width + std::clamp(column, 0, camera.width - 1);
      const double off = kShare * static_cast<double>(field[static_cast<std::size_t>(inside)]);
      p.point += off * p.point + kNoise * random.gaussian() * p.normal;
      measured.push_back(p.point);
    }
    // So wide that all of the points count.
    const auto noise = [](const Vec3&) { return 2.0 * kNoise; };
    const std::optional<Shape> fit = test::fitTo(points, patch.truth, noise);
    if (!fit) return {std::nan(""), std::nan("")};
    const auto errorOf = [&](const SharedErrors& shared) {
      const Hessian covariance = measureCovariance(*fit, measured, noise, shared);
      return test::normalisedError(*fit, patch.truth, covariance) / kSeeds;
    };
    mean.alone += errorOf({});
    mean.with_waves += errorOf({{}, plane.found(seed)});
  }
  return mean;
}

TEST(DepthWaves, HaveTheSameCovariancesOfManyDistancesAsOfEach) {
  DepthWaves waves;
  waves.variances = {2e-6, 0.0, 5e-6, 1e-6};
  const std::vector<float> apart_sq = {0.0f, 1e-6f, 0.002f, 0.01f, 0.03f, 0.13f, 1.0f, 30.0f};
  std::vector<float> alike(apart_sq.size() + 1, -1.0f);
  waves.covariances(apart_sq.data(), apart_sq.size(), alike.data());
  for (std::size_t k = 0; k < apart_sq.size(); ++k) {
    const double one = waves.covariance(static_cast<double>(apart_sq[k]));
    EXPECT_NEAR(static_cast<double>(alike[k]), one, 1e-6 * one) << apart_sq[k];
  }
  EXPECT_EQ(alike.back(), -1.0f);
}

TEST(DepthWaves, MakeTheCovarianceThatOfTheErrors) {
  for (const Kind kind : test::kKinds) {
    const Errors errors = normalisedErrors(kind);
    EXPECT_GT(errors.alone, 10.0) << kindName(kind);
    EXPECT_GT(errors.with_waves, 0.6) << kindName(kind);
    EXPECT_LT(errors.with_waves, 1.8) << kindName(kind);
  }
}

/// A ball, a can and a cone on a table, seen by a camera of this kind.
constexpr double kRadius = 0.08, kDistance = 0.9, kDown = 0.9;

Cloud thingsOnTable(const std::string& sensor, std::uint64_t seed) {
  synthetic::World world;
  const Eigen::Isometry3d table = test::tableBeforeCamera(kDistance, kDown);
  const auto on_table = [&table](double x, double z) { return table * Eigen::Translation3d(x, 0.0, z); };
  world.add("table", synthetic::Sheet{0.5, 0.35}, table);
  world.add("ball", synthetic::Ball{kRadius}, on_table(0.0, kRadius));
  world.add("can", synthetic::Rod{0.04, 0.06}, on_table(-0.2, 0.06));
  world.add("cone", synthetic::Frustum{0.3, 0.05, 0.25}, on_table(0.22, 0.25) * Eigen::AngleAxisd(M_PI, Vec3::UnitX()));
  synthetic::FrameParams params;
  params.noise = synthetic::noiseOf(sensor);
  return test::renderedCloud(world, params, seed);
}

const Detection* firstOf(Kind kind, const Detections& found) {
  for (const Detection& item : found.items) {
    if (kindOf(item.shape) == kind) return &item;
  }
  return nullptr;
}

/// Squared error of a centre over its degrees of freedom.
double errorOfBall(const Detection& ball) {
  const Vec3 truth(0.0, -std::cos(kDown) * kRadius, kDistance - std::sin(kDown) * kRadius);
  const Vec3 off = std::get<Sphere>(ball.shape).center - truth;
  const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> covariance(ball.covariance.data());
  return off.dot(Eigen::Matrix3d(covariance.topLeftCorner<3, 3>()).ldlt().solve(off)) / 3.0;
}

struct WithAndWithout {
  Detections with_waves, alone;

  WithAndWithout(const std::string& sensor, std::uint64_t seed) {
    const Cloud cloud = thingsOnTable(sensor, seed);
    Params without;
    without.left_out.add(Step::depth_waves);
    with_waves = Detector{Params()}.detect(cloud);
    alone = Detector{without}.detect(cloud);
  }
};

TEST(DepthWaves, AreInTheCovariancesOfAFrame) {
  constexpr int kSeeds = 12;
  double with_waves = 0.0, alone = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const WithAndWithout found("bent_structured_light", seed);
    EXPECT_NEAR(found.with_waves.depth_waves, 0.0025, 0.0015) << seed;
    EXPECT_EQ(found.alone.depth_waves, -1.0) << seed;
    const Detection* const ball = firstOf(Kind::sphere, found.with_waves);
    const Detection* const same = firstOf(Kind::sphere, found.alone);
    ASSERT_TRUE(ball && same) << seed;
    with_waves += errorOfBall(*ball) / kSeeds;
    alone += errorOfBall(*same) / kSeeds;
    EXPECT_GT(ball->radius_stddev, same->radius_stddev) << seed;
    const Detection* const can = firstOf(Kind::cylinder, found.with_waves);
    const Detection* const table = firstOf(Kind::plane, found.with_waves);
    ASSERT_TRUE(can && table) << seed;
    EXPECT_GE(can->axis_stddev, 0.99f * table->axis_stddev) << "which it stands on, seed " << seed;
  }
  EXPECT_GT(alone, 10.0);
  EXPECT_GT(with_waves, 0.3);
  EXPECT_LT(with_waves, 2.5);
}

TEST(DepthWaves, ChangeNothingElse) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const WithAndWithout found("bent_structured_light", seed);
    ASSERT_EQ(found.with_waves.items.size(), found.alone.items.size()) << seed;
    for (std::size_t k = 0; k < found.alone.items.size(); ++k) {
      const Detection &item = found.with_waves.items[k], &same = found.alone.items[k];
      EXPECT_EQ(kindOf(item.shape), kindOf(same.shape)) << seed;
      EXPECT_EQ(item.rival, same.rival) << seed;
      EXPECT_EQ(item.confidence, same.confidence) << seed;
      EXPECT_EQ(item.extent.origin, same.extent.origin) << seed;
      EXPECT_EQ(item.extent.size, same.extent.size) << seed;
      EXPECT_GT(item.position_stddev, same.position_stddev) << seed;
    }
  }
}

/// Nor where nothing is known of depths.
TEST(DepthWaves, AreNotSeenWhereTheCameraHasNone) {
  Detector detector{Params()};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    EXPECT_EQ(detector.detect(thingsOnTable("structured_light", seed)).depth_waves, 0.0) << seed;
  }
  Params of_any_sensor;
  of_any_sensor.inlier_depth_share = 0.0;
  EXPECT_EQ(Detector{of_any_sensor}.detect(thingsOnTable("bent_structured_light", 1)).depth_waves, -1.0);
}

}  // namespace
}  // namespace primitect::depth_waves_test
