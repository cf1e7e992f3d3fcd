// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A rendered can before a wall, said to be longer than it is.
#include "core/seen_ends.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/extent.h"
#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/scene_layout.h"
#include "synthetic/tabletop.h"

namespace primitect::seen_ends_test {
namespace {

using synthetic::Box;
using synthetic::Rod;

/// A can of 5 cm radius and 16 cm height, 1 m in front of the camera.
class SeenEnds : public testing::Test {
 protected:
  void render(bool top_hidden) {
    const auto at = [](double x, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, z)); };
    const int body = world_.add("can", Rod{0.05, kHalf}, at(0.0, 0.1));
    world_.add("wall", Box{0.02, 0.8, 0.8}, at(0.5, 0.1));
    if (top_hidden) world_.add("box", Box{0.02, 0.2, 0.1}, at(-0.2, 0.1 + kHalf + 0.06));
    const int mantle = world_.bodies()[static_cast<std::size_t>(body)].first_surface;
    const Eigen::Isometry3d pose = synthetic::lookAt(Vec3(-1.0, 0.0, 0.1), Vec3(0.0, 0.0, 0.1));
    const synthetic::Frame frame = synthetic::renderFrame(world_, camera_, pose, synthetic::FrameParams(), 1, 0);
    synthetic::cloudFromDepth(frame.depth, camera_, range_, cloud_);
    rays_ = findRays(cloud_);
    ASSERT_TRUE(rays_.known);
    can_ = std::get<Cylinder>(transformed(pose.inverse(), world_.surfaces()[static_cast<std::size_t>(mantle)].shape));
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (frame.surface[i] == mantle && cloud_.valid(i)) points.push_back(cloud_.point(i));
    }
    extent_ = measureExtent(can_, points);
    extent_.origin = pose.inverse() * Vec3(0.0, 0.0, 0.1);
    extent_.size.z() = 2.0 * kHalf;
  }

  /// With this much more at both ends (m).
  std::optional<AxisPart> ends(double more) const {
    Extent extent = extent_;
    extent.size.z() += 2.0 * more;
    return seenEnds(can_, false, extent, {cloud_, rays_, range_, sigma_});
  }

  static constexpr double kHalf = 0.08, kPixels = 0.006;  // m; three pixels are 5 mm there
  synthetic::World world_;
  synthetic::PinholeCamera camera_;
  DepthRange range_{0.1f, 3.0f};
  PointNoise sigma_{[](const Vec3&) { return 0.002; }};
  Cloud cloud_;
  ImageRays rays_;
  Cylinder can_;
  Extent extent_;
};

TEST_F(SeenEnds, AreWhereTheyAre) {
  render(false);
  EXPECT_FALSE(ends(0.0));
  EXPECT_FALSE(ends(-0.02)) << "it goes on";
}

TEST_F(SeenEnds, AreBeforeWhatIsNotThere) {
  render(false);
  for (const double more : {0.02, 0.04, 0.06}) {
    const std::optional<AxisPart> part = ends(more);
    ASSERT_TRUE(part) << more;
    EXPECT_NEAR(part->low, -kHalf, kPixels) << more;
    EXPECT_NEAR(part->high, kHalf, kPixels) << more;
  }
}

TEST_F(SeenEnds, LoseThreeTenthsAtMost) {
  render(false);
  const std::optional<AxisPart> part = ends(0.3);
  ASSERT_TRUE(part);
  const double half = kHalf + 0.3;
  EXPECT_NEAR(part->low, -half + 0.3 * 2.0 * half, 0.02) << "other tests than this one refuse it";
  EXPECT_NEAR(part->high, half - 0.3 * 2.0 * half, 0.02);
}

/// An extent of a few pixels, wholly beside the can.
TEST_F(SeenEnds, LoseThreeTenthsAtMostOfAFewPixels) {
  render(false);
  for (int pixels = 1; pixels <= 12; ++pixels) {
    extent_.origin = can_.point + (kHalf + 0.05) * can_.axis;
    extent_.size.z() = pixels * rays_.x_scale * extent_.origin.z();
    const std::optional<AxisPart> part = ends(0.0);
    const double length = extent_.size.z();
    EXPECT_EQ(part.has_value(), pixels >= 7) << pixels;
    if (!part) continue;
    EXPECT_LE(part->low + 0.5 * length, 0.3 * length + 1e-6) << pixels;
    EXPECT_LE(0.5 * length - part->high, 0.3 * length + 1e-6) << pixels;
  }
}

TEST_F(SeenEnds, StayWhereSomethingHidesThem) {
  render(true);
  const std::optional<AxisPart> part = ends(0.03);
  ASSERT_TRUE(part);
  const bool top_is_low = extent_.rotation.col(2).y() > 0.0;  // y of the camera is down
  EXPECT_TRUE(std::isinf(top_is_low ? part->low : part->high)) << "hidden";
  EXPECT_NEAR(top_is_low ? part->high : -part->low, kHalf, kPixels);
}

TEST_F(SeenEnds, StayWithoutRays) {
  render(false);
  rays_.known = false;
  EXPECT_FALSE(ends(0.04));
}

}  // namespace
}  // namespace primitect::seen_ends_test
