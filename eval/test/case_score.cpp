// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole score of a cloud: what counts, by kind, and what shapes that need not be found do.
#include "eval/case_score.h"

#include <gtest/gtest.h>

#include "eval/test/hand_made.h"

namespace case_score_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

Plane shelf(double height) { return {Vec3(0, 0, height), Vec3::UnitZ()}; }

/// A sphere so large that it is a plane for the rules, at this height.
Sphere flatSphere(double height) { return {Vec3(0, 0, height - 1e6), 1e6}; }

const Counts& of(const CaseScore& score, Kind kind) { return score.of_kind[static_cast<std::size_t>(kind)]; }

TEST(CaseScore, GivesFullMarksToTheTruth) {
  const CaseScore score = scoreCase(shelves(2), {shelf(1), shelf(2)});
  EXPECT_EQ(score.all.truths, 2);
  EXPECT_EQ(score.all.found, 2);
  EXPECT_EQ(score.all.typed_correct, 2);
  EXPECT_EQ(score.all.type_right, 2);
  EXPECT_EQ(score.all.missed + score.all.noise + score.all.over_segmented + score.all.under_segmented, 0);
  EXPECT_EQ(score.all.dod, 0.0);
  EXPECT_EQ(score.points, 20);
  EXPECT_EQ(score.p_coverage.size(), kCurvePoints);
  EXPECT_EQ(score.s_coverage.back(), 1.0);
}

TEST(CaseScore, JudgesEachDetection) {
  LabelledCloud input = shelves(3);
  input.truth[2].must = false;
  // The first has the right place and the wrong kind, the third lies on what need not be found, the last on nothing.
  const CaseScore score = scoreCase(input, {flatSphere(1), shelf(2), shelf(3), flatSphere(9)});
  EXPECT_EQ(score.verdicts, (std::vector<Verdict>{Verdict::wrong, Verdict::right, Verdict::no_matter, Verdict::wrong}));
  EXPECT_EQ(score.true_shape, (std::vector<int>{kNoShape, 1, kNoShape, kNoShape}));
}

TEST(CaseScore, TellsTheKindThatADetectionLiesOn) {
  LabelledCloud input = shelves(3);
  input.truth[2].must = false;
  const CaseScore score = scoreCase(input, {flatSphere(1), shelf(3), flatSphere(9)});
  using Kinds = std::vector<std::optional<Kind>>;
  EXPECT_EQ(score.lies_on, (Kinds{Kind::plane, Kind::plane, std::nullopt}));
}

TEST(CaseScore, CountsFalseCurvedShapes) {
  LabelledCloud input = shelves(3);
  input.truth[2].must = false;
  const std::vector<Shape> found = {flatSphere(1), shelf(2), flatSphere(3), shelf(9)};
  EXPECT_EQ(scoreCase(input, found).false_curved, 1);
  input.recipe.set = "clutter";
  EXPECT_EQ(scoreCase(input, found).false_curved, 2) << "there is no curved shape at all on such a frame";
}

TEST(CaseScore, GivesDodInTheUnitOfTheCloud) {
  LabelledCloud input = shelves(2);
  input.unit = 0.01;
  const CaseScore score = scoreCase(input, {shelf(1.02), shelf(2)});
  EXPECT_EQ(score.all.correct, 2);
  EXPECT_NEAR(score.all.dod, 2.0, 1e-5);
  EXPECT_NEAR(score.all.typed_dod, 2.0, 1e-5);
  EXPECT_NEAR(score.errors[0].position.at(0), 0.02, 1e-7);
}

/// The first of two true shapes is that of two shelves that are a millimetre apart in height.
LabelledCloud nearlyOneShelf() {
  LabelledCloud input = shelves(3);
  for (std::size_t i = 10; i < 20; ++i) input.scored.x[i] += 9.0f, input.scored.z[i] = 1.001f;
  input.truth[0].exact = false;
  input.face = labels({{0, 10}, {1, 10}, {kNoShape, 10}});
  input.surface = labels({{0, 20}, {2, 10}});
  input.truth[1].must = false;
  return input;
}

TEST(CaseScore, CountsOneForBothFacesOfAShapeLikeOneForEach) {
  const CaseScore both = scoreCase(nearlyOneShelf(), {shelf(1.0005), shelf(3)});
  const CaseScore each = scoreCase(nearlyOneShelf(), {shelf(1), shelf(1.001), shelf(3)});
  for (const CaseScore& score : {both, each}) {
    EXPECT_EQ(score.all.truths, 2);
    EXPECT_EQ(score.all.found, 2);
    EXPECT_EQ(score.all.typed_correct, 2);
    EXPECT_EQ(score.all.over_segmented + score.all.noise, 0);
  }
  EXPECT_EQ(each.verdicts, std::vector<Verdict>(3, Verdict::right));
  EXPECT_EQ(each.true_shape, (std::vector<int>{0, 0, 2}));
}

