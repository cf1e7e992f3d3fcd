// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labels of runs of points against labels of one point after the other.
#include "core/labeling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/extent.h"
#include "test/support/exact_shapes.h"
#include "test/support/noisy_points.h"

namespace primitect::labeling_test {
namespace {

using test::measured;
using test::patchOf;
using test::together;

const Plane kTable = {Vec3(0, 0.2, 1.2), Vec3(0, -0.8, -0.6)};
const Sphere kBall = {Vec3(-0.25, 0.0, 1.0), 0.08};
const Cylinder kCan = {Vec3(0.05, 0.05, 0.95), Vec3(0, -0.8, -0.6), 0.05};
const Cone kHat = {Vec3(0.3, -0.1, 0.9), Vec3(0, 0.8, 0.6), 0.44};

/// One shape after the other, with points missing and not a whole number of runs.
Cloud cloudInOrder() {
  Random random(61);
  const auto curved = together(
      {patchOf(kBall, 1000, random), patchOf(kCan, 1000, -0.1, 0.1, random), patchOf(kHat, 1003, 0.03, 0.25, random)});
  Cloud cloud = test::cloudOf(measured(together({patchOf(kTable, 3000, 0.5, random), curved}), 0.002, 0.0, random));
  for (std::size_t i = 0; i < cloud.size(); i += 17) cloud.x[i] = cloud.y[i] = cloud.z[i] = std::nanf("");
  for (std::size_t i = 640; i < 900; ++i) cloud.x[i] = cloud.y[i] = cloud.z[i] = std::nanf("");
  return cloud;
}

/// All of it but the last points, as an image that runs fill.
Cloud asImage(Cloud cloud) {
  cloud.width = 64, cloud.height = 92;
  for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) values->resize(cloud.width * cloud.height);
  cloud.countPoints();
  return cloud;
}

Cloud shuffled(Cloud cloud) {
  Random random(62);
  for (std::size_t i = cloud.size() - 1; i > 0; --i) {
    const std::size_t k = random.below(i + 1);
    std::swap(cloud.x[i], cloud.x[k]);
    std::swap(cloud.y[i], cloud.y[k]);
    std::swap(cloud.z[i], cloud.z[k]);
  }
  return cloud;
}

/// Of which parts were seen that are smaller than the patches.
std::vector<Detection> detections() {
  Random random(63);
  const auto seen = [](const Shape& shape, const std::vector<test::SurfacePoint>& patch) {
    std::vector<Vec3> points;
    for (const test::SurfacePoint& p : patch) points.push_back(p.point);
    Detection detection;
    detection.shape = shape;
    detection.extent = measureExtent(shape, points);
    return detection;
  };
  return {seen(kTable, patchOf(kTable, 2000, 0.4, random)), seen(kBall, patchOf(kBall, 500, random)),
          seen(kCan, patchOf(kCan, 500, -0.05, 0.05, random)), seen(kHat, patchOf(kHat, 500, 0.05, 0.2, random))};
}

/// The label of a point by its distances and depths; nothing when float may decide otherwise.
std::optional<std::uint32_t> labelOf(const Vec3& p, const std::vector<Detection>& items, const Tolerance& tolerance) {
  constexpr double kUndecided = 1e-6;  // m
  const double allowed = tolerance.distanceAt(p);
  double nearest = allowed;
  std::uint32_t label = 0;
  for (std::uint32_t k = 0; k < items.size(); ++k) {
    const Eigen::Vector3f f = p.cast<float>();
    const double away = std::abs(distance(items[k].shape, p));
    const double depth = ObservedPart(items[k].shape, items[k].extent).depth(f.x(), f.y(), f.z()) + allowed;
    if (std::abs(away - nearest) < kUndecided || std::abs(depth) < kUndecided) return std::nullopt;
    if (!(away < nearest) || depth < 0.0) continue;
    nearest = away;
    label = k + 1;
  }
  return label;
}

const Tolerance kEverywhereAlike = {NoiseModel{0.002}, 1.0, 3.0};
const Tolerance kOfDepthCamera = {NoiseModel{0.0, 0.001}, 1.0, 3.0};

TEST(LabelPoints, GivesEachPointToTheNearestShapeOnWhosePartItLies) {
  const std::vector<Detection> items = detections();
  for (const Cloud& cloud : {cloudInOrder(), shuffled(cloudInOrder()), asImage(cloudInOrder())}) {
    for (const Tolerance& tolerance : {kEverywhereAlike, kOfDepthCamera, kOfDepthCamera.scaled(2.0)}) {
      std::vector<std::uint32_t> labels;
      labelPoints(cloud, items, tolerance, labels);
      ASSERT_EQ(labels.size(), cloud.size());
      std::size_t decided = 0;
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (!cloud.valid(i)) {
          ASSERT_EQ(labels[i], 0u) << i;
          continue;
        }
        const auto label = labelOf(cloud.point(i), items, tolerance);
        if (!label) continue;
        ++decided;
        ASSERT_EQ(labels[i], *label) << i;
      }
      EXPECT_GT(decided, 0.95 * cloud.valid_count * 16.0 / 17.0 - 260);
      for (std::uint32_t k = 0; k <= items.size(); ++k) EXPECT_GT(std::count(labels.begin(), labels.end(), k), 100);
    }
  }
}

