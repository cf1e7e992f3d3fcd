// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A rendered can: whole, in tatters, behind a post, and with the shadow of the post.
#include "core/seen_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "core/extent.h"
#include "core/random.h"
#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/scene_layout.h"
#include "synthetic/tabletop.h"

namespace primitect::seen_share_test {
namespace {

using synthetic::Rod;

// Pixels within 1.5 px of the can's ends may belong to what is behind: 2 rows of some 60.
constexpr double kBorders = 0.04;

/// A can of 5 cm radius 1 m in front of the camera; and, if it is asked for, a post of 1.5 cm 30 cm before it.
class Can : public testing::Test {
 protected:
  void render(bool with_post, const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity(), double away = 1.0) {
    const Eigen::Isometry3d place = Eigen::Translation3d(0, 0, 0.08) * turn;
    const int body = world_.add("can", Rod{0.05, 0.08}, place);
    surface_ = world_.bodies()[static_cast<std::size_t>(body)].first_surface;
    if (with_post) world_.add("post", Rod{0.015, 0.4}, Eigen::Isometry3d(Eigen::Translation3d(-0.3, 0, 0.2)));
    const Eigen::Isometry3d pose = synthetic::lookAt(Vec3(-away, 0.0, 0.1), Vec3(0.0, 0.0, 0.08));
    frame_ = synthetic::renderFrame(world_, camera_, pose, synthetic::FrameParams(), 1, 0);
    synthetic::cloudFromDepth(frame_.depth, camera_, range_, cloud_);
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (frame_.surface[i] == surface_ && cloud_.valid(i)) pixels_.push_back(static_cast<std::uint32_t>(i));
    }
    can_.shape = transformed(pose.inverse(), world_.surfaces()[static_cast<std::size_t>(surface_)].shape);
    std::vector<Vec3> points;
    for (const std::uint32_t i : pixels_) points.emplace_back(cloud_.x[i], cloud_.y[i], cloud_.z[i]);
    can_.extent = measureExtent(can_.shape, points);
    rays_ = findRays(cloud_);
    ASSERT_TRUE(rays_.known);
    ASSERT_GT(pixels_.size(), 2000u);
  }

  /// Calls change(pixel) for a random share of the can's pixels, which are on it no longer.
  template <class Change>
  void changeSome(double share, const Change& change) {
    Random random(3);
    List<std::uint32_t> left;
    for (const std::uint32_t i : pixels_) {
      if (random.uniform(0.0, 1.0) < share) {
        change(i);
      } else {
        left.push_back(i);
      }
    }
    pixels_ = left;
  }

  /// The same for those in columns from first to before end; returns the share of the can's pixels that is left.
  template <class Change>
  double changeColumns(std::uint32_t first, std::uint32_t end, const Change& change) {
    List<std::uint32_t> left;
    for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
      if (frame_.surface[i] != surface_) continue;
      if (first <= i % cloud_.width && i % cloud_.width < end) change(i);
    }
    const auto before = static_cast<double>(pixels_.size());
    for (const std::uint32_t i : pixels_) {
      if (i % cloud_.width < first || end <= i % cloud_.width) left.push_back(i);
    }
    pixels_ = left;
    return static_cast<double>(left.size()) / before;
  }

  void miss(std::uint32_t i) { cloud_.x[i] = cloud_.y[i] = cloud_.z[i] = std::numeric_limits<float>::quiet_NaN(); }

