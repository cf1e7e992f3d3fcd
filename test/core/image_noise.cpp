// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How noisy an image is, told from its windows, and what the detector makes of noisy ones.
#include "core/image_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/noise.h"
#include "core/point_noise.h"
#include "core/random.h"
#include "core/sampling.h"
#include "core/window_normal.h"
#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "synthetic/sensors.h"
#include "test/support/rendered_cloud.h"

namespace primitect::image_noise_test {
namespace {

synthetic::FrameParams noisy(double scale, int grain = 1) {
  synthetic::FrameParams params;
  params.noise.scale = scale;
  params.noise.grain = grain;
  if (scale == 0.0) params.noise.disparity_step = 0.0;
  return params;
}

Cloud tableCloud(double scale, std::uint64_t seed, int grain = 1) {
  return test::renderedCloud(synthetic::clutteredTable(seed), noisy(scale, grain), seed, synthetic::clutterPose(seed));
}

ImageNoise noiseIn(const Cloud& image) {
  Samples samples;
  drawSamples(image, 900, 1, samples);
  NormalSource source;
  return measureImageNoise(image, source, samples);
}

double measuredIn(const Cloud& image) { return noiseIn(image).scale; }

TEST(ImageNoise, IsThatOfTheSensor) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    EXPECT_LT(measuredIn(tableCloud(0.0, seed)), 0.3) << "what curves in a window";
    EXPECT_NEAR(measuredIn(tableCloud(1.0, seed)), 1.0, 0.12);
    EXPECT_NEAR(measuredIn(tableCloud(2.0, seed)), 2.0, 0.2);
    EXPECT_NEAR(measuredIn(tableCloud(3.0, seed)), 3.0, 0.35);
    EXPECT_GT(measuredIn(tableCloud(10.0, seed)), 3.0) << "as far as can be told";
  }
}

TEST(ImageNoise, IsAlikeInGrains) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    EXPECT_NEAR(noiseIn(tableCloud(3.0, seed)).likeness, 0.0, 0.1);
    EXPECT_NEAR(noiseIn(tableCloud(3.0, seed, 3)).likeness, 0.3, 0.1);
    EXPECT_NEAR(noiseIn(tableCloud(3.0, seed, 7)).likeness, 0.57, 0.06);
    EXPECT_EQ(grainOf(noiseIn(tableCloud(1.0, seed))), 1.0);
    EXPECT_GT(grainOf(noiseIn(tableCloud(3.0, seed, 7))), 4.0);
  }
  EXPECT_EQ(grainOf(ImageNoise()), 1.0) << "not measured";
}

TEST(ImageNoise, OfAStereoCameraGrowsFaster) {
  synthetic::FrameParams stereo;
  stereo.noise = synthetic::noiseOf("stereo");
  synthetic::World world;
  const Eigen::Isometry3d table = test::tableBeforeCamera(0.8, 30.0 * M_PI / 180.0);
  world.add("table", synthetic::Sheet{1.0, 0.4}, table);
  world.add("wall", synthetic::Sheet{4.0, 4.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.8)));
  const ImageNoise seen = noiseIn(test::renderedCloud(world, stereo, 3));
  EXPECT_GT(seen.farther, 1.4);
  EXPECT_GT(growthOf(seen), 1.4);
  for (const int grain : {1, 7}) {
    const ImageNoise usual = noiseIn(test::renderedCloud(world, noisy(2.0, grain), 3));
    EXPECT_NEAR(usual.farther, 1.0, 0.15) << grain;
    EXPECT_EQ(growthOf(usual), 1.0) << grain;
  }
  NoiseModel noise;
  noise.depth_share = 0.002;
  const double before = noise.at(Vec3(0.0, 0.0, 1.8));
  noise.growth = 1.8;
  EXPECT_NEAR(noise.at(Vec3(0.0, 0.0, 1.8)) - before, 0.8 * kAxialGrowth * 1.4 * 1.4, 1e-9);
  EXPECT_EQ(PointNoise(noise)(Vec3(0.0, 0.0, 1.8)), noise.at(Vec3(0.0, 0.0, 1.8)));
}

