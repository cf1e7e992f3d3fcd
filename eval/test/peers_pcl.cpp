// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PCL's detectors as peers, the names of all peers, and the cloud that they get.
#include <gtest/gtest.h>

#include <algorithm>

#include "eval/peers/peer_cloud.h"
#include "eval/peers/points.h"
#include "eval/test/peers_find.h"

namespace primitect::eval::peers_pcl_test {
namespace {

using namespace primitect::test;

/// A camera that sees a wall 2 m away and a floor below it.
LabelledCloud roomFrame() {
  LabelledCloud frame;
  frame.cloud = cameraCloud({0.0, 0.0, 1.0}, 2.0);
  const Cloud floor = cameraCloud(Vec3(0.0, 1.0, 0.3).normalized(), 1.0);
  for (std::size_t i = 0; i < floor.size(); ++i) {
    if (floor.z[i] > 0.0f && floor.z[i] < 2.0f) frame.cloud.setPoint(i, floor.x[i], floor.y[i], floor.z[i], {});
  }
  return frame;
}

TEST(PeerNames, UnknownOnesAreNoPeers) {
  for (const char* name : {"", "pcl", "pcl-sac:planes", "cgal-", "cgal-0", "cgal-x", "cgal:plane", "cgal:tori",
                           "cgal:planes:cones", "xcgal", "cgal-2048 "}) {
    EXPECT_FALSE(makePeer(name)) << name;
  }
}

TEST(PeerNames, AllThatAreListedCanBeMadeAndKeepTheirName) {
  EXPECT_GE(peerNames().size(), 2u);
  for (const std::string& name : peerNames()) {
    const std::optional<Method> method = makePeer(name);
    ASSERT_TRUE(method) << name;
    EXPECT_EQ(method->name, name);
  }
}

TEST(PclSac, FindsWallAndSphere) { expectFindsSphere("pcl-sac"); }
TEST(PclSac, FindsWallAndCylinder) { expectFindsCylinder("pcl-sac"); }
TEST(PclSac, FindsWallAndConeWithItsAxisIntoTheBody) { expectFindsCones("pcl-sac"); }

TEST(PclSac, SameCloudAndSeedSameShapes) {
  const LabelledCloud scene = wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25});
  const Sphere first = shapesOf<Sphere>(answerOf("pcl-sac", scene)).at(0);
  const Sphere second = shapesOf<Sphere>(answerOf("pcl-sac", scene)).at(0);
  EXPECT_EQ(first.center, second.center);
  EXPECT_EQ(first.radius, second.radius);
}

TEST(PclSac, ACloudWithoutUsablePointsIsAFailureWithItsReason) {
  LabelledCloud empty;
  empty.cloud.reset(10, 1, true);
  EXPECT_EQ(makePeer("pcl-sac")->run(empty, 1).failure, "no point has a normal");
}

TEST(PclPlanes, FindsWallAndFloorOfAFrameWithoutNormals) {
  const Answer answer = answerOf("pcl-planes", roomFrame());
  const std::vector<Plane> planes = shapesOf<Plane>(answer);
  EXPECT_EQ(planes.size(), answer.shapes.size());
  for (const Plane& plane : planes) EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-6);
  // Strips along the edge, where the normals turn, may be planes of their own. Without noise the two are exact.
  const auto count = [&planes](const Vec3& normal, double offset) {
    return std::count_if(planes.begin(), planes.end(), [&](const Plane& plane) {
      return angleDeg(plane.normal, normal) < 1.0 && std::abs(plane.normal.dot(plane.point) - offset) < 0.01;
    });
  };
  EXPECT_GE(count({0.0, 0.0, -1.0}, -2.0), 1) << "wall";
  EXPECT_GE(count(Vec3(0.0, -1.0, -0.3).normalized(), -1.0), 1) << "floor";
}

TEST(PclPlanes, NeedsAnOrganizedCloud) {
  const Answer answer = makePeer("pcl-planes")->run(wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25}), 1);
  EXPECT_EQ(answer.failure, "needs an organized cloud");
  EXPECT_TRUE(answer.shapes.empty());
}

TEST(PeerCloud, IsTheCloudItselfIfItBringsNormals) {
  const LabelledCloud scene = wallAnd(Sphere{{-0.3, 0.2, 1.5}, 0.25});
  EXPECT_EQ(&peerCloud(scene), &scene.cloud);
}

TEST(PeerCloud, HasNormalsOfTheCloudInQuestionNotOfTheOneBefore) {
  LabelledCloud frame;
  for (const Vec3& normal : {Vec3(0.0, 0.0, 1.0), Vec3(0.3, 0.0, 1.0).normalized()}) {
    frame.cloud = cameraCloud(normal, 1.5);
    const Cloud& cloud = peerCloud(frame);
    ASSERT_TRUE(cloud.hasNormals());
    const std::size_t center = 60 * 160 + 80;
    EXPECT_LT(angleDeg(cloud.normal(center), -normal), 0.1);
  }
}

TEST(PeerCloud, MissingPointsHaveNoNormalAndAreNotUsed) {
  LabelledCloud frame;
  frame.cloud = cameraCloud({0.0, 0.0, 1.0}, 1.5);
  frame.cloud.setPoint(5000, 0.0f, 0.0f, 0.0f, {});
  const std::vector<std::uint32_t> points = usablePoints(peerCloud(frame));
  EXPECT_EQ(points.size(), frame.cloud.size() - 1);
  EXPECT_EQ(std::count(points.begin(), points.end(), 5000u), 0);
}

TEST(DrawnPoints, AreDifferentOnesAndTheSameForTheSameSeed) {
  std::vector<std::uint32_t> all(1000);
  for (std::uint32_t i = 0; i < 1000; ++i) all[i] = i;
  std::vector<std::uint32_t> drawn = drawPoints(all, 300, 7);
  EXPECT_EQ(drawn, drawPoints(all, 300, 7));
  EXPECT_NE(drawn, drawPoints(all, 300, 8));
  std::sort(drawn.begin(), drawn.end());
  EXPECT_EQ(drawn.size(), 300u);
  EXPECT_EQ(std::unique(drawn.begin(), drawn.end()), drawn.end());
  EXPECT_EQ(drawPoints(all, 0, 7), all);
  EXPECT_EQ(drawPoints(all, 5000, 7), all);
}

}  // namespace
}  // namespace primitect::eval::peers_pcl_test
