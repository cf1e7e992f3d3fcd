// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labels of shelves whose points can be counted.
#include "eval/label_score.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "eval/test/hand_made.h"

namespace label_score_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

Plane shelf(double height) { return {Vec3(0, 0, height), Vec3::UnitZ()}; }

/// Of twenty points on two shelves, the first detection has seven of the lower and two of the upper shelf, the second
/// six of the upper one.
std::vector<std::uint32_t> someLabels() {
  std::vector<std::uint32_t> result;
  for (const int label : labels({{1, 7}, {0, 3}, {1, 2}, {2, 6}, {0, 2}})) result.push_back(label);
  return result;
}

std::vector<std::optional<LabelScore>> scored(const LabelledCloud& input, const std::vector<Shape>& found) {
  return scoreLabels(input, someLabels(), scoreCase(input, found));
}

TEST(LabelScore, CountsPointsWithTheLabelAndPointsOfTheShape) {
  const auto scores = scored(shelves(2), {shelf(1), shelf(2)});
  ASSERT_TRUE(scores.at(0) && scores.at(1));
  EXPECT_EQ(scores[0]->labelled, 9);
  EXPECT_EQ(scores[0]->on_shape, 10);
  EXPECT_EQ(scores[0]->both, 7);
  EXPECT_EQ(scores[1]->labelled, 6);
  EXPECT_EQ(scores[1]->both, 6);
}

TEST(LabelScore, LeavesMissingPointsOut) {
  LabelledCloud input = shelves(2);
  const CaseScore score = scoreCase(input, {shelf(1), shelf(2)});
  input.cloud.z[0] = std::numeric_limits<float>::quiet_NaN();
  const auto scores = scoreLabels(input, someLabels(), score);
  EXPECT_EQ(scores.at(0)->labelled, 8);
  EXPECT_EQ(scores[0]->on_shape, 9);
  EXPECT_EQ(scores[0]->both, 6);
}

TEST(LabelScore, IsOfRightDetectionsAlone) {
  const auto scores = scored(shelves(2), {shelf(1), shelf(9)});
  EXPECT_TRUE(scores.at(0));
  EXPECT_FALSE(scores.at(1));
}

TEST(LabelScore, IsNotOfSurfacesThatAreOneTrueShape) {
  LabelledCloud input = shelves(2);
  input.truth[0].exact = false;
  const auto scores = scored(input, {shelf(1), shelf(2)});
  EXPECT_FALSE(scores.at(0));
  EXPECT_TRUE(scores.at(1));
}

TEST(LabelScore, NeedsThePointsThatAreScoredInTheirOrder) {
  LabelledCloud shuffled = shelves(2);
  shuffled.recipe.shuffle = true;
  for (const auto& score : scored(shuffled, {shelf(1), shelf(2)})) EXPECT_FALSE(score);
  const LabelledCloud input = shelves(2);
  EXPECT_THROW(scoreLabels(input, {1, 2}, scoreCase(input, {shelf(1)})), std::invalid_argument);
}

}  // namespace
}  // namespace label_score_test
