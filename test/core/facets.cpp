// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which planes may be facets of one curved surface.
#include "core/facets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::facets_test {
namespace {

using test::SurfacePoint;

/// A wall of three faces of 20 cm, each turned by so much (rad) against the one before; 400 points of each in turn.
Samples foldedWall(double turn, Random& random) {
  std::vector<SurfacePoint> points;
  Vec3 corner(-0.3, 0, 1);
  for (int face = -1; face <= 1; ++face) {
    const Vec3 along(std::cos(face * turn), 0, std::sin(face * turn)), normal(along.z(), 0, -along.x());
    for (int i = 0; i < 400; ++i) {
      const double across = random.uniform(0.0, 0.2), up = random.uniform(-0.1, 0.1);
      points.push_back({corner + across * along + up * Vec3::UnitY(), normal});
    }
    corner += 0.2 * along;
  }
  return test::samplesOf(points);
}

SampleParts groupsOf(const Samples& samples, const List<std::uint32_t>& owner) {
  SampleGraph graph;
  graph.build(samples);
  return facetGroups(samples, graph, owner, 3);
}

List<std::uint32_t> byFace(const Samples& samples) {
  List<std::uint32_t> owner;
  for (std::uint32_t i = 0; i < samples.size(); ++i) owner.push_back(i / 400);
  return owner;
}

TEST(FacetGroups, AreOneWhereEveryPlaneRunsSmoothlyIntoTheNext) {
  Random random(11);
  const Samples samples = foldedWall(0.3, random);
  const SampleParts groups = groupsOf(samples, byFace(samples));
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0], test::allOf(samples));
}

TEST(FacetGroups, AreNoneOfASquareFold) {
  Random random(12);
  const Samples samples = foldedWall(0.5 * M_PI, random);
  EXPECT_TRUE(groupsOf(samples, byFace(samples)).empty());
}

/// Between two facets is what is beyond the noise of both.
TEST(FacetGroups, LeadOverWhatIsNobodys) {
  Random random(13);
  const Samples samples = foldedWall(0.3, random);
  List<std::uint32_t> owner = byFace(samples);
  List<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    if (std::abs(std::abs(samples.x[i]) - 0.1f) < 0.015f) owner[i] = kNobody;
    if (owner[i] != kNobody) kept.push_back(i);
  }
  const SampleParts groups = groupsOf(samples, owner);
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0], kept);
}

TEST(FacetGroups, DoNotLeadOverAnotherShape) {
  Random random(14);
  const Samples samples = foldedWall(0.3, random);
  List<std::uint32_t> owner = byFace(samples);
  for (std::uint32_t& of : owner) of = of == 1 ? kOther : of;
  EXPECT_TRUE(groupsOf(samples, owner).empty());
}

}  // namespace
}  // namespace primitect::facets_test
