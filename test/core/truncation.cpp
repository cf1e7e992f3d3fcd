// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Rendered frames in which something ends by the image border, by the depth cut, behind another, or on its own.
#include "core/truncation.h"

#include <gtest/gtest.h>

#include "core/extent.h"
#include "core/random.h"
#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/scene_layout.h"
#include "synthetic/tabletop.h"

namespace primitect::truncation_test {
namespace {

using synthetic::Box;
using synthetic::PinholeCamera;
using synthetic::Rod;
using synthetic::World;

/// A world seen by a camera, with noise, and which of the surfaces are asked for.
struct View {
  World world;
  Eigen::Isometry3d pose = synthetic::lookAt(Vec3(-1.0, 0.0, 0.5), Vec3::Zero());
  DepthRange range = {0.1f, 2.0f};
  std::uint64_t seed = 1;
  PinholeCamera camera;
  bool border_known = true;
  synthetic::Frame frame;
  Cloud cloud;

  void render() {
    synthetic::FrameParams params;
    params.truth.range = range;
    frame = synthetic::renderFrame(world, camera, pose, params, seed, 0);
    synthetic::cloudFromDepth(frame.depth, camera, range, cloud);
  }

  /// One in forty of the surface's pixels, as samples are.
  List<std::uint32_t> samplesOf(int surface) const {
    Random random(seed);
    List<std::uint32_t> samples;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (frame.surface[i] == surface && cloud.valid(i) && random.below(40) == 0) {
        samples.push_back(static_cast<std::uint32_t>(i));
      }
    }
    return samples;
  }

  Shape shape(int surface) const {
    return transformed(pose.inverse(), world.surfaces()[static_cast<std::size_t>(surface)].shape);
  }

  Truncated truncated(int surface) const {
    const List<std::uint32_t> samples = samplesOf(surface);
    std::vector<Vec3> points;
    for (const std::uint32_t i : samples) points.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
    const auto noise = [](const Vec3& p) { return std::max(synthetic::axialSigma(p.z()), 0.003 * p.z()); };
    ImageRays rays = findRays(cloud);
    rays.border_known = border_known;
    const TruncationFinder finder(cloud, rays, range, noise);
    return finder.find(shape(surface), measureExtent(shape(surface), points), samples);
  }
  int truncationOf(int surface) const { return truncated(surface).by; }
};

Eigen::Isometry3d at(double x, double y, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

/// Its top is the plane z = 0, surface 5 of the body.
int addTable(World& world, double half_x = 0.4, double half_y = 0.4) {
  const int body = world.add("table", Box{half_x, half_y, 0.01}, at(0, 0, -0.01));
  return world.bodies()[static_cast<std::size_t>(body)].first_surface + 5;
}

/// A standing can of 5 cm radius; its mantle.
int addCan(World& world, double x, double y, double half_length = 0.08) {
  const int body = world.add("can", Rod{0.05, half_length}, at(x, y, half_length));
  return world.bodies()[static_cast<std::size_t>(body)].first_surface;
}

int addBall(World& world, double x, double y, double radius) {
  const int body = world.add("ball", synthetic::Ball{radius}, at(x, y, radius));
  return world.bodies()[static_cast<std::size_t>(body)].first_surface;
}

TEST(Truncation, OfThingsThatStandFreeIsNone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    View view;
    view.seed = seed;
    const int table = addTable(view.world), can = addCan(view.world, 0.0, 0.15),
              ball = addBall(view.world, 0, -0.1, 0.06);
    const int cone = view.world.surfaces().size();
    view.world.add("cone", synthetic::Frustum{0.35, 0.0, 0.15},
                   at(0.1, 0.0, 0.15) * Eigen::AngleAxisd(M_PI, Vec3::UnitX()));
    view.render();
    EXPECT_EQ(view.truncationOf(table), 0) << seed;
    EXPECT_EQ(view.truncationOf(can), 0) << seed;
    EXPECT_EQ(view.truncationOf(ball), 0) << seed;
    for (const int surface : {table, can, ball, cone}) EXPECT_EQ(view.truncated(surface).unseen_ends, 0) << seed;
    EXPECT_EQ(view.truncationOf(cone), 0) << seed;
  }
}

TEST(Truncation, OfABallHalfOutOfTheImageIsByTheImage) {
  // The camera looks along +x, so that +y is to the left; at 1.1 m the image is 1.25 m wide.
  for (const double y : {0.6, -0.6}) {
    View view;
    const int ball = addBall(view.world, 0.0, y, 0.1);
    addTable(view.world, 0.8, 0.8);
    view.render();
    EXPECT_EQ(view.truncationOf(ball), kTruncatedByImage) << y;
  }
}

TEST(Truncation, AtTheEndOfAListIsUnknown) {
  View view;
  view.border_known = false;
  const int out = addBall(view.world, 0.0, 0.6, 0.1), inside = addBall(view.world, 0.0, 0.2, 0.1);
  addTable(view.world, 0.8, 0.8);
  view.render();
  EXPECT_EQ(view.truncationOf(out) & kTruncationUnknown, kTruncationUnknown);
  EXPECT_EQ(view.truncationOf(inside), 0);
}

/// Of 24 walks across it and along it one or two come to the border.
TEST(Truncation, OfAPipeThatRunsSlantwiseOutOfTheImageIsByTheImage) {
  for (const double turn : {0.5, -0.5}) {  // rad
    View view;
    addTable(view.world, 0.8, 0.8);
    const int pipe = view.world.add(
        "pipe", Rod{0.03, 0.5},
        at(0.0, 0.4, 0.03) * Eigen::AngleAxisd(turn, Vec3::UnitZ()) * Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitX()));
    view.render();
    const int mantle = view.world.bodies()[static_cast<std::size_t>(pipe)].first_surface;
    EXPECT_EQ(view.truncationOf(mantle), kTruncatedByImage) << turn;
    // z of the pipe, -y of the world before it is turned, points to the right.
    EXPECT_EQ(view.truncated(mantle).unseen_ends, kEndAtMinusZ) << turn;
  }
}

