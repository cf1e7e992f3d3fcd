// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages around the voting: sampling, normals, clustering, segmentation, extent.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/clustering.h"
#include "core/extent.h"
#include "core/normals.h"
#include "core/sampling.h"
#include "core/segmentation.h"
#include "test/support/exact_shapes.h"

namespace primitect {
namespace {

using test::patchOf;
using test::pointOn;
using test::SurfacePoint;

constexpr double kDegree = M_PI / 180.0;

/// An organized cloud of a pinhole camera (160 x 120, focal length 140 px) that looks at one plane n.p = offset.
Cloud cameraCloud(const Vec3& normal, double offset) {
  Cloud cloud;
  cloud.reset(160, 120, false);
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Vec3 ray((column - 79.5) / 140.0, (row - 59.5) / 140.0, 1.0);
      const Vec3 p = ray * (offset / normal.dot(ray));
      cloud.setPoint(row * 160 + column, static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z()), {});
    }
  }
  return cloud;
}

TEST(Cloud, TakesZeroAndNotFiniteAndOutOfRangeAsMissing) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float depths[][3] = {{0, 0, 0},     {kNan, 0, 1},  {0, kInfinity, 1}, {0, 0, kNan},
                             {0, 0, 2.01f}, {0, 0, 0.09f}, {0, 0, -1},        {3e38f, 0, 1}};
  Cloud cloud;
  cloud.reset(9, 1, false);
  for (std::size_t i = 0; i < 7; ++i) cloud.setPoint(i, depths[i][0], depths[i][1], depths[i][2], {0.1f, 2.0f});
  cloud.setPoint(7, 0.0f, 0.0f, 2.0f, {0.1f, 2.0f});
  cloud.setPoint(8, 1.0f, 0.0f, 0.1f, {0.1f, 2.0f});
  EXPECT_EQ(cloud.valid_count, 2u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(cloud.valid(i), i >= 7) << i;
}

TEST(Cloud, KeepsAllDepthsWhenTheRangeIsOff) {
  Cloud cloud;
  cloud.reset(2, 1, false);
  cloud.setPoint(0, 0.0f, 1.0f, -50.0f, {});
  cloud.setPoint(1, 0.0f, 1.0f, 5000.0f, {});
  EXPECT_EQ(cloud.valid_count, 2u);
}

TEST(Cloud, ScalesNormalsAndDropsThoseWithoutDirection) {
  Cloud cloud;
  cloud.reset(3, 1, true);
  cloud.setNormal(0, 0.0f, 3.0f, 4.0f);
  cloud.setNormal(1, 0.0f, 0.0f, 0.0f);
  cloud.setNormal(2, std::numeric_limits<float>::infinity(), 0.0f, 0.0f);
  EXPECT_FLOAT_EQ(cloud.ny[0], 0.6f);
  EXPECT_TRUE(std::isnan(cloud.nx[1]) && std::isnan(cloud.nx[2]));
}

TEST(Sampling, DrawsValidPointsOnceSpreadOverTheCloud) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); i += 3) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  cloud.valid_count =
      static_cast<std::uint32_t>(std::count_if(cloud.z.begin(), cloud.z.end(), [](float z) { return z == z; }));
  Samples samples;
  drawSamples(cloud, {}, 1000, 1, samples);
  ASSERT_EQ(samples.size(), 1000u);
  std::set<std::uint32_t> unique(samples.index.begin(), samples.index.end());
  EXPECT_EQ(unique.size(), 1000u);
  int per_quarter[4] = {0, 0, 0, 0};
  for (const std::uint32_t i : samples.index) {
    EXPECT_TRUE(cloud.valid(i));
    ++per_quarter[i * 4 / cloud.size()];
  }
  for (const int count : per_quarter) EXPECT_NEAR(count, 250, 2);
}

TEST(Sampling, TakesAllPointsOfASmallCloudAndNoneOfAnEmptyOne) {
  Random random(31);
  const Cloud cloud = test::cloudOf(patchOf(Sphere{Vec3(0, 0, 1), 0.1}, 50, random));
  Samples samples;
  drawSamples(cloud, {}, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 50u);
  Cloud empty;
  empty.reset(10, 10, false);
  drawSamples(empty, {}, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 0u);
  EXPECT_EQ(boundingBoxDiagonal(samples), 0.0);
}