/// Of two walls that face the camera every depth is exact.
TEST(ImageNoise, OfExactDepthsGrowsAsUsual) {
  const synthetic::PinholeCamera camera;
  std::vector<float> depth(camera.pixelCount(), 1.5f);
  std::fill_n(depth.begin(), depth.size() / 2, 1.0f);
  Cloud cloud;
  cloudFromDepth(depth, camera, DepthRange(), cloud);
  EXPECT_EQ(growthOf(noiseIn(cloud)), 1.0);
  Detector detector{Params()};
  EXPECT_EQ(detector.detect(cloud).items.size(), 2u);
}

/// Too few pixels there have neighbours that tell whether they err alike.
TEST(ImageNoise, IsToldInCoarseImagesWithHoles) {
  const synthetic::PinholeCamera coarse = synthetic::PinholeCamera().scaledTo(160, 120);
  synthetic::FrameParams params = noisy(3.0);
  params.noise.blots = 0.3;
  params.noise.blot_grain = 1;
  Cloud cloud;
  cloudFromDepth(renderFrame(synthetic::clutteredTable(1), coarse, synthetic::clutterPose(1), params, 1, 0).depth,
                 coarse, params.truth.range, cloud);
  EXPECT_GT(measuredIn(cloud), 2.0);
}

TEST(ImageNoise, HasTheUsualGrainOfCamerasWherePixelsErrAlikeAtAll) {
  const auto at = [](double likeness) { return usualGrainOf({1.0, 1.0, likeness}); };
  EXPECT_EQ(at(0.0), 1.0);
  EXPECT_EQ(at(0.15), 1.0);
  EXPECT_NEAR(at(0.225), 1.75, 1e-9);
  EXPECT_EQ(at(0.35), 2.5);
  EXPECT_EQ(at(0.66), 2.5);
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_EQ(usualGrainOf(noiseIn(tableCloud(1.0, seed))), 1.0);
    EXPECT_GT(usualGrainOf(noiseIn(tableCloud(3.0, seed, 3))), 1.5);
  }
}

TEST(ImageNoise, IsSteadiedDownToTheUsual) {
  const auto of = [](double scale, double likeness = 0.01) { return steadyingOf({scale, 1.0, likeness}); };
  EXPECT_EQ(of(0.0), 0.0) << "not measured";
  EXPECT_EQ(of(3.0, 0.0), 0.0) << "nobody knows what pixels share";
  EXPECT_GT(of(3.0, 0.4), 0.5) << "as usual";
  EXPECT_EQ(of(3.0, 0.5), 0.0) << "pixels share more than usual";
  EXPECT_EQ(of(1.0), 0.0);
  EXPECT_EQ(of(kNoisy), 0.0);
  EXPECT_NEAR(of(2.0 * kNoisy), 0.5, 1e-9);
  EXPECT_NEAR(of(4.0 * kNoisy), 0.75, 1e-9);
}