TEST(Truncation, OfATableThatLeavesTheImageIsByTheImage) {
  View view;
  view.range.max = 0.0f;
  const int table = addTable(view.world, 0.9, 0.9);
  view.render();
  EXPECT_EQ(view.truncationOf(table) & ~kTruncatedByDepth, kTruncatedByImage);
}

/// Of some four dozen walks two go along it.
TEST(Truncation, OfAPlankThatRunsSlantwiseThroughTheImageIsByTheImage) {
  for (const double yaw : {-0.4, -0.2, 0.2, 0.4}) {
    for (const double half_length : {2.0, 0.3}) {
      View view;
      const int plank = static_cast<int>(view.world.surfaces().size()) + 5;
      view.world.add("plank", Box{0.035, half_length, 0.01}, at(0, 0, 0) * Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
      view.render();
      ASSERT_GT(view.samplesOf(plank).size(), 50u);
      EXPECT_EQ(view.truncationOf(plank), half_length > 1.0 ? kTruncatedByImage : 0) << yaw << " " << half_length;
    }
  }
}

TEST(Truncation, OfATableBeyondTheDepthCutIsByTheDepth) {
  View view;
  const int table = addTable(view.world, 0.55, 0.3);
  view.range.max = 1.2f;
  view.render();
  EXPECT_EQ(view.truncationOf(table), kTruncatedByDepth);
  view.range = {1.0f, 2.0f};
  view.render();
  EXPECT_EQ(view.truncationOf(table), kTruncatedByDepth);
}

TEST(Truncation, OfATableThatEndsBeforeTheDepthCutIsNone) {
  View view;
  const int table = addTable(view.world, 0.3, 0.3);
  view.range.max = 1.6f;  // the table ends at 1.36 m
  view.render();
  EXPECT_EQ(view.truncationOf(table), 0);
}

TEST(Truncation, OfACanBehindAnotherIsByOcclusion) {
  for (const double y : {0.05, -0.05, 0.0}) {
    for (const double distance : {0.15, 0.25}) {
      View view;
      addTable(view.world);
      const int front = addCan(view.world, -0.1, y, 0.05), behind = addCan(view.world, distance - 0.1, 0.0, 0.1);
      view.render();
      EXPECT_EQ(view.truncationOf(behind), kTruncatedByOcclusion) << y << " " << distance;
      EXPECT_EQ(view.truncationOf(front), 0) << y << " " << distance;
    }
  }
}

TEST(Truncation, OfACanBehindABoxLeavesItsFootUnseen) {
  for (const double side : {-0.04, 0.0, 0.04}) {  // m: part of its left, all, part of its right
    View view;
    addTable(view.world);
    view.world.add("box", Box{0.02, 0.06, 0.04}, at(-0.1, side, 0.04));
    const int can = addCan(view.world, 0.0, 0.0);
    view.render();
    EXPECT_EQ(view.truncationOf(can), kTruncatedByOcclusion) << side;
    EXPECT_EQ(view.truncated(can).unseen_ends, side == 0.0 ? kEndAtMinusZ : 0) << side;
  }
}

/// Its z downwards, the origin so high (m).
Eigen::Isometry3d upsideDown(double height) {
  Eigen::Isometry3d pose = at(0.0, 0.0, height);
  pose.rotate(Eigen::AngleAxisd(M_PI, Vec3::UnitX()));
  return pose;
}

TEST(Truncation, OfAConeBehindABarThatHidesItsTipIsByOcclusion) {
  View view;
  addTable(view.world);
  const int body = view.world.add("cone", synthetic::Frustum{0.3, 0.0, 0.3}, upsideDown(0.3));
  const int cone = view.world.bodies()[static_cast<std::size_t>(body)].first_surface;
  view.world.add("bar", Box{0.01, 0.3, 0.03}, at(-0.2, 0.0, 0.335));  // the last 5 cm
  view.render();
  EXPECT_EQ(view.truncationOf(cone), kTruncatedByOcclusion);
  EXPECT_EQ(view.truncated(cone).unseen_ends, kEndAtMinusZ);
}

TEST(Truncation, OfABallBehindACanIsByOcclusion) {
  View view;
  addTable(view.world);
  addCan(view.world, -0.15, 0.04);
  const int ball = addBall(view.world, 0.15, 0.0, 0.07);
  view.render();
  EXPECT_EQ(view.truncationOf(ball), kTruncatedByOcclusion);
}

TEST(Truncation, OfABoxIsNoneThoughItsFacesMeetEachOtherAndTheTable) {
  for (const double yaw : {0.0, 0.4, 0.8}) {
    View view;
    addTable(view.world);
    const int box = static_cast<int>(view.world.surfaces().size());
    view.world.add("box", Box{0.08, 0.1, 0.07}, at(0, 0, 0.07) * Eigen::AngleAxisd(yaw, Vec3::UnitZ()));
    view.render();
    for (int side = 0; side < 6; ++side) {
      if (view.samplesOf(box + side).size() >= 20) {
        EXPECT_EQ(view.truncationOf(box + side), 0) << yaw << " " << side;
      }
    }
  }
}

TEST(Truncation, OfTheInsideOfABowlIsByItsOwnNearWall) {
  View view;
  addTable(view.world);
  const int bowl = static_cast<int>(view.world.surfaces().size());
  view.world.add("bowl", synthetic::Bowl{0.1, 0.09, 0.0, -0.095}, at(0, 0, 0.095));
  view.render();
  EXPECT_EQ(view.truncationOf(bowl), 0);
  EXPECT_EQ(view.truncationOf(bowl + 1), kTruncatedByOcclusion);
}

TEST(Truncation, WithoutAnImageOnlyTheDepthIsKnown) {
  View view;
  const int table = addTable(view.world, 0.55, 0.3);
  for (const float far : {1.2f, 2.0f}) {
    view.range.max = far;
    view.render();
    std::swap(view.cloud.width, view.cloud.height);
    view.cloud.width = static_cast<std::uint32_t>(view.cloud.size());
    view.cloud.height = 1;
    EXPECT_EQ(view.truncationOf(table), far == 1.2f ? kTruncationUnknown + kTruncatedByDepth : kTruncationUnknown);
  }
}

TEST(Truncation, OfAShuffledImageIsUnknown) {
  View view;
  const int table = addTable(view.world), can = addCan(view.world, 0.0, 0.0);
  view.render();
  Random random(5);
  for (std::size_t i = view.cloud.size() - 1; i > 0; --i) {
    const std::size_t k = random.below(i + 1);
    std::swap(view.cloud.x[i], view.cloud.x[k]);
    std::swap(view.cloud.y[i], view.cloud.y[k]);
    std::swap(view.cloud.z[i], view.cloud.z[k]);
    std::swap(view.frame.surface[i], view.frame.surface[k]);
  }
  EXPECT_EQ(view.truncationOf(table), kTruncationUnknown);
  EXPECT_EQ(view.truncated(table).unseen_ends, 0) << "has no axis";
  EXPECT_EQ(view.truncated(can).unseen_ends, kEndsUnknown);
}

TEST(ImageRays, AreThoseOfTheCamera) {
  View view;
  addTable(view.world);
  view.render();
  const ImageRays rays = findRays(view.cloud);
  ASSERT_TRUE(rays.known);
  for (const auto& [column, row] : {std::pair(0, 0), std::pair(639, 479)}) {
    EXPECT_LT((rays.through(column, row) - view.camera.ray(column, row)).norm(), 1e-5);
  }
}

TEST(PixelPitch, IsOnePixelOfTheCamera) {
  View view;
  addTable(view.world);
  view.render();
  const PixelPitch pitch = pitchOf(findRays(view.cloud));
  const Vec3 here = view.camera.ray(320, 240), next = view.camera.ray(321, 241);
  // A window of 15 pixels is then as wide as it should be to a thousandth of a pixel.
  EXPECT_NEAR(pitch.u, next.x() / next.z() - here.x() / here.z(), 1e-4 * pitch.u);
  EXPECT_NEAR(pitch.v, next.y() / next.z() - here.y() / here.z(), 1e-4 * pitch.v);
}

TEST(PixelPitch, IsUnknownWhereRaysAreOffByATenthOfAPixelOrThereAreNone) {
  View view;
  addTable(view.world);
  view.render();
  Random random(3);
  const double pixel = findRays(view.cloud).x_scale;
  Cloud moved = view.cloud;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved.x[i] += static_cast<float>(0.1 * pixel * random.gaussian()) * moved.z[i];
  }
  EXPECT_TRUE(findRays(moved).known);
  EXPECT_EQ(pitchOf(findRays(moved)).u, 0.0);
  Cloud flattened = view.cloud;
  flattened.width *= flattened.height, flattened.height = 1;
  EXPECT_EQ(pitchOf(findRays(flattened)).u, 0.0);
}

TEST(ImageRays, EndWhereTheSensorMeasuresNothing) {
  View view;
  addTable(view.world, 1.0, 1.0);
  view.range.max = 0.0f;
  view.render();
  for (std::size_t i = 0; i < view.cloud.size(); ++i) {
    if (i % 640 < 8 || i % 640 >= 630) view.cloud.x[i] = view.cloud.y[i] = view.cloud.z[i] = std::nanf("");
  }
  const ImageRays rays = findRays(view.cloud);
  EXPECT_EQ(rays.first_column, 8);
  EXPECT_EQ(rays.last_column, 629);
  EXPECT_EQ(rays.last_row, 479);
}

}  // namespace
}  // namespace primitect::truncation_test
