// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A ball, a band of it as the tread of a tyre has, and a bowl, empty and with something in it, over a floor.
#include "core/open_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/image_rays.h"
#include "primitect/detector.h"

namespace primitect::open_ball_test {
namespace {

/// The camera looks down at 45 deg.
const Vec3 kUp = Vec3(0.0, -1.0, -1.0).normalized();

/// What there is of a sphere's surface, by the normal there.
using Part = std::function<bool(const Vec3&)>;

bool whole(const Vec3&) { return true; }
bool band(const Vec3& normal) { return std::abs(kUp.dot(normal)) < 0.35; }
bool bowl(const Vec3& normal) { return kUp.dot(normal) < 0.0; }
/// Of a band the half that is turned to the camera.
bool strip(const Vec3& normal) { return band(normal) && normal.z() < 0.0; }

/// Heights over the middle of a sphere, in radii, at which a floor and a disc within the sphere lie.
struct Heights {
  double floor = -1.0, disc = -1.0;
};

constexpr Heights kTyre = {-0.35, 0.2};

/// Spheres, or parts of them, 1 m away.
class OpenBall : public testing::Test {
 protected:
  OpenBall() { ball_.center = Vec3(0.0, 0.0, 1.0); }

  void render(const Part& part, const Heights& heights) {
    cloud_.reset(kWidth, kHeight, false);
    for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
      const Vec3 ray = Vec3((i % kWidth - 159.5) / 260.0, (i / kWidth - 119.5) / 260.0, 1.0);
      double z = depthAt(heights.floor, ray);
      if (!(z > 0.0)) z = std::numeric_limits<double>::infinity();
      const double disc = depthAt(heights.disc, ray);
      if (0.0 < disc && disc < z && (disc * ray - ball_.center).norm() < 0.9 * ball_.radius) z = disc;
      const double a = ray.squaredNorm(), b = ray.dot(ball_.center);
      const double root = b * b - a * (ball_.center.squaredNorm() - ball_.radius * ball_.radius);
      for (const double side : {1.0, -1.0}) {  // the far one first
        if (!(root > 0.0)) continue;
        const double at = (b + side * std::sqrt(root)) / a;
        if (at < z && part((at * ray - ball_.center) / ball_.radius)) z = at;
      }
      const Vec3 point = z * ray;
      cloud_.setPoint(i, static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()),
                      range_);
    }
    rays_ = findRays(cloud_);
    ASSERT_TRUE(rays_.known);
  }

  /// Of a plane at this height.
  double depthAt(double height, const Vec3& ray) const {
    return (height * ball_.radius + kUp.dot(ball_.center)) / kUp.dot(ray);
  }

  SightsOfBall sights() const { return sightsOf(ball_, {cloud_, rays_, range_, sigma_}); }
  bool open() const { return isOpen(ball_, {cloud_, rays_, range_, sigma_}); }

  /// How many the detector finds.
  int balls(const Params& params) {
    Detector detector{params};
    const Detections& found = detector.detect(cloud_);
    refused_ = found.refusals[Refusal::not_seen];
    int count = 0;
    for (const Detection& item : found.items) count += kindOf(item.shape) == Kind::sphere ? 1 : 0;
    return count;
  }

  static constexpr std::uint32_t kWidth = 320, kHeight = 240;
  Sphere ball_{Vec3::Zero(), 0.1};
  DepthRange range_{0.1f, 2.0f};
  PointNoise sigma_{[](const Vec3&) { return 0.001; }};
  Cloud cloud_;
  ImageRays rays_;
  std::size_t refused_ = 0;  ///< not_seen
};

TEST_F(OpenBall, ABallIsClosed) {
  render(whole, {});
  EXPECT_EQ(sights().deep, 0.0);
  EXPECT_EQ(sights().beyond, 0.0);
  EXPECT_EQ(sights().far_side, 0.0);
  EXPECT_FALSE(open());
}

TEST_F(OpenBall, WhatHidesItDoesNotOpenIt) {
  render(whole, {});
  for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
    const Eigen::Vector3f nearer = 0.7f * cloud_.point(i).cast<float>();
    if (i % kWidth > kWidth / 2) cloud_.setPoint(i, nearer.x(), nearer.y(), nearer.z(), range_);
  }
  EXPECT_FALSE(open());
}

TEST_F(OpenBall, ABandWithADiscInItIsOpen) {
  render(band, kTyre);
  EXPECT_GT(sights().deep, 0.2);
  EXPECT_TRUE(open());
}

TEST_F(OpenBall, AStripHighInTheAirIsOpen) {
  render(strip, {-6.0, -1.0});
  EXPECT_EQ(sights().deep, 0.0);
  EXPECT_GT(sights().beyond, 0.6);
  EXPECT_TRUE(open());
}

TEST_F(OpenBall, ABowlIsNot) {
  render(bowl, {});
  EXPECT_GT(sights().far_side, 0.3);
  EXPECT_FALSE(open());
}

TEST_F(OpenBall, ABowlWithSomethingInItIsNot) {
  render(bowl, {-1.0, -0.45});
  EXPECT_GT(sights().deep, 0.15);
  EXPECT_FALSE(open());
}

TEST_F(OpenBall, NotSeenFromWithin) {
  render(band, kTyre);
  ball_.radius = 1.2;
  EXPECT_FALSE(open());
}

TEST_F(OpenBall, UnknownRaysDoNotTell) {
  render(band, kTyre);
  rays_.known = false;
  EXPECT_FALSE(open());
}

/// What the detector makes of a tyre's tread: no ball.
TEST_F(OpenBall, TheDetectorRefusesIt) {
  ball_.radius = 0.2;
  render(whole, {});
  EXPECT_EQ(balls({}), 1);
  render(band, kTyre);
  EXPECT_EQ(balls({}), 0);
  EXPECT_GT(refused_, 0u) << "so that others may have its samples";
}

/// Where it was not asked of the samples, it is of what is measured.
TEST_F(OpenBall, TheDetectorRefusesWhatItHasMeasured) {
  ball_.radius = 0.2;
  Params params;
  params.left_out.add(Step::seen_tubes);
  render(whole, {});
  EXPECT_EQ(balls(params), 1);
  render(band, kTyre);
  EXPECT_EQ(balls(params), 0);
  params.left_out.add(Step::seen_share);
  EXPECT_EQ(balls(params), 1);
}

}  // namespace
}  // namespace primitect::open_ball_test
