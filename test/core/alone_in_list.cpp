// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One thing alone in a list of points, as somebody cut it out: its radius is large against what there is of it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/random.h"
#include "primitect/detector.h"

namespace primitect::alone_in_list_test {
namespace {

constexpr double kNoise = 0.001;  // m

/// Points where `place` says for two numbers in [0, 1], with noise.
Cloud listOf(const std::function<Vec3(double, double)>& place) {
  constexpr std::uint32_t kCount = 3000;
  Random random(17);
  Cloud cloud;
  cloud.reset(kCount, 1, false);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double u = random.uniform(0.0, 1.0), v = random.uniform(0.0, 1.0);
    const Vec3 noise{random.gaussian(), random.gaussian(), random.gaussian()};
    const Eigen::Vector3f point = (place(u, v) + kNoise * noise).cast<float>();
    cloud.setPoint(i, point.x(), point.y(), point.z(), DepthRange());
  }
  return cloud;
}

Params forLists() {
  Params params;
  params.min_depth = params.max_depth = 0.0;
  return params;
}

/// Its radius is a third of the diagonal: no bin reaches so far, and no fit was allowed to.
TEST(AloneInList, HalfABallIsABall) {
  constexpr double kRadius = 0.1;
  const Cloud cloud = listOf([&](double u, double v) {
    const double z = -u, across = std::sqrt(1.0 - z * z), turn = 2.0 * M_PI * v;
    return Vec3(kRadius * Vec3(across * std::cos(turn), across * std::sin(turn), z) + Vec3(0.0, 0.0, 0.9));
  });
  Detector detector{forLists()};
  const Detections& found = detector.detect(cloud);
  ASSERT_EQ(found.items.size(), 1u);
  const Sphere* const ball = std::get_if<Sphere>(&found.items[0].shape);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->radius, kRadius, 0.001);
  EXPECT_NEAR((ball->center - Vec3(0.0, 0.0, 0.9)).norm(), 0.0, 0.001);
}

TEST(AloneInList, TheFrontOfABinIsACylinder) {
  constexpr double kRadius = 0.2, kHeight = 0.3;
  const Cloud cloud = listOf([&](double u, double v) {
    const double turn = M_PI * (u - 1.0);
    return Vec3(kRadius * std::cos(turn), kHeight * (v - 0.5), 1.0 + kRadius * std::sin(turn));
  });
  Detector detector{forLists()};
  const Detections& found = detector.detect(cloud);
  ASSERT_FALSE(found.items.empty());
  const Cylinder* const bin = std::get_if<Cylinder>(&found.items[0].shape);
  ASSERT_TRUE(bin);
  EXPECT_NEAR(bin->radius, kRadius, 0.002);
  for (const Detection& item : found.items) {
    EXPECT_TRUE(&item == &found.items[0] || kindOf(item.shape) == Kind::plane) << "strips of it at most";
  }
}

}  // namespace
}  // namespace primitect::alone_in_list_test
