// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The loops over points of a cloud, of every instruction set that this machine has, against plain code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/flat.h"
#include "core/random.h"
#include "kernels/loops.h"

namespace primitect::kernels::point_loops_test {
namespace {

const std::vector<Shape> kShapes = {Plane{Vec3(0.1, 0, 1), Vec3(0, 0.6, -0.8)}, Sphere{Vec3(0, 0.1, 1), 0.3},
                                    Cylinder{Vec3(0, 0, 1.1), Vec3(0.6, 0, 0.8), 0.2},
                                    Cone{Vec3(0.1, 0, 0.9), Vec3(0, 0.8, 0.6), 0.4}};

struct Points {
  std::vector<float> x, y, z;
  explicit Points(std::size_t count) {
    Random random(count);
    for (std::size_t i = 0; i < count; ++i) {
      x.push_back(static_cast<float>(random.uniform(-0.5, 0.5)));
      y.push_back(static_cast<float>(random.uniform(-0.5, 0.5)));
      z.push_back(static_cast<float>(random.uniform(0.5, 1.5)));
    }
  }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

// Odd lengths, shorter and longer than vectors are.
constexpr std::size_t kCounts[] = {1, 15, 16, 31, 64, 200};
constexpr double kRounding = 1e-6;  // m; float holds 1 m to 1e-7

TEST(Feet, AreDistancesAndNormalsOfTheSurface) {
  for (const Loops* table : allLoops()) {
    for (const Shape& shape : kShapes) {
      for (const std::size_t count : kCounts) {
        const Points p(count);
        std::vector<float> distance(count), nx(count), ny(count), nz(count);
        table->feet(flattened(shape, Vec3::Zero()), p.x.data(), p.y.data(), p.z.data(), count,
                    {distance.data(), nx.data(), ny.data(), nz.data()});
        for (std::size_t i = 0; i < count; ++i) {
          ASSERT_NEAR(distance[i], primitect::distance(shape, p.at(i)), kRounding) << table->name << " " << i;
          // A thousand times nearer to an axis than 1 m, normals are known a thousand times worse.
          ASSERT_LT((Vec3(nx[i], ny[i], nz[i]) - normalAt(shape, p.at(i))).norm(), 1e3 * kRounding) << table->name;
        }
      }
    }
  }
}

TEST(Feet, OnAnAxisOrACentreHaveNoNormal) {
  for (const Loops* table : allLoops()) {
    for (const Shape& shape : {Shape(Sphere{Vec3(0, 0, 1), 0.1}), Shape(Cylinder{Vec3(0, 0, 1), Vec3(0, 1, 0), 0.1}),
                               Shape(Cone{Vec3(0, 0, 1), Vec3(0, 1, 0), 0.3})}) {
      const float x = 0.0f, z = 1.0f;
      float distance, nx, ny, nz;
      table->feet(flattened(shape, Vec3::Zero()), &x, &x, &z, 1, {&distance, &nx, &ny, &nz});
      EXPECT_TRUE(std::isfinite(distance) && std::isfinite(nx) && std::isfinite(ny) && std::isfinite(nz));
      EXPECT_LE(Vec3(nx, ny, nz).norm(), 1.0 + kRounding);
    }
  }
}

TEST(Balls, HoldTheirPointsAndLeaveOutMissingOnes) {
  constexpr std::size_t kSize = 64;
  for (const Loops* table : allLoops()) {
    for (const std::size_t count : {std::size_t{1}, std::size_t{64}, std::size_t{150}, std::size_t{331}}) {
      Points p(count);
      for (std::size_t i = 0; i < count; i += 5) p.x[i] = p.y[i] = p.z[i] = std::nanf("");
      for (std::size_t i = 64; i < 128 && i < count; ++i) p.x[i] = p.y[i] = p.z[i] = std::nanf("");
      const std::size_t runs = (count + kSize - 1) / kSize;
      std::vector<float> x(runs), y(runs), z(runs), radius(runs);
      table->balls(p.x.data(), p.y.data(), p.z.data(), count, kSize, {x.data(), y.data(), z.data(), radius.data()});
      for (std::size_t k = 0; k < runs; ++k) EXPECT_EQ(radius[k] < 0.0f, k == 1 || count == 1) << count << " " << k;
      for (std::size_t i = 0; i < count; ++i) {
        if (std::isnan(p.x[i])) continue;
        const std::size_t k = i / kSize;
        EXPECT_LE((p.at(i) - Vec3(x[k], y[k], z[k])).norm(), radius[k] + kRounding);
        EXPECT_LT(radius[k], 0.88);  // half the diagonal of what the points lie in
      }
    }
  }
}

TEST(Depths, AreThoseOfTheNearestSide) {
  const std::vector<FlatSide> sides = {{1, 0, 0, -0.2f}, {0, -1, 0, -0.3f}, {0.6f, 0, 0.8f, 0.5f}};
  for (const Loops* table : allLoops()) {
    for (const std::size_t count : kCounts) {
      const Points p(count);
      std::vector<float> depth(count);
      table->depths({sides.data(), sides.size()}, p.x.data(), p.y.data(), p.z.data(), count, depth.data());
      for (std::size_t i = 0; i < count; ++i) {
        const double expected = std::min({p.x[i] + 0.2, 0.3 - p.y[i], 0.6 * p.x[i] + 0.8 * p.z[i] - 0.5});
        ASSERT_NEAR(depth[i], expected, kRounding) << table->name;
      }
      table->depths({nullptr, 0}, p.x.data(), p.y.data(), p.z.data(), count, depth.data());
      for (const float d : depth) ASSERT_EQ(d, std::numeric_limits<float>::infinity());
    }
  }
}

TEST(Around, SumsWhatIsWithinReach) {
  constexpr std::size_t kCount = 10 * kLanes;
  const Points p(kCount);
  std::vector<float> weight(kCount);
  for (std::size_t i = 0; i < kCount; ++i) weight[i] = i % 7 == 0 ? 0.0f : 1.0f + 0.1f * static_cast<float>(i % 3);
  const Vec3 probe(0.1, -0.1, 1.0);
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    if ((p.at(i) - probe).squaredNorm() >= 0.16) continue;
    sum += weight[i] * (p.at(i) - probe);
    total += weight[i];
  }
  ASSERT_GT(total, 10.0);
  for (const Loops* table : allLoops()) {
    const FlatAround found =
        table->around({0.1f, -0.1f, 1.0f, 0.16f}, p.x.data(), p.y.data(), p.z.data(), weight.data(), kCount);
    EXPECT_LT((Vec3(found.x, found.y, found.z) - sum).norm(), 1e2 * kRounding) << table->name;
    EXPECT_NEAR(found.weight, total, 1e2 * kRounding) << table->name;
  }
}

/// A run within an image 40 wide against its points one after the other.
TEST(PointLoops, TakeRunsFromRowsOfAnImage) {
  constexpr std::size_t kWidth = 40, kFirst = 7;
  const Points image(4 * kWidth);
  std::vector<float> x, y, z;
  for (std::size_t i = 0; i < kPointsPerRun; ++i) {
    const std::size_t at = kFirst + i / kPointsPerRow * kWidth + i % kPointsPerRow;
    x.push_back(image.x[at]), y.push_back(image.y[at]), z.push_back(image.z[at]);
  }
  const RunOfPoints in_rows = {&image.x[kFirst], &image.y[kFirst], &image.z[kFirst], kWidth};
  const RunOfPoints in_line = {x.data(), y.data(), z.data(), kPointsPerRow};
  const FlatSide kSide = {1, 0, 0, -0.1f};
  const FlatTolerance kWide = {0.1f, 0.0f, 0.4f, 0.0f};
  for (const Loops* table : allLoops()) {
    const RunBall ball = table->ballOfRun(in_rows), expected = table->ballOfRun(in_line);
    EXPECT_EQ(ball.x, expected.x) << table->name;
    EXPECT_EQ(ball.y, expected.y) << table->name;
    EXPECT_EQ(ball.z, expected.z) << table->name;
    EXPECT_EQ(ball.radius, expected.radius) << table->name;
    EXPECT_EQ(ball.measured, expected.measured) << table->name;
    for (const Shape& shape : kShapes) {
      const FlatShape flat = flattened(shape, Vec3::Zero());
      for (const std::size_t sides : {0, 1}) {
        const LabelTarget targets[] = {{&flat, {&kSide, sides}, 3}, {&flat, {&kSide, 1}, 5}};
        for (const std::size_t count : {1, 2}) {
          std::uint32_t labels[kPointsPerRun];
          std::vector<std::uint32_t> of_image(4 * kWidth, 9), beside(4 * kWidth, 9);
          table->label(kWide, targets, count, in_line, labels);
          table->label(kWide, targets, count, in_rows, of_image.data() + kFirst);
          for (std::size_t i = 0; i < kPointsPerRun; ++i) {
            beside[kFirst + i / kPointsPerRow * kWidth + i % kPointsPerRow] = labels[i];
          }
          EXPECT_EQ(of_image, beside) << table->name;
          EXPECT_EQ(table->unexplained(kWide, targets, count, in_rows),
                    table->unexplained(kWide, targets, count, in_line))
              << table->name;
        }
      }
    }
  }
}

TEST(PointLoops, GiveTheSameBitsWithEveryInstructionSet) {
  const Points p(200);
  const FlatSide kSide = {1, 0, 0, -0.1f};
  for (const Shape& shape : kShapes) {
    std::vector<std::vector<float>> results;
    for (const Loops* table : allLoops()) {
      std::vector<float> all(800), ball(16);
      table->feet(flattened(shape, Vec3::Zero()), p.x.data(), p.y.data(), p.z.data(), 200,
                  {&all[0], &all[200], &all[400], &all[600]});
      table->balls(p.x.data(), p.y.data(), p.z.data(), 200, 64, {&ball[0], &ball[4], &ball[8], &ball[12]});
      all.insert(all.end(), ball.begin(), ball.end());
      table->tolerances({0.001f, 0.002f, 0.4f, 0.001f}, p.z.data(), 200, &all[0]);
      std::uint32_t labels[kPointsPerRun];
      const FlatShape flat = flattened(shape, Vec3::Zero());
      const LabelTarget target = {&flat, {&kSide, 1}, 1};
      const RunOfPoints run = {p.x.data(), p.y.data(), p.z.data(), kPointsPerRow};
      table->label({0.1f, 0.0f, 0.4f, 0.0f}, &target, 1, run, labels);
      all.insert(all.end(), labels, labels + kPointsPerRun);
      results.push_back(all);
      EXPECT_EQ(results.front(), results.back()) << table->name;
    }
  }
}

TEST(PixelsAt, AreTheSameWithEveryInstructionSet) {
  Random random(7);
  const PixelGrid grid = {-0.4871f, -0.3613f, 1.0f / 0.001753f, 1.0f / 0.001749f, 557, 413};
  std::vector<float> u, v;
  for (int k = 0; k < 5000; ++k) {
    // Many on the edges of pixels.
    u.push_back(grid.left + 0.001753f * static_cast<float>(random.below(560)));
    v.push_back(grid.top + 0.001749f * static_cast<float>(random.uniform(0.0, 415.0)));
  }
  std::vector<std::uint32_t> expected;
  for (const Loops* table : allLoops()) {
    std::vector<std::uint32_t> pixel(u.size());
    table->pixelsAt(grid, u.data(), v.data(), u.size(), pixel.data());
    if (expected.empty()) expected = pixel;
    EXPECT_EQ(pixel, expected) << table->name;
  }
  EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](std::uint32_t p) { return p != kNoPixel; }), 4900);
}

