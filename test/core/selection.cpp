// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which hypotheses explain the samples best together.
#include "core/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/support/hypotheses.h"
#include "test/support/scenes.h"

namespace primitect::selection_test {
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

List<std::uint32_t> chosenOf(const List<Hypothesis>& pool, const Samples& samples, std::size_t fewest = kFewest) {
  List<std::uint32_t> chosen = selectHypotheses(samples, pool, fewest).chosen;
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

List<std::uint32_t> chosenOf(const std::vector<Shape>& shapes, const Samples& samples, std::size_t fewest = kFewest) {
  return chosenOf(poolOf(shapes, samples), samples, fewest);
}

Samples twoBalls() {
  Random random(21);
  return noisySamples(together({patchOf(kBall, 300, random), patchOf(kOtherBall, 200, random)}), kTurn, random);
}

/// The point of a plane with these two coordinates.
SurfacePoint pointAt(const Plane& plane, double x, double y) {
  Vec3 p(x, y, 0.0);
  p.z() -= (p - plane.point).dot(plane.normal) / plane.normal.z();
  return {p, plane.normal};
}

using Indices = List<std::uint32_t>;

/// Nine versions of a table, as fits to parts of it would give: shifted by a millimetre, turned by half a degree.
std::vector<Shape> versionsOfATable() {
  std::vector<Shape> planes;
  for (const double turn : {-0.01, 0.0, 0.01}) {
    for (const double shift : {-0.001, 0.0, 0.001}) {
      planes.push_back(Plane{Vec3(0, 0, 1.0 + shift), Vec3(turn, 0, -1).normalized()});
    }
  }
  return planes;
}

Samples samplesOfATable() {
  Random random(23);
  return noisySamples(patchOf(Plane{Vec3(0, 0, 1), Vec3(0, 0, -1)}, 600, 0.2, random), kTurn, random);
}

TEST(Choice, TellsAtOnceWhatItWouldTellOnceEachHadLeft) {
  const Samples samples = samplesOfATable();
  const List<Hypothesis> pool = poolOf(versionsOfATable(), samples);
  Choice choice(samples.size(), pool, kFewest);
  for (const std::uint32_t h : {0u, 4u, 8u}) choice.add(h);
  List<WorthWithout> worths;
  std::size_t told = 0;
  for (const std::uint32_t h : {1u, 2u, 3u, 5u, 7u}) {
    choice.worthsOfAdding(h, worths);
    told += worths.size();
    for (const std::uint32_t gone : choice.order()) {
      Choice without = choice;
      without.remove(gone);
      const auto named = [gone](const WorthWithout& worth) { return worth.gone == gone; };
      const auto told_worth = std::find_if(worths.begin(), worths.end(), named);
      // Of those that leave it no sample nothing is told: their leaving does not help it.
      const Worth worth = told_worth == worths.end() ? choice.worthOfAdding(h) : told_worth->worth;
      EXPECT_NEAR(worth.gain, without.worthOfAdding(h).gain, 1e-9);
      EXPECT_NEAR(worth.total, without.worthOfAdding(h).total, 1e-9);
    }
  }
  EXPECT_GT(told, 10u);
}

TEST(Choice, GoesBackToWhatItWas) {
  const Samples samples = samplesOfATable();
  const List<Hypothesis> pool = poolOf(versionsOfATable(), samples);
  Choice choice(samples.size(), pool, kFewest);
  choice.add(0), choice.add(4);
  const double total = choice.total();
  const Indices order = choice.order(), owners = choice.owners();
  choice.note();
  choice.remove(0), choice.add(8), choice.add(0);
  ASSERT_NE(choice.total(), total);
  choice.goBack();
  EXPECT_EQ(choice.total(), total);
  EXPECT_EQ(choice.order(), order);
  EXPECT_EQ(choice.owners(), owners);
  EXPECT_TRUE(choice.holds(0) && !choice.holds(8));
}

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
  EXPECT_EQ(chosenOf(versionsOfATable(), samplesOfATable()), (Indices{4}));
}

TEST(Selection, TakesTwoPlanesRatherThanOneConeOverTwoFaces) {
  Random random(24);
  const test::TwoFaces box;
  const Samples samples = noisySamples(box.points(random), kTurn, random);
  ASSERT_GT(test::inlierCount(hypothesisOf(box.cone, samples)), kFewest);
  EXPECT_EQ(chosenOf({box.cone, box.front, box.top}, samples), (Indices{1, 2}));
}

/// A strip bent by 8 deg in its middle: a wide cylinder explains more samples of it than either half does, well enough
/// to be chosen first.
struct BentStrip {
  static constexpr double kBend = 4.0 * M_PI / 180.0;
  // Normals turn by 8 deg over 8 cm between the middles of the halves; in between the strip is at most 1.4 mm off.
  static constexpr double kRadius = 0.08 / (2.0 * kBend);
  const Plane left = {Vec3(0, 0, 1), Vec3(-std::sin(kBend), 0, -std::cos(kBend))};
  const Plane right = {Vec3(0, 0, 1), Vec3(std::sin(kBend), 0, -std::cos(kBend))};
  const Cylinder cylinder = {Vec3(0, 0, 1.0 + kRadius + 0.0007), Vec3(0, 1, 0), kRadius};

