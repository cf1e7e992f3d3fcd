// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits to image windows, of every instruction set, against the definition in double.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/random.h"
#include "test/support/exact_shapes.h"
#include "test/support/plain_window_fit.h"

namespace primitect::window_fits_test {
namespace {

using kernels::allLoops;
using kernels::Loops;
using kernels::PointImage;
using kernels::WindowPlane;
using kernels::WindowTask;

PointImage imageOf(const Cloud& cloud) {
  return {cloud.x.data(), cloud.y.data(), cloud.z.data(), cloud.width, cloud.height};
}

WindowTask taskAt(const Cloud& cloud, std::size_t pixel, std::size_t half_width) {
  const float depth = cloud.z[pixel];
  WindowTask task = {};
  task.pixel = pixel, task.half_width = half_width, task.inner_half_width = (half_width + 1) / 2;
  task.depth = depth, task.u = cloud.x[pixel] / depth, task.v = cloud.y[pixel] / depth;
  task.largest_jump = 0.04f, task.tolerance = 0.005f, task.tolerance_per_slope = 0.01f, task.fewest_at_start = 6;
  return task;
}

/// With the pitch that these clouds have.
WindowTask onGrid(WindowTask task, const Cloud& cloud) {
  const std::size_t last = cloud.size() - 1;
  const auto pitch = [&cloud, last](const std::vector<float>& values, std::uint32_t count) {
    const double first_ratio = static_cast<double>(values[0]) / cloud.z[0];
    return static_cast<float>((static_cast<double>(values[last]) / cloud.z[last] - first_ratio) / (count - 1.0));
  };
  task.u_per_column = pitch(cloud.x, cloud.width), task.v_per_row = pitch(cloud.y, cloud.height);
  return task;
}

/// Points along the same rays at other depths.
void scale(Cloud& cloud, std::size_t i, float factor) {
  for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) (*values)[i] *= factor;
}

/// A slanted plane with noise, a step, stragglers and holes.
Cloud roughCloud(std::uint64_t seed) {
  Random random(seed);
  Cloud cloud = test::cameraCloud(Vec3(0.4, -0.2, 1.0).normalized(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    scale(cloud, i, 1.0f + 0.001f * static_cast<float>(random.gaussian()));
    if (i % cloud.width > 100) scale(cloud, i, 1.3f);
    if (random.uniform() < 0.05) scale(cloud, i, 1.02f);
    if (random.uniform() < 0.1 && i > 0 && i + 1 < cloud.size()) cloud.setPoint(i, 0.0f, 0.0f, 0.0f, {});
  }
  return cloud;
}

/// Each instruction set, from points and on the grid of a pinhole camera.
std::vector<std::pair<const Loops*, bool>> allWays() {
  std::vector<std::pair<const Loops*, bool>> ways;
  for (const Loops* loops : allLoops()) ways.insert(ways.end(), {{loops, false}, {loops, true}});
  return ways;
}

/// A slanted plane with noise and a step, else without a fault.
Cloud cleanCloud(std::uint64_t seed) {
  Random random(seed);
  Cloud cloud = test::cameraCloud(Vec3(0.4, -0.2, 1.0).normalized(), 1.0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    scale(cloud, i, 1.0f + 0.001f * static_cast<float>(random.gaussian()));
    if (i % cloud.width > 100) scale(cloud, i, 1.01f);
  }
  return cloud;
}

/// A plane at 60 to 85 deg to the view, with noise that often is more than what is tolerated about gentler ones.
Cloud steepCloud(std::uint64_t seed) {
  Random random(seed);
  Cloud cloud = test::cameraCloud(Vec3(0.5, 0.1, 0.4).normalized(), 0.3);
  for (std::size_t i = 0; i < cloud.size(); ++i) scale(cloud, i, 1.0f + 0.004f * static_cast<float>(random.gaussian()));
  return cloud;
}

/// Returns how many fits there were.
int compareWithDefinition(const Cloud& cloud, std::size_t half_width) {
  int fitted = 0;
  for (std::size_t pixel = 0; pixel < cloud.size(); pixel += 97) {
    if (!cloud.valid(pixel)) continue;
    for (const auto& [loops, grid] : allWays()) {
      const WindowTask points = taskAt(cloud, pixel, half_width), task = grid ? onGrid(points, cloud) : points;
      const WindowPlane plain = test::plainWindowFit(imageOf(cloud), task);
      const WindowPlane found = loops->fitWindow(imageOf(cloud), task);
      // A pixel on the threshold may fall to either side of it: it weighs one in the window's.
      EXPECT_NEAR(found.used, plain.used, 1) << loops->name << " at " << pixel;
      if (found.used != plain.used || plain.used == 0) continue;
      ++fitted;
      // Rounding of d is 1e-7 at a slope per window of 1e-2 and more.
      EXPECT_NEAR(found.a, plain.a, 1e-4) << loops->name << " at " << pixel;
      EXPECT_NEAR(found.b, plain.b, 1e-4);
      EXPECT_NEAR(found.c, plain.c, 1e-6);
      // Of windows a few hundredths wide.
      EXPECT_NEAR(found.u, plain.u, 1e-6);
      EXPECT_NEAR(found.v, plain.v, 1e-6);
      EXPECT_NEAR(found.variance, plain.variance, 1e-4 * plain.variance);
    }
  }
  return fitted;
}

TEST(WindowFits, AgreeWithTheDefinitionInDouble) {
  int fitted = 0;
  for (const std::size_t half_width : {3u, 7u, 8u, 10u, 30u}) {
    fitted += compareWithDefinition(roughCloud(51 + half_width), half_width);
    fitted += compareWithDefinition(cleanCloud(51 + half_width), half_width);
    fitted += compareWithDefinition(steepCloud(51 + half_width), half_width);
  }
  EXPECT_GT(fitted, 3600);
}

TEST(WindowFits, TolerateMoreOfAPlaneTheSteeperItIs) {
  WindowTask task = {};
  task.tolerance = 0.003f, task.tolerance_per_slope = 0.004f, task.largest_jump = 0.04f;
  const auto tolerated = [&task](double a, double b) { return toleranceOf(task, {a, b}); };
  EXPECT_FLOAT_EQ(tolerated(0.0, 0.0), 0.003f);
  EXPECT_FLOAT_EQ(tolerated(1.8, -2.4), 0.003f) << "a slope of 3";
  EXPECT_FLOAT_EQ(tolerated(0.0, 4.0), 0.005f);
  EXPECT_FLOAT_EQ(tolerated(-2.4, 3.2), 0.005f);
  EXPECT_FLOAT_EQ(tolerated(0.0, 20.0), 0.04f) << "no more than parts surfaces";
}

TEST(WindowFits, TakeAllPixelsOfAPinholeImageOnlyWhereTheyAreOneSurface) {
  // Noise of a fifth of the tolerance: some pixels of many are off by more than it in the end.
  Cloud cloud = cleanCloud(57);
  const std::size_t pixel = 60 * 160 + 50;
  scale(cloud, pixel + 3, 1.009f);
  const auto used = [&cloud](std::size_t at) {
    const WindowTask task = onGrid(taskAt(cloud, at, 7), cloud);
    return kernels::loops().fitWindow(imageOf(cloud), task).used;
  };
  EXPECT_EQ(used(pixel), 15 * 15) << "beyond the tolerance, but no more than noise makes it";
  // The step is at column 101: of two tolerances.
  EXPECT_LT(used(60 * 160 + 97), 13 * 15);
  EXPECT_EQ(used(60 * 160 + 93), 15 * 15) << "ends before the step";
  cloud.setPoint(pixel + 4, 0.0f, 0.0f, 0.0f, {});
  EXPECT_EQ(used(pixel), 15 * 15 - 2) << "one is missing: what is beyond the tolerance is not taken";
}

/// A smaller window around the same centre.
WindowTask nearest(WindowTask task) {
  task.half_width = (task.half_width + 2) / 4;
  return task;
}

double plainOffset(const Cloud& cloud, const WindowTask& task, const WindowPlane& plane) {
  double count = 0.0, sum = 0.0;
  test::plainPass(imageOf(cloud), task, static_cast<int>(task.half_width), [&](double u, double v, double d) {
    const double off = d - plane.a * u - plane.b * v;
    if (std::abs(off - plane.c) < test::plainTolerance(task, plane)) count += 1.0, sum += off;
    return false;
  });
  return count > 0.0 ? sum / count : plane.c;
}

TEST(WindowOffsets, AgreeWithTheDefinitionInDouble) {
  // A pixel on the threshold, which falls to either side of it, would move the mean by a ninth of the tolerance.
  int compared = 0, near = 0;
  for (const Cloud& cloud : {roughCloud(61), cleanCloud(61), steepCloud(61)}) {
    for (std::size_t pixel = 0; pixel < cloud.size(); pixel += 97) {
      if (!cloud.valid(pixel)) continue;
      const WindowTask task = onGrid(taskAt(cloud, pixel, 3 + pixel % 17), cloud);
      const WindowPlane plane = test::plainWindowFit(imageOf(cloud), task);
      if (plane.used == 0) continue;
      const double plain = plainOffset(cloud, nearest(task), plane);
      for (const Loops* loops : allLoops()) {
        ++compared;
        near += std::abs(loops->offsetInWindow(imageOf(cloud), nearest(task), plane) - plain) < 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GE(near, compared - 3);
}

TEST(WindowOffsets, AreThePlanesOwnWhereNoPixelLiesOnIt) {
  Cloud cloud = cleanCloud(62);
  const std::size_t pixel = 60 * 160 + 50;
  const WindowTask task = taskAt(cloud, pixel, 1);
  WindowPlane plane;
  plane.c = 0.25;
  for (const Loops* loops : allLoops()) EXPECT_EQ(loops->offsetInWindow(imageOf(cloud), task, plane), 0.25);
  for (float& z : cloud.z) z = std::numeric_limits<float>::quiet_NaN();
  plane.c = 0.0;
  for (const Loops* loops : allLoops()) EXPECT_EQ(loops->offsetInWindow(imageOf(cloud), task, plane), 0.0);
}

void expectSameBits(const Cloud& cloud) {
  for (std::size_t pixel = 0; pixel < cloud.size(); pixel += 31) {
    if (!cloud.valid(pixel)) continue;
    WindowTask task = taskAt(cloud, pixel, 3 + pixel % 9);
    if (pixel % 2 == 0) task = onGrid(task, cloud);
    const WindowPlane first = (*allLoops().begin())->fitWindow(imageOf(cloud), task);
    for (const Loops* loops : allLoops()) {
      const WindowPlane found = loops->fitWindow(imageOf(cloud), task);
      EXPECT_EQ(found.used, first.used) << loops->name << " at " << pixel;
      EXPECT_EQ(found.a, first.a);
      EXPECT_EQ(found.b, first.b);
      EXPECT_EQ(found.c, first.c);
      EXPECT_EQ(found.variance, first.variance);
      const auto offset = [&](const Loops& of) { return of.offsetInWindow(imageOf(cloud), nearest(task), first); };
      EXPECT_EQ(offset(*loops), offset(**allLoops().begin())) << loops->name << " at " << pixel;
    }
  }
}

TEST(WindowFits, GiveTheSameBitsOnEveryInstructionSet) {
  expectSameBits(roughCloud(52));
  expectSameBits(cleanCloud(52));
  expectSameBits(steepCloud(52));
}

TEST(WindowFits, ReadNothingBeyondASmallImage) {
  for (const std::uint32_t width : {1u, 5u, 7u}) {
    Cloud cloud;
    cloud.reset(width, 9, false);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      cloud.setPoint(i, 0.01f * static_cast<float>(i % width), 0.01f * static_cast<float>(i / width), 1.0f, {});
    }
    WindowTask task = taskAt(cloud, cloud.size() / 2, 7);
    for (const auto& [loops, grid] : allWays()) {
      task.u_per_column = task.v_per_row = grid ? 0.01f : 0.0f;
      const WindowPlane found = loops->fitWindow(imageOf(cloud), task);
      // One column is a line: no plane.
      EXPECT_EQ(found.used, width == 1 ? 0 : static_cast<int>(cloud.size())) << loops->name;
      EXPECT_NEAR(found.a, 0.0, 1e-5);
    }
  }
}

TEST(WindowFits, FindNothingWhereNothingWasMeasured) {
  Cloud cloud = test::cameraCloud(Vec3::UnitZ(), 1.0);
  const WindowTask task = taskAt(cloud, 60 * 160 + 80, 7);
  for (float& z : cloud.z) z = std::numeric_limits<float>::quiet_NaN();
  for (const Loops* loops : allLoops()) EXPECT_EQ(loops->fitWindow(imageOf(cloud), task).used, 0) << loops->name;
}

}  // namespace
}  // namespace primitect::window_fits_test
