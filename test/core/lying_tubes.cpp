// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Thin tubes that lie on a table, of which the image shows some thirty rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"

namespace primitect::lying_tubes_test {
namespace {

/// Noise without steps, and without pixels that are lost where a tube turns away.
synthetic::FrameParams simpleNoise() {
  synthetic::FrameParams params;
  params.noise.disparity_step = 0.0;
  params.noise.max_incidence_deg = 90.0;
  return params;
}

/// A tube of 25 cm across the image on a table 1 m in front of a camera that looks down by 50 deg.
Cloud tubeOnTable(double radius, double along_table, std::uint64_t seed,
                  const synthetic::FrameParams& params = simpleNoise()) {
  const Eigen::Isometry3d table = test::tableBeforeCamera(1.0, 50.0 * M_PI / 180.0);
  const Eigen::Isometry3d tube =
      table * Eigen::Translation3d(0.0, along_table, radius) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY());
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  world.add("tube", synthetic::Rod{radius, 0.125}, tube);
  return test::renderedCloud(world, params, seed);
}

/// Strips of the flanks, planes of too few points, took the points there by their noise before they were dropped:
/// errors were 0.8 mm (median) and up to 2.3, said to be good to 0.2 to 1.5 mm.
TEST(LyingTubes, HaveTheirRadii) {
  constexpr int kTimes = 20;
  std::vector<double> errors, deviations;
  std::uint64_t seed = 0;
  for (int k = 0; k < 12 * kTimes; ++k) {
    const double radius = 0.02 + 0.005 * (k / 4 % 3), along = -0.06 + 0.04 * (k % 4);
    Detector detector{Params()};
    for (const Detection& item : detector.detect(tubeOnTable(radius, along, ++seed)).items) {
      const Cylinder* const found = std::get_if<Cylinder>(&item.shape);
      if (!found) continue;
      errors.push_back(std::abs(found->radius - radius));
      EXPECT_LT(errors.back(), 4.0 * item.radius_stddev) << radius << " " << along;
      deviations.push_back(item.radius_stddev);
    }
  }
  ASSERT_GE(errors.size(), 235u);
  std::sort(errors.begin(), errors.end());
  std::sort(deviations.begin(), deviations.end());
  EXPECT_LT(errors[errors.size() / 2], 0.0003);
  // Others have few points and say so: 7 of 240 have a deviation above 1 mm.
  EXPECT_LT(errors[errors.size() * 95 / 100], 0.0012);
  EXPECT_LT(deviations[deviations.size() * 95 / 100], 0.001);
}

/// Normals of their samples are fitted to windows as wide as they are: of eight there were three planes of 90 to 99 %.
TEST(LyingTubes, AreNoPlanesWhereTheyAreThin) {
  constexpr double kRadius = 0.015;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Detector detector{Params()};
    for (const Detection& item : detector.detect(tubeOnTable(kRadius, 0.015 * static_cast<double>(seed), seed)).items) {
      if (const Cylinder* const found = std::get_if<Cylinder>(&item.shape)) {
        EXPECT_NEAR(found->radius, kRadius, 0.004) << seed;
      } else {
        EXPECT_GT(item.extent.size.y(), 0.3) << seed;  // the table
      }
    }
  }
}

/// With all of the camera's noise; prints what README.md says of pipes.
TEST(LyingTubes, AreFoundFromTwentyMillimetersOn) {
  constexpr int kFrames = 32;
  int strips = 0;
  for (const double radius : {0.014, 0.016, 0.018, 0.02}) {
    int tubes = 0, strips_of_radius = 0;
    for (int k = 1; k <= kFrames; ++k) {
      Detector detector{Params()};
      bool found = false;
      const Cloud cloud = tubeOnTable(radius, 0.0075 * k - 0.12, static_cast<std::uint64_t>(k), {});
      for (const Detection& item : detector.detect(cloud).items) {
        found = found || kindOf(item.shape) == Kind::cylinder;
        if (kindOf(item.shape) == Kind::plane && item.extent.size.y() < 0.3) ++strips_of_radius;
      }
      tubes += found ? 1 : 0;
    }
    std::cout << "radius " << 1000.0 * radius << " mm: a tube in " << tubes << " of " << kFrames << " frames, "
              << strips_of_radius << " strips as planes\n";
    if (radius == 0.02) {
      // At the bound that no thinner one is looked at beyond: 30 to 32 with windows that find as much elsewhere.
      EXPECT_GE(tubes, kFrames - 2);
    }
    strips += strips_of_radius;
  }
  EXPECT_LE(strips, kFrames);  // of four times as many frames
}

}  // namespace
}  // namespace primitect::lying_tubes_test
