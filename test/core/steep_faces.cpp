// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sides of boxes that the camera sees at a steep angle, where it errs sideways, too: they have normals, and are found.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "primitect/detector.h"
#include "test/support/exact_shapes.h"
#include "test/support/rendered_cloud.h"

namespace primitect::steep_faces_test {
namespace {

constexpr double kAway = 1.2;                                       // m
constexpr double kLength = 0.14, kThickness = 0.07, kHeight = 0.2;  // m, of a box of cereals

/// One on a table, and one of its large sides as the camera sees it, at this angle to the view.
struct SteepSide {
  synthetic::World world;
  Vec3 middle, normal;

  explicit SteepSide(double incidence) {
    const Eigen::Isometry3d table = test::tableBeforeCamera(kAway, 37.0 * test::kDegree);
    world.add("table", synthetic::Sheet{1.0, 0.6}, table);
    // Turned until the side is seen that steeply.
    for (double turn = 0.0;; turn += 0.1 * test::kDegree) {
      const Eigen::Isometry3d box =
          table * Eigen::Translation3d(0.0, 0.0, 0.5 * kHeight) * Eigen::AngleAxisd(turn, Vec3::UnitZ());
      middle = box * Vec3(0.5 * kThickness, 0.0, 0.0), normal = box.linear().col(0);
      if (!(test::angle(normal, -middle) > incidence)) {
        world.add("box", synthetic::Box{0.5 * kThickness, 0.5 * kLength, 0.5 * kHeight}, box);
        return;
      }
    }
  }

  bool isFound(const Detections& result) const {
    for (const Detection& item : result.items) {
      const Plane* plane = std::get_if<Plane>(&item.shape);
      if (!plane || test::angle(plane->normal, normal) > 5.0 * test::kDegree) continue;
      if (std::abs(distance(*plane, middle)) < 0.005 && (item.extent.origin - middle).norm() < 0.03) return true;
    }
    return false;
  }
};

int found(double incidence_deg) {
  const SteepSide side(incidence_deg * test::kDegree);
  synthetic::FrameParams params;
  params.noise.sideways = 0.8;
  params.noise.max_incidence_deg = 85.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Detector detector{Params()};
    count += side.isFound(detector.detect(test::renderedCloud(side.world, params, seed))) ? 1 : 0;
  }
  return count;
}

TEST(SteepFaces, AreFoundWhereTheCameraErrsSideways) {
  for (const double deg : {60.0, 70.0, 76.0, 78.0}) EXPECT_EQ(found(deg), 10) << deg;
  EXPECT_GE(found(80.0), 8) << "4 where as much is tolerated as of what faces the camera";
}

}  // namespace
}  // namespace primitect::steep_faces_test