  /// A wall behind the can, as far as nothing is there yet and none of it is missing.
  void addBackground() {
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (cloud_.valid(i) || frame_.surface[i] == surface_) continue;
      const Vec3 ray = rays_.through(static_cast<double>(i % cloud_.width), static_cast<double>(i / cloud_.width));
      cloud_.x[i] = static_cast<float>(1.9 * ray.x()), cloud_.y[i] = static_cast<float>(1.9 * ray.y());
      cloud_.z[i] = 1.9f;
    }
  }

  double share() { return seen().all; }

  SeenShare seen() { return seenShare(can_, pixels_, {cloud_, rays_, range_, sigma()}); }
  bool isSeenSomewhere() { return primitect::isSeenSomewhere(can_, pixels_, {cloud_, rays_, range_, sigma()}); }

  PointNoise sigma() {
    return [this](const Vec3& p) {
      ++asked_;
      return synthetic::axialSigma(p.z());
    };
  }

  /// By so much (m) at its upper end, where a pixel of something else passes for its own.
  void stretch(double longer) {
    const bool up = can_.extent.rotation.col(2).y() < 0.0;
    moveEnds(up ? 0.0 : -longer, up ? longer : 0.0, can_.shape, can_.extent);
    const Vec3 end = can_.extent.origin + 0.5 * (up ? 1.0 : -1.0) * can_.extent.size.z() * can_.extent.rotation.col(2);
    const double column = camera_.cx + camera_.fx * end.x() / end.z(),
                 row = camera_.cy + camera_.fy * end.y() / end.z();
    pixels_.push_back(static_cast<std::uint32_t>(std::lround(row)) * cloud_.width +
                      static_cast<std::uint32_t>(std::lround(column)));
  }

  synthetic::World world_;
  synthetic::PinholeCamera camera_;
  synthetic::Frame frame_;
  Cloud cloud_;
  Detection can_;
  int surface_ = 0;
  List<std::uint32_t> pixels_;
  ImageRays rays_;
  DepthRange range_ = {0.1f, 2.0f};
  int asked_ = 0;  ///< places so far
};

TEST_F(Can, ThatIsWholeIsSeenEverywhere) {
  render(false);
  EXPECT_GT(share(), 1.0 - kBorders);
}