TEST(Sampling, LeavesOutThePointsThatHaveALabel) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  std::vector<std::uint32_t> labels(cloud.size(), 3);
  for (std::size_t i = 5000; i < 5100; ++i) labels[i] = 0;
  Samples samples;
  drawSamples(cloud, labels, 60, 1, samples);
  EXPECT_EQ(samples.size(), 60u);
  for (const std::uint32_t i : samples.index) EXPECT_TRUE(5000 <= i && i < 5100) << i;
  drawSamples(cloud, labels, 1000, 1, samples);
  EXPECT_EQ(samples.size(), 100u);
}

TEST(Sampling, DependsOnTheSeedAlone) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples a, b, c;
  drawSamples(cloud, {}, 500, 7, a);
  drawSamples(cloud, {}, 500, 7, b);
  drawSamples(cloud, {}, 500, 8, c);
  EXPECT_EQ(a.index, b.index);
  EXPECT_NE(a.index, c.index);
}

TEST(Sampling, PutsNeighborsInSpaceNearEachOtherInMemory) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  Samples samples;
  drawSamples(cloud, {}, 1024, 1, samples);
  double step = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) step += (samples.point(i) - samples.point(i - 1)).norm() / 1023.0;
  // 1024 samples on 1.14 m x 0.86 m are 31 mm apart; in raster order the mean step would be a third of a row, 380 mm.
  EXPECT_LT(step, 0.08);
}

TEST(Sampling, MeasuresTheBoundingBox) {
  Samples samples = test::samplesOf({{Vec3(0, 0, 0), Vec3::UnitX()}, {Vec3(1, 2, 2), Vec3::UnitX()}});
  EXPECT_NEAR(boundingBoxDiagonal(samples), 3.0, 1e-6);
}

TEST(WindowNormals, AreExactOnSlantedPlanesAndPointToTheSensor) {
  for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0.5, 0, 1), Vec3(-0.3, 0.8, 1), Vec3(0.0, 1.5, 1)}) {
    const Vec3 normal = direction.normalized();
    const Cloud cloud = cameraCloud(normal, 0.6);
    const std::optional<Vec3> found = windowNormal(cloud, 60 * 160 + 80, 5);
    ASSERT_TRUE(found);
    EXPECT_LT((*found + normal).norm(), 1e-4) << direction.transpose();
  }
}

TEST(WindowNormals, AreNotBentByTheSurfaceBehindAnEdge) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (int row = 0; row < 120; ++row) {
    for (int column = 83; column < 160; ++column) {
      const std::size_t i = row * 160 + column;
      for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= 1.5f;
    }
  }
  const std::optional<Vec3> found = windowNormal(cloud, 60 * 160 + 80, 5);
  ASSERT_TRUE(found);
  EXPECT_LT((*found + Vec3::UnitZ()).norm(), 1e-4);
}

TEST(WindowNormals, AreMissingWhereThePixelStandsAlone) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  const std::size_t pixel = 60 * 160 + 80;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i != pixel) cloud.z[i] = std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_FALSE(windowNormal(cloud, pixel, 5));
}

TEST(WindowNormals, AreRobustAgainstStragglersInTheWindow) {
  Cloud cloud = cameraCloud(Vec3(0.3, 0, 1).normalized(), 1.0);
  // One side of the window stands off by 2 cm: within the first pass' reach, beyond the noise.
  for (int row = 55; row <= 65; ++row) {
    for (int column = 83; column <= 85; ++column) {
      const std::size_t i = row * 160 + column;
      for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= 1.02f;
    }
  }
  const std::optional<Vec3> found = windowNormal(cloud, 60 * 160 + 80, 5);
  ASSERT_TRUE(found);
  EXPECT_LT((*found + Vec3(0.3, 0, 1).normalized()).norm(), 1e-3);
}

