// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest places of a cloud.
#include "core/neighbors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "test/support/exact_shapes.h"

namespace primitect::neighbors_test {
namespace {

using test::listOf;
using Points = std::vector<Vec3>;

/// In the order of their numbers.
List<std::uint32_t> nearest(const Cloud& cloud, std::uint32_t point, int count) {
  NeighborSearch search(cloud);
  List<std::uint32_t> found;
  search.nearest(cloud, point, count, found);
  std::sort(found.begin(), found.end());
  return found;
}

using Numbers = List<std::uint32_t>;

TEST(Neighbors, AreTheNearestPlacesHoweverManyPointsLieInOne) {
  const Vec3 here(0.5, 0.0, 1.0), beside(0.51, 0.0, 1.0), below(0.5, 0.02, 1.0), far(0.6, 0.0, 1.0);
  const Cloud cloud = listOf(Points{far, here, here, beside, here, here, beside, below, here, far});
  EXPECT_EQ(nearest(cloud, 1, 3), (Numbers{1, 3, 7}));
  EXPECT_EQ(nearest(cloud, 8, 3), (Numbers{1, 3, 7})) << "of a point that is not the first of its place";
  EXPECT_EQ(nearest(cloud, 1, 99), (Numbers{0, 1, 3, 7}));
}

TEST(Neighbors, OfZeroAndMinusZeroAreOne) {
  EXPECT_EQ(nearest(listOf(Points{Vec3(0.0, -0.0, 1.0), Vec3(-0.0, 0.0, 1.0), Vec3(0.0, 0.0, 2.0)}), 1, 9),
            (Numbers{0, 2}));
}

TEST(Neighbors, LeaveMissingPointsOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(nearest(listOf(Points{Vec3(0, 0, kNan), Vec3(0, 0, 1), Vec3(kNan, 0, 1), Vec3(0, 0, 1.1)}), 1, 9),
            (Numbers{1, 3}));
}

TEST(Neighbors, OfDifferentPointsAreAllOfThem) {
  Points points;
  // Coordinates in steps, many of them alike: their bits differ in few places.
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) points.emplace_back(0.125 * i, 0.25 * j, 1.0 + 0.001 * i * j);
  }
  Numbers all;
  for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back(i);
  EXPECT_EQ(nearest(listOf(points), 7, 1000), all);
}

}  // namespace
}  // namespace primitect::neighbors_test
