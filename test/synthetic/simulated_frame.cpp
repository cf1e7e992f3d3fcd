// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A whole simulated frame and its cloud.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic::simulated_frame_test {
namespace {

const PinholeCamera kCamera;

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(SimulatedFrame, IsTheSameBytesForTheSameSeedAndFrame) {
  const World world = tabletop(4);
  const Frame frame = renderFrame(world, kCamera, cameraPose(2.0), {}, 11, 60);
  const Frame again = renderFrame(tabletop(4), kCamera, cameraPose(2.0), {}, 11, 60);
  EXPECT_TRUE(sameBytes(frame.depth, again.depth));
  EXPECT_TRUE(sameBytes(frame.surface, again.surface));
  ASSERT_EQ(frame.truth.items.size(), again.truth.items.size());
  for (std::size_t i = 0; i < frame.truth.items.size(); ++i) {
    EXPECT_EQ(frame.truth.items[i].inlier_count, again.truth.items[i].inlier_count);
    EXPECT_EQ(frame.truth.items[i].extent.origin, again.truth.items[i].extent.origin);
  }
  EXPECT_FALSE(sameBytes(frame.depth, renderFrame(world, kCamera, cameraPose(2.0), {}, 12, 60).depth));
  EXPECT_FALSE(sameBytes(frame.depth, renderFrame(world, kCamera, cameraPose(2.0), {}, 11, 61).depth));
}

TEST(SimulatedFrame, MeasuresWithinTheNoiseAroundTheExactDepth) {
  const World world = tabletop(4);
  Rendering exact;
  render(world, kCamera, cameraPose(2.0), exact);
  const Frame frame = renderFrame(world, kCamera, cameraPose(2.0), {}, 11, 60);
  EXPECT_TRUE(sameBytes(frame.surface, exact.surface));
  std::size_t measured = 0;
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (std::isnan(frame.depth[i])) continue;
    const double z = exact.depth[i];
    // Four sigma, and half a step of disparity: 0.5 * 0.125 * z^2 / (570.3 * 0.075), a little more for its curvature.
    ASSERT_LT(std::abs(frame.depth[i] - z), 4 * axialSigma(z) + 0.0016 * z * z) << z;
    ++measured;
  }
  EXPECT_GT(measured, frame.depth.size() * 9 / 10);
  EXPECT_LT(measured, frame.depth.size() * 995 / 1000);
}

TEST(SimulatedFrame, TruthHoldsEveryCurvedObjectForAMinute) {
  for (int seed = 1; seed <= 6; ++seed) {
    const World world = tabletop(seed);
    int curved_bodies = 0;
    for (const Surface& surface : world.surfaces()) curved_bodies += kindOf(surface.shape) != Kind::plane;
    for (int second = 0; second <= 60; second += 3) {
      const Frame frame = renderFrame(world, kCamera, cameraPose(second), {}, 1, 30 * second);
      int curved_found = 0;
      for (const Detection& item : frame.truth.items) curved_found += kindOf(item.shape) != Kind::plane;
      EXPECT_EQ(curved_found, curved_bodies) << "seed " << seed << ", s " << second;
      EXPECT_EQ(frame.truth.status, Status::ok);
    }
  }
}

TEST(SimulatedFrame, TruthStaysExactUnderNoise) {
  const World world = tabletop(4);
  const Eigen::Isometry3d pose = cameraPose(2.0);
  const Frame frame = renderFrame(world, kCamera, pose, {}, 11, 60);
  for (const Detection& item : frame.truth.items) {
    double nearest = 1.0;
    for (const Surface& surface : world.surfaces()) {
      const Shape shape = transformed(pose.inverse(), surface.shape);
      if (shape.index() != item.shape.index()) continue;
      double farthest = 0.0;
      for (const Vec3& p : {Vec3(0.1, 0.2, 0.9), Vec3(-0.3, 0.1, 1.1), Vec3(0.0, -0.2, 1.3), Vec3(0.4, 0.3, 0.7)}) {
        const double difference = std::abs(distance(shape, p)) - std::abs(distance(item.shape, p));
        farthest = std::max(farthest, std::abs(difference));
      }
      nearest = std::min(nearest, farthest);
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(SimulatedFrame, CloudHoldsThePointsOfTheDepthImageWithinTheRange) {
  const Frame frame = renderFrame(tabletop(4), kCamera, cameraPose(2.0), {}, 11, 60);
  Cloud cloud;
  cloudFromDepth(frame.depth, kCamera, DepthRange{0.1f, 2.0f}, cloud);
  ASSERT_EQ(cloud.size(), kCamera.pixelCount());
  EXPECT_TRUE(cloud.organized());
  EXPECT_FALSE(cloud.hasNormals());
  std::uint32_t valid = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool inside = frame.depth[i] >= 0.1f && frame.depth[i] <= 2.0f;
    ASSERT_EQ(cloud.valid(i), inside);
    if (!inside) continue;
    ++valid;
    const Eigen::Vector2d pixel = kCamera.project(cloud.point(i));
    ASSERT_NEAR(pixel.x(), static_cast<double>(i % kCamera.width), 1e-3);
    ASSERT_NEAR(pixel.y(), static_cast<double>(i / kCamera.width), 1e-3);
    ASSERT_EQ(cloud.z[i], frame.depth[i]);
  }
  EXPECT_EQ(cloud.valid_count, valid);
  EXPECT_THROW(cloudFromDepth({1.0f}, kCamera, DepthRange{}, cloud), std::invalid_argument);
}

}  // namespace
}  // namespace primitect::synthetic::simulated_frame_test
