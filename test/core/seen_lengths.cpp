// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes, against those of the part that a depth camera sees, and in lists of points.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "core/extent.h"
#include "primitect/detector.h"
#include "test/support/noisy_points.h"
#include "test/support/scenes.h"
#include "test/support/table_frame.h"

namespace primitect::seen_lengths_test {
namespace {

/// Of this kind and in about this place; null: none.
const Detection* foundAs(const Detection& truth, const Detections& found) {
  constexpr double kNear = 0.03;  // m
  for (const Detection& item : found.items) {
    const bool same = kindOf(item.shape) == kindOf(truth.shape) && item.concave == truth.concave;
    if (same && (item.extent.origin - truth.extent.origin).norm() < kNear) return &item;
  }
  return nullptr;
}

/// Of a cylinder or a cone (m).
struct Lengths {
  Kind kind;
  double true_one, found;
};

/// Of those that are found on tables of these seeds, seen with so many times the usual noise.
std::vector<Lengths> lengthsOnTables(std::uint64_t first, std::uint64_t end, double noise_scale) {
  std::vector<Lengths> lengths;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const test::TableFrame table(seed, noise_scale);
    for (const Detection& truth : table.frame.truth.items) {
      const Kind kind = kindOf(truth.shape);
      if (!hasAxis(kind)) continue;
      const Detection* const item = foundAs(truth, table.found);
      if (item) lengths.push_back({kind, truth.extent.size.z(), item->extent.size.z()});
    }
  }
  return lengths;
}

TEST(SeenLengths, GoNearlyToTheEndsOfCylindersAndCones) {
  std::map<Kind, std::vector<double>> shares;
  for (const Lengths& one : lengthsOnTables(2500, 2548, 1.0)) shares[one.kind].push_back(one.found / one.true_one);
  for (auto& [kind, of_kind] : shares) {
    SCOPED_TRACE(kindName(kind));
    ASSERT_GE(of_kind.size(), 40u);
    std::sort(of_kind.begin(), of_kind.end());
    // Against those of the pixels' middles: ends lie up to a pixel farther, 2 % of the length in the mean.
    EXPECT_GT(of_kind[of_kind.size() / 2], 1.0) << "without the outer 1 % of the points";
    EXPECT_GT(of_kind.front(), 0.8);
    EXPECT_LT(of_kind[of_kind.size() * 95 / 100], 1.13);
    // One in a hundred, in 120 tables, takes points of what stands behind it.
    EXPECT_LT(of_kind[of_kind.size() - 2], 1.4);
    EXPECT_LT(of_kind.back(), 1.6);
  }
}

/// By how much (m) axes are too long in the median, on tables seen with so many times the usual noise.
double medianTooLong(double noise_scale) {
  std::vector<double> too_long;
  for (const Lengths& one : lengthsOnTables(2600, 2624, noise_scale)) too_long.push_back(one.found - one.true_one);
  std::nth_element(too_long.begin(), too_long.begin() + too_long.size() / 2, too_long.end());
  return too_long[too_long.size() / 2];
}

TEST(SeenLengths, DoNotGrowMuchWithTheNoise) {
  // Where faces do not tell where axes end, 2.6 and 9.1 mm.
  EXPECT_NEAR(medianTooLong(1.0), 0.0, 0.0015);
  EXPECT_NEAR(medianTooLong(3.0), 0.0, 0.0055);
}

/// Lengths (m) of the cylinders and cones in a list without normals, as several cameras together see things: what is
/// behind each of them, too, so that no place could have seen it all.
std::map<Kind, double> lengthsIn(const std::vector<test::SurfacePoint>& points, double noise, Random& random) {
  Params params;
  params.use_cloud_normals = false;
  Detector detector{params};
  const Detections& found = detector.detect(test::cloudOf(test::measured(points, noise, 0.0, random)));
  EXPECT_FALSE(found.seen_from_origin) << "or it is taken for an image";
  std::map<Kind, double> lengths;
  for (const Detection& item : found.items) {
    const Kind kind = kindOf(item.shape);
    if (hasAxis(kind)) lengths[kind] = item.extent.size.z();
  }
  return lengths;
}

const Vec3 kUp = test::kTable.normal, kRight = Vec3::UnitX();

TEST(SeenLengths, InListsGoToTheTableAndNoFarther) {
  for (const double noise : {0.0005, 0.002, 0.004}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(testing::Message() << noise << " m, seed " << seed);
      Random random(seed);
      const Cylinder can = {test::kTable.point - 0.2 * kRight, kUp, 0.05};
      const Cone hat = {test::kTable.point + 0.2 * kRight + 0.16 * kUp, -kUp, 0.35};
      const auto table = test::patchOf(test::kTable, 80000, 0.4, random);
      const auto side = test::patchOf(can, 5000, 0.0, 0.2, random);
      const auto lengths =
          lengthsIn(test::together({table, side, test::patchOf(hat, 3000, 0.0, 0.16, random)}), noise, random);
      ASSERT_EQ(lengths.size(), 2u);
      // Where samples end, 8 to 12 and 20 to 30 mm are missing; what the table gives them reaches 3 deviations farther.
      EXPECT_NEAR(lengths.at(Kind::cylinder), 0.2, 0.002 + noise);
      // Of 60 with 4 mm two are 8 and 10 mm short.
      EXPECT_GT(lengths.at(Kind::cone), 0.157 - 2.0 * noise) << "tips of cones are cut";
      EXPECT_LT(lengths.at(Kind::cone), 0.161 + 0.75 * noise);
    }
  }
}

TEST(SeenLengths, InListsDoNotGoOnWhereACanTouchesTheTable) {
  constexpr double kNoise = 0.002, kRadius = 0.05;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const Cylinder can = {test::kTable.point + kRadius * kUp, kRight, kRadius};
    const auto table = test::patchOf(test::kTable, 80000, 0.4, random);
    const auto lengths =
        lengthsIn(test::together({table, test::patchOf(can, 4000, -0.1, 0.1, random)}), kNoise, random);
    ASSERT_EQ(lengths.count(Kind::cylinder), 1u) << seed;
    EXPECT_NEAR(lengths.at(Kind::cylinder), 0.2, 0.01) << seed;
  }
}

}  // namespace
}  // namespace primitect::seen_lengths_test
