// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Flying pixels, shadows, waves and blots against what they are said to be, and the sensors made of them.
#include "synthetic/depth_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "synthetic/sensors.h"

namespace primitect::synthetic::depth_faults_test {
namespace {

const PinholeCamera kCamera;
constexpr int kEdge = 300;  // first column of what is far

/// Near to the left of a column, far to its right.
std::vector<float> step(float near, float far) {
  std::vector<float> depth(kCamera.pixelCount());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] = static_cast<int>(i % static_cast<std::size_t>(kCamera.width)) < kEdge ? near : far;
  }
  return depth;
}

float at(const std::vector<float>& depth, int column, int row = 240) {
  return depth[static_cast<std::size_t>(row) * kCamera.width + column];
}

double deviation(const std::vector<float>& depth, double truth) {
  double squares = 0.0, count = 0.0;
  for (const float z : depth) {
    if (z == z) squares += (z - truth) * (z - truth), count += 1.0;
  }
  return std::sqrt(squares / count);
}

TEST(DepthFaults, PixelsAtAnEdgeMeasureTheMeanOfWhatTheySee) {
  std::vector<float> depth = step(1.0f, 1.6f);
  mixNeighbors(3, kCamera, depth);
  EXPECT_FLOAT_EQ(at(depth, kEdge - 2), 1.0f);
  EXPECT_FLOAT_EQ(at(depth, kEdge - 1), 1.2f);
  EXPECT_FLOAT_EQ(at(depth, kEdge), 1.4f);
  EXPECT_FLOAT_EQ(at(depth, kEdge + 1), 1.6f);
}

TEST(DepthFaults, WhatSawNothingNeitherMixesNorGetsADepth) {
  std::vector<float> depth = step(1.0f, std::nanf(""));
  mixNeighbors(3, kCamera, depth);
  EXPECT_FLOAT_EQ(at(depth, kEdge - 1), 1.0f);
  EXPECT_TRUE(std::isnan(at(depth, kEdge)));
}

TEST(DepthFaults, TheShadowOfWhatIsNearIsAsWideAsTheDisparitiesDiffer) {
  std::vector<float> depth = step(0.8f, 1.6f);
  removeShadows(0.08, kCamera, depth);
  const double width = kCamera.fx * 0.08 * (1.0 / 0.8 - 1.0 / 1.6);  // 26 px
  int missing = 0;
  for (int column = 0; column < kCamera.width; ++column) missing += std::isnan(at(depth, column)) ? 1 : 0;
  EXPECT_NEAR(missing, width, 2.0);
  EXPECT_TRUE(std::isnan(at(depth, kEdge))) << "it begins at the edge";
  EXPECT_FALSE(std::isnan(at(depth, kEdge - 1))) << "what is near is seen";
}

TEST(DepthFaults, WavesAreAShareOfTheDepthAndLong) {
  constexpr int kLength = 41;
  std::vector<float> depth = step(1.0f, 1.0f);
  bend(0.002, kLength, kCamera, 7, depth);
  EXPECT_NEAR(deviation(depth, 1.0), 0.002, 1e-5);
  const auto correlation = [&depth](int apart) {
    double products = 0.0, count = 0.0;
    for (int row = 0; row < kCamera.height; ++row) {
      for (int column = 0; column + apart < kCamera.width; ++column, count += 1.0) {
        products += (at(depth, column, row) - 1.0) * (at(depth, column + apart, row) - 1.0);
      }
    }
    return products / count / (0.002 * 0.002);
  };
  EXPECT_GT(correlation(2), 0.95);
  EXPECT_NEAR(correlation(kLength / 2), 0.7, 0.15);
  EXPECT_LT(std::abs(correlation(3 * kLength)), 0.2);
}

TEST(DepthFaults, BlotsTakeTheirShareOfTheImageInPieces) {
  std::vector<float> depth = step(1.0f, 1.0f);
  removeBlots(0.2, 9, kCamera, 7, depth);
  const auto missing = static_cast<double>(std::count_if(depth.begin(), depth.end(), [](float z) { return z != z; }));
  EXPECT_NEAR(missing / static_cast<double>(depth.size()), 0.2, 1e-3);
  double edges = 0.0;
  for (std::size_t i = 1; i < depth.size(); ++i) edges += (depth[i] == depth[i]) != (depth[i - 1] == depth[i - 1]);
  EXPECT_GT(2.0 * missing / edges, 4.0) << "pixels in a row of a blot; of single pixels 1.25";
}