/// Behind the sensor, far aside, and missing ones among them.
Points someUnseen(std::size_t count) {
  Points p(count);
  for (std::size_t i = 0; i < count; i += 7) p.z[i] = i % 2 == 0 ? -p.z[i] : 0.0f;
  for (std::size_t i = 3; i < count; i += 11) p.x[i] = 5.0f;
  for (std::size_t i = 5; i < count; i += 13) p.x[i] = p.y[i] = p.z[i] = std::numeric_limits<float>::quiet_NaN();
  return p;
}

TEST(Tangents, AreThoseOfWhatACameraSees) {
  constexpr float kWidest = 2.0f;
  for (const Loops* table : allLoops()) {
    for (const std::size_t count : kCounts) {
      const Points p = someUnseen(count);
      std::vector<float> u(count), v(count);
      const ViewBounds view = table->tangents(p.x.data(), p.y.data(), p.z.data(), count, kWidest, u.data(), v.data());
      std::size_t seen = 0;
      float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
      for (std::size_t i = 0; i < count; ++i) {
        const float across = p.x[i] / p.z[i], down = p.y[i] / p.z[i];
        const bool in = p.z[i] > 0.0f && std::abs(across) < kWidest && std::abs(down) < kWidest;
        ASSERT_EQ(std::isnan(u[i]), !in) << table->name << " " << i;
        ASSERT_EQ(std::isnan(v[i]), !in) << table->name << " " << i;
        if (!in) continue;
        ++seen;
        ASSERT_EQ(u[i], across) << table->name << " " << i;
        ASSERT_EQ(v[i], down) << table->name << " " << i;
        left = std::min(left, across), right = std::max(right, across);
        top = std::min(top, down), bottom = std::max(bottom, down);
      }
      EXPECT_EQ(view.seen, seen) << table->name;
      if (seen == 0) {
        EXPECT_EQ(view.left, std::numeric_limits<float>::infinity());
        EXPECT_EQ(view.bottom, -std::numeric_limits<float>::infinity());
        continue;
      }
      EXPECT_EQ(view.left, left) << table->name;
      EXPECT_EQ(view.right, right) << table->name;
      EXPECT_EQ(view.top, top) << table->name;
      EXPECT_EQ(view.bottom, bottom) << table->name;
    }
  }
}