TEST(PointRuns, KnowWhichPointsWereMeasured) {
  for (const Cloud& cloud : {cloudInOrder(), asImage(cloudInOrder())}) {
    PointRuns runs;
    findRuns(cloud, runs);
    for (std::size_t i = 0; i < runs.size() * kernels::kPointsPerRun; ++i) {
      const std::size_t run = i / kernels::kPointsPerRun, place = i % kernels::kPointsPerRun;
      const std::size_t point = runs.layout.point(run, place);
      ASSERT_EQ(runs.measured[run] >> place & 1, point < cloud.size() && cloud.valid(point)) << i;
    }
  }
}

TEST(PointRuns, OfAnImageHoldEachPointOnceCloseTogether) {
  Cloud image;
  image.reset(48, 8, false);
  const RunLayout layout(image);
  std::vector<int> times(image.size(), 0);
  for (std::size_t run = 0; run < numberOfRuns(image); ++run) {
    const std::size_t first = layout.firstPointOf(run);
    for (std::size_t place = 0; place < kernels::kPointsPerRun; ++place) {
      const std::size_t point = layout.point(run, place);
      ++times.at(point);
      EXPECT_EQ(layout.runOf(point), run);
      EXPECT_LT(point % 48 - first % 48, 16u);
      EXPECT_LT(point / 48 - first / 48, 4u);
    }
  }
  EXPECT_EQ(times, std::vector<int>(image.size(), 1));
}

TEST(PointRuns, OfOtherCloudsFollowEachOther) {
  for (const auto& [width, height] : {std::pair{384u, 1u}, {50u, 8u}, {48u, 9u}}) {
    Cloud cloud;
    cloud.reset(width, height, false);
    const RunLayout layout(cloud);
    EXPECT_EQ(layout.point(2, 40), 168u) << width;
    EXPECT_EQ(layout.runOf(168), 2u) << width;
  }
}

TEST(LabelPoints, KnowMoreShapesThanAWordHasBits) {
  const Cloud cloud = cloudInOrder();
  std::vector<Detection> many(40), few = detections();
  for (Detection& far : many) far.shape = Sphere{Vec3(0, 0, 50), 0.1}, far.extent.origin = Vec3(0, 0, 50);
  many.insert(many.end(), few.begin(), few.end());
  std::vector<std::uint32_t> labels, labels_of_many;
  labelPoints(cloud, few, kEverywhereAlike, labels);
  labelPoints(cloud, many, kEverywhereAlike, labels_of_many);
  for (std::size_t i = 0; i < cloud.size(); ++i) ASSERT_EQ(labels_of_many[i], labels[i] == 0 ? 0 : labels[i] + 40) << i;
}

