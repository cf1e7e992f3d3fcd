// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which hypotheses explain the samples best together.
#include "core/selection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "test/support/hypotheses.h"
#include "test/support/scenes.h"

namespace primitect {
namespace {

using test::hypothesisOf;
using test::kNoise;
using test::kNoiseModel;
using test::measured;
using test::noisySamples;
using test::patchOf;
using test::samplesWith;
using test::SurfacePoint;
using test::together;

constexpr double kTurn = 0.08;  // rad, of normals
constexpr std::size_t kFewest = 25;

const Sphere kBall = {Vec3(-0.15, 0, 1), 0.08};
const Sphere kOtherBall = {Vec3(0.15, 0, 1), 0.06};

List<Hypothesis> poolOf(const std::vector<Shape>& shapes, const Samples& samples) {
  List<Hypothesis> pool;
  for (const Shape& shape : shapes) pool.push_back(hypothesisOf(shape, samples));
  return pool;
}

List<std::uint32_t> chosenOf(const std::vector<Shape>& shapes, const Samples& samples, std::size_t fewest = kFewest) {
  List<std::uint32_t> chosen = selectHypotheses(samples, poolOf(shapes, samples), fewest).chosen;
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Samples twoBalls() {
  Random random(21);
  return noisySamples(together(patchOf(kBall, 300, random), patchOf(kOtherBall, 200, random)), kTurn, random);
}

/// The point of a plane with these two coordinates.
SurfacePoint pointAt(const Plane& plane, double x, double y) {
  Vec3 p(x, y, 0.0);
  p.z() -= (p - plane.point).dot(plane.normal) / plane.normal.z();
  return {p, plane.normal};
}

using Indices = List<std::uint32_t>;

TEST(Selection, OfNothingIsNothing) {
  EXPECT_TRUE(selectHypotheses(Samples(), {}, kFewest).chosen.empty());
  const Selection none = selectHypotheses(twoBalls(), {}, kFewest);
  EXPECT_TRUE(none.chosen.empty());
  EXPECT_EQ(none.owner, Indices(500, kNobody));
}

TEST(Selection, GivesEachSampleToOneOfTheChosen) {
  const Samples samples = twoBalls();
  const Selection selection = selectHypotheses(samples, poolOf({kBall, kOtherBall}, samples), kFewest);
  EXPECT_EQ(selection.chosen, (Indices{0, 1}));  // best first
  ASSERT_EQ(selection.owner.size(), samples.size());
  // 3 standard deviations hold 99.7 %, and the normals hardly take any: a few of 500 may be outside.
  EXPECT_GT(std::count(selection.owner.begin(), selection.owner.begin() + 300, 0u), 290);
  EXPECT_GT(std::count(selection.owner.begin() + 300, selection.owner.end(), 1u), 190);
  for (const std::uint32_t owner : selection.owner) EXPECT_TRUE(owner == kNobody || owner < 2u);
}

TEST(Selection, GivesASampleOfTwoShapesToTheOneThatFitsBetter) {
  // Two walls that meet: samples at the edge are near both, and their normals tell.
  Random random(22);
  const Plane front = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const Plane slanted = {Vec3(0, 0, 1), Vec3(0, -0.4, -1).normalized()};
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 600; ++i) {
    const Plane& plane = i < 300 ? front : slanted;
    const double x = random.uniform(-0.1, 0.1);
    points.push_back(pointAt(plane, x, i < 300 ? random.uniform(0.0, 0.1) : random.uniform(-0.1, 0.0)));
  }
  const Samples samples = samplesWith(kNoiseModel, points);
  const Selection selection = selectHypotheses(samples, poolOf({front, slanted}, samples), kFewest);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(selection.owner[i], i < 300 ? 0u : 1u) << i;
}

TEST(Selection, DoesNotChooseDuplicates) {
  const Samples samples = twoBalls();
  const Sphere shifted = {kBall.center + Vec3(0.001, 0, 0), kBall.radius + 0.0005};
  EXPECT_EQ(chosenOf({shifted, kBall, kBall, kOtherBall, shifted}, samples).size(), 2u);
}

TEST(Selection, TakesTheBetterOfTwoVersionsWhereverItStands) {
  const Samples samples = twoBalls();
  const Sphere shifted = {kBall.center + Vec3(0.002, 0, 0), kBall.radius};
  EXPECT_EQ(chosenOf({shifted, kBall}, samples), (Indices{1}));
  EXPECT_EQ(chosenOf({kBall, shifted}, samples), (Indices{0}));
}

TEST(Selection, CountsNearlyEqualPlanesOnce) {
  Random random(23);
  const Plane table = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const Samples samples = noisySamples(patchOf(table, 600, 0.2, random), kTurn, random);
  // Versions as fits to parts of the table would give: shifted by a millimetre, turned by half a degree.
  std::vector<Shape> planes;
  for (const double turn : {-0.01, 0.0, 0.01}) {
    for (const double shift : {-0.001, 0.0, 0.001}) {
      planes.push_back(Plane{Vec3(0, 0, 1.0 + shift), Vec3(turn, 0, -1).normalized()});
    }
  }
  EXPECT_EQ(chosenOf(planes, samples), (Indices{4}));
}

TEST(Selection, TakesTwoPlanesRatherThanOneConeOverTwoFaces) {
  Random random(24);
  const test::TwoFaces box;
  const Samples samples = noisySamples(box.points(random), kTurn, random);
  ASSERT_GT(test::inlierCount(hypothesisOf(box.cone, samples)), kFewest);
  EXPECT_EQ(chosenOf({box.cone, box.front, box.top}, samples), (Indices{1, 2}));
}

TEST(Selection, ExchangesALargeWrongShapeForTwoRightOnes) {
  // A strip bent by 8 deg in its middle: a wide cylinder explains more samples of it than either half does, well
  // enough to be chosen first.
  Random random(25);
  const double bend = 4.0 * M_PI / 180.0;
  const Plane left = {Vec3(0, 0, 1), Vec3(-std::sin(bend), 0, -std::cos(bend))};
  const Plane right = {Vec3(0, 0, 1), Vec3(std::sin(bend), 0, -std::cos(bend))};
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 800; ++i) {
    const Plane& plane = i < 400 ? left : right;
    const double x = i < 400 ? random.uniform(-0.08, 0.0) : random.uniform(0.0, 0.08);
    points.push_back(pointAt(plane, x, random.uniform(-0.1, 0.1)));
  }
  const Samples samples = samplesWith(kNoiseModel, measured(points, 0.5 * kNoise, 0.02, random));
  // Normals turn by 8 deg over 8 cm between the middles of the halves; in between the strip is at most 1.4 mm off.
  const double radius = 0.08 / (2.0 * bend);
  const Cylinder cylinder = {Vec3(0, 0, 1.0 + radius + 0.0007), Vec3(0, 1, 0), radius};
  const std::vector<Shape> shapes = {cylinder, left, right};
  const List<Hypothesis> pool = poolOf(shapes, samples);
  ASSERT_GT(pool[0].score, pool[1].score);
  ASSERT_GT(pool[0].score, pool[2].score);
  EXPECT_EQ(chosenOf(shapes, samples), (Indices{1, 2}));
}

TEST(Selection, LeavesOutWhatOwnsFewerThanTheLeast) {
  Random random(26);
  const Samples samples =
      samplesWith(kNoiseModel, together(patchOf(kBall, 300, random), patchOf(kOtherBall, 40, random)));
  EXPECT_EQ(chosenOf({kBall, kOtherBall}, samples, 40), (Indices{0, 1}));
  EXPECT_EQ(chosenOf({kBall, kOtherBall}, samples, 41), (Indices{0}));
}

TEST(Selection, LeavesOutAShapeThatFewerSamplesSpeakForThanAgainst) {
  // A sphere that touches a plane from behind fits in a small cap; around it, samples are near but off.
  Random random(27);
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const Samples samples = noisySamples(patchOf(plane, 800, 0.15, random), kTurn, random);
  const Sphere bulge = {Vec3(0, 0, 1.4), 0.4};
  ASSERT_GT(test::inlierCount(hypothesisOf(bulge, samples)), kFewest);
  EXPECT_TRUE(chosenOf({bulge}, samples).empty());
}

}  // namespace
}  // namespace primitect
