// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes through many of the points.
#include "core/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"

namespace primitect::ground_test {
namespace {

using Point = Eigen::Vector3f;

/// So many points of a plane across the direction, .3 m along it; the others anywhere within a metre.
std::vector<Point> withPlane(const Point& across, int on_plane, int elsewhere) {
  Random random(5);
  const auto anywhere = [&random] {
    return Eigen::Vector3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  std::vector<Point> points;
  for (int k = 0; k < on_plane; ++k) {
    const Point point = anywhere().cast<float>();
    points.push_back(point - (across.dot(point) - 0.3f) * across);
  }
  for (int k = 0; k < elsewhere; ++k) points.push_back(anywhere().cast<float>());
  return points;
}

TEST(FindGrounds, ThroughMostOfThePoints) {
  const Point across = Point(0.2f, -0.5f, 0.8f).normalized();
  const std::vector<Ground> grounds = findGrounds(withPlane(across, 5000, 5000));
  ASSERT_EQ(grounds.size(), 1u);
  EXPECT_GT(std::abs(grounds[0].normal.dot(across)), 0.9999f);
  EXPECT_NEAR(std::abs(grounds[0].offset), 0.3f, 0.002f);
}

TEST(FindGrounds, WithTheNormalToTheSideOfMostOthers) {
  // .3 m along the direction more lies below.
  EXPECT_LT(findGrounds(withPlane(Point::UnitZ(), 5000, 5000)).at(0).normal.z(), -0.99f);
  EXPECT_LT(findGrounds(withPlane(-Point::UnitZ(), 5000, 5000)).at(0).normal.dot(-Point::UnitZ()), -0.99f);
}

TEST(FindGrounds, TwoWhereThereAreTwo) {
  std::vector<Point> points = withPlane(Point::UnitZ(), 6000, 0);
  for (const Point& point : withPlane(Point::UnitX(), 4000, 500)) points.push_back(point);
  const std::vector<Ground> grounds = findGrounds(points);
  ASSERT_EQ(grounds.size(), 2u);
  EXPECT_GT(std::abs(grounds[0].normal.z()), 0.999f) << "the larger one first";
  EXPECT_GT(std::abs(grounds[1].normal.x()), 0.999f);
}

TEST(FindGrounds, NoneWhereItWouldBeFewerThanAFifth) {
  EXPECT_TRUE(findGrounds(withPlane(Point::UnitZ(), 1000, 9000)).empty());
  EXPECT_EQ(findGrounds(withPlane(Point::UnitZ(), 3000, 7000)).size(), 1u);
}

TEST(FindGrounds, NoneOfNothingNorOfOnePlaceNorOfALine) {
  EXPECT_TRUE(findGrounds({}).empty());
  EXPECT_TRUE(findGrounds(std::vector<Point>(1000, Point(1, 2, 3))).empty());
  std::vector<Point> line;
  for (int k = 0; k < 1000; ++k) line.push_back(0.125f * static_cast<float>(k) * Point(1, 2, 4));
  EXPECT_TRUE(findGrounds(line).empty());
}

}  // namespace
}  // namespace primitect::ground_test
