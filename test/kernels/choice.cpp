// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which kernels run, and who decides.
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "kernels/kernels.h"
#include "primitect/detector.h"
#include "primitect/kernel_choice.h"

namespace primitect::choice_test {
namespace {

TEST(Kernels, ScalarAndPortableRunEverywhere) {
  EXPECT_STREQ(kernels::kernelsNamed("scalar").name, "scalar");
  EXPECT_STREQ(kernels::kernelsNamed("portable").name, "portable");
}

TEST(Kernels, WithoutANameAreTheFastest) {
  EXPECT_EQ(kernels::kernelsNamed(nullptr).name, kernelNames().back());
  EXPECT_EQ(kernels::kernelsNamed("").name, kernelNames().back());
}

TEST(Kernels, OfAnotherNameAreRefusedWithTheOnesThatThereAre) {
  try {
    kernels::kernelsNamed("fast");
    FAIL();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    for (const std::string& part : {std::string("PRIMITECT_KERNELS"), std::string("'fast'")}) {
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
    for (const std::string& name : kernelNames()) EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

/// First the refusal, then the choice: what was chosen once stays for the whole process.
TEST(Environment, DecidesWhichKernelsADetectorUses) {
  setenv("PRIMITECT_KERNELS", "fast", 1);
  EXPECT_THROW(Detector{Params()}, std::invalid_argument);
  setenv("PRIMITECT_KERNELS", "scalar", 1);
  EXPECT_NO_THROW(Detector{Params()});
  EXPECT_EQ(kernelInUse(), "scalar");
  unsetenv("PRIMITECT_KERNELS");
  EXPECT_EQ(kernelInUse(), "scalar");
}

}  // namespace
}  // namespace primitect::choice_test
