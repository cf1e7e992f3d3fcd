// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows that are far apart, as a laser scanner's, of a table: the planes of the scan are no surfaces.
#include <gtest/gtest.h>

#include <cmath>

#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::scan_rows_test {
namespace {

/// All rows but every so-many-th are missing.
Cloud everyRow(std::uint32_t step, std::uint64_t seed) {
  Cloud cloud = test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, synthetic::clutterPose(seed));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i / cloud.width % step != step / 2) cloud.x[i] = cloud.y[i] = cloud.z[i] = NAN;
  }
  cloud.countPoints();
  return cloud;
}

/// Planes that a sensor at the origin would see as a line.
int planesOfScan(const Detections& detections) {
  int count = 0;
  for (const Detection& item : detections.items) {
    if (kindOf(item.shape) != Kind::plane) continue;
    const Plane& plane = std::get<Plane>(item.shape);
    count += std::abs(plane.normal.dot(item.extent.origin)) < 0.02 * item.extent.origin.norm() ? 1 : 0;
  }
  return count;
}

TEST(ScanRows, AreNoPlanesThroughTheSensor) {
  Detector detector{Params()};
  for (const std::uint32_t step : {16u, 20u, 24u}) {
    for (const std::uint64_t seed : {1, 5, 6}) {
      const Detections& found = detector.detect(everyRow(step, seed));
      EXPECT_EQ(planesOfScan(found), 0) << "every " << step << "th row, table " << seed;
    }
  }
}

TEST(ScanRows, ShowTheTableWhereMoreNeighboursReachTheNextOnes) {
  Detector detector{Params()};
  for (const std::uint64_t seed : {1, 5, 6}) {
    const Cloud rows = everyRow(20, seed);
    const auto& largest = detector.detect(everyRow(1, seed)).items;
    const Plane table = std::get<Plane>(largest.front().shape);
    bool found = false;
    for (const Detection& item : detector.detect(rows).items) {
      const Plane* plane = std::get_if<Plane>(&item.shape);
      found = found || (plane && plane->normal.dot(table.normal) > std::cos(2.0 * test::kDegree) &&
                        std::abs((plane->point - table.point).dot(table.normal)) < 0.01);
    }
    EXPECT_TRUE(found) << seed;
  }
}

TEST(ScanRows, OneOfThemShowsNothing) {
  const Cloud table = everyRow(1, 1);
  Cloud row;
  row.reset(table.width, 1, false);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t of = 300u * table.width + i;
    if (table.valid(of)) row.setPoint(i, table.x[of], table.y[of], table.z[of], {});
  }
  Detector detector{Params()};
  EXPECT_GT(row.valid_count, 300u);
  EXPECT_TRUE(detector.detect(row).items.empty());
  EXPECT_TRUE(detector.detect(everyRow(480, 1)).items.empty()) << "in an image";
}

}  // namespace
}  // namespace primitect::scan_rows_test