TEST(CaseScore, CountsASecondDetectionOfOneFaceAsWrong) {
  LabelledCloud input = nearlyOneShelf();
  for (std::size_t i = 0; i < 5; ++i) input.scored.z[i] = 0.999f;  // a step within the first
  const CaseScore score = scoreCase(input, {shelf(0.999), shelf(1.0005), shelf(3)});
  EXPECT_EQ(score.all.found, 3);
  EXPECT_EQ(score.all.typed_correct, 2);
}

TEST(CaseScore, KeepsADetectionThatOnlyPassesThroughAFaceForItsOwnShape) {
  // Where nothing lies on a face, what is nearest has its points.
  LabelledCloud input = nearlyOneShelf();
  input.rules.max_distance = 3.0;
  for (std::size_t i = 10; i < 14; ++i) input.surface[i] = input.face[i] = kNoShape;
  for (std::size_t i = 14; i < 20; ++i) input.scored.z[i] = 2.5f;
  const CaseScore score = scoreCase(input, {shelf(1), shelf(3)});
  EXPECT_EQ(score.all.found, 2);
  EXPECT_EQ(score.true_shape, (std::vector<int>{0, 2}));
}

TEST(CaseScore, TakesItsRulesFromTheCloud) {
  LabelledCloud input = shelves(1);
  input.rules.max_distance = 0.01;
  EXPECT_EQ(scoreCase(input, {shelf(1.02)}).all.correct, 0);
  input = shelves(1);
  for (std::size_t i = 0; i < 3; ++i) input.scored.z[i] = 9.0f;
  EXPECT_EQ(scoreCase(input, {shelf(1)}).all.correct, 1);
  input.rules.overlap = 0.8;
  EXPECT_EQ(scoreCase(input, {shelf(1)}).all.correct, 0);
}

TEST(CaseScore, MeasuresCoverageOnTheMeasuredPoints) {
  LabelledCloud input = shelves(1);
  for (float& z : input.cloud.z) z += 0.03f;
  const CaseScore score = scoreCase(input, {shelf(1)});
  EXPECT_EQ(score.p_coverage[10], 0.0);
  EXPECT_EQ(score.p_coverage[20], 1.0);
}

TEST(CaseScore, TakesPlaneErrorsInTheMiddleOfTheirPoints) {
  LabelledCloud input = shelves(1);
  // The points lie around (2, 0.5): a tilt about the x axis through y = 0 is felt half a metre away.
  const double tilt_deg = 2.0;
  const CaseScore score = scoreCase(input, {Plane{Vec3(0, 0, 1), tilted(tilt_deg)}});
  EXPECT_NEAR(score.errors[0].position.at(0), 0.5 * std::sin(tilt_deg * kDegree), 1e-6);
}

TEST(CaseScore, SaysWhatIsSplitByTheTrueKindAndWhatIsJoinedByTheKindFound) {
  LabelledCloud input = shelves(1);
  for (std::size_t i = 0; i < 5; ++i) input.scored.z[i] = 3.0f;
  const CaseScore split = scoreCase(input, {shelf(1), flatSphere(3)});
  EXPECT_EQ(of(split, Kind::plane).over_segmented, 1);
  EXPECT_EQ(split.all.over_segmented, 1);
  EXPECT_EQ(split.all.under_segmented, 0);

  LabelledCloud two = shelves(2);
  for (std::size_t i = 10; i < 20; ++i) two.scored.z[i] = 1.0f;
  const CaseScore joined = scoreCase(two, {flatSphere(1)});
  EXPECT_EQ(of(joined, Kind::sphere).under_segmented, 1);
  EXPECT_EQ(joined.all.under_segmented, 1);
  EXPECT_EQ(joined.all.over_segmented, 0);
}

TEST(CaseScore, KeepsAPairOfDifferentKindsOutOfTheTypedFigures) {
  const CaseScore score = scoreCase(shelves(1), {flatSphere(1.01)});
  EXPECT_EQ(score.all.correct, 1);
  EXPECT_EQ(score.all.typed_correct, 0);
  EXPECT_EQ(score.all.type_right, 0);
  EXPECT_EQ(score.all.typed_dod, 0.0);
  EXPECT_NEAR(score.all.dod, 0.01, 1e-4);
  EXPECT_EQ(of(score, Kind::plane).correct, 1);
  EXPECT_EQ(of(score, Kind::plane).found, 0);
  EXPECT_EQ(of(score, Kind::sphere).found, 1);
  EXPECT_TRUE(score.errors[1].radius.empty());
}

TEST(CaseScore, CountsWhatIsMissedByItsKindAndWhatIsNoiseByTheKindFound) {
  const CaseScore score = scoreCase(shelves(2), {shelf(1), flatSphere(5)});
  EXPECT_EQ(of(score, Kind::plane).missed, 1);
  EXPECT_EQ(of(score, Kind::sphere).noise, 1);
  EXPECT_EQ(score.all.missed, 1);
  EXPECT_EQ(score.all.noise, 1);
}