TEST_F(Can, InTattersIsSeenWhereItIsLeft) {
  render(false);
  changeSome(0.15, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  EXPECT_NEAR(share(), 0.85, kBorders);
}

TEST_F(Can, IsAskedAtMorePlacesOnlyUntilTheseSettleOrAreMany) {
  constexpr int kNinth = 280;  // at most, of the places in its box: so near, about each third pixel of each third row
  render(false, Eigen::Quaterniond::Identity(), 0.5);
  EXPECT_GT(share(), 1.0 - kBorders);
  EXPECT_LE(asked_, kNinth);
  asked_ = 0;
  // In the middle of where confidence goes down no number of places settles it: five hundred are enough.
  changeSome(0.17, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  EXPECT_NEAR(share(), 0.83, kBorders);
  EXPECT_GE(asked_, 500);
  EXPECT_LE(asked_, 500 + kNinth);
}

TEST_F(Can, ThatIsTakenForALongerOneIsSeenInAPartOfIt) {
  render(false);
  addBackground();
  const double length = can_.extent.size.z();
  EXPECT_FALSE(seen().part);
  stretch(0.6 * length);
  const SeenShare found = seen();
  EXPECT_NEAR(found.all, 1.0 / 1.6, kBorders);
  ASSERT_TRUE(found.part);
  const bool up = can_.extent.rotation.col(2).y() < 0.0;
  const double end = up ? found.part->high : -found.part->low, other = up ? found.part->low : -found.part->high;
  EXPECT_NEAR(end + 0.5 * can_.extent.size.z(), length, 1.6 * length / 24.0) << "to one of 24 parts";
  EXPECT_EQ(other, -std::numeric_limits<double>::infinity()) << "the other end is that of the extent";
  EXPECT_GT(found.in_part, 1.0 - 2.0 * kBorders);
  EXPECT_TRUE(isSeenSomewhere());
}

/// Its end is behind something nearer, and of the rest a fifth is not there: nobody knows where it ends.
TEST_F(Can, WhoseEndIsHiddenIsNoShorterForThat) {
  render(false);
  const std::uint32_t first = pixels_.front() / cloud_.width, last = pixels_.back() / cloud_.width;
  const List<std::uint32_t> all = pixels_;
  const std::uint32_t rows = (last - first) / 6;
  for (const bool upper : {true, false}) {
    const Cloud whole = cloud_;
    pixels_.clear();
    for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
      const std::uint32_t row = i / cloud_.width;
      if (upper ? row < first + rows : row > last - rows) cloud_.setPoint(i, 0.0f, 0.0f, 0.5f, {});
    }
    for (const std::uint32_t i : all) {
      if (cloud_.z[i] != 0.5f) pixels_.push_back(i);
    }
    changeSome(0.2, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
    pixels_.push_back(upper ? all.front() : all.back());  // a straggler
    EXPECT_LT(seen().all, 0.88);
    EXPECT_FALSE(seen().part) << upper;
    cloud_ = whole;
  }
}

TEST_F(Can, InTattersIsASeenPartOfNothing) {
  render(false);
  addBackground();
  EXPECT_TRUE(isSeenSomewhere());
  changeSome(0.5, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  EXPECT_FALSE(seen().part) << "it is as much in tatters everywhere";
  EXPECT_FALSE(isSeenSomewhere());
  changeSome(0.95, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  EXPECT_FALSE(isSeenSomewhere()) << "nowhere any more";
}

TEST_F(Can, OfWhichATenthIsSeenIsNotSeen) {
  render(false);
  const List<std::uint32_t> all = pixels_;
  const std::uint32_t first = all.front() / cloud_.width, last = all.back() / cloud_.width;
  for (const double part : {0.4, 0.1}) {
    const auto end = first + static_cast<std::uint32_t>((1.0 - part) * (last - first));
    pixels_ = {all.front()};  // a straggler
    for (const std::uint32_t i : all) {
      if (i / cloud_.width < end) cloud_.z[i] = 1.9f;
      if (i / cloud_.width >= end) pixels_.push_back(i);
    }
    EXPECT_EQ(isSeenSomewhere(), part > 0.2) << part;
  }
}

TEST_F(Can, WithBumpsIsNotSeenThere) {
  render(false);
  // Nearer by 10 standard deviations: not so much that something would hide the can.
  changeSome(
      0.15, [this](std::uint32_t i) { cloud_.z[i] -= 10.0f * static_cast<float>(synthetic::axialSigma(cloud_.z[i])); });
  EXPECT_NEAR(share(), 0.85, kBorders);
}

/// As dark and glossy ones have: a quarter of it speaks against the can, and half of it where noise has taken one of
/// the pixels beside it off the surface, as it does in a quarter of the rows.
TEST_F(Can, WithABlotIsMostlySeen) {
  render(false);
  const double left = changeColumns(310, 335, [this](std::uint32_t i) { miss(i); });
  ASSERT_LT(left, 0.6);
  EXPECT_NEAR(share(), left / (left + (0.75 * 0.25 + 0.25 * 0.5) * (1.0 - left)),
              2.0 * kBorders);  // near the limb nothing is asked
}

/// As between the leaves of a plant, and as glossy things have that reach to their limb: half of it speaks against the
/// can.
TEST_F(Can, WithAHoleBesideSomethingElseIsHalfNotSeenThere) {
  render(false);
  const double seen = changeColumns(306, 339, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  changeColumns(310, 335, [this](std::uint32_t i) { miss(i); });
  constexpr double kColumns = 33.0, kMissing = 25.0;
  const double against = (1.0 - seen) * (kColumns - 0.5 * kMissing) / kColumns;
  EXPECT_NEAR(share(), seen / (seen + against), kBorders);
}

TEST_F(Can, OfWhichEveryThirdPixelIsMissingIsSeenEverywhere) {
  render(false);
  changeSome(0.33, [this](std::uint32_t i) { miss(i); });
  EXPECT_GT(share(), 1.0 - kBorders);
}

TEST_F(Can, BehindAPostIsSeenEverywhereElse) {
  render(true);
  EXPECT_GT(share(), 1.0 - kBorders);
}

TEST_F(Can, InTheShadowOfAPostIsSeenEverywhereElse) {
  constexpr std::uint32_t kShadow = 10;  // px, to the right of the post
  render(true);
  List<std::uint32_t> left;
  for (const std::uint32_t i : pixels_) {
    bool shadowed = false;
    for (std::uint32_t k = 1; k <= kShadow; ++k) shadowed = shadowed || frame_.depth[i - k] < 0.8f;
    if (!shadowed) left.push_back(i);
    if (shadowed) miss(i);
  }
  ASSERT_GT(pixels_.size() - left.size(), pixels_.size() / 10);
  pixels_ = left;
  EXPECT_GT(share(), 1.0 - kBorders);
}

TEST_F(Can, AtTheBoundOfTheDepthIsSeenUpToIt) {
  // The can's nearest line is 0.95 m away, its limb 1.0 m.
  constexpr float kBound = 0.962f;
  render(false);
  List<std::uint32_t> left;
  for (const std::uint32_t i : pixels_) {
    if (cloud_.z[i] <= kBound) left.push_back(i);
    if (cloud_.z[i] > kBound) miss(i);
  }
  pixels_ = left;
  addBackground();
  EXPECT_LT(share(), 0.95);
  range_.max = kBound;
  EXPECT_GT(share(), 1.0 - kBorders);
}

TEST_F(Can, IsSeenToWhatWasCutAwayAroundIt) {
  render(false);
  // A corner of it.
  const std::uint32_t middle = pixels_[pixels_.size() / 2], column = middle % cloud_.width, row = middle / cloud_.width;
  List<std::uint32_t> left;
  for (const std::uint32_t i : pixels_) {
    const bool hidden = i % cloud_.width < column && i / cloud_.width < row;
    if (!hidden) left.push_back(i);
    if (hidden) miss(i);
  }
  ASSERT_LT(left.size(), 0.9 * pixels_.size());
  pixels_ = left;
  EXPECT_GT(share(), 1.0 - kBorders) << "what hid it may have been cut away, too";
  const Cloud nothing_measured = cloud_;
  for (std::size_t i = 0; i < cloud_.size(); ++i) {
    if (!cloud_.valid(i)) cloud_.setPoint(i, 0.0f, 0.0f, 5.0f, {0.1f, 2.0f});
  }
  EXPECT_LT(share(), 0.9) << "the camera saw through it, beyond the range";
  cloud_ = nothing_measured;
  addBackground();
  EXPECT_LT(share(), 0.95) << "a hole";
}

TEST_F(Can, IsTakenAsItIsWhereTheCloudIsNoImage) {
  render(false);
  changeSome(0.5, [this](std::uint32_t i) { miss(i); });
  rays_.known = false;
  EXPECT_EQ(share(), 1.0);
}

/// How far it leans towards the camera, and then turns about the camera's axis (rad).
class LeaningCan : public Can, public testing::WithParamInterface<std::pair<double, double>> {};

TEST_P(LeaningCan, IsAskedAllOver) {
  const auto [lean, roll] = GetParam();
  // Some rays at the borders of the image's box around it meet its far side.
  render(false, Eigen::AngleAxisd(roll, Vec3::UnitX()) * Eigen::AngleAxisd(lean, Vec3::UnitY()), 0.5);
  changeSome(0.5, [this](std::uint32_t i) { cloud_.z[i] += 0.1f; });
  EXPECT_NEAR(share(), 0.5, 0.08);
}

INSTANTIATE_TEST_SUITE_P(SeenShare, LeaningCan,
                         testing::Values(std::pair(0.9, 1.0), std::pair(1.2, 1.0), std::pair(-0.9, 1.0),
                                         std::pair(1.2, -1.0)));

TEST(TrustInShare, IsFullNearTheWholeAndGoneWhereAQuarterIsNotSeen) {
  EXPECT_EQ(trustInShare(1.0), 1.0);
  EXPECT_EQ(trustInShare(0.9), 1.0);
  EXPECT_LT(trustInShare(0.85), 0.7);
  EXPECT_EQ(trustInShare(0.75), 0.0);
  EXPECT_EQ(trustInShare(0.0), 0.0);
}

}  // namespace
}  // namespace primitect::seen_share_test
