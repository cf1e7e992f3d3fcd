// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The polynomials of each kernel against libm, over the whole range, with the errors that their comments state.
#include <gtest/gtest.h>

#include <string>

#include "kernels/kernels.h"
#include "test/kernels/approximation_errors.h"

namespace primitect::kernels::approximations_test {
namespace {

bool canRun(const std::string& name) {
  const Available available = availableKernels();
  for (int k = 0; k < available.count; ++k) {
    if (available.kernels[k]->name == name) return true;
  }
  return false;
}

void expectWithinBounds(const test::ApproximationErrors& worst) {
  EXPECT_LT(worst.small_arc_sine, 7e-7);
  EXPECT_LT(worst.small_sine, 3e-7);
  EXPECT_LT(worst.angle_in_plane, 2.5e-6);
  EXPECT_LT(worst.angle_in_half_plane, 2.5e-6);
  EXPECT_TRUE(worst.zero_without_direction);
}

TEST(Approximations, OfThePortableKernelAreWithinTheirBounds) { expectWithinBounds(test::errorsOfPortable()); }

#if defined(__x86_64__)
TEST(Approximations, OfAvx2AreWithinTheirBounds) {
  if (!canRun("avx2")) GTEST_SKIP() << "this processor cannot run it";
  expectWithinBounds(test::errorsOfAvx2());
}

TEST(Approximations, OfAvx512AreWithinTheirBounds) {
  if (!canRun("avx512")) GTEST_SKIP() << "this processor cannot run it";
  expectWithinBounds(test::errorsOfAvx512());
}
#endif

}  // namespace
}  // namespace primitect::kernels::approximations_test