TEST(LabelPoints, GoToOthersWhenSomeDetectionsAreNotWanted) {
  std::vector<Detection> items = detections();
  items.push_back(items[2]);  // on the can, a little wider: it has the points that noise moved out
  std::get<Cylinder>(items[4].shape).radius += 0.002;
  for (const Cloud& cloud : {cloudInOrder(), asImage(cloudInOrder())})
    for (const List<bool>& wanted : {List<bool>{0, 1, 1, 1, 1}, List<bool>{1, 1, 0, 1, 1}, List<bool>{1, 1, 1, 1, 0},
                                     List<bool>{0, 1, 0, 1, 1}, List<bool>{1, 1, 0, 1, 0}, List<bool>(5, false)}) {
      std::vector<Detection> others;
      std::vector<std::uint32_t> number = {0}, labels, expected;  // of each other one among all
      for (std::uint32_t k = 0; k < items.size(); ++k) {
        if (wanted[k]) others.push_back(items[k]), number.push_back(k + 1);
      }
      Labeling labeling;
      labeling.begin(cloud);
      labeling.label(items, kEverywhereAlike, labeling.allRuns(), labels);
      for (std::uint32_t k = 0; k < items.size(); ++k) {
        EXPECT_NE(std::find(labels.begin(), labels.end(), k + 1), labels.end()) << k;
      }
      labeling.labelWithout(items, wanted, kEverywhereAlike, labeling.allRuns(), labelRuns(labels), labels);
      labelPoints(cloud, others, kEverywhereAlike, expected);
      for (std::uint32_t& label : expected) label = number[label];
      EXPECT_EQ(labels, expected);
    }
}

TEST(LabelPoints, OfLongStretchesAllGoToOthers) {
  Random random(63);
  const Cloud cloud = test::cloudOf(patchOf(kTable, 1000, 0.03, random));  // without gaps
  std::vector<Detection> items = detections();
  items.push_back(items[0]);  // beside the table's plane
  std::get<Plane>(items[4].shape).point += 0.004 * kTable.normal;
  const List<bool> wanted = {0, 1, 1, 1, 1};
  Labeling labeling;
  labeling.begin(cloud);
  std::vector<std::uint32_t> labels;
  labeling.label(items, kEverywhereAlike, labeling.allRuns(), labels);
  ASSERT_GT(std::count(labels.begin(), labels.end(), 1u), 900);
  labeling.labelWithout(items, wanted, kEverywhereAlike, labeling.allRuns(), labelRuns(labels), labels);
  EXPECT_GT(std::count(labels.begin(), labels.end(), 5u), 900);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 1u), 0);
}

void expectUnexplainedIn(const Cloud& cloud, Labeling::Rows rows, const std::vector<Detection>& items) {
  Labeling labeling;
  labeling.begin(cloud);
  std::vector<std::uint32_t> labels;
  List<std::uint64_t> unexplained;
  labeling.label(items, kOfDepthCamera, labeling.allRuns(), labels);
  labeling.findUnexplained(items, kOfDepthCamera, labeling.allRuns(), rows, unexplained);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t run = i / kernels::kPointsPerRun, place = i % kernels::kPointsPerRun;
    const std::size_t point = labeling.allRuns().layout.point(run, place);
    if (!cloud.valid(point)) continue;
    const bool free = unexplained[run] >> place & 1;
    const bool looked_at = rows == Labeling::Rows::all || place / kernels::kPointsPerRow % 2 == 0;
    ASSERT_EQ(free, looked_at && labels[point] == 0) << i;
  }
}

TEST(Unexplained, AreThePointsWithoutALabel) {
  const std::vector<Detection> items = detections();
  for (const Cloud& cloud : {cloudInOrder(), asImage(cloudInOrder())}) {
    for (const Labeling::Rows rows : {Labeling::Rows::all, Labeling::Rows::every_second}) {
      for (const std::ptrdiff_t count :
           {static_cast<std::ptrdiff_t>(items.size()), std::ptrdiff_t{1}, std::ptrdiff_t{0}}) {
        expectUnexplainedIn(cloud, rows, {items.begin(), items.begin() + count});
      }
    }
  }
}

TEST(LabelPoints, OfNothingAreNone) {
  std::vector<std::uint32_t> labels = {1, 2, 3};
  labelPoints(Cloud(), detections(), kEverywhereAlike, labels);
  EXPECT_TRUE(labels.empty());
  labelPoints(cloudInOrder(), {}, kEverywhereAlike, labels);
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0u), static_cast<std::ptrdiff_t>(labels.size()));
}

}  // namespace
}  // namespace primitect::labeling_test
