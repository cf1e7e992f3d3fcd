// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strip.h"

#include <gtest/gtest.h>

namespace primitect::strip_test {
namespace {

double trust(double length, double width, float runs_into) {
  Extent extent;
  extent.size = Vec3(length, width, 0.0);
  Evidence evidence;
  evidence.runs_into = runs_into;
  return trustInStrip(extent, evidence);
}

TEST(IsLine, OfAPlaneNoWiderThanTheNoise) {
  const NoiseModel noise = {0.001};
  Detection detection;
  detection.shape = Plane{Vec3(0, 0, 1), -Vec3::UnitZ()};
  detection.extent.size = Vec3(0.4, 0.0019, 0.0);
  EXPECT_TRUE(isLine(detection, noise));
  detection.extent.size = Vec3(0.4, 0.0021, 0.0);
  EXPECT_FALSE(isLine(detection, noise));
  detection.extent.size = Vec3(0.4, 0.0, 0.0);
  detection.shape = Sphere{Vec3(0, 0, 1), 0.1};
  EXPECT_FALSE(isLine(detection, noise));
}

TEST(TrustInStrip, IsGoneForALongOneThatRunsIntoOthersAlongItsSides) {
  EXPECT_EQ(trust(0.22, 0.015, 1.7f), 0.0);
  EXPECT_EQ(trust(0.015, 0.22, 1.7f), 0.0);
}

TEST(TrustInStrip, IsFullForOneThatEndsAtItsSides) { EXPECT_EQ(trust(0.22, 0.015, 0.4f), 1.0); }

TEST(TrustInStrip, IsFullForASlatOnATable) { EXPECT_EQ(trust(0.4, 0.04, 1.28f), 1.0); }

TEST(TrustInStrip, IsFullForWhatHasNoSize) { EXPECT_EQ(trust(0.0, 0.0, 1.7f), 1.0); }

TEST(TrustInStrip, IsFullForWhatIsNoStrip) { EXPECT_EQ(trust(0.2, 0.12, 1.7f), 1.0); }

TEST(TrustInStrip, GoesDownInBetween) {
  EXPECT_LT(trust(0.25, 0.1, 1.7f), 1.0);
  EXPECT_GT(trust(0.25, 0.1, 1.7f), trust(0.3, 0.1, 1.7f));
  EXPECT_GT(trust(0.3, 0.1, 1.35f), trust(0.3, 0.1, 1.45f));
  EXPECT_GT(trust(0.3, 0.1, 1.45f), 0.0);
}

}  // namespace
}  // namespace primitect::strip_test