TEST(PixelsAt, AreRowByRowAndNoneOutside) {
  const PixelGrid grid = {-0.25f, -0.125f, 64.0f, 32.0f, 32, 8};
  const float none = std::numeric_limits<float>::quiet_NaN();
  struct Place {
    float u, v;
    std::uint32_t pixel;
  };
  const std::vector<Place> places = {{-0.25f, -0.125f, 0},    {-0.235f, -0.125f, 0},     {-0.234375f, -0.125f, 1},
                                     {-0.25f, -0.09375f, 32}, {0.249f, 0.124f, 255},     {-0.2501f, 0.0f, kNoPixel},
                                     {0.25f, 0.0f, kNoPixel}, {0.0f, -0.126f, kNoPixel}, {0.0f, 0.125f, kNoPixel},
                                     {none, 0.0f, kNoPixel},  {0.0f, none, kNoPixel},    {1e30f, 0.0f, kNoPixel},
                                     {0.0f, -1e30f, kNoPixel}};
  for (const Loops* table : allLoops()) {
    for (const std::size_t count : kCounts) {
      std::vector<float> u, v;
      for (std::size_t i = 0; i < count; ++i) {
        u.push_back(places[i % places.size()].u);
        v.push_back(places[i % places.size()].v);
      }
      std::vector<std::uint32_t> pixel(count);
      table->pixelsAt(grid, u.data(), v.data(), count, pixel.data());
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(pixel[i], places[i % places.size()].pixel) << table->name << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace primitect::kernels::point_loops_test