TEST(WindowNormals, LookAtAWiderWindowNearby) {
  // Noise of half a millimetre in a checkerboard; a wider window averages more of it away.
  const auto errorAt = [](double depth) {
    Cloud cloud = cameraCloud(Vec3::UnitZ(), depth);
    Random random(39);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const float factor = 1.0f + 0.002f * static_cast<float>(random.gaussian());
      for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= factor;
    }
    Samples samples;
    drawSamples(cloud, {}, 300, 1, samples);
    std::unique_ptr<NeighborSearch> neighbors;
    estimateNormals(cloud, Params(), neighbors, samples);
    double sum = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) sum += (samples.normal(i) + Vec3::UnitZ()).norm() / 300.0;
    return sum;
  };
  // The noise is a share of the depth, so the angle of a fixed window would be the same at both.
  EXPECT_LT(2.0 * errorAt(0.7), errorAt(2.0));
}

TEST(WindowNormals, ReachTheCornersOfTheImage) {
  const Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (const std::uint32_t pixel : {0u, 159u, 119u * 160u, 119u * 160u + 159u}) {
    const std::optional<Vec3> found = windowNormal(cloud, pixel, 5);
    ASSERT_TRUE(found) << pixel;
    EXPECT_LT((*found + Vec3::UnitZ()).norm(), 1e-4);
  }
}

TEST(NeighborNormals, OfUnorganizedCloudsFollowTheSphere) {
  Random random(32);
  const Sphere sphere = {Vec3(0.1, 0.0, 1.0), 0.3};
  Cloud cloud = test::cloudOf(patchOf(sphere, 4000, random));
  cloud.nx.clear();
  cloud.ny.clear();
  cloud.nz.clear();
  Samples samples;
  drawSamples(cloud, {}, 200, 1, samples);
  std::unique_ptr<NeighborSearch> neighbors;
  estimateNormals(cloud, Params(), neighbors, samples);
  std::vector<double> errors;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_TRUE(samples.hasNormal(i));
    const Vec3 truth = normalAt(sphere, samples.point(i));
    errors.push_back(std::acos(std::min(1.0, truth.dot(samples.normal(i)))));
  }
  std::nth_element(errors.begin(), errors.begin() + 100, errors.end());
  // 41 neighbours of a half sphere of 4000 points span 6 deg either way; their plane is off by a fraction of that.
  EXPECT_LT(errors[100], 2.0 * kDegree);
}

TEST(NeighborNormals, OfPointsOnALineOrInOnePlaceAreMissing) {
  Cloud line;
  line.reset(20, 1, false);
  for (std::size_t i = 0; i < 20; ++i) line.setPoint(i, 0.1f * static_cast<float>(i), 0.0f, 1.0f, {});
  std::vector<std::uint32_t> all(20);
  for (std::uint32_t i = 0; i < 20; ++i) all[i] = i;
  EXPECT_FALSE(planeNormal(line, all));
  for (std::size_t i = 0; i < 20; ++i) line.x[i] = 1.0f;
  EXPECT_FALSE(planeNormal(line, all));
}

TEST(CloudNormals, AreKeptOrTurnedTowardsTheSensor) {
  Cloud cloud = test::cloudOf({{Vec3(0, 0, 1), Vec3(0, 0, 1)}, {Vec3(0, 1, 1), Vec3(0, 0, -1)}});
  Samples samples = test::samplesOf({{Vec3(0, 0, 1), Vec3::UnitX()}, {Vec3(0, 1, 1), Vec3::UnitX()}});
  Params params;
  std::unique_ptr<NeighborSearch> neighbors;
  params.orient_normals = false;
  estimateNormals(cloud, params, neighbors, samples);
  EXPECT_FLOAT_EQ(samples.nz[0], 1.0f);
  params.orient_normals = true;
  estimateNormals(cloud, params, neighbors, samples);
  EXPECT_FLOAT_EQ(samples.nz[0], -1.0f);
  EXPECT_FLOAT_EQ(samples.nz[1], -1.0f);
}

TEST(CloudNormals, ThatAreAllMissingAreEstimated) {
  Cloud cloud = cameraCloud(Vec3::UnitZ(), 1.0);
  for (std::vector<float>* values : {&cloud.nx, &cloud.ny, &cloud.nz}) {
    values->assign(cloud.size(), std::numeric_limits<float>::quiet_NaN());
  }
  Samples samples;
  drawSamples(cloud, {}, 50, 1, samples);
  std::unique_ptr<NeighborSearch> neighbors;
  estimateNormals(cloud, Params(), neighbors, samples);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_NEAR(samples.nz[i], -1.0f, 1e-4f);
}