  std::vector<SurfacePoint> points(Random& random) const {
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 800; ++i) {
      const Plane& plane = i < 400 ? left : right;
      const double x = i < 400 ? random.uniform(-0.08, 0.0) : random.uniform(0.0, 0.08);
      points.push_back(pointAt(plane, x, random.uniform(-0.1, 0.1)));
    }
    return measured(points, 0.5 * kNoise, 0.02, random);
  }
};

TEST(Selection, ExchangesALargeWrongShapeForTwoRightOnes) {
  Random random(25);
  const BentStrip strip;
  const Samples samples = samplesWith(kNoiseModel, strip.points(random));
  const std::vector<Shape> shapes = {strip.cylinder, strip.left, strip.right};
  const List<Hypothesis> pool = poolOf(shapes, samples);
  ASSERT_GT(pool[0].score, pool[1].score);
  ASSERT_GT(pool[0].score, pool[2].score);
  EXPECT_EQ(chosenOf(shapes, samples), (Indices{1, 2}));
}

List<std::uint32_t> chosenAgain(const Samples& samples, const List<Hypothesis>& pool, const Indices& before) {
  List<std::uint32_t> chosen = selectAgain(samples, pool, kFewest, before).chosen;
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

TEST(SelectionAgain, PutsTheNextBestInThePlaceOfWhatWasRefused) {
  const Samples samples = twoBalls();
  const Sphere shifted = {kBall.center + Vec3(0.002, 0, 0), kBall.radius};
  List<Hypothesis> pool = poolOf({kBall, shifted, kOtherBall}, samples);
  ASSERT_EQ(selectHypotheses(samples, pool, kFewest).chosen, (Indices{0, 2}));
  silence(pool[0]);
  const Selection again = selectAgain(samples, pool, kFewest, {0, 2});
  EXPECT_EQ(again.chosen, (Indices{2, 1}));  // what stays comes first
  EXPECT_EQ(again.owner, selectHypotheses(samples, pool, kFewest).owner);
}

TEST(SelectionAgain, LeavesEverythingAsItWasWhereNothingWasRefused) {
  const Samples samples = twoBalls();
  const List<Hypothesis> pool = poolOf({kBall, kOtherBall}, samples);
  const Selection first = selectHypotheses(samples, pool, kFewest),
                  again = selectAgain(samples, pool, kFewest, first.chosen);
  EXPECT_EQ(again.chosen, first.chosen);
  EXPECT_EQ(again.owner, first.owner);
}

TEST(SelectionAgain, ExchangesWhatCameInstead) {
  Random random(25);
  const BentStrip strip;
  const Samples samples = samplesWith(kNoiseModel, strip.points(random));
  List<Hypothesis> pool = poolOf({strip.cylinder, strip.left, strip.right, strip.cylinder}, samples);
  silence(pool[3]);
  EXPECT_EQ(chosenAgain(samples, pool, {3}), (Indices{1, 2}));
}

TEST(SelectionAgain, TriesOnlyWhatIsNextToWhatWasRefused) {
  Random random(25);
  const BentStrip strip;
  const std::vector<SurfacePoint> ball = patchOf(Sphere{Vec3(0.6, 0, 1), 0.1}, 256, random);  // four blocks of its own
  const Samples samples = samplesWith(kNoiseModel, together({ball, strip.points(random)}));
  // As if the cylinder had been tried before the halves were there: what was refused tells whether it is tried now.
  List<Hypothesis> pool =
      poolOf({strip.cylinder, strip.left, strip.right, Sphere{Vec3(0.6, 0, 1), 0.1}, strip.cylinder}, samples);
  ASSERT_FALSE(mayOverlap(pool[0], pool[3]));
  silence(pool[3]);
  EXPECT_EQ(chosenAgain(samples, pool, {0, 3}), (Indices{0}));
  silence(pool[4]);
  EXPECT_EQ(chosenAgain(samples, pool, {0, 4}), (Indices{1, 2}));
}

TEST(SelectionAgain, TriesWhatIsNextToWhatJoined) {
  const BentStrip strip;
  const Sphere ball = {Vec3(0.6, 0, 1), 0.1};
  // Four blocks of its own, or the last one with samples of the strip in it. Nothing was refused.
  for (const int count : {256, 240}) {
    Random random(25);
    const std::vector<SurfacePoint> on_ball = patchOf(ball, count, random);
    const Samples samples = samplesWith(kNoiseModel, together({on_ball, strip.points(random)}));
    const List<Hypothesis> pool = poolOf({strip.cylinder, strip.left, strip.right, ball}, samples);
    ASSERT_EQ(mayOverlap(pool[0], pool[3]), count == 240);
    EXPECT_EQ(chosenAgain(samples, pool, {0}), count == 240 ? (Indices{1, 2, 3}) : (Indices{0, 3}));
  }
}

/// Neighbouring samples that a shape has the same gain at.
struct Part {
  std::uint32_t begin, end;
  float gain;
};

/// What explains these, whatever its shape.
Hypothesis explaining(const Shape& shape, std::size_t samples, const std::vector<Part>& parts) {
  Hypothesis hypothesis;
  hypothesis.shape = shape;
  hypothesis.blocks.assign(samples / SampleBlocks::kSize / 64 + 1, 0);
  hypothesis.on.assign(samples / 64 + 1, 0);
  for (const Part& part : parts) {
    for (std::uint32_t i = part.begin; i < part.end; ++i) {
      const std::size_t block = i / SampleBlocks::kSize;
      hypothesis.support.push_back({i, part.gain});
      hypothesis.blocks[block / 64] |= std::uint64_t{1} << block % 64;
      if (!(part.gain > 0.0f)) continue;
      hypothesis.on[i / 64] |= std::uint64_t{1} << i % 64;
      hypothesis.gain_sum += part.gain;
      ++hypothesis.inliers;
    }
  }
  return hypothesis;
}

TEST(Selection, TriesAgainWhatIsNextToWhatCameByAnExchange) {
  constexpr std::uint32_t kSamples = 456;
  const Plane plane = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  const Cylinder tube = {Vec3(0, 0, 1), Vec3(0, 1, 0), 0.1};
  // Two tubes, each over two planes that explain its samples better. Those between the tubes speak against a plane of
  // the first one, so that it stays when it is tried, before the second one. But a plane of that one explains them.
  const Part first = {0, 200, 0.8f}, between = {200, 230, 0.9f}, second = {256, kSamples, 0.8f};
  const List<Hypothesis> pool = {explaining(tube, kSamples, {first}),
                                 explaining(tube, kSamples, {second}),
                                 explaining(plane, kSamples, {{0, 100, 0.9f}}),
                                 explaining(plane, kSamples, {{100, 200, 0.9f}, {200, 230, -1.0f}}),
                                 explaining(plane, kSamples, {between, {256, 356, 0.9f}}),
                                 explaining(plane, kSamples, {{356, kSamples, 0.9f}})};
  ASSERT_FALSE(mayOverlap(pool[0], pool[1]));
  const Samples samples = test::samplesOf(std::vector<SurfacePoint>(kSamples, pointAt(plane, 0.0, 0.0)));
  List<Hypothesis> without_it = pool;
  silence(without_it[4]);
  ASSERT_EQ(chosenOf(without_it, samples), (Indices{0, 1})) << "nobody explains what is between";
  EXPECT_EQ(chosenOf(pool, samples), (Indices{2, 3, 4, 5}));
}

TEST(Selection, LeavesOutWhatOwnsFewerThanTheLeast) {
  Random random(26);
  const Samples samples =
      samplesWith(kNoiseModel, together({patchOf(kBall, 300, random), patchOf(kOtherBall, 40, random)}));
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
}  // namespace primitect::selection_test
