// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes that touch others: noise gives points of each to the other, and still all err as their covariances say.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/random.h"
#include "eval/nees.h"
#include "primitect/detector.h"
#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"

namespace primitect::eval::touching_nees_test {
namespace {

constexpr int kSeeds = 50;

/// A ball of 4 to 8 cm and a cup with a wall of 4 mm that stand on a table, in the camera's frame. Inside and rim of
/// the cup are within the noise of its outside.
struct SetTable {
  Shape table, ball, cup;
  Cloud cloud;

  explicit SetTable(std::uint64_t seed) {
    Random random(seed);
    const auto standing = [&random](double side, double height) {
      const Vec3 place{random.uniform(-0.1, 0.1), side * random.uniform(0.1, 0.2), synthetic::kTableHeight + height};
      return Eigen::Isometry3d(Eigen::Translation3d(place));
    };
    const double radius = random.uniform(0.04, 0.08), width = random.uniform(0.035, 0.06), half_length = 0.05;
    synthetic::World world;
    world.add("table", synthetic::Sheet{0.6, 0.6},
              Eigen::Isometry3d(Eigen::Translation3d(0, 0, synthetic::kTableHeight)));
    world.add("ball", synthetic::Ball{radius}, standing(-1.0, radius));
    world.add("cup", synthetic::Cup{width, width - 0.004, half_length, 0.005}, standing(1.0, half_length));
    const Eigen::Isometry3d pose = synthetic::cameraPose(random.uniform(0.0, 60.0));
    const auto shapeOf = [&](std::size_t surface) {
      return transformed(pose.inverse(), world.surfaces()[surface].shape);
    };
    table = shapeOf(0), ball = shapeOf(1), cup = shapeOf(2);
    const synthetic::PinholeCamera camera;
    const synthetic::Frame frame = synthetic::renderFrame(world, camera, pose, {}, seed, 0);
    synthetic::cloudFromDepth(frame.depth, camera, {}, cloud);
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

/// Not the bottom of the cup, which is a plane, too.
bool isOf(const Shape& truth, const Detection& detection) {
  const Extent& extent = detection.extent;
  const Vec3 on_surface = project(detection.shape, extent.origin + 0.01 * extent.rotation.col(0));
  return truth.index() == detection.shape.index() && std::abs(distance(truth, on_surface)) < 0.003;
}

TEST(ShapesThatTouch, ErrAsTheirCovariancesSay) {
  Detector detector{Params()};
  std::array<Mean, kKindCount> means;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const SetTable scene(seed);
    for (const Detection& detection : detector.detect(scene.cloud).items) {
      for (const Shape& truth : {scene.table, scene.ball, scene.cup}) {
        if (isOf(truth, detection)) means[truth.index()].add(truth, detection);
      }
    }
  }
  for (const Kind kind : {Kind::plane, Kind::sphere, Kind::cylinder}) {
    const Mean& mean = means[static_cast<std::size_t>(kind)];
    EXPECT_EQ(mean.found, kSeeds) << kindName(kind);
    // Calibrated to 20 % at the worst, and three times what chance does: 10 % of 200 degrees.
    EXPECT_NEAR(mean.value(), 1.0, 0.2 + 3.0 * mean.spread()) << kindName(kind);
  }
}

}  // namespace
}  // namespace primitect::eval::touching_nees_test