TEST(ImageNoise, OfSteadiedSamplesIsTheirOwnAndWhatPixelsShare) {
  const auto of = [](double likeness, double steadying) { return noiseOfSteadied({3.0, 1.0, likeness}, steadying); };
  EXPECT_DOUBLE_EQ(of(0.0, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(of(0.5, 0.0), 3.0);
  EXPECT_NEAR(of(-0.05, 1.0), 1.0, 1e-9) << "each for itself: a mean of 9";
  EXPECT_NEAR(of(0.16, 1.0), 1.5, 1e-9) << "a quarter of the squares is shared";
  EXPECT_NEAR(of(0.16, 0.5), 3.0 * std::sqrt(0.25 + 0.75 * 0.25), 1e-9);
  EXPECT_NEAR(of(0.8, 0.5), 3.0, 1e-9) << "a block matcher's share it all";
}

/// Whether steady points change where the shapes of a table are.
bool areSteadied(const Cloud& cloud) {
  Params without;
  without.left_out.add(Step::steady_points);
  const auto places = [&cloud](const Params& params) {
    Detector detector{params};
    std::vector<double> result;
    for (const Detection& found : detector.detect(cloud).items) {
      result.insert(result.end(), found.extent.origin.data(), found.extent.origin.data() + 3);
    }
    return result;
  };
  const std::vector<double> with_them = places(Params());
  EXPECT_FALSE(with_them.empty());
  return with_them != places(without);
}

TEST(SteadyPoints, AreThoseOfNoisyImagesWithoutNormals) {
  EXPECT_FALSE(areSteadied(tableCloud(1.0, 5))) << "as noisy as usual";
  Cloud cloud = tableCloud(3.0, 5);
  EXPECT_TRUE(areSteadied(cloud));
  EXPECT_FALSE(areSteadied(tableCloud(3.0, 5, 7))) << "pixels share too much";
  // Their samples are not moved, so that these have all of the noise.
  cloud.nx.assign(cloud.size(), 0.0f), cloud.ny = cloud.nx, cloud.nz = cloud.nx;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const auto normal = cloud.valid(i) ? windowNormal(cloud, i, 7, {}, 2.0) : std::nullopt;
    const Vec3 direction = normal ? normal->direction : Vec3(Vec3::Constant(std::nan("")));
    cloud.setNormal(i, static_cast<float>(direction.x()), static_cast<float>(direction.y()),
                    static_cast<float>(direction.z()));
  }
  EXPECT_FALSE(areSteadied(cloud)) << "brings normals";
}

/// A wall, 1.8 m away: how far its normals are off about each axis, and what is said of that (rad).
std::pair<double, double> spreadAndSigma(const Cloud& wall, const NormalSource& with) {
  Samples samples;
  drawSamples(wall, 900, 1, samples);
  NormalSource source;
  source.grain = with.grain, source.usual_grain = with.usual_grain;
  estimateNormals(wall, Params(), source, samples);
  double squares = 0.0, sigmas = 0.0, count = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples.hasNormal(i)) continue;
    squares += samples.normal(i).head<2>().squaredNorm(), sigmas += samples.normal_sigma[i], count += 1.0;
  }
  return {std::sqrt(0.5 * squares / count), sigmas / count};
}

Cloud farWall(double noise_scale, int grain) {
  synthetic::World world;
  world.add("wall", synthetic::Sheet{4.0, 4.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.8)));
  return test::renderedCloud(world, noisy(noise_scale, grain), 3);
}

TEST(ImageNoise, OfTheUsualGrainMakesFarWindowsLargerAndSaysMore) {
  const Cloud wall = farWall(1.0, 3);
  NormalSource with;
  const auto [alone, alone_sigma] = spreadAndSigma(wall, with);
  with.usual_grain = 2.5;
  const auto [larger, larger_sigma] = spreadAndSigma(wall, with);
  EXPECT_LT(larger, 0.75 * alone);
  EXPECT_GT(alone, 1.5 * alone_sigma) << "as if each pixel erred on its own";
  EXPECT_LT(larger, 2.1 * larger_sigma) << "the rest is measured on the strongest candidates";
}

/// Walls that were not found in the first look cost the closer look its samples, and with it all small things.
TEST(ImageNoise, OfTheUsualGrainHidesNoWallsFromTheFirstLook) {
  const Cloud wall = farWall(1.5, 3);
  for (int seed = 1; seed <= 10; ++seed) {
    Params params;
    params.seed = seed;
    params.closer_samples = 0;
    EXPECT_EQ(Detector(params).detect(wall).items.size(), 1u) << seed;
  }
}

/// Far away 7 x 7 pixels that share their noise are nearly a whole window of the usual size.
TEST(ImageNoise, InGrainsMakesWindowsOfNormalsLarger) {
  const Cloud wall = farWall(1.5, 7);
  NormalSource with;
  const auto [usual, usual_sigma] = spreadAndSigma(wall, with);
  with.grain = 7.0;
  const auto [larger, larger_sigma] = spreadAndSigma(wall, with);
  EXPECT_LT(larger, 0.7 * usual);
  EXPECT_LT(larger, 0.2);
  EXPECT_GT(usual, 4.0 * usual_sigma) << "as if each pixel erred on its own";
  EXPECT_LT(larger, 4.0 * larger_sigma);
}

