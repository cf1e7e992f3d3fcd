// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What every peer that knows all kinds must find; the peer is named by the test.
#pragma once

#include <gtest/gtest.h>

#include "eval/peers/peers.h"
#include "eval/test/peers_scenes.h"

namespace primitect::test {

inline eval::Answer answerOf(const std::string& peer, const eval::LabelledCloud& scene) {
  const std::optional<eval::Method> method = eval::makePeer(peer);
  EXPECT_TRUE(method) << peer;
  eval::Answer answer = method->run(scene, 1);
  EXPECT_EQ(answer.failure, "");
  EXPECT_GT(answer.total_ms, 0.0);
  return answer;
}

inline void expectTheWall(const eval::Answer& answer) {
  const std::vector<Plane> planes = shapesOf<Plane>(answer);
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_LT(angleDeg(planes[0].normal, wall().normal), 2.0) << "towards the sensor";
  EXPECT_NEAR(planes[0].point.z(), 2.0, kRansacError);
  EXPECT_NEAR(planes[0].normal.norm(), 1.0, 1e-6);
}

inline void expectFindsSphere(const std::string& peer) {
  const Sphere truth{{-0.3, 0.2, 1.5}, 0.25};
  const eval::Answer answer = answerOf(peer, wallAnd(truth));
  expectTheWall(answer);
  const std::vector<Sphere> spheres = shapesOf<Sphere>(answer);
  ASSERT_EQ(spheres.size(), 1u);
  EXPECT_LT((spheres[0].center - truth.center).norm(), kRansacError);
  EXPECT_NEAR(spheres[0].radius, truth.radius, kRansacError);
}

inline void expectFindsCylinder(const std::string& peer) {
  const Cylinder truth{{0.2, 0.0, 1.5}, Vec3(0.3, 1.0, 0.2).normalized(), 0.15};
  const eval::Answer answer = answerOf(peer, wallAnd(truth, -0.4, 0.4));
  expectTheWall(answer);
  const std::vector<Cylinder> cylinders = shapesOf<Cylinder>(answer);
  ASSERT_EQ(cylinders.size(), 1u);
  const Vec3 offset = cylinders[0].point - truth.point;
  EXPECT_LT(offset.cross(truth.axis).norm(), kRansacError + 0.05 * offset.norm());
  EXPECT_LT(degrees(lineAngle(cylinders[0].axis, truth.axis)), 3.0);
  EXPECT_NEAR(cylinders[0].radius, truth.radius, kRansacError);
  EXPECT_NEAR(cylinders[0].axis.norm(), 1.0, 1e-6);
}

/// Once opening to each side: the axis must point into the body that was seen.
inline void expectFindsCones(const std::string& peer) {
  for (const double side : {-1.0, 1.0}) {
    SCOPED_TRACE(side);
    const Cone truth{{-0.3 * side, 0.0, 1.4}, Vec3(side, 0.3, 0.1).normalized(), 25.0 * M_PI / 180.0};
    const eval::Answer answer = answerOf(peer, wallAnd(truth, 0.05, 0.6));
    expectTheWall(answer);
    const std::vector<Cone> cones = shapesOf<Cone>(answer);
    ASSERT_EQ(cones.size(), 1u);
    // An error of the angle moves the apex along the axis: twice the threshold.
    EXPECT_LT((cones[0].apex - truth.apex).norm(), 2.0 * kRansacError);
    EXPECT_LT(angleDeg(cones[0].axis, truth.axis), 4.0);
    EXPECT_NEAR(degrees(cones[0].half_angle), 25.0, 4.0);
  }
}

}  // namespace primitect::test
