// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes that touch: noise gives points of each to the other, and still both err as their covariances say.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "eval/nees.h"
#include "primitect/detector.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect::eval {
namespace {

constexpr int kSeeds = 50;

/// A ball of 4 to 8 cm that stands on a table, and its shapes in the camera's frame.
struct BallOnTable {
  Plane table = {Vec3(0, 0, synthetic::kTableHeight), Vec3::UnitZ()};
  Sphere ball;
  Cloud cloud;

  explicit BallOnTable(std::uint64_t seed) {
    Random random(seed);
    ball.radius = random.uniform(0.04, 0.08);
    ball.center = table.point + Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), ball.radius);
    synthetic::World world;
    world.add("table", synthetic::Sheet{0.6, 0.6}, Eigen::Isometry3d(Eigen::Translation3d(table.point)));
    world.add("ball", synthetic::Ball{ball.radius}, Eigen::Isometry3d(Eigen::Translation3d(ball.center)));
    const Eigen::Isometry3d pose = synthetic::cameraPose(random.uniform(0.0, 60.0));
    const synthetic::PinholeCamera camera;
    const synthetic::Frame frame = synthetic::renderFrame(world, camera, pose, {}, seed, 0);
    synthetic::cloudFromDepth(frame.depth, camera, {}, cloud);
    table = std::get<Plane>(synthetic::transformed(pose.inverse(), table));
    ball = std::get<Sphere>(synthetic::transformed(pose.inverse(), ball));
  }
};

/// Of what was found of one kind.
struct Mean {
  double sum = 0.0;  ///< of normalised squared errors
  int degrees = 0, found = 0;

  void add(const Shape& truth, const Detection& detection) {
    const auto error = normalisedErrors(truth, detection).total(kindOf(truth));
    if (!error) return;
    sum += error->value;
    degrees += error->degrees;
    ++found;
  }
  double value() const { return sum / degrees; }
  /// The sum of the squares of n normal numbers strays by sqrt(2 n).
  double spread() const { return std::sqrt(2.0 / degrees); }
};

TEST(ShapesThatTouch, ErrAsTheirCovariancesSay) {
  Detector detector{Params()};
  Mean tables, balls;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const BallOnTable scene(seed);
    for (const Detection& detection : detector.detect(scene.cloud).items) {
      if (kindOf(detection.shape) == Kind::plane) tables.add(scene.table, detection);
      if (kindOf(detection.shape) == Kind::sphere) balls.add(scene.ball, detection);
    }
  }
  EXPECT_EQ(tables.found, kSeeds);
  EXPECT_EQ(balls.found, kSeeds);
  // Calibrated to 20 % at the worst, and three times what chance does: 12 % of 150 degrees, 10 % of 200.
  EXPECT_NEAR(tables.value(), 1.0, 0.2 + 3.0 * tables.spread());
  EXPECT_NEAR(balls.value(), 1.0, 0.2 + 3.0 * balls.spread());
}

}  // namespace
}  // namespace primitect::eval