Candidate candidate(const Shape& shape, const SurfacePoint& reference, double votes) {
  return {shape, reference.point, reference.normal, votes};
}

TEST(Clustering, AveragesByVotes) {
  const Sphere a = {Vec3(0, 0, 1), 0.100}, b = {Vec3(0, 0, 1.004), 0.104};
  std::vector<Candidate> candidates = {candidate(a, pointOn(a, -Vec3::UnitZ()), 30.0),
                                       candidate(b, pointOn(b, -Vec3::UnitZ()), 10.0)};
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_NEAR(std::get<Sphere>(candidates[0].shape).radius, 0.101, 1e-12);
  EXPECT_NEAR(std::get<Sphere>(candidates[0].shape).center.z(), 1.001, 1e-12);
  EXPECT_EQ(candidates[0].votes, 40.0);
  EXPECT_EQ(candidates[0].proposals, 2);
}

TEST(Clustering, MergesAveragesThatComeToAgree) {
  // Spheres in a row along z: each agrees with its neighbour, the outer ones only with the average of the others.
  std::vector<Candidate> candidates;
  const double tops[] = {0.0, 0.012, 0.024};
  const double votes[] = {10.0, 30.0, 20.0};
  for (int k = 0; k < 3; ++k) {
    const Plane plane = {Vec3(0, 0, 1.0 + tops[k]), -Vec3::UnitZ()};
    candidates.push_back({plane, plane.point, plane.normal, votes[k]});
  }
  // 0.01 d_s = 13 mm: all three agree with the middle one, so one cluster; with the middle one weakest it takes two
  // passes.
  std::vector<Candidate> middle_weakest = candidates;
  middle_weakest[1].votes = 5.0;
  clusterCandidates(candidates, presetParams("paper"), 1.3);
  EXPECT_EQ(candidates.size(), 1u);
  clusterCandidates(middle_weakest, presetParams("paper"), 2.2);
  EXPECT_EQ(middle_weakest.size(), 1u);
}

