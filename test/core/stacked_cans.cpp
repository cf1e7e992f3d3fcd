// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Cans of several radii on each other.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "primitect/detector.h"
#include "test/support/rendered_cloud.h"
#include "test/support/scenes.h"

namespace primitect::stacked_cans_test {
namespace {

constexpr double kHeight = 0.09;  // m, of each can
constexpr int kSeeds = 4;         // frames of a pile

/// Upright on a table so far away (m), the first one at the bottom.
class Pile {
 public:
  explicit Pile(std::vector<double> radii, double away = 0.9)
      : radii_(std::move(radii)), table_(test::tableBeforeCamera(away, 30.0 * test::kDegree)) {
    world_.add("table", synthetic::Sheet{1.0, 0.6}, table_);
    double height = 0.0;
    for (const double radius : radii_) {
      middles_.push_back((table_ * Eigen::Translation3d(0.0, 0.0, height + 0.5 * kHeight)).translation());
      world_.add("can", synthetic::Rod{radius, 0.5 * kHeight},
                 table_ * Eigen::Translation3d(0.0, 0.0, height + 0.5 * kHeight));
      height += kHeight;
    }
  }

  /// How many are found with their own radius and at their own place, in frames of several seeds; cans: all cylinders.
  int found(int seeds, int* cans) const {
    constexpr double kNearRadius = 0.0015, kNearMiddle = 0.015;  // m
    int count = 0;
    *cans = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      Params params;
      params.seed = seed;
      Detector detector{params};
      const std::vector<Detection>& items =
          detector.detect(test::renderedCloud(world_, {}, static_cast<std::uint64_t>(seed))).items;
      for (const Detection& item : items) *cans += std::holds_alternative<Cylinder>(item.shape) ? 1 : 0;
      for (std::size_t k = 0; k < radii_.size(); ++k) {
        for (const Detection& item : items) {
          const Cylinder* can = std::get_if<Cylinder>(&item.shape);
          if (!can || std::abs(can->radius - radii_[k]) > kNearRadius) continue;
          const Vec3 way = item.extent.origin - middles_[k];
          count += std::abs(can->axis.dot(way)) < kNearMiddle ? 1 : 0;
        }
      }
    }
    return count;
  }

 private:
  std::vector<double> radii_;
  Eigen::Isometry3d table_;
  synthetic::World world_;
  std::vector<Vec3> middles_;
};

TEST(StackedCans, OfTwoRadiiAreTwo) {
  int cans = 0;
  EXPECT_EQ(Pile({0.046, 0.041}).found(kSeeds, &cans), 2 * kSeeds) << "one of a radius between theirs";
  EXPECT_EQ(cans, 2 * kSeeds);
  EXPECT_GE(Pile({0.038, 0.044}).found(kSeeds, &cans), 6) << "of 8, radii to 1.5 mm";
  EXPECT_EQ(cans, 2 * kSeeds);
}

TEST(StackedCans, FourMillimetresApartAreTwo) {
  for (const double away : {0.6, 0.9, 1.2}) {
    int cans = 0;
    EXPECT_GE(Pile({0.040, 0.044}, away).found(kSeeds, &cans), 7) << "of 8, " << away << " m away";
    EXPECT_EQ(cans, 2 * kSeeds) << away << " m away";
  }
}

TEST(StackedCans, ThreeMillimetresApartAreTwoNearby) {
  int cans = 0;
  EXPECT_GE(Pile({0.040, 0.043}, 0.6).found(kSeeds, &cans), 7) << "of 8";
  EXPECT_EQ(cans, 2 * kSeeds);
}

TEST(StackedCans, OfThreeRadiiAreThree) {
  int cans = 0;
  EXPECT_GE(Pile({0.048, 0.0435, 0.039}).found(kSeeds, &cans), 10) << "of 12; a cone over all of them finds none";
  EXPECT_TRUE(cans == 11 || cans == 12) << cans << ": no can is cut in two";
}

TEST(StackedCans, OfOneRadiusStayOneTube) {
  int cans = 0;
  Pile({0.042, 0.042}).found(kSeeds, &cans);
  EXPECT_EQ(cans, kSeeds);
}

}  // namespace
}  // namespace primitect::stacked_cans_test
