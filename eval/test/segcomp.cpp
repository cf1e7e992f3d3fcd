// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// SegComp's instances and the accuracy of the kinds on hand-made labels.
#include "eval/segcomp.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "eval/test/hand_made.h"

namespace segcomp_test {
namespace {

using namespace primitect;
using namespace primitect::eval;
using Pairs = std::vector<std::pair<int, int>>;

Segmentation segmentLabels(const std::vector<int>& truth, int truths, const std::vector<int>& found, int detections) {
  return segment(countOverlaps(truth, truths, found, detections), 0.6);
}

TEST(SegComp, CountsAPairAsCorrectFromSixtyPercentOfBothOn) {
  const std::vector<int> truth = labels({{0, 10}, {-1, 4}});
  EXPECT_EQ(segmentLabels(truth, 1, labels({{0, 6}, {-1, 4}, {0, 4}}), 1).correct.size(), 1u);
  EXPECT_EQ(segmentLabels(truth, 1, labels({{0, 5}, {-1, 9}}), 1).correct.size(), 0u);
}

TEST(SegComp, AsksForTheShareOfTheDetectionToo) {
  const Segmentation result = segmentLabels(labels({{0, 10}, {-1, 10}}), 1, labels({{0, 20}}), 1);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.missed.size(), 1u);
  EXPECT_EQ(result.noise.size(), 1u);
}

TEST(SegComp, FindsOverSegmentation) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 5}, {1, 5}}), 2);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.over_segmented.size(), 1u);
  EXPECT_EQ(result.missed.size(), 0u);
  EXPECT_EQ(result.noise.size(), 0u);
}

TEST(SegComp, FindsUnderSegmentation) {
  const Segmentation result = segmentLabels(labels({{0, 5}, {1, 5}}), 2, labels({{0, 10}}), 1);
  EXPECT_TRUE(result.correct.empty());
  EXPECT_EQ(result.under_segmented.size(), 1u);
  EXPECT_EQ(result.missed.size(), 0u);
  EXPECT_EQ(result.noise.size(), 0u);
}

TEST(SegComp, KeepsACorrectPairBesideASmallDuplicateThatIsNoNoise) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 8}, {1, 2}}), 2);
  ASSERT_EQ(result.correct.size(), 1u);
  EXPECT_EQ(result.correct[0], std::make_pair(0, 0));
  EXPECT_EQ(result.over_segmented.size(), 0u);
  EXPECT_EQ(result.noise.size(), 0u);
}

TEST(SegComp, CallsADetectionWithoutPointsNoise) {
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 10}}), 2);
  EXPECT_EQ(result.correct.size(), 1u);
  EXPECT_EQ(result.noise.size(), 1u);
}

TEST(SegComp, MissesEverythingWithoutDetections) {
  const Segmentation result = segmentLabels(labels({{0, 5}, {1, 5}}), 2, labels({{-1, 10}}), 0);
  EXPECT_EQ(result.missed.size(), 2u);
  EXPECT_EQ(result.noise.size(), 0u);
}

TEST(SegComp, NamesTheRegionsOfAnInstance) {
  const Segmentation result =
      segmentLabels(labels({{0, 10}, {1, 10}, {2, 10}}), 3, labels({{3, 10}, {0, 5}, {1, 5}, {-1, 10}}), 5);
  EXPECT_EQ(result.correct, (Pairs{{0, 3}}));
  EXPECT_EQ(result.over_segmented, (std::vector<int>{1}));
  EXPECT_EQ(result.missed, (std::vector<int>{2}));
  EXPECT_EQ(result.noise, (std::vector<int>{2, 4}));
}

TEST(SegComp, NeedsTheSplitToCoverItsShareOfTheRegion) {
  // Two detections within the region, 5 of 10 points together: neither an over-segmentation nor correct.
  const Segmentation result = segmentLabels(labels({{0, 10}}), 1, labels({{0, 3}, {1, 2}, {-1, 5}}), 2);
  EXPECT_TRUE(result.over_segmented.empty());
  EXPECT_EQ(result.missed.size(), 1u);
  EXPECT_EQ(result.noise.size(), 2u);
}

TEST(SegComp, CountsNoDetectionIntoASplitThatLiesMostlyElsewhere) {
  // The second detection covers half of the region, but most of it is outside.
  const Segmentation result = segmentLabels(labels({{0, 10}, {-1, 20}}), 1, labels({{0, 5}, {1, 5}, {1, 20}}), 2);
  EXPECT_TRUE(result.over_segmented.empty());
  EXPECT_EQ(result.missed.size(), 1u);
}

TEST(Overlaps, RefuseLabelsThatDoNotFit) {
  EXPECT_THROW(countOverlaps({0, 1}, 1, {0, 0}, 1), std::out_of_range);
  EXPECT_THROW(countOverlaps({0}, 1, {0, 0}, 1), std::invalid_argument);
}

TEST(KindAccuracy, TakesTheDetectionThatOverlapsMost) {
  const Overlaps overlaps = countOverlaps(labels({{0, 10}}), 1, labels({{0, 3}, {1, 7}}), 2);
  EXPECT_EQ(sameKindMatches(overlaps, {Kind::cone}, {Kind::sphere, Kind::cone}), (Pairs{{0, 1}}));
  EXPECT_TRUE(sameKindMatches(overlaps, {Kind::cone}, {Kind::cone, Kind::sphere}).empty());
}

TEST(KindAccuracy, SetsWhatIsCommonAgainstWhatBothCoverTogether) {
  // The large detection shares more points with the region, the small one overlaps with it better.
  const Overlaps overlaps = countOverlaps(labels({{0, 11}, {-1, 30}}), 1, labels({{1, 5}, {0, 6}, {0, 30}}), 2);
  EXPECT_EQ(sameKindMatches(overlaps, {Kind::cone}, {Kind::sphere, Kind::cone}), (Pairs{{0, 1}}));
}

TEST(KindAccuracy, UsesADetectionOnlyOnce) {
  const Overlaps overlaps = countOverlaps(labels({{0, 10}, {1, 8}}), 2, labels({{0, 18}}), 1);
  EXPECT_EQ(sameKindMatches(overlaps, {Kind::plane, Kind::plane}, {Kind::plane}), (Pairs{{0, 0}}));
}

TEST(KindAccuracy, NeedsNoMinimumOverlap) {
  const Overlaps overlaps = countOverlaps(labels({{0, 10}}), 1, labels({{0, 1}, {-1, 9}}), 1);
  EXPECT_EQ(sameKindMatches(overlaps, {Kind::plane}, {Kind::plane}).size(), 1u);
}

TEST(KindAccuracy, GivesNothingToARegionThatNothingTouches) {
  const Overlaps overlaps = countOverlaps(labels({{0, 5}, {-1, 5}}), 1, labels({{-1, 5}, {0, 5}}), 1);
  EXPECT_TRUE(sameKindMatches(overlaps, {Kind::plane}, {Kind::plane}).empty());
}

}  // namespace
}  // namespace segcomp_test