/// Of a thing that was cut out of its frame nothing flat is in view.
TEST(ImageNoise, IsNotWhatCurves) {
  for (const double radius : {0.03, 0.05, 0.08}) {
    synthetic::World world;
    world.add("ball", synthetic::Ball{radius}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.9)));
    const double measured = measuredIn(test::renderedCloud(world, noisy(1.0), 7));
    EXPECT_GT(measured, 0.85) << radius;
    EXPECT_EQ(toleratedScale(measured), 1.0) << radius << " m, noise " << measured;
  }
  synthetic::World world;
  world.add("can", synthetic::Rod{0.04, 0.1},
            Eigen::Translation3d(0.0, 0.0, 0.9) * Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX())));
  EXPECT_NEAR(measuredIn(test::renderedCloud(world, noisy(1.0), 8)), 1.0, 0.2);
}

TEST(ImageNoise, InGrainsIsTakenForSomeOfIt) {
  const double measured = measuredIn(tableCloud(2.0, 1, 5));
  EXPECT_GT(measured, 1.4);
  EXPECT_LT(measured, 2.0);
}

TEST(ImageNoise, IsThatOfTheSmoothestQuarter) {
  Cloud cloud = tableCloud(1.0, 4);
  Random random(5);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % cloud.width < cloud.width / 2) continue;
    const float rough = 1.0f + 0.02f * static_cast<float>(random.gaussian());
    for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= rough;
  }
  EXPECT_NEAR(measuredIn(cloud), 1.0, 0.2);
}

TEST(ImageNoise, OfACoarseImageIsToldFromSmallerWindows) {
  const synthetic::PinholeCamera coarse = {160, 120, 131.25, 131.25, 79.5, 59.5};
  synthetic::FrameParams params = noisy(2.0);
  params.noise.disparity_step = 0.0;  // of so few pixels an eighth is more than the noise
  Cloud cloud;
  cloudFromDepth(renderFrame(synthetic::clutteredTable(3), coarse, synthetic::clutterPose(3), params, 3, 0).depth,
                 coarse, params.truth.range, cloud);
  EXPECT_NEAR(measuredIn(cloud), 2.0, 0.3);
}

TEST(ImageNoise, OfAFewPointsCannotBeTold) {
  Cloud cloud = tableCloud(1.0, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t column = i % cloud.width, row = i / cloud.width;
    if (column % 8 == 0 && row % 8 == 0) continue;
    cloud.x[i] = cloud.y[i] = cloud.z[i] = std::nanf("");
  }
  EXPECT_EQ(measuredIn(cloud), 0.0);
}

TEST(ImageNoise, IsToldWhereADepthCameraTookTheCloud) {
  Detector detector{Params()};
  EXPECT_NEAR(detector.detect(tableCloud(2.0, 1)).image_noise, 2.0, 0.25);
  Params of_any;
  of_any.inlier_depth_share = 0.0;
  Detector other{of_any};
  EXPECT_EQ(other.detect(tableCloud(2.0, 1)).image_noise, 0.0);
}

TEST(ImageNoise, IsWhatNormalsOfSamplesAreFittedWith) {
  const auto measured = [](double scale) {
    Detector detector{Params()};
    detector.detect(tableCloud(scale, 1));
    const SampleView samples = detector.samples();
    const auto count = std::count_if(samples.nx, samples.nx + samples.count, [](float nx) { return !std::isnan(nx); });
    return static_cast<double>(count);
  };
  const double usual = measured(1.0);
  for (const double scale : {2.0, 3.0}) EXPECT_GT(measured(scale), 0.93 * usual) << scale;  // else .86 and .68
}

