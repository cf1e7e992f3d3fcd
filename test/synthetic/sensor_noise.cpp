// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The noise model against its formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "synthetic/noise.h"
#include "synthetic/raycast.h"
#include "synthetic/world.h"

namespace primitect::synthetic::sensor_noise_test {
namespace {

const PinholeCamera kCamera;
const Eigen::Isometry3d kAtOrigin = Eigen::Isometry3d::Identity();

NoiseParams noNoise() {
  NoiseParams params;
  params.scale = 0.0;
  params.disparity_step = 0.0;
  params.max_incidence_deg = 90.0;
  params.min_depth = params.max_depth = 0.0;
  return params;
}

std::vector<float> flatImage(double depth) {
  return std::vector<float>(kCamera.pixelCount(), static_cast<float>(depth));
}

struct Moments {
  double mean = 0.0, sigma = 0.0, kurtosis = 0.0, largest = 0.0;
};

Moments errorsOf(const std::vector<float>& depth, double truth) {
  double sum = 0.0, sum_sq = 0.0, sum_4 = 0.0;
  Moments moments;
  for (const float z : depth) {
    const double error = z - truth;
    sum += error;
    sum_sq += error * error;
    sum_4 += error * error * error * error;
    moments.largest = std::max(moments.largest, std::abs(error));
  }
  const double count = static_cast<double>(depth.size());
  moments.mean = sum / count;
  moments.sigma = std::sqrt(sum_sq / count - moments.mean * moments.mean);
  moments.kurtosis = sum_4 / count / std::pow(moments.sigma, 4);
  return moments;
}

TEST(SensorNoise, HasMeanZeroAndTheModelledSigmaAtEachDepth) {
  NoiseParams params = noNoise();
  for (const double scale : {0.5, 1.0, 2.0}) {
    for (const double z : {0.4, 0.75, 1.0, 2.0, 3.9}) {
      params.scale = scale;
      std::vector<float> depth = flatImage(z);
      addNoise(params, kCamera, 7, 3, depth);
      const double sigma = scale * (0.0012 + 0.0019 * (z - 0.4) * (z - 0.4));
      const Moments moments = errorsOf(depth, static_cast<float>(z));
      // Of 307200 values the mean has a standard error of sigma / 554, sigma one of 0.13 %: five of each.
      EXPECT_NEAR(moments.mean, 0.0, sigma * 5 / 554) << z;
      EXPECT_NEAR(moments.sigma, sigma, sigma * 0.0065) << z;
      // Four uniform numbers have kurtosis 2.7; an exact Gaussian has 3, one uniform number 1.8.
      EXPECT_NEAR(moments.kurtosis, 2.7, 0.05) << z;
    }
  }
}

TEST(SensorNoise, NeighbouringPixelsAndFramesAreIndependent) {
  NoiseParams params = noNoise();
  params.scale = 1.0;
  std::vector<float> first = flatImage(1.0), second = flatImage(1.0);
  addNoise(params, kCamera, 7, 3, first);
  addNoise(params, kCamera, 7, 4, second);
  double between_pixels = 0.0, between_frames = 0.0;
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    between_pixels += (first[i] - 1.0) * (first[i + 1] - 1.0);
    between_frames += (first[i] - 1.0) * (second[i] - 1.0);
  }
  const double variance = axialSigma(1.0) * axialSigma(1.0) * static_cast<double>(first.size());
  // A correlation of independent values has a standard error of 1 / 554.
  EXPECT_NEAR(between_pixels / variance, 0.0, 5.0 / 554);
  EXPECT_NEAR(between_frames / variance, 0.0, 5.0 / 554);
}

TEST(SensorNoise, InGrainsIsAsStrongAndSharedByNeighbours) {
  constexpr int kGrain = 5;
  NoiseParams params = noNoise();
  params.scale = 1.0;
  params.grain = kGrain;
  std::vector<float> depth = flatImage(1.0);
  addNoise(params, kCamera, 7, 3, depth);
  // Grains are a 25th as many values as pixels: the standard error of sigma is .6 %, that of a correlation 1 %.
  EXPECT_NEAR(errorsOf(depth, 1.0).sigma, axialSigma(1.0), 0.03 * axialSigma(1.0));
  const auto correlation = [&depth](int apart) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i + apart < depth.size(); ++i) {
      sum += (depth[i] - 1.0) * (depth[i + apart] - 1.0);
      squares += (depth[i] - 1.0) * (depth[i] - 1.0);
    }
    return sum / squares;
  };
  for (const int apart : {1, 2, 4, 5, 8}) {
    const double shared = std::max(0.0, 1.0 - static_cast<double>(apart) / kGrain);
    EXPECT_NEAR(correlation(apart), shared, 0.05) << apart << " columns";
    EXPECT_NEAR(correlation(apart * kCamera.width), shared, 0.05) << apart << " rows";
  }
  for (const int wrong : {0, 2, 33}) {
    params.grain = wrong;
    EXPECT_THROW(addNoise(params, kCamera, 7, 3, depth), std::invalid_argument) << wrong;
  }
}