TEST(CaseScore, GivesNothingToAnEmptyResult) {
  const CaseScore score = scoreCase(shelves(3), {});
  EXPECT_EQ(score.all.missed, 3);
  EXPECT_EQ(score.all.found, 0);
  EXPECT_EQ(score.p_coverage.back(), 0.0);
  EXPECT_TRUE(score.s_coverage.empty());
}

TEST(OptionalShapes, CountNeitherWhenFoundNorWhenNot) {
  LabelledCloud input = shelves(2);
  input.truth[1].must = false;
  for (const std::vector<Shape>& found : {std::vector<Shape>{shelf(1), shelf(2)}, std::vector<Shape>{shelf(1)}}) {
    const CaseScore score = scoreCase(input, found);
    EXPECT_EQ(score.all.truths, 1);
    EXPECT_EQ(score.all.found, 1);
    EXPECT_EQ(score.all.typed_correct, 1);
    EXPECT_EQ(score.all.noise, 0);
  }
}

TEST(OptionalShapes, DoNotExcuseNoiseElsewhere) {
  LabelledCloud input = shelves(2);
  input.truth[1].must = false;
  EXPECT_EQ(scoreCase(input, {shelf(1), shelf(7)}).all.noise, 1);
}

TEST(OptionalShapes, LendNoPointsToADetectionOfAnotherShape) {
  // A cup: inner and outer wall 5 mm apart, the inner need not be found. The one detection takes the points of both.
  LabelledCloud input = shelves(2);
  input.truth[1] = {shelf(1.005), true, false};
  for (std::size_t i = 10; i < 20; ++i) input.scored.z[i] = 1.005f;
  const CaseScore score = scoreCase(input, {shelf(1)});
  EXPECT_EQ(score.all.typed_correct, 1);
  EXPECT_EQ(score.all.found, 1);
}

TEST(OptionalShapes, ExcuseADetectionThatIsMostlyOnTheirPoints) {
  LabelledCloud input = shelves(2);
  input.truth[1].must = false;
  // Four points of the first shelf are lifted to the second: too few to be its detection, and not noise either.
  for (std::size_t i = 0; i < 4; ++i) input.scored.z[i] = 2.0f;
  const CaseScore score = scoreCase(input, {shelf(2)});
  EXPECT_EQ(score.all.found, 0);
  EXPECT_EQ(score.all.missed, 1);
}

TEST(Clutter, IsNoMissButADetectionOfItIsNoise) {
  LabelledCloud input = shelves(2);
  input.truth.pop_back();
  for (std::size_t i = 10; i < 20; ++i) input.surface[i] = kClutter;
  EXPECT_EQ(scoreCase(input, {shelf(1)}).all.noise, 0);
  EXPECT_EQ(scoreCase(input, {shelf(1)}).all.truths, 1);
  EXPECT_EQ(scoreCase(input, {shelf(1), shelf(2)}).all.noise, 1);
}

TEST(Clutter, DoesNotSpoilADetectionThatRunsThroughIt) {
  LabelledCloud input = shelves(2);
  input.truth.pop_back();
  for (std::size_t i = 10; i < 20; ++i) input.surface[i] = kClutter, input.scored.z[i] = 1.01f;
  const CaseScore score = scoreCase(input, {shelf(1)});
  EXPECT_EQ(score.all.typed_correct, 1);
  EXPECT_EQ(score.all.noise, 0);
}

TEST(Outliers, DoSpoilADetectionThatTakesThem) {
  LabelledCloud input = shelves(2);
  input.truth.pop_back();
  for (std::size_t i = 10; i < 20; ++i) input.surface[i] = kNoShape, input.scored.z[i] = 1.01f;
  EXPECT_EQ(scoreCase(input, {shelf(1)}).all.correct, 0);
}

TEST(Counts, AddUpFieldByField) {
  const CaseScore one = scoreCase(shelves(2), {shelf(1), flatSphere(5)});
  Counts sum = one.all;
  sum += one.all;
  EXPECT_EQ(sum.truths, 4);
  EXPECT_EQ(sum.found, 4);
  EXPECT_EQ(sum.correct, 2);
  EXPECT_EQ(sum.typed_correct, 2);
  EXPECT_EQ(sum.missed, 2);
  EXPECT_EQ(sum.noise, 2);
  EXPECT_EQ(sum.type_right, 2);

  const Counts some{1, 2, 3, 4, 5, 6, 7, 8, 9, 10.0, 11.0};
  Counts twice = some;
  twice += some;
  EXPECT_EQ(twice.over_segmented, 14);
  EXPECT_EQ(twice.under_segmented, 16);
  EXPECT_EQ(twice.dod, 20.0);
  EXPECT_EQ(twice.typed_dod, 22.0);
}

}  // namespace
}  // namespace case_score_test