TEST(Sensors, OfAStereoCameraTheNoiseGrowsWithTheSquareOfTheDepth) {
  NoiseParams params = noiseOf("stereo");
  params.waves = 0.0;
  const auto sigmaAt = [&params](float z) {
    std::vector<float> depth(kCamera.pixelCount(), z);
    addNoise(params, kCamera, 3, 0, depth);
    return deviation(depth, static_cast<double>(z));
  };
  EXPECT_NEAR(sigmaAt(1.0f), 0.06 / (kCamera.fx * 0.05), 2e-4);
  EXPECT_NEAR(sigmaAt(2.0f) / sigmaAt(1.0f), 4.0, 0.3);
}

TEST(Sensors, OfTimeOfFlightLeavesFlyingPixels) {
  const auto between = [](const std::string& sensor) {
    std::vector<float> depth = step(1.0f, 1.6f);
    addNoise(noiseOf(sensor), kCamera, 3, 0, depth);
    return std::count_if(depth.begin(), depth.end(), [](float z) { return 1.1f < z && z < 1.5f; });
  };
  EXPECT_GE(between("time_of_flight"), kCamera.height);
  EXPECT_EQ(between("structured_light"), 0);
}

TEST(DepthFaults, APoleHasAShadowAsWideAsItself) {
  std::vector<float> depth = step(2.0f, 2.0f);
  for (int column = 0; column < 5; ++column) depth[240u * 640u + 300u + static_cast<std::size_t>(column)] = 0.8f;
  removeShadows(0.05, kCamera, depth);
  int missing = 0;
  for (int column = 0; column < kCamera.width; ++column) missing += std::isnan(at(depth, column)) ? 1 : 0;
  EXPECT_NEAR(missing, 5, 2);
}

/// What addNoise makes of a sensor's parameters, one fault at a time.
TEST(Sensors, HaveTheirShadowsAndWaves) {
  NoiseParams stereo = noiseOf("stereo");
  stereo.scale = stereo.disparity_step = stereo.waves = 0.0;
  stereo.footprint = 1;
  stereo.max_incidence_deg = 90.0;
  std::vector<float> depth = step(0.8f, 1.6f);
  addNoise(stereo, kCamera, 3, 0, depth);
  int missing = 0;
  for (int column = 0; column < kCamera.width; ++column) missing += std::isnan(at(depth, column)) ? 1 : 0;
  EXPECT_NEAR(missing, kCamera.fx * 0.05 * (1.0 / 0.8 - 1.0 / 1.6), 2.0);
  for (const auto& [sensor, waves] :
       {std::pair("time_of_flight", 0.0015), std::pair("bent_structured_light", 0.0025)}) {
    NoiseParams params = noiseOf(sensor);
    params.scale = params.disparity_step = 0.0;
    std::vector<float> wall = step(1.0f, 1.0f);
    addNoise(params, kCamera, 3, 0, wall);
    EXPECT_NEAR(deviation(wall, 1.0), waves, 1e-5) << sensor;
  }
}

TEST(Sensors, AllHaveNoiseThatIsAllowed) {
  for (const std::string& name : sensorNames()) {
    std::vector<float> depth = step(1.0f, 1.6f);
    EXPECT_NO_THROW(addNoise(noiseOf(name), kCamera, 3, 0, depth)) << name;
  }
  EXPECT_THROW(noiseOf("lidar"), std::invalid_argument);
}

TEST(Sensors, FaultsOutOfRangeAreRefused) {
  std::vector<float> depth = step(1.0f, 1.6f);
  const auto refused = [&depth](void (*spoil)(NoiseParams&)) {
    NoiseParams params;
    spoil(params);
    EXPECT_THROW(addNoise(params, kCamera, 1, 0, depth), std::invalid_argument);
  };
  refused([](NoiseParams& p) { p.footprint = 2; });
  refused([](NoiseParams& p) { p.disparity_noise = -1.0; });
  refused([](NoiseParams& p) { p.waves = 0.2; });
  refused([](NoiseParams& p) { p.wave_length = 0; });
  refused([](NoiseParams& p) { p.blots = 1.5; });
  refused([](NoiseParams& p) { p.blot_grain = 4; });
}

}  // namespace
}  // namespace primitect::synthetic::depth_faults_test
