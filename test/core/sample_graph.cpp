// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which samples are next to each other.
#include "core/sample_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "test/support/exact_shapes.h"

namespace primitect::sample_graph_test {
namespace {

using test::SurfacePoint;

Samples samplesAt(const std::vector<Vec3>& points) {
  std::vector<SurfacePoint> surface;
  for (const Vec3& p : points) surface.push_back({p, Vec3::UnitZ()});
  return test::samplesOf(surface);
}

/// Columns of ten points, 1 cm apart either way, column by column along x; the gaps (m) come before columns.
Samples columnsWith(int columns, int column_after_gap, double gap) {
  std::vector<Vec3> points;
  for (int column = 0; column < columns; ++column) {
    const double x = 0.01 * column + (column >= column_after_gap ? gap : 0.0);
    for (int row = 0; row < 10; ++row) points.emplace_back(x, 0.01 * row, 1.0);
  }
  return samplesAt(points);
}

List<std::uint32_t> range(std::uint32_t first, std::uint32_t end) {
  List<std::uint32_t> indices(end - first);
  std::iota(indices.begin(), indices.end(), first);
  return indices;
}

List<std::uint32_t> partOf(const Samples& samples, const List<std::uint32_t>& set, std::uint32_t start) {
  SampleGraph graph;
  graph.build(samples);
  List<std::uint32_t> part;
  graph.connected(
      start, [&set](std::uint32_t i) { return std::binary_search(set.begin(), set.end(), i); }, part);
  return part;
}

TEST(SampleGraph, HoldsTheNearestOfAllOthers) {
  Random random(12);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) points.push_back(test::randomPoint(random));
  const Samples samples = samplesAt(points);
  SampleGraph graph;
  graph.build(samples);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const auto distance = [&](std::uint32_t j) { return (samples.point(j) - samples.point(i)).norm(); };
    List<double> distances;
    for (std::uint32_t j = 0; j < samples.size(); ++j) {
      if (j != i) distances.push_back(distance(j));
    }
    std::sort(distances.begin(), distances.end());
    for (std::size_t k = 0; k < SampleGraph::kNeighbors; ++k) {
      EXPECT_NEAR(distance(graph.of(i)[k]), distances[k], 5e-4 * distances[k]) << i;
      EXPECT_EQ(std::count(graph.of(i).begin(), graph.of(i).end(), graph.of(i)[k]), 1) << i;
    }
    EXPECT_EQ(std::count(graph.of(i).begin(), graph.of(i).end(), i), 0) << i;
  }
}

/// Rows of points along x, each on its own height.
std::vector<Vec3> rowsOf(int rows, int first_row) {
  std::vector<Vec3> points;
  Random random(13);
  for (int row = first_row; row < first_row + rows; ++row) {
    for (int k = 0; k < 37; ++k) points.emplace_back(0.01 * k + 0.004 * random.uniform(), 0.01 * row, 1.0);
  }
  return points;
}

TEST(SampleGraph, IsTheSameWhetherSamplesComeAtOnceOrInRounds) {
  std::vector<Vec3> points = rowsOf(10, 0);
  SampleGraph in_rounds, at_once;
  for (const int first_row : {5, 2, 12}) {
    in_rounds.build(samplesAt(points));
    const std::vector<Vec3> more = rowsOf(10, first_row);
    points.insert(points.end(), more.begin(), more.end());
  }
  in_rounds.build(samplesAt(points));
  at_once.build(samplesAt(points));
  for (std::uint32_t i = 0; i < points.size(); ++i) ASSERT_EQ(in_rounds.of(i), at_once.of(i)) << i;
}

TEST(SampleGraph, OfMoreSamplesThanItHadRoomForIsTheSameAsAtOnce) {
  std::vector<Vec3> points = rowsOf(200, 0);
  SampleGraph in_rounds, at_once;
  in_rounds.build(samplesAt(points));
  const std::vector<Vec3> more = rowsOf(50, 200);
  points.insert(points.end(), more.begin(), more.end());
  in_rounds.build(samplesAt(points));
  at_once.build(samplesAt(points));
  const auto last = static_cast<std::uint32_t>(points.size() - 1);
  ASSERT_GT(last, 8192u);
  for (std::uint32_t i = 0; i <= last; ++i) {
    ASSERT_EQ(in_rounds.of(i), at_once.of(i)) << i;
    EXPECT_LT((samplesAt({points[i]}).point(0) - points[at_once.of(i)[0]]).norm(), 0.0145) << i;
  }
}

