// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The scores on hand-made cases with known answers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "eval/metrics.h"
#include "eval/score_table.h"

namespace {

using namespace primitect;
using namespace primitect::eval;

constexpr double kDegree = 0.017453292519943295;

/// Points with their normals.
Cloud makeCloud(const std::vector<std::pair<Vec3, Vec3>>& points) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points.size()), 1, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i].first.cast<float>(), n = points[i].second.cast<float>();
    cloud.setPoint(i, p.x(), p.y(), p.z(), DepthRange());
    cloud.setNormal(i, n.x(), n.y(), n.z());
  }
  return cloud;
}

/// Normal of the plane z = 0 tilted about x.
Vec3 tilted(double degrees) { return {0.0, std::sin(degrees * kDegree), std::cos(degrees * kDegree)}; }

std::vector<int> labels(const std::vector<std::pair<int, int>>& runs) {
  std::vector<int> all;
  for (const auto& [label, count] : runs) all.insert(all.end(), count, label);
  return all;
}

Segmentation segmentLabels(const std::vector<int>& truth, int truths, const std::vector<int>& found, int detections) {
  return segment(countOverlaps(truth, truths, found, detections), 0.6);
}

TEST(Assignment, TakesTheClosestShapeWithinDistanceAndAngle) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane shelf{Vec3(0, 0, 0.06), Vec3::UnitZ()};
  const Cloud cloud = makeCloud(
      {{{1, 0, 0.01}, tilted(0)}, {{1, 0, 0.04}, tilted(14)}, {{1, 0, 0.01}, tilted(16)}, {{1, 0, 0.12}, tilted(0)}});
  const Assignment result = assign(cloud, {floor, shelf}, Rules());
  EXPECT_EQ(result.shape, (std::vector<int>{0, 1, -1, -1}));
  EXPECT_NEAR(result.distance[2], 0.01, 1e-6);
  EXPECT_NEAR(result.distance[3], 0.06, 1e-6);
}

TEST(Assignment, IgnoresTheSignOfNormals) {
  const Cloud cloud = makeCloud({{{1, 0, 0.01}, -tilted(3)}});
  EXPECT_EQ(assign(cloud, {Plane()}, Rules()).shape[0], 0);
}

TEST(Assignment, PrefersAFartherShapeWhoseNormalAgrees) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane wall{Vec3::Zero(), Vec3::UnitY()};
  const Cloud cloud = makeCloud({{{1, 0.02, 0.01}, Vec3::UnitY()}});
  EXPECT_EQ(assign(cloud, {floor, wall}, Rules()).shape[0], 1);
}

TEST(Assignment, LeavesOutMissingPointsAndMissingNormals) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  const Cloud cloud = makeCloud({{Vec3::Constant(kMissing), Vec3::UnitZ()}, {{1, 0, 0.01}, Vec3::Constant(kMissing)}});
  const Assignment result = assign(cloud, {Plane()}, Rules());
  EXPECT_EQ(result.shape, (std::vector<int>{-1, -1}));
  EXPECT_TRUE(std::isinf(result.distance[0]));
}

TEST(Assignment, RefusesACloudWithoutNormals) {
  Cloud cloud;
  cloud.reset(1, 1, false);
  EXPECT_THROW(assign(cloud, {Plane()}, Rules()), std::invalid_argument);
}

TEST(SegComp, CountsAPairAsCorrectFromSixtyPercentOfBothOn) {
  const std::vector<int> truth = labels({{0, 10}, {-1, 4}});
  EXPECT_EQ(segmentLabels(truth, 1, labels({{0, 6}, {-1, 4}, {0, 4}}), 1).correct.size(), 1u);
  EXPECT_EQ(segmentLabels(truth, 1, labels({{0, 5}, {-1, 9}}), 1).correct.size(), 0u);
}

TEST(SegComp, AsksForTheShareOfTheDetectionToo) {
  const Segmentation result = segmentLabels(labels({{0, 10}, {-1, 10}}), 1, labels({{0, 20}}), 1);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.missed, 1);
  EXPECT_EQ(result.noise, 1);
}

TEST(SegComp, FindsOverSegmentation) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 5}, {1, 5}}), 2);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.over_segmented, 1);
  EXPECT_EQ(result.missed, 0);
  EXPECT_EQ(result.noise, 0);
}

TEST(SegComp, FindsUnderSegmentation) {
  const Segmentation result = segmentLabels(labels({{0, 5}, {1, 5}}), 2, labels({{0, 10}}), 1);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.under_segmented, 1);
  EXPECT_EQ(result.missed, 0);
  EXPECT_EQ(result.noise, 0);
}

