// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Merging candidates that mean the same shape.
#include "core/clustering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/support/candidates.h"
#include "test/support/exact_shapes.h"

namespace primitect::clustering_test {
namespace {

using test::candidate;
using test::kDegree;
using test::pointOn;

TEST(Clustering, AveragesByVotes) {
  const Sphere a = {Vec3(0, 0, 1), 0.100}, b = {Vec3(0, 0, 1.004), 0.104};
  List<Candidate> candidates = {candidate(a, pointOn(a, -Vec3::UnitZ()), 30.0),
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
  List<Candidate> candidates;
  const double tops[] = {0.0, 0.012, 0.024};
  const double votes[] = {10.0, 30.0, 20.0};
  for (int k = 0; k < 3; ++k) {
    const Plane plane = {Vec3(0, 0, 1.0 + tops[k]), -Vec3::UnitZ()};
    candidates.push_back({plane, false, plane.point, plane.normal, votes[k]});
  }
  // 0.01 d_s = 13 mm: all three agree with the middle one, so one cluster; with the middle one weakest it takes two
  // passes.
  List<Candidate> middle_weakest = candidates;
  middle_weakest[1].votes = 5.0;
  clusterCandidates(candidates, presetParams("paper"), 1.3);
  EXPECT_EQ(candidates.size(), 1u);
  clusterCandidates(middle_weakest, presetParams("paper"), 2.2);
  EXPECT_EQ(middle_weakest.size(), 1u);
}

TEST(Clustering, WithNmsKeepsTheStrongest) {
  const Sphere a = {Vec3(0, 0, 1), 0.100}, b = {Vec3(0, 0, 1.004), 0.104};
  List<Candidate> candidates = {candidate(b, pointOn(b, -Vec3::UnitZ()), 10.0),
                                candidate(a, pointOn(a, -Vec3::UnitZ()), 30.0)};
  clusterCandidates(candidates, presetParams("drost"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_EQ(std::get<Sphere>(candidates[0].shape).radius, 0.100);
}

TEST(Clustering, AveragesCylinderAxesOfEitherSign) {
  const Cylinder a = {Vec3(0, 0, 1), Vec3(0.05, 1, 0).normalized(), 0.1};
  const Cylinder b = {Vec3(0, 0.1, 1), Vec3(0.05, -1, 0).normalized(), 0.1};
  List<Candidate> candidates = {candidate(a, {Vec3(0, 0, 0.9), -Vec3::UnitZ()}, 10.0),
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
  List<Candidate> candidates;
  for (const Plane& plane : {near, far, tilted})
    candidates.push_back(candidate(plane, {plane.point, plane.normal}, 10.0));
  candidates.push_back(candidate(sphere, pointOn(sphere, -Vec3::UnitZ()), 10.0));
  clusterCandidates(candidates, params, 2.0);
  EXPECT_EQ(candidates.size(), 4u);
}

/// Inner wall of a tube at its lowest point, seen from above.
Candidate tubeCandidate(double radius, double votes) {
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitX(), radius};
  return {tube, true, Vec3(0, 0, 1 + radius), -Vec3::UnitZ(), votes};
}

TEST(Clustering, AveragesShapesSeenFromInside) {
  List<Candidate> candidates = {tubeCandidate(0.100, 30.0), tubeCandidate(0.104, 10.0)};
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_NEAR(std::get<Cylinder>(candidates[0].shape).radius, 0.101, 1e-12);
  EXPECT_TRUE(candidates[0].concave);
}

TEST(Clustering, WithNmsKeepsTheSideOfTheStrongest) {
  List<Candidate> candidates = {tubeCandidate(0.100, 30.0), tubeCandidate(0.104, 10.0)};
  clusterCandidates(candidates, presetParams("drost"), 2.0);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_TRUE(candidates[0].concave);
}

TEST(Clustering, KeepsTheSidesOfOneShapeApart) {
  // A thin tube seen from both sides: the same cylinder, found outside and inside.
  const Cylinder tube = {Vec3(0, 0, 1), Vec3::UnitX(), 0.1};
  List<Candidate> candidates = {tubeCandidate(0.1, 10.0), candidate(tube, pointOn(tube, 0.0, 0.0), 10.0)};
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  EXPECT_EQ(candidates.size(), 2u);
}

TEST(Agreement, OfShapesSeenFromInsideTakesTheInwardNormalAndTheSameSide) {
  const Candidate tube = tubeCandidate(0.1, 10.0);
  Candidate other = tube;
  EXPECT_TRUE(agrees(other, tube, 0.02, 20.0 * kDegree));
  other.concave = false;
  EXPECT_FALSE(agrees(other, tube, 0.02, 20.0 * kDegree));
  other = tube;
  other.normal = Vec3::UnitZ();  // outward
  EXPECT_FALSE(agrees(other, tube, 0.02, 20.0 * kDegree));
}

TEST(Clustering, SortsByVotes) {
  List<Candidate> candidates;
  for (int k = 0; k < 5; ++k) {
    const Plane plane = {Vec3(0, 0, 1.0 + 0.1 * k), -Vec3::UnitZ()};
    candidates.push_back(candidate(plane, {plane.point, plane.normal}, 10.0 + (k * 3) % 5));
  }
  clusterCandidates(candidates, presetParams("paper"), 2.0);
  for (std::size_t k = 1; k < candidates.size(); ++k) EXPECT_GE(candidates[k - 1].votes, candidates[k].votes);
}

}  // namespace
}  // namespace primitect::clustering_test