TEST(SensorNoise, OfAPixelDoesNotDependOnOtherPixels) {
  NoiseParams params = noNoise();
  params.scale = 1.0;
  std::vector<float> whole = flatImage(1.0), holed = flatImage(1.0);
  for (std::size_t i = 0; i < holed.size(); i += 3) holed[i] = std::numeric_limits<float>::quiet_NaN();
  addNoise(params, kCamera, 7, 3, whole);
  addNoise(params, kCamera, 7, 3, holed);
  for (std::size_t i = 0; i < holed.size(); ++i) {
    if (i % 3 == 0) {
      ASSERT_TRUE(std::isnan(holed[i]));
    } else {
      ASSERT_EQ(holed[i], whole[i]);
    }
  }
}

TEST(SensorNoise, MeasuredDisparitiesAreMultiplesOfTheStep) {
  NoiseParams params = noNoise();
  params.scale = 1.0;
  params.disparity_step = 0.125;
  std::vector<float> depth = flatImage(1.5);
  addNoise(params, kCamera, 7, 3, depth);
  for (const float z : depth) {
    const double steps = kCamera.fx * params.baseline / z / params.disparity_step;
    ASSERT_NEAR(steps, std::round(steps), 1e-4);
  }
}

TEST(SensorNoise, QuantisationErrsByHalfAStepOfDisparityAtMost) {
  NoiseParams params;
  double largest = 0.0;
  for (double z = 0.4; z < 4.0; z += 0.00137) {
    const double measured = quantizedDepth(z, params, kCamera.fx);
    const double error = kCamera.fx * params.baseline * (1.0 / measured - 1.0 / z);
    ASSERT_LE(std::abs(error), 0.0625 + 1e-9) << z;
    largest = std::max(largest, std::abs(error));
  }
  EXPECT_GT(largest, 0.06);
  EXPECT_TRUE(std::isnan(quantizedDepth(1000.0, params, kCamera.fx)));
}

TEST(SensorNoise, PixelsOutOfRangeGoMissing) {
  NoiseParams params = noNoise();
  params.min_depth = 0.4;
  params.max_depth = 4.0;
  for (const double z : {0.2, 0.399, 4.01, 10.0, 0.0, -1.0}) {
    std::vector<float> depth = flatImage(z);
    addNoise(params, kCamera, 7, 3, depth);
    for (const float measured : depth) ASSERT_TRUE(std::isnan(measured)) << z;
  }
  std::vector<float> depth = flatImage(3.99);
  params.scale = 1.0;
  addNoise(params, kCamera, 7, 3, depth);
  int missing = 0;
  for (const float measured : depth) {
    ASSERT_FALSE(measured > 4.0f);
    missing += std::isnan(measured);
  }
  EXPECT_GT(missing, 1000);
}

/// Incidence angle (deg) at a pixel that sees a plane with this normal.
double incidenceDeg(const Vec3& normal, int u, int v) {
  return std::acos(std::abs(normal.dot(kCamera.ray(u, v).normalized()))) * 180.0 / M_PI;
}

TEST(SensorNoise, PixelsGoMissingJustWhereAPlaneIsSeenAtMoreThan80Degrees) {
  NoiseParams params = noNoise();
  params.max_incidence_deg = 80.0;
  for (const bool sideways : {false, true}) {
    const Vec3 tilt_axis = sideways ? Vec3::UnitY().eval() : Vec3::UnitX().eval();
    World world;
    world.add("sheet", Sheet{100.0, 100.0},
              Eigen::Translation3d(0.0, 0.0, 2.0) * Eigen::AngleAxisd(-75.0 * M_PI / 180.0, tilt_axis));
    const Vec3 normal = std::get<Plane>(world.surfaces()[0].shape).normal;
    Rendering rendering;
    render(world, kCamera, kAtOrigin, rendering);
    std::vector<float> depth = rendering.depth;
    addNoise(params, kCamera, 7, 3, depth);
    int lost = 0, kept = 0;
    for (int v = 1; v + 1 < kCamera.height; ++v) {
      for (int u = 1; u + 1 < kCamera.width; ++u) {
        const std::size_t i = static_cast<std::size_t>(v) * kCamera.width + u;
        const double incidence = incidenceDeg(normal, u, v);
        // Float inverse depths make the slope uncertain by a few 1e-4; at 80 deg that is far less than 0.1 deg.
        if (std::isnan(rendering.depth[i]) || std::abs(incidence - 80.0) < 0.1) continue;
        ASSERT_EQ(std::isnan(depth[i]), incidence > 80.0) << u << ' ' << v << ' ' << incidence;
        ++(incidence > 80.0 ? lost : kept);
      }
    }
    EXPECT_GT(lost, 10000);
    EXPECT_GT(kept, 10000);
  }
}

