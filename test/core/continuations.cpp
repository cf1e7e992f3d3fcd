// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points of other things that by chance lie where a can would go on: they neither stretch it nor speak against it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/random.h"
#include "primitect/detector.h"
#include "test/support/exact_shapes.h"
#include "test/support/found_cans.h"
#include "test/support/rendered_cloud.h"

namespace primitect::continuations_test {
namespace {

constexpr double kRadius = 0.04, kLength = 0.12, kAway = 0.9;  // m

/// A can across the view, before a wall. A share of the pixels beyond its upper end, as far as it would reach if it
/// were `longer` times its length longer, see something on its surface instead of the wall.
Cloud withContinuation(double share, double longer, std::uint64_t seed) {
  synthetic::World world;
  world.add("wall", synthetic::Sheet{2.0, 2.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 1.5)));
  const Eigen::Isometry3d across(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX()));
  world.add("can", synthetic::Rod{kRadius, 0.5 * kLength}, Eigen::Translation3d(0.0, 0.0, kAway) * across);
  Cloud cloud = test::renderedCloud(world, {}, seed);
  const synthetic::PinholeCamera camera;
  Random random(seed);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 ray = camera.ray(static_cast<int>(i % cloud.width), static_cast<int>(i / cloud.width));
    // x^2 + (z - kAway)^2 = kRadius^2, the nearer one.
    const double a = ray.x() * ray.x() + 1.0, root = kAway * kAway - a * (kAway * kAway - kRadius * kRadius);
    if (root < 0.0) continue;
    const Vec3 point = (kAway - std::sqrt(root)) / a * ray;
    const double beyond = -0.5 * kLength - point.y();
    if (beyond < 0.003 || beyond > longer * kLength || random.uniform() >= share) continue;
    cloud.setPoint(i, static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(point.z()), {});
  }
  return cloud;
}

TEST(Continuations, AreNoPartOfATube) {
  for (const double share : {0.0, 0.1, 0.2}) {
    for (const double longer : {0.5, 1.0}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(testing::Message() << share << ", " << longer << ", " << seed);
        Detector detector{Params()};
        const Detection* can = nullptr;
        const Detections& result = detector.detect(withContinuation(share, longer, seed));
        for (const Detection& item : result.items) {
          if (kindOf(item.shape) == Kind::cylinder) can = &item;
        }
        ASSERT_TRUE(can) << "of all pixels there, a fifth take half of its confidence or more";
        EXPECT_GT(can->confidence, 0.95f) << ".65 to .8 with a tenth";
        EXPECT_NEAR(can->extent.size.z(), kLength, 0.007) << ".14 m and more";
        const double half = 0.5 * can->extent.size.z() * std::abs(can->extent.rotation.col(2).y());
        EXPECT_NEAR(can->extent.origin.y() + half, 0.5 * kLength, 0.0025) << "the other end is as it was";
        EXPECT_NEAR(can->inlier_count, 3700.0, 100.0);
      }
    }
  }
}

/// A can that lies on a table, and two boxes as high as it behind one another beyond its end.
int foundBesideBoxes(double gap) {
  constexpr double kEnd = 0.07;  // m, from its middle
  const Eigen::Isometry3d table = test::tableBeforeCamera(1.1, 37.0 * test::kDegree);
  const auto at = [&table](double x, double y, double z) { return table * Eigen::Translation3d(x, y, z); };
  synthetic::World world;
  world.add("table", synthetic::Sheet{1.0, 0.6}, table);
  const Eigen::Isometry3d lying = at(-0.1, 0.0, kRadius) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY());
  world.add("can", synthetic::Rod{kRadius, kEnd}, lying);
  const double begin = -0.1 + kEnd + gap;
  world.add("box", synthetic::Box{0.06, 0.05, kRadius}, at(begin + 0.06, 0.02, kRadius));
  world.add("lower box", synthetic::Box{0.05, 0.05, 0.035}, at(begin + 0.19, 0.015, 0.035));
  synthetic::FrameParams params;
  params.noise.scale = 1.3;
  int count = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    Params detector_params;
    detector_params.seed = seed;
    Detector detector{detector_params};
    const Cloud cloud = test::renderedCloud(world, params, static_cast<std::uint64_t>(seed));
    count += test::isCanFound(lying.translation(), kRadius, detector.detect(cloud)) ? 1 : 0;
  }
  return count;
}

TEST(Continuations, OfBoxesLeaveTheCan) {
  EXPECT_EQ(foundBesideBoxes(0.02), 10);
  EXPECT_EQ(foundBesideBoxes(0.1), 10) << "2 where a tube through all must be seen all along";
}

}  // namespace
}  // namespace primitect::continuations_test
