// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Simulated tables: planes that once came out tilted, and what is too small to be one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::cluttered_tables_test {
namespace {

using test::kDegree;

Cloud tableCloud(std::uint64_t seed) {
  return test::renderedCloud(synthetic::clutteredTable(seed), {}, seed, synthetic::clutterPose(seed));
}

/// The same points without their image, every seventh one first.
Cloud withoutOrder(const Cloud& image) {
  Cloud points;
  points.reset(static_cast<std::uint32_t>(image.size()), 1, false);
  std::size_t next = 0;
  for (std::size_t first = 0; first < 7; ++first) {
    for (std::size_t i = first; i < image.size(); i += 7, ++next) {
      if (image.valid(i)) points.setPoint(next, image.x[i], image.y[i], image.z[i], {});
    }
  }
  return points;
}

/// From this column and row on.
Cloud partOf(const Cloud& image, std::uint32_t left, std::uint32_t top, std::uint32_t width, std::uint32_t height) {
  Cloud part;
  part.reset(width, height, false);
  for (std::uint32_t i = 0; i < width * height; ++i) {
    const std::size_t from = std::size_t{top + i / width} * image.width + left + i % width;
    part.setPoint(i, image.x[from], image.y[from], image.z[from], {});
  }
  return part;
}

/// The middle of the image alone.
Cloud middleOf(const Cloud& image, std::uint32_t width) {
  return partOf(image, (image.width - width) / 2, (image.height - width) / 2, width, width);
}

/// How far (rad) the plane found within 3 mm of this place, and most parallel to the true one, is tilted.
double tiltAt(const Plane& truth, const Cloud& cloud, int seed = 1) {
  constexpr double kNear = 0.003;
  Params params;
  params.seed = seed;
  Detector detector{params};
  double least = M_PI;
  for (const Detection& found : detector.detect(cloud).items) {
    const Plane* plane = std::get_if<Plane>(&found.shape);
    if (!plane || distance(*plane, truth.point) > kNear) continue;
    const Eigen::Vector3d around = found.extent.origin - truth.point;
    if (around.norm() > 0.2) continue;
    least = std::min(least, test::lineAngle(plane->normal, truth.normal));
  }
  return least;
}

TEST(ClutteredTable, TiltsNoTopTowardsCrumbsOfAnotherThatAreNoPlane) {
  // 33 cm beside it, and 7 mm lower, lies the narrow top of another box.
  const Plane top = {Vec3(-0.1665, -0.0550, 1.0234), Vec3(-0.0397, -0.5976, -0.8008).normalized()};
  EXPECT_LT(tiltAt(top, tableCloud(2485)), 0.5 * kDegree);  // was 1.05
}

TEST(ClutteredTable, HasNoFaceOnARingThatTouchesThePlaneOfATop) {
  constexpr std::uint64_t kSeed = 2608;
  constexpr std::uint32_t kOfTable = 20000;  // points
  const synthetic::World world = synthetic::clutteredTable(kSeed);
  Detector detector{Params()};
  const Detections& found = detector.detect(tableCloud(kSeed));
  int rings = 0;
  for (const synthetic::Body& body : world.bodies()) {
    const synthetic::Torus* ring = std::get_if<synthetic::Torus>(&body.solid);
    if (!ring) continue;
    ++rings;
    const Vec3 middle = synthetic::clutterPose(kSeed).inverse() * body.world_from_body.translation();
    for (const Detection& item : found.items) {
      if (kindOf(item.shape) != Kind::plane || item.inlier_count > kOfTable) continue;
      EXPECT_GT((item.extent.origin - middle).norm(), ring->ring_radius) << item.confidence;  // was one of .96
    }
  }
  EXPECT_EQ(rings, 1);
}

TEST(ClutteredTable, TiltsNoTopTowardsAnotherWithTooFewSamples) {
  // 50 cm away, and 7 mm lower, lies a top of 468 pixels.
  const Plane top = {Vec3(0.2506, 0.1158, 0.9679), Vec3(0.0181, -0.6880, -0.7255).normalized()};
  EXPECT_LT(tiltAt(top, tableCloud(2624)), 0.6 * kDegree);  // was 1.46, and more than 3 mm away
}

TEST(ClutteredTable, TakesNoBiasOutOfAFaceTooNarrowForClearPoints) {
  // The front of a box of 28 mm, seen at a steep angle.
  const Plane front = {Vec3(-0.0461, 0.2933, 0.8843), Vec3(0.1104, 0.6753, -0.7292).normalized()};
  const Cloud cloud = withoutOrder(tableCloud(2515));
  int found = 0;
  for (int seed = 1; seed <= 12; ++seed) {  // so few points that not every draw finds it
    const double tilt = tiltAt(front, cloud, seed);
    if (tilt > 10.0 * kDegree) continue;
    ++found;
    EXPECT_LT(tilt, 3.0 * kDegree) << seed;  // was 3.7; of twelve draws 1.6 to 2.5
  }
  EXPECT_GE(found, 3);
}

TEST(PartOfAClutteredTable, IsNotTakenApartIntoSlivers) {
  // Each of 19 samples, three quarters of min_inliers, needs 24 pixels to itself; of curved shapes 16.
  constexpr std::uint32_t kPlane = 19 * 24, kCurved = 19 * 16;
  int found = 0;
  for (std::uint64_t seed = 2300; seed < 2310; ++seed) {
    Detector detector{Params()};
    for (const Detection& item : detector.detect(middleOf(tableCloud(seed), 160)).items) {
      ++found;
      EXPECT_GE(item.inlier_count, kindOf(item.shape) == Kind::plane ? kPlane : kCurved) << "seed " << seed;
    }
  }
  EXPECT_GT(found, 30);
}

int curvedIn(const Cloud& cloud) {
  Detector detector{Params()};
  const auto& items = detector.detect(cloud).items;
  return static_cast<int>(std::count_if(items.begin(), items.end(),
                                        [](const Detection& item) { return kindOf(item.shape) != Kind::plane; }));
}

TEST(ClutteredTables, ShowAsManyCurvedThingsInImagesOfAnyHeight) {
  // Of heights that are no multiple of four, runs of points are no tiles: a third to two thirds were lost.
  int whole = 0, fewer_rows[3] = {};
  for (std::uint64_t seed = 2300; seed < 2308; ++seed) {
    const Cloud image = tableCloud(seed);
    whole += curvedIn(image);
    for (std::uint32_t k = 0; k < 3; ++k) fewer_rows[k] += curvedIn(partOf(image, 0, 0, image.width, 477 + k));
  }
  ASSERT_GE(whole, 20);
  for (const int found : fewer_rows) EXPECT_GE(found, whole - 2);
}

bool hasWholeEvidence(const Detection& item) { return item.evidence.inliers == std::round(item.evidence.inliers); }

/// A sample that speaks for one and a bit leaves no whole number.
TEST(ClutteredTables, WeighSamplesOfTheCloserLookWhereMuchIsLeftForIt) {
  Detector detector{Params()};
  const auto allWhole = [&detector](std::uint64_t seed) {
    const auto& items = detector.detect(tableCloud(seed)).items;
    return std::all_of(items.begin(), items.end(), hasWholeEvidence);
  };
  EXPECT_FALSE(allWhole(2301));
  EXPECT_TRUE(allWhole(2300));
}

/// More would be asked of what becomes likely later, too, and it would be gone.
TEST(ClutteredTables, LoseWithAHigherLeastConfidenceOnlyWhatIsBelow) {
  std::size_t lost = 0;
  for (const std::uint64_t seed : {2301, 2302, 2303, 2304}) {
    const Cloud cloud = tableCloud(seed);
    Params params;
    Detector detector{params};
    std::vector<double> expected, found;
    params.min_confidence = 0.97;
    for (const Detection& item : detector.detect(cloud).items) {
      if (item.confidence >= params.min_confidence) expected.push_back(item.confidence);
    }
    lost += detector.result().items.size() - expected.size();
    Detector bounded{params};
    for (const Detection& item : bounded.detect(cloud).items) found.push_back(item.confidence);
    EXPECT_EQ(found, expected) << seed;
  }
  EXPECT_GT(lost, 0u) << "or it asks nothing";
}

}  // namespace
}  // namespace primitect::cluttered_tables_test