TEST(SegComp, KeepsACorrectPairBesideASmallDuplicateThatIsNoNoise) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 8}, {1, 2}}), 2);
  ASSERT_EQ(result.correct.size(), 1u);
  EXPECT_EQ(result.correct[0], std::make_pair(0, 0));
  EXPECT_EQ(result.over_segmented, 0);
  EXPECT_EQ(result.noise, 0);
}

TEST(SegComp, CallsADetectionWithoutPointsNoise) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 10}}), 2);
  EXPECT_EQ(result.correct.size(), 1u);
  EXPECT_EQ(result.noise, 1);
}

TEST(SegComp, MissesEverythingWithoutDetections) {
  const Segmentation result = segmentLabels(labels({{0, 5}, {1, 5}}), 2, labels({{-1, 10}}), 0);
  EXPECT_EQ(result.missed, 2);
  EXPECT_EQ(result.noise, 0);
}

TEST(Totals, KeepACorrectPairOfTheWrongKindOutOfTheTypedFigures) {
  synthetic::PaperScene scene;
  scene.cloud = makeCloud({{{1, 0, 0}, tilted(0)}, {{0, 1, 0}, tilted(0)}});
  scene.truth = {Plane()};
  scene.surface = {0, 0};
  Totals totals;
  addScene(totals, scene, {Sphere{Vec3(0, 0, -1000), 1000}}, Rules());
  EXPECT_EQ(totals.correct, 1);
  EXPECT_EQ(totals.typed_correct, 0);
  EXPECT_EQ(totals.typed_distance_sum, 0.0);
  // The sphere lies 1^2 / 2000 m below the plane at both points.
  EXPECT_NEAR(totals.distance_sum, 0.0005, 1e-6);
}

TEST(ObjectDistance, IsTheShiftBetweenParallelPlanes) {
  const Cloud cloud = makeCloud({{{1, 0, 0.01}, tilted(0)}, {{0, 1, -0.02}, tilted(0)}, {{0, 0, 9}, tilted(0)}});
  const Plane shifted{Vec3(0, 0, 0.007), Vec3::UnitZ()};
  EXPECT_NEAR(objectDistance(cloud, {0, 0, 1}, 0, Plane(), shifted), 0.007, 1e-9);
}

TEST(ObjectDistance, IsTheDifferenceOfRadiiForConcentricSpheres) {
  const Cloud cloud = makeCloud({{{1.1, 0, 0}, Vec3::UnitX()}, {{0, 0.8, 0}, Vec3::UnitY()}});
  EXPECT_NEAR(objectDistance(cloud, {0, 0}, 0, Sphere{Vec3::Zero(), 1.0}, Sphere{Vec3::Zero(), 1.03}), 0.03, 1e-7);
}

TEST(Coverage, CountsPointsNearAnyShapeAndAveragesOverShapes) {
  const Plane floor{Vec3::Zero(), Vec3::UnitZ()};
  const Plane high{Vec3(0, 0, 1), Vec3::UnitZ()};
  // Floor: 1 of 2 points within 0.01; high: 2 of 2; one point belongs to nothing.
  const Cloud cloud = makeCloud({{{1, 0, 0.005}, tilted(0)},
                                 {{1, 0, 0.03}, tilted(0)},
                                 {{1, 0, 1.001}, tilted(0)},
                                 {{1, 0, 0.999}, tilted(0)},
                                 {{1, 0, 0.5}, tilted(0)}});
  const std::vector<Shape> found = {floor, high, Sphere{Vec3(9, 9, 9), 1.0}};
  const Assignment assignment = assign(cloud, found, Rules());
  EXPECT_DOUBLE_EQ(pointCoverage(assignment, cloud, 0.01), 0.6);
  EXPECT_DOUBLE_EQ(shapeCoverage(assignment, cloud, found, 0.01), 0.75);
}

TEST(PaperScene, GivesFullMarksToItsOwnTruth) {
  const synthetic::PaperScene scene = synthetic::makePaperScene(synthetic::SceneKind::spheres, 1, 0.005);
  Totals totals;
  addScene(totals, scene, scene.truth, Rules());
  EXPECT_EQ(totals.typed_correct, totals.truths);
  EXPECT_EQ(totals.correct, totals.found);
  EXPECT_EQ(totals.missed + totals.noise, 0);
  EXPECT_EQ(totals.distance_sum, 0.0);
}

TEST(PaperScene, GivesNothingToAnEmptyResult) {
  const synthetic::PaperScene scene = synthetic::makePaperScene(synthetic::SceneKind::spheres, 1, 0.005);
  Totals totals;
  addScene(totals, scene, {}, Rules());
  EXPECT_EQ(totals.correct, 0);
  EXPECT_EQ(totals.missed, totals.truths);
  EXPECT_EQ(totals.point_coverage, 0.0);
}

}  // namespace