TEST(Noise, OfACameraGrowsWithItsScale) {
  NoiseModel noise = {0.0, 0.0001};
  const Vec3 point(0.0, 0.0, 1.2);
  const double usual = noise.at(point);
  noise.scale = 3.0;
  EXPECT_DOUBLE_EQ(noise.at(point), 3.0 * usual);
  EXPECT_EQ(toleratedScale(1.4), 1.0) << "as it was";
  EXPECT_DOUBLE_EQ(toleratedScale(3.0), 2.1);
  EXPECT_DOUBLE_EQ(fullScale(3.0), 3.0);
  EXPECT_EQ(fullScale(0.0), 1.0);
}

TEST(Noise, OfACameraIsTheSameForOneAndForManyPoints) {
  const NoiseModel noise = {0.0, 0.0001, 0.5, 3.0};
  const float depths[] = {0.5f, 1.0f, 1.5f, 2.0f};
  float sigma[4];
  kernels::loops().tolerances(flattened(noise, 2.0), depths, 4, sigma);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(sigma[k], 2.0 * noise.at(Vec3(0.0, 0.0, depths[k])), 1e-6) << depths[k];
}

TEST(WindowNormals, AreAsMuchWorseAsTheImageIsNoisier) {
  const Cloud cloud = tableCloud(3.0, 1);
  int found_as_usual = 0, found = 0;
  for (std::uint32_t pixel = 240 * 640 + 100; pixel < 240 * 640 + 540; pixel += 5) {
    const auto as_usual = windowNormal(cloud, pixel, 7), noisy = windowNormal(cloud, pixel, 7, {}, 3.0);
    found_as_usual += as_usual ? 1 : 0, found += noisy ? 1 : 0;
    if (!as_usual || !noisy) continue;
    EXPECT_GT(noisy->sigma, 1.5 * as_usual->sigma) << "of more pixels, each three times as noisy";
  }
  EXPECT_GT(found, 1.2 * found_as_usual) << "the centre is too far from the plane for the usual noise";
}

TEST(ImageNoise, IsToldWhereEverySecondRowIsMissing) {
  Cloud cloud = tableCloud(3.0, 1);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i / cloud.width % 2 == 0) cloud.x[i] = cloud.y[i] = cloud.z[i] = std::nanf("");
  }
  EXPECT_NEAR(measuredIn(cloud), 3.0, 0.4);
}

/// Tables fell apart, or were not found, before tolerances grew with the noise.
TEST(ImageNoise, OfThreeTimesTheUsualLeavesTheTableInOnePiece) {
  for (const int grain : {1, 5}) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
      const synthetic::FrameParams params = noisy(3.0, grain);
      const synthetic::PinholeCamera camera;
      const synthetic::Frame frame =
          renderFrame(synthetic::clutteredTable(seed), camera, synthetic::clutterPose(seed), params, seed, 0);
      Cloud cloud;
      cloudFromDepth(frame.depth, camera, params.truth.range, cloud);
      const Detection* table = nullptr;
      for (const Detection& truth : frame.truth.items) {
        const bool larger = !table || truth.inlier_count > table->inlier_count;
        if (kindOf(truth.shape) == Kind::plane && larger) table = &truth;
      }
      ASSERT_TRUE(table);
      const Plane& plane = std::get<Plane>(table->shape);
      Detector detector{Params()};
      std::uint32_t largest = 0, others = 0;
      for (const Detection& found : detector.detect(cloud).items) {
        const Plane* face = std::get_if<Plane>(&found.shape);
        const bool of_table = face && std::abs(face->normal.dot(plane.normal)) > std::cos(0.05) &&
                              std::abs(distance(table->shape, found.extent.origin)) < 0.02;
        if (!of_table) continue;
        others += std::min(largest, found.inlier_count);
        largest = std::max(largest, found.inlier_count);
      }
      EXPECT_GT(largest, 0.6 * table->inlier_count) << "seed " << seed << ", grain " << grain;
      EXPECT_LT(others, (grain == 1 ? 0.1 : 0.2) * largest) << "seed " << seed << ", grain " << grain;
    }
  }
}

}  // namespace
}  // namespace primitect::image_noise_test