TEST(Clustering, WithNmsKeepsTheStrongest) {
  const Sphere a = {Vec3(0, 0, 1), 0.100}, b = {Vec3(0, 0, 1.004), 0.104};
  std::vector<Candidate> candidates = {candidate(b, pointOn(b, -Vec3::UnitZ()), 10.0),
                                       candidate(a, pointOn(a, -Vec3::UnitZ()), 30.0)};
  clusterCandidates(candidates, presetParams("drost"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_EQ(std::get<Sphere>(candidates[0].shape).radius, 0.100);
}

TEST(Clustering, AveragesCylinderAxesOfEitherSign) {
  const Cylinder a = {Vec3(0, 0, 1), Vec3(0.05, 1, 0).normalized(), 0.1};
  const Cylinder b = {Vec3(0, 0.1, 1), Vec3(0.05, -1, 0).normalized(), 0.1};
  std::vector<Candidate> candidates = {candidate(a, {Vec3(0, 0, 0.9), -Vec3::UnitZ()}, 10.0),
                                       candidate(b, {Vec3(0, 0.1, 0.9), -Vec3::UnitZ()}, 10.0)};
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_LT(test::lineAngle(std::get<Cylinder>(candidates[0].shape).axis, Vec3::UnitY()), 1e-6);
}

TEST(Clustering, KeepsKindsDistancesAndNormalsApart) {
  const Params params = presetParams("paper");
  const Sphere sphere = {Vec3(0, 0, 1), 0.1};
  const Plane near = {Vec3(0, 0, 0.9), -Vec3::UnitZ()};
  const Plane far = {Vec3(0, 0, 0.925), -Vec3::UnitZ()};                                             // 0.01 d_s = 20 mm
  const Plane tilted = {Vec3(0, 0, 0.9), -Vec3(0, std::sin(21 * kDegree), std::cos(21 * kDegree))};  // 20 deg
  std::vector<Candidate> candidates;
  for (const Plane& plane : {near, far, tilted})
    candidates.push_back(candidate(plane, {plane.point, plane.normal}, 10.0));
  candidates.push_back(candidate(sphere, pointOn(sphere, -Vec3::UnitZ()), 10.0));
  clusterCandidates(candidates, params, 2.0);
  EXPECT_EQ(candidates.size(), 4u);
}

TEST(Clustering, SortsByVotes) {
  std::vector<Candidate> candidates;
  for (int k = 0; k < 5; ++k) {
    const Plane plane = {Vec3(0, 0, 1.0 + 0.1 * k), -Vec3::UnitZ()};
    candidates.push_back(candidate(plane, {plane.point, plane.normal}, 10.0 + (k * 3) % 5));
  }
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  for (std::size_t k = 1; k < candidates.size(); ++k) EXPECT_GE(candidates[k - 1].votes, candidates[k].votes);
}

/// 10 mm and 20 deg.
const Tolerance kTolerance = {0.01, 0.0, std::cos(20.0 * kDegree)};

TEST(Segmentation, ExplainsEachSampleAtMostOnce) {
  Random random(33);
  const Sphere a = {Vec3(0, 0, 1), 0.1}, b = {Vec3(0.3, 0, 1), 0.1};
  std::vector<SurfacePoint> points = patchOf(a, 100, random);
  for (const SurfacePoint& p : patchOf(b, 100, random)) points.push_back(p);
  const Samples samples = test::samplesOf(points);
  Params few;
  few.min_inliers = 30;
  const Sphere double_of_a = {Vec3(0, 0, 1.002), 0.101};
  std::vector<Segment> segments;
  segments.clear();
  selectSegments(samples,
                 {candidate(a, points[0], 9), candidate(double_of_a, points[0], 5), candidate(b, points[150], 3)}, few,
                 kTolerance, segments);
  ASSERT_EQ(segments.size(), 2u);
  assignSamples(samples, few, kTolerance, segments);
  EXPECT_EQ(segments[0].inliers.size(), 100u);
  EXPECT_EQ(segments[1].inliers.size(), 100u);
  EXPECT_EQ(std::get<Sphere>(segments[1].candidate.shape).center, b.center);
}

TEST(Segmentation, AsksForDistanceNormalAndNumber) {
  Random random(34);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<SurfacePoint> points = patchOf(plane, 30, 0.3, random);
  for (int k = 0; k < 15; ++k) points[k].normal = Vec3::UnitX();
  Params params;
  params.min_inliers = 15;
  std::vector<Segment> segments;
  segments.clear();
  selectSegments(test::samplesOf(points), {candidate(plane, points[20], 9)}, params, kTolerance, segments);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].inliers.size(), 15u);
  params.min_inliers = 16;
  segments.clear();
  selectSegments(test::samplesOf(points), {candidate(plane, points[20], 9)}, params, kTolerance, segments);
  EXPECT_TRUE(segments.empty());
  params.min_inliers = 3;
  const Plane moved = {Vec3(0, 0, 1.011), -Vec3::UnitZ()};  // tolerance 10 mm
  segments.clear();
  selectSegments(test::samplesOf(points), {candidate(moved, points[20], 9)}, params, kTolerance, segments);
  EXPECT_TRUE(segments.empty());
}

TEST(Segmentation, RefusesShapesBeyondTheLimits) {
  Params params;
  params.min_radius = 0.02;
  params.max_radius = 0.5;
  EXPECT_TRUE(withinLimits(Sphere{Vec3::Zero(), 0.1}, params));
  EXPECT_FALSE(withinLimits(Sphere{Vec3::Zero(), 0.01}, params));
  EXPECT_FALSE(withinLimits(Cylinder{Vec3::Zero(), Vec3::UnitX(), 0.6}, params));
  EXPECT_FALSE(withinLimits(Sphere{Vec3::Zero(), std::nan("")}, params));
  EXPECT_FALSE(withinLimits(Cone{Vec3::Zero(), Vec3::UnitX(), 80 * kDegree}, params));
  EXPECT_FALSE(withinLimits(Cone{Vec3::Zero(), Vec3::UnitX(), 2 * kDegree}, params));
  EXPECT_TRUE(withinLimits(Plane{}, params));
}

std::vector<Vec3> pointsOf(const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> result;
  for (const SurfacePoint& p : points) result.push_back(p.point);
  return result;
}