TEST(SampleGraph, PutsTheNearestFirstAndTheEarlierOfTwoAsNear) {
  // In steps of powers of two, so that distances are exactly the same on both sides.
  std::vector<Vec3> points;
  for (int k = 0; k < 20; ++k) points.emplace_back(0.125 * k, 0.0, 1.0);
  SampleGraph graph;
  graph.build(samplesAt(points));
  EXPECT_EQ(graph.of(10), (SampleGraph::Neighbors{9, 11, 8, 12, 7, 13, 6, 14}));
  EXPECT_EQ(graph.of(0), (SampleGraph::Neighbors{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(SampleGraph, HoldsOthersWhereManySamplesAreInOnePlace) {
  SampleGraph graph;
  graph.build(samplesAt(std::vector<Vec3>(50, Vec3(0.1, 0.2, 1.0))));
  for (std::uint32_t i = 0; i < 50; ++i) EXPECT_EQ(std::count(graph.of(i).begin(), graph.of(i).end(), i), 0) << i;
}

TEST(SampleGraph, NamesTheSampleItselfWhereThereAreNoOthers) {
  SampleGraph graph;
  graph.build(samplesAt({Vec3(0, 0, 1), Vec3(0.1, 0, 1), Vec3(0.2, 0, 1)}));
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(std::count(graph.of(i).begin(), graph.of(i).end(), i), SampleGraph::kNeighbors - 2) << i;
  }
}

TEST(SampleGraph, IsBuiltAnewForOtherSamples) {
  SampleGraph graph;
  graph.build(columnsWith(20, 20, 0.0));
  graph.build(samplesAt({Vec3(0, 0, 1), Vec3(0.1, 0, 1)}));
  for (const std::uint32_t j : graph.of(0)) EXPECT_LT(j, 2u);
  graph.build(samplesAt({}));
  List<std::uint32_t> part = {7};
  graph.build(samplesAt({Vec3(0, 0, 1)}));
  graph.connected(
      0, [](std::uint32_t i) { return i == 0; }, part);
  EXPECT_EQ(part, range(0, 1));
}

TEST(Connected, ReachesEverythingOfOnePatch) {
  EXPECT_EQ(partOf(columnsWith(20, 20, 0.0), range(0, 200), 105), range(0, 200));
}

TEST(Connected, StopsAtAGapInSpace) {
  const Samples samples = columnsWith(20, 12, 0.1);
  EXPECT_EQ(partOf(samples, range(0, 200), 5), range(0, 120));
  EXPECT_EQ(partOf(samples, range(0, 200), 150), range(120, 200));
}

TEST(Connected, StopsWhereSamplesAreNotInTheSet) {
  // Eight neighbours reach two columns at most: four columns that are missing are a gap.
  List<std::uint32_t> set = range(0, 80);
  const List<std::uint32_t> right = range(120, 200);
  set.insert(set.end(), right.begin(), right.end());
  EXPECT_EQ(partOf(columnsWith(20, 20, 0.0), set, 3), range(0, 80));
  EXPECT_EQ(partOf(columnsWith(20, 20, 0.0), set, 199), right);
}

TEST(Connected, BeginsAtNeighborsOfAStartOutsideOfTheSet) {
  const Samples samples = columnsWith(20, 12, 0.1);
  List<std::uint32_t> set = range(0, 200);
  set.erase(set.begin() + 55);
  List<std::uint32_t> left = range(0, 120);
  left.erase(left.begin() + 55);
  EXPECT_EQ(partOf(samples, set, 55), left);
  EXPECT_TRUE(partOf(samples, range(120, 200), 55).empty());
}

/// Two patches whose samples take turns, and a third one of eight samples: large and small parts, each in rising order.
TEST(Parts, HoldTheirSamplesInRisingOrder) {
  std::vector<Vec3> points;
  List<List<std::uint32_t>> expected(3);
  Random random(41);
  for (int k = 0; k < 300; ++k) {
    const bool right = random.uniform(0.0, 1.0) < 0.5;
    expected[right ? 1 : 0].push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(Vec3{(right ? 1.0 : 0.0) + random.uniform(0.0, 0.1), random.uniform(0.0, 0.1), 1.0});
    if (k % 34 != 33) continue;
    expected[2].push_back(static_cast<std::uint32_t>(points.size()));
    points.emplace_back(random.uniform(0.0, 0.02), 2.0, 1.0);
  }
  ASSERT_NE(points.size() % 8, 0u);
  SampleGraph graph;
  graph.build(samplesAt(points));
  const auto parts = graph.parts(range(0, static_cast<std::uint32_t>(points.size())), 1);
  ASSERT_GE(parts.size(), 2u);
  List<std::uint32_t> all;
  for (const List<std::uint32_t>& part : parts) {
    EXPECT_TRUE(std::is_sorted(part.begin(), part.end()));
    all.insert(all.end(), part.begin(), part.end());
  }
  for (const List<std::uint32_t>& part : expected) EXPECT_NE(std::find(parts.begin(), parts.end(), part), parts.end());
  EXPECT_EQ(all.size(), points.size());
  const auto together = graph.largeParts(range(0, static_cast<std::uint32_t>(points.size())), 50);
  EXPECT_TRUE(std::is_sorted(together.begin(), together.end()));
}

TEST(LargeParts, LeaveOutWhatIsTooSmallTogether) {
  // Seven columns, a gap, two columns: seventy samples and twenty.
  const Samples samples = columnsWith(9, 7, 0.1);
  SampleGraph graph;
  graph.build(samples);
  EXPECT_EQ(graph.largeParts(range(0, 90), 21), range(0, 70));
  EXPECT_EQ(graph.largeParts(range(0, 90), 20), range(0, 90));
  EXPECT_TRUE(graph.largeParts({}, 1).empty());
}

}  // namespace
}  // namespace primitect::sample_graph_test