TEST(SensorNoise, SidewaysIsThatManyPixelsOfASlant) {
  NoiseParams params = noNoise();
  params.sideways = 0.5;
  for (const bool down : {false, true}) {
    World world;
    const Vec3 tilt_axis = down ? Vec3::UnitX().eval() : Vec3::UnitY().eval();
    world.add("slanted", Sheet{0.4, 0.4},
              Eigen::Translation3d(0.0, 0.0, 1.0) * Eigen::AngleAxisd(70.0 * M_PI / 180.0, tilt_axis));
    world.add("facing", Sheet{5.0, 5.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 2.0)));
    Rendering rendering;
    render(world, kCamera, kAtOrigin, rendering);
    std::vector<float> depth = rendering.depth;
    addNoise(params, kCamera, 7, 3, depth);
    const std::size_t stride = down ? static_cast<std::size_t>(kCamera.width) : 1;
    double count = 0.0, squares = 0.0;
    for (std::size_t i = stride; i + stride < depth.size(); ++i) {
      if (rendering.depth[i] == 2.0f) {
        ASSERT_EQ(depth[i], 2.0f) << "no slant, and no step to what lies before it";
      }
      if (rendering.surface[i - stride] != 0 || rendering.surface[i] != 0 || rendering.surface[i + stride] != 0) {
        continue;
      }
      const float step = 0.5f * (rendering.depth[i + stride] - rendering.depth[i - stride]);
      count += 1.0, squares += std::pow((depth[i] - rendering.depth[i]) / step, 2);
    }
    ASSERT_GT(count, 5000.0);
    EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.02) << down;
  }
}

TEST(SensorNoise, BothSidesOfADepthEdgeGoMissingAndNothingElse) {
  World world;
  world.add("wall", Sheet{5.0, 5.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.5)));
  world.add("sheet", Sheet{0.2, 0.15}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.0)));
  Rendering rendering;
  render(world, kCamera, kAtOrigin, rendering);
  std::vector<float> depth = rendering.depth;
  addNoise(NoiseParams{}, kCamera, 7, 3, depth);
  int edges = 0;
  for (int v = 1; v + 1 < kCamera.height; ++v) {
    for (int u = 1; u + 1 < kCamera.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * kCamera.width + u;
      bool edge = false;
      for (const int step : {-1, 1, -kCamera.width, kCamera.width}) {
        edge = edge || rendering.surface[i] != rendering.surface[i + step];
      }
      ASSERT_EQ(std::isnan(depth[i]), edge) << u << ' ' << v;
      edges += edge;
    }
  }
  // The outline of 228 x 171 pixels, one pixel on each side.
  EXPECT_NEAR(edges, 2 * 2 * (228 + 171), 10);
}

TEST(SensorNoise, SameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  const auto measured = [](std::uint64_t seed, std::uint64_t frame) {
    std::vector<float> depth = flatImage(1.0);
    addNoise(NoiseParams{}, kCamera, seed, frame, depth);
    return depth;
  };
  const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
  };
  EXPECT_TRUE(same(measured(1, 2), measured(1, 2)));
  EXPECT_FALSE(same(measured(1, 2), measured(2, 2)));
  EXPECT_FALSE(same(measured(1, 2), measured(1, 3)));
  EXPECT_FALSE(same(measured(1, 2), measured(2, 1)));
}

TEST(SensorNoise, RefusesParametersOutOfRangeByName) {
  const auto complaint = [](void (*spoil)(NoiseParams&)) -> std::string {
    NoiseParams params;
    spoil(params);
    std::vector<float> depth = flatImage(1.0);
    try {
      addNoise(params, kCamera, 1, 1, depth);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(complaint([](NoiseParams& p) { p.scale = -1.0; }).find("scale"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.scale = std::nan(""); }).find("scale"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.sideways = -0.5; }).find("sideways"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.baseline = 0.0; }).find("baseline"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.disparity_step = -0.1; }).find("disparity_step"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.max_incidence_deg = 91.0; }).find("incidence"), std::string::npos);
  EXPECT_NE(complaint([](NoiseParams& p) { p.max_depth = -4.0; }).find("max_depth"), std::string::npos);
  std::vector<float> too_short(10, 1.0f);
  EXPECT_THROW(addNoise(NoiseParams{}, kCamera, 1, 1, too_short), std::invalid_argument);
}

}  // namespace
}  // namespace primitect::synthetic::sensor_noise_test
