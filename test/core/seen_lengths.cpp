// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes, against those of the part that a depth camera sees.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "test/support/table_frame.h"

namespace primitect {
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

TEST(SeenLengths, GoNearlyToTheEndsOfCylindersAndCones) {
  std::map<Kind, std::vector<double>> shares;
  for (std::uint64_t seed = 2500; seed < 2548; ++seed) {
    const test::TableFrame table(seed);
    for (const Detection& truth : table.frame.truth.items) {
      const Kind kind = kindOf(truth.shape);
      if (kind != Kind::cylinder && kind != Kind::cone) continue;
      const Detection* const item = foundAs(truth, table.found);
      if (item) shares[kind].push_back(item->extent.size.z() / truth.extent.size.z());
    }
  }
  for (auto& [kind, of_kind] : shares) {
    SCOPED_TRACE(kindName(kind));
    ASSERT_GE(of_kind.size(), 40u);
    std::sort(of_kind.begin(), of_kind.end());
    // Against those of the pixels' middles: ends lie up to a pixel farther, 2 % of the length in the mean.
    EXPECT_GT(of_kind[of_kind.size() / 2], 1.0) << "without the outer 1 % of the points";
    EXPECT_GT(of_kind.front(), 0.8);
    EXPECT_LT(of_kind[of_kind.size() * 95 / 100], 1.13);
    // One in a hundred, in 120 tables, takes points of what stands behind it.
    EXPECT_LT(of_kind.back(), 1.4);
  }
}

}  // namespace
}  // namespace primitect
