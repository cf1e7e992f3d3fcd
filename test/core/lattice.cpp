// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lattices are found in numbers that lie on one, and in no others.
#include "core/lattice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace primitect::lattice_test {
namespace {

constexpr double kSpacing = 0.00175, kOffset = -0.4321;

/// Places from 0 on, each off by a standard deviation of so many spacings, in random order.
List<double> onLattice(int count, int places, double off) {
  Random random(3);
  List<double> values;
  for (int k = 0; k < count; ++k) {
    const auto place = static_cast<double>(random.below(static_cast<std::uint64_t>(places)));
    values.push_back(kOffset + kSpacing * (place + off * random.gaussian()));
  }
  return values;
}

TEST(Lattice, IsFoundFromSomeOfItsPlaces) {
  for (const int places : {40, 640, 2000}) {
    for (const double off : {0.0, 1e-4, 0.01}) {
      const auto found = findLattice(onLattice(1024, places, off));
      ASSERT_TRUE(found) << places << " places, " << off;
      // At the last place it is off by no more than a twentieth.
      EXPECT_NEAR(found->spacing, kSpacing, 0.05 * kSpacing / places) << off;
      const double place = found->place(kOffset);
      EXPECT_NEAR(place, std::round(place), 0.05) << places << " places, " << off;
    }
  }
}

TEST(Lattice, IsFoundAmongAFewStrays) {
  List<double> values = onLattice(1000, 300, 0.0);
  Random random(4);
  for (int k = 0; k < 20; ++k) values.push_back(kOffset + 300.0 * kSpacing * random.uniform());
  const auto found = findLattice(values);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->spacing, kSpacing, 1e-4 * kSpacing);
}

TEST(Lattice, IsNoneInNumbersOfChance) {
  Random random(5);
  for (int time = 0; time < 20; ++time) {
    List<double> uniform, gaussian;
    for (int k = 0; k < 1024; ++k) uniform.push_back(random.uniform()), gaussian.push_back(random.gaussian());
    EXPECT_FALSE(findLattice(uniform));
    EXPECT_FALSE(findLattice(gaussian));
  }
  EXPECT_FALSE(findLattice(onLattice(1024, 640, 0.3)));
}

TEST(Lattice, IsNoneOfFewOrEqualNumbers) {
  EXPECT_FALSE(findLattice({}));
  EXPECT_FALSE(findLattice({1.0}));
  EXPECT_FALSE(findLattice(List<double>(1000, 0.5)));
  EXPECT_FALSE(findLattice(onLattice(1000, 5, 0.0))) << "five places are too few to tell";
}

}  // namespace
}  // namespace primitect::lattice_test
