// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes that were seen are where the body ends.
#include "core/unseen_ends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "primitect/detector.h"
#include "synthetic/clutter.h"
#include "test/support/table_frame.h"

namespace primitect::unseen_ends_test {
namespace {

/// How far (m) an end of a found rod is from the end of the body: positive where the body goes on.
struct EndGap {
  double gap;
  bool unseen;
};

/// A rod or a frustum in the camera's frame (m).
struct TrueBody {
  Kind kind;
  Vec3 begin, end;  ///< of its axis, along z of the body
  Vec3 axis() const { return (end - begin).normalized(); }
};

std::optional<TrueBody> trueBody(const synthetic::Body& body, const Eigen::Isometry3d& camera_from_world) {
  const Eigen::Isometry3d pose = camera_from_world * body.world_from_body;
  const auto between = [&pose](Kind kind, double begin, double end) {
    return TrueBody{kind, pose * Vec3(0, 0, begin), pose * Vec3(0, 0, end)};
  };
  if (const auto* rod = std::get_if<synthetic::Rod>(&body.solid)) {
    return between(Kind::cylinder, -rod->half_length, rod->half_length);
  }
  if (const auto* cone = std::get_if<synthetic::Frustum>(&body.solid)) {
    return between(Kind::cone, cone->begin, cone->end);
  }
  return std::nullopt;
}

/// Of the same kind, and the middle of what was found is near the axis of the body.
bool isOn(const TrueBody& body, const Detection& found) {
  const Vec3 from_begin = found.extent.origin - body.begin;
  const double along = from_begin.dot(body.axis());
  return kindOf(found.shape) == body.kind && !found.concave &&
         std::abs(found.extent.rotation.col(2).dot(body.axis())) > 0.98 &&
         (from_begin - along * body.axis()).norm() < 0.015 && along > 0.0 && along < (body.end - body.begin).norm();
}

void addGaps(const TrueBody& body, const Detection& found, std::vector<EndGap>& gaps) {
  const Vec3 axis = found.extent.rotation.col(2);
  const double begin = axis.dot(body.begin - found.extent.origin), end = axis.dot(body.end - found.extent.origin);
  const double half = 0.5 * found.extent.size.z();
  const std::uint8_t unseen = found.extent.unseen_ends;
  gaps.push_back({std::max(begin, end) - half, (unseen & kEndAtPlusZ) != 0});
  gaps.push_back({-half - std::min(begin, end), (unseen & kEndAtMinusZ) != 0});
}

/// Of rods and frusta on tables of these seeds.
std::vector<EndGap> gapsOnTables(std::uint64_t first, std::uint64_t end) {
  std::vector<EndGap> gaps;
  for (std::uint64_t seed = first; seed < end; ++seed) {
    const test::TableFrame table(seed);
    const synthetic::World world = synthetic::clutteredTable(seed);
    for (const synthetic::Body& body : world.bodies()) {
      const std::optional<TrueBody> truth = trueBody(body, synthetic::clutterPose(seed).inverse());
      if (!truth) continue;
      for (const Detection& found : table.found.items) {
        if (isOn(*truth, found)) addGaps(*truth, found, gaps);
      }
    }
  }
  return gaps;
}

/// How many of these ends fall short of the body's by more than this (m); where it is negative, go so far beyond it.
std::size_t countShort(double gap, const std::vector<EndGap>& ends) {
  const auto is_short = [gap](const EndGap& end) { return gap < 0.0 ? end.gap < gap : end.gap > gap; };
  return static_cast<std::size_t>(std::count_if(ends.begin(), ends.end(), is_short));
}

TEST(UnseenEnds, AreThoseWhereABodyGoesOn) {
  std::vector<EndGap> seen, unseen;
  for (const EndGap& end : gapsOnTables(2500, 2540)) (end.unseen ? unseen : seen).push_back(end);
  for (const auto& [name, ends] : {std::pair("seen", &seen), std::pair("not seen", &unseen)}) {
    std::printf("%zu ends told to be %s: %zu short by more than 10 mm, %zu beyond by as much\n", ends->size(), name,
                countShort(0.01, *ends), countShort(-0.01, *ends));
  }
  EXPECT_GT(seen.size(), 80u);
  EXPECT_LE(countShort(0.01, seen) + countShort(-0.01, seen), seen.size() / 25);
  EXPECT_GE(countShort(0.02, unseen), 2u);
  EXPECT_LE(unseen.size(), seen.size() / 10);
}

/// Along z from -0.1 to 0.1 m.
Extent rodOfTwentyCentimetres() {
  Extent extent;
  extent.size.z() = 0.2;
  return extent;
}

TEST(UnseenEnds, AreToldByWalksAlongTheAxisFromNearThem) {
  const Extent extent = rodOfTwentyCentimetres();
  const Vec3 up(0.0, 0.0, 0.002), across(0.002, 0.0, 0.001), near_top(0.0, 0.05, 0.08), near_foot(0.0, 0.05, -0.08);
  UnseenEnds ends(Kind::cylinder, extent);
  EXPECT_EQ(ends.bits(), kEndAtMinusZ | kEndAtPlusZ) << "nobody looked";
  ends.add(near_top, up, 0);
  EXPECT_EQ(ends.bits(), kEndAtMinusZ);
  ends.add(near_foot, -up, 0);
  EXPECT_EQ(ends.bits(), 0);
  for (int k = 0; k < 5; ++k) {
    ends.add(near_top, across, kTruncatedByImage);          // to the side
    ends.add(Vec3(0.0, 0.05, 0.0), up, kTruncatedByImage);  // from the middle
    ends.add(near_foot, up, kTruncatedByImage);             // away from it
    ends.add(near_foot, Vec3::Zero(), kTruncatedByImage);
  }
  EXPECT_EQ(ends.bits(), 0);
  EXPECT_EQ(ends.cutOffBy(), 0);
  ends.add(near_foot, -up, kTruncatedByDepth);
  EXPECT_EQ(ends.bits(), kEndAtMinusZ) << "half of its walks";
  EXPECT_EQ(ends.cutOffBy(), kTruncatedByDepth);
  ends.add(near_foot, -up, 0);
  EXPECT_EQ(ends.bits(), 0);
  EXPECT_EQ(ends.cutOffBy(), 0) << "seen by most";
}

/// Whether a walk from there, in steps of 2 mm at this angle to the axis (deg), tells of the end at +z.
bool tells(const Extent& extent, const Vec3& from, double degrees) {
  UnseenEnds ends(Kind::cylinder, extent);
  ends.add(from, 0.002 * Vec3(std::sin(degrees * M_PI / 180.0), 0.0, std::cos(degrees * M_PI / 180.0)), 0);
  return !(ends.bits() & kEndAtPlusZ);
}

TEST(UnseenEnds, AreToldByStepsThatGoAlongTheAxisMoreThanAcross) {
  const Vec3 near_top(0.0, 0.05, 0.09);
  EXPECT_TRUE(tells(rodOfTwentyCentimetres(), near_top, 40.0));
  EXPECT_FALSE(tells(rodOfTwentyCentimetres(), near_top, 50.0));
}

TEST(UnseenEnds, OfAPlaneAreThoseOfItsLongerSide) {
  for (const int longer : {0, 1}) {
    Extent extent;
    extent.size = Vec3(0.1, 0.1, 0.0);
    extent.size[longer] = 0.5;
    UnseenEnds ends(Kind::plane, extent);
    const Vec3 along = Vec3::Unit(longer), across = Vec3::Unit(1 - longer);
    ends.add(0.05 * across, 0.002 * across, kTruncatedByOcclusion);
    EXPECT_EQ(ends.cutOffBy(), 0);
    ends.add(-0.24 * along, -0.002 * along, kTruncatedByImage);
    EXPECT_EQ(ends.cutOffBy(), kTruncatedByImage);
  }
}

TEST(UnseenEnds, OfAThingOfFewPixelsAreWithinThreeOfThem) {
  Extent of_ten_pixels;
  of_ten_pixels.size.z() = 0.02;
  EXPECT_TRUE(tells(of_ten_pixels, Vec3(0.0, 0.01, 0.01 - 0.0055), 0.0));
  EXPECT_FALSE(tells(of_ten_pixels, Vec3(0.0, 0.01, 0.01 - 0.0065), 0.0));
}

}  // namespace
}  // namespace primitect::unseen_ends_test
