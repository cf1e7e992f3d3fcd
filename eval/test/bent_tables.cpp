// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables in front of a camera that bends what it sees, which two planes through each other explain better than one.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "eval/data_sets.h"
#include "primitect/detector.h"

namespace bent_tables_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

/// Of planes with more points than anything but the table has.
std::vector<double> tablesIn(const Cloud& cloud, const Params& params) {
  constexpr std::size_t kPoints = 60000;
  std::vector<double> points;
  Detector detector(params);
  for (const Detection& detection : detector.detect(cloud).items) {
    if (kindOf(detection.shape) != Kind::plane || detection.inlier_count < kPoints) continue;
    points.push_back(static_cast<double>(detection.inlier_count));
  }
  return points;
}

TEST(BentTables, AreOnePlane) {
  Recipe recipe;
  recipe.sensor = "bent_structured_light";
  Params without;
  without.left_out.add(Step::joined_planes);
  const std::pair<const char*, std::uint64_t> clouds[] = {{"tabletop", 245}, {"household", 219}};
  for (const auto& [set, seed] : clouds) {
    recipe.set = set;
    recipe.seed = seed;
    const Cloud cloud = makeLabelledCloud(recipe).cloud;
    const std::vector<double> halves = tablesIn(cloud, without), table = tablesIn(cloud, Params());
    ASSERT_EQ(halves.size(), 2u) << set << " " << seed << " shows nothing any more";
    ASSERT_EQ(table.size(), 1u) << set << " " << seed;
    EXPECT_GT(table[0], 0.95 * (halves[0] + halves[1])) << set << " " << seed;
  }
}

}  // namespace
}  // namespace bent_tables_test