TEST(Extent, OfARectangleIsItsOutlineSeenFromTheSensor) {
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  std::vector<Vec3> points;
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) points.push_back({0.1 + 0.06 * i, 0.2 + 0.02 * j, 1.0});
  }
  const Extent extent = measureExtent(plane, points);
  EXPECT_LT((extent.origin - Vec3(0.4, 0.3, 1.0)).norm(), 1e-9);
  EXPECT_NEAR(extent.size.x(), 0.6, 1e-9);
  EXPECT_NEAR(extent.size.y(), 0.2, 1e-9);
  EXPECT_LT((extent.rotation.col(2) - plane.normal).norm(), 1e-12);
  EXPECT_NEAR(extent.rotation.determinant(), 1.0, 1e-12);
  ASSERT_EQ(extent.hull.size(), 4u);
  double area = 0.0;
  for (std::size_t k = 0; k < 4; ++k) area += 0.5 * extent.hull[k].cross(extent.hull[(k + 1) % 4]).dot(plane.normal);
  EXPECT_NEAR(area, 0.12, 1e-9);  // positive: counter-clockwise around the normal
}

TEST(Extent, OfACylinderLiesBetweenItsSeenEnds) {
  Random random(35);
  const Cylinder cylinder = {Vec3(0.1, 0.2, 1.0), Vec3(0, -1, 0), 0.05};
  const Extent extent = measureExtent(cylinder, pointsOf(patchOf(cylinder, 3000, 0.02, 0.14, random)));
  EXPECT_NEAR(extent.size.z(), 0.12, 0.005);  // 1 % of stragglers at either end
  EXPECT_LT((extent.origin - Vec3(0.1, 0.12, 1.0)).norm(), 0.003);
  EXPECT_EQ(extent.radius, 0.05);
  EXPECT_LT((extent.rotation.col(2) - cylinder.axis).norm(), 1e-12);
  EXPECT_LT(extent.rotation.col(0).dot(cylinder.point), 0.0);  // x towards the side that was seen
}

TEST(Extent, OfAConeHasTheRadiiOfItsSeenEnds) {
  Random random(36);
  const Cone cone = {Vec3(0, -0.1, 1.0), Vec3(0, 1, 0), std::atan(0.5)};
  const Extent extent = measureExtent(cone, pointsOf(patchOf(cone, 3000, 0.05, 0.25, random)));
  EXPECT_NEAR(extent.radius, 0.125, 0.003);
  EXPECT_NEAR(extent.radius_small, 0.025, 0.003);
  EXPECT_NEAR(extent.size.z(), 0.2, 0.008);
}

TEST(Extent, IsNotStretchedByAStraggler) {
  Random random(37);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  std::vector<Vec3> points = pointsOf(patchOf(cylinder, 300, -0.05, 0.05, random));
  points.push_back(pointOn(cylinder, 3.0, 0.0).point);
  EXPECT_LT(measureExtent(cylinder, points).size.z(), 0.101);
}

TEST(Extent, ContainsWhatWasSeenAndNotTheRestOfTheSurface) {
  Random random(38);
  const Cylinder cylinder = {Vec3(0, 0, 1), Vec3(0, -1, 0), 0.05};
  const Extent extent = measureExtent(cylinder, pointsOf(patchOf(cylinder, 300, -0.05, 0.05, random)));
  EXPECT_TRUE(contains(cylinder, extent, pointOn(cylinder, 0.04, 0.0).point, 0.005));
  EXPECT_FALSE(contains(cylinder, extent, pointOn(cylinder, 0.07, 0.0).point, 0.005));
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  const Extent patch = measureExtent(plane, pointsOf(patchOf(plane, 300, 0.1, random)));
  EXPECT_TRUE(contains(plane, patch, Vec3(0, 0, 1), 0.005));
  EXPECT_FALSE(contains(plane, patch, Vec3(0.2, 0, 1), 0.005));
}

TEST(Canonical, CylinderAxesPointUpInTheImage) {
  for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0.9, 0.1, 0.3)}) {
    EXPECT_LT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), axis.normalized(), 1.0})).axis.y(), 0.0);
  }
  EXPECT_GT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), -Vec3::UnitX(), 1.0})).axis.x(), 0.0);
  EXPECT_GT(std::get<Cylinder>(canonical(Cylinder{Vec3::Zero(), -Vec3::UnitZ(), 1.0})).axis.z(), 0.0);
}

}  // namespace
}  // namespace primitect
