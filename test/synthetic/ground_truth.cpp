// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The written truth against the rendered points and against scenes with known numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "synthetic/outline.h"
#include "synthetic/tabletop.h"
#include "synthetic/truth.h"

namespace primitect::synthetic::ground_truth_test {
namespace {

const PinholeCamera kCamera;
const Eigen::Isometry3d kAtOrigin = Eigen::Isometry3d::Identity();
/// At 1 m a pixel is 1.75 mm wide; an extent may miss one at each end.
constexpr double kTwoPixels = 2.0 / 570.3;

struct Scene {
  World world;
  Rendering rendering;
  Detections truth;
  std::vector<int> surface_of_item;
};

Scene observe(World world, const Eigen::Isometry3d& pose, const TruthParams& params) {
  Scene scene{std::move(world), {}, {}, {}};
  render(scene.world, kCamera, pose, scene.rendering);
  scene.truth = truthOf(scene.world, kCamera, pose, scene.rendering, params, &scene.surface_of_item);
  return scene;
}

Scene observeOne(const Solid& solid, const Eigen::Isometry3d& pose) {
  World world;
  world.add("body", solid, pose);
  return observe(std::move(world), kAtOrigin, {DepthRange{}, 900});
}

Eigen::Isometry3d at(double x, double y, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

Vec3 pointAt(const Scene& scene, std::size_t i) {
  const Vec3 ray = kCamera.ray(static_cast<double>(i % kCamera.width), static_cast<double>(i / kCamera.width));
  return ray * static_cast<double>(scene.rendering.depth[i]);
}

TEST(Truth, ShapesAgreeWithThePointsOfTheirSurface) {
  for (int seed = 1; seed <= 4; ++seed) {
    const Scene scene = observe(tabletop(seed), cameraPose(7.0 * seed), {});
    ASSERT_GE(scene.truth.items.size(), 7u);
    for (std::size_t item = 0; item < scene.truth.items.size(); ++item) {
      const Shape& shape = scene.truth.items[item].shape;
      std::uint32_t pixels = 0;
      for (std::size_t i = 0; i < kCamera.pixelCount(); ++i) {
        if (scene.rendering.surface[i] != scene.surface_of_item[item] || scene.rendering.depth[i] > 2.0f) continue;
        ASSERT_LT(std::abs(distance(shape, pointAt(scene, i))), 1e-5) << "seed " << seed << " item " << item;
        ++pixels;
      }
      EXPECT_EQ(scene.truth.items[item].inlier_count, pixels);
    }
  }
}

TEST(Truth, NormalsOfShapesAgreeWithTheSlopeOfTheDepthImage) {
  const int width = kCamera.width;
  int compared[kKindCount] = {};
  for (int seed = 1; seed <= 3; ++seed) {
    const Scene scene = observe(tabletop(seed), cameraPose(11.0 * seed), {});
    for (std::size_t item = 0; item < scene.truth.items.size(); ++item) {
      const int surface = scene.surface_of_item[item];
      const auto belongs = [&](std::size_t i) { return scene.rendering.surface[i] == surface; };
      for (std::size_t i = width; i + width < kCamera.pixelCount(); ++i) {
        if (!belongs(i) || !belongs(i - 1) || !belongs(i + 1) || !belongs(i - width) || !belongs(i + width)) continue;
        const Vec3 p = pointAt(scene, i);
        const Vec3 along_row = pointAt(scene, i + 1) - pointAt(scene, i - 1);
        const Vec3 along_column = pointAt(scene, i + width) - pointAt(scene, i - width);
        const Vec3 measured = along_column.cross(along_row).normalized();
        if (measured.dot(p.normalized()) > -0.6) continue;  // slanted: differences between pixels are too coarse
        const Cone* cone = std::get_if<Cone>(&scene.truth.items[item].shape);
        if (cone && (p - cone->apex).norm() < 0.03) continue;  // so they are next to the apex
        // Two pixels of a sphere of 40 mm span up to 10 deg; central differences err by less than a fifth of it.
        ASSERT_GT(measured.dot(normalAt(scene.truth.items[item].shape, p)), std::cos(2.0 * M_PI / 180.0));
        ++compared[scene.truth.items[item].shape.index()];
      }
    }
  }
  for (const int count : compared) EXPECT_GT(count, 1000);
}

TEST(Truth, KindsAreThoseOfTheObjects) {
  const Scene scene = observe(tabletop(3), cameraPose(5.0), {});
  std::vector<int> curved_bodies, found;
  for (const Surface& surface : scene.world.surfaces()) {
    if (kindOf(surface.shape) != Kind::plane) curved_bodies.push_back(surface.body);
  }
  for (std::size_t item = 0; item < scene.truth.items.size(); ++item) {
    const Surface& surface = scene.world.surfaces()[scene.surface_of_item[item]];
    EXPECT_EQ(kindOf(scene.truth.items[item].shape), kindOf(surface.shape));
    if (kindOf(surface.shape) != Kind::plane) found.push_back(surface.body);
  }
  EXPECT_EQ(found, curved_bodies);
}

TEST(Truth, DepthCutAtTwoMetresRemovesFloorAndWall) {
  for (double seconds = 0.0; seconds < 60.0; seconds += 6.1) {
    const Scene cut = observe(tabletop(2), cameraPose(seconds), {DepthRange{0.1f, 2.0f}, 900});
    const Scene whole = observe(tabletop(2), cameraPose(seconds), {DepthRange{}, 900});
    for (const int surface : cut.surface_of_item) EXPECT_GT(surface, 1);
    EXPECT_EQ(whole.surface_of_item[0], 0);
    EXPECT_EQ(whole.surface_of_item[1], 1);
    EXPECT_LT(cut.truth.points_used, whole.truth.points_used);
    EXPECT_EQ(cut.truth.points_in, kCamera.pixelCount());
  }
}

TEST(Truth, SurfacesWithTooFewPixelsAreLeftOut) {
  World world;
  world.add("ball", Ball{0.03}, at(0.0, 0.0, 1.0));
  const Scene scene = observe(world, kAtOrigin, {DepthRange{}, 1});
  ASSERT_EQ(scene.truth.items.size(), 1u);
  const std::uint32_t pixels = scene.truth.items[0].inlier_count;
  // The outline of a sphere at distance d has the half angle asin(r / d).
  EXPECT_NEAR(pixels, M_PI * std::pow(570.3 * std::tan(std::asin(0.03)), 2), 30);
  EXPECT_EQ(observe(world, kAtOrigin, {DepthRange{}, pixels}).truth.items.size(), 1u);
  EXPECT_EQ(observe(world, kAtOrigin, {DepthRange{}, pixels + 1}).truth.items.size(), 0u);
  EXPECT_EQ(observe(World{}, kAtOrigin, {DepthRange{}, 0}).truth.items.size(), 0u);
}

TEST(Truth, PlaneExtentIsTheRectangleWithItsNormalToTheSensor) {
  for (const double turn : {0.0, 0.4, 1.2, M_PI}) {  // half a turn about x shows the sheet's other side
    const Eigen::Isometry3d pose = at(0.05, -0.02, 1.0) * Eigen::AngleAxisd(turn == M_PI ? M_PI : 0.0, Vec3::UnitX()) *
                                   Eigen::AngleAxisd(turn == M_PI ? 0.0 : turn, Vec3::UnitZ());
    const Scene scene = observeOne(Sheet{0.2, 0.1}, pose);
    ASSERT_EQ(scene.truth.items.size(), 1u);
    const Extent& extent = scene.truth.items[0].extent;
    const Vec3 normal = std::get<Plane>(scene.truth.items[0].shape).normal;
    EXPECT_NEAR(extent.size.x(), 0.4, 2 * kTwoPixels);
    EXPECT_NEAR(extent.size.y(), 0.2, 2 * kTwoPixels);
    EXPECT_LT((extent.origin - pose.translation()).norm(), kTwoPixels);
    EXPECT_NEAR(std::abs(extent.rotation.col(0).dot(pose.linear().col(0))), 1.0, 1e-4);
    EXPECT_LT(normal.z(), -0.999);
    EXPECT_TRUE(extent.rotation.col(2).isApprox(normal));
    EXPECT_NEAR(extent.rotation.determinant(), 1.0, 1e-9);
  }
}

TEST(Truth, PlaneHullIsConvexAndCounterClockwiseSeenFromTheSensor) {
  const Eigen::Isometry3d pose = at(0.0, 0.0, 1.0) * Eigen::AngleAxisd(0.7, Vec3(1.0, 0.5, 0.3).normalized());
  const Scene scene = observeOne(Sheet{0.2, 0.1}, pose);
  ASSERT_EQ(scene.truth.items.size(), 1u);
  const std::vector<Vec3>& hull = scene.truth.items[0].extent.hull;
  const Plane plane = std::get<Plane>(scene.truth.items[0].shape);
  ASSERT_GE(hull.size(), 4u);
  Vec3 doubled_area = Vec3::Zero();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec3& a = hull[i];
    const Vec3& b = hull[(i + 1) % hull.size()];
    const Vec3& c = hull[(i + 2) % hull.size()];
    EXPECT_LT(std::abs(distance(plane, a)), 1e-9);
    EXPECT_GT((b - a).cross(c - b).dot(plane.normal), 0.0);
    doubled_area += a.cross(b);
  }
  // The outermost pixel centres are within the sheet, each side up to a pixel short.
  EXPECT_NEAR(doubled_area.dot(plane.normal) / 2, 0.4 * 0.2, 0.6 * kTwoPixels * 2);
  EXPECT_LE(doubled_area.dot(plane.normal) / 2, 0.4 * 0.2);
}

TEST(Truth, CylinderExtentIsThePartInTheImage) {
  const Eigen::AngleAxisd along_x(M_PI / 2, Vec3::UnitY());
  const Scene whole = observeOne(Rod{0.05, 0.2}, at(0.0, 0.1, 1.0) * along_x);
  ASSERT_EQ(whole.truth.items.size(), 1u);
  EXPECT_NEAR(whole.truth.items[0].extent.size.z(), 0.4, kTwoPixels);
  EXPECT_LT((whole.truth.items[0].extent.origin - Vec3(0.0, 0.1, 1.0)).norm(), kTwoPixels);
  EXPECT_DOUBLE_EQ(whole.truth.items[0].extent.radius, 0.05);

  // Moved so that the image's right border, at x / z = 319.5 / 570.3, cuts it.
  const Scene cut = observeOne(Rod{0.05, 0.2}, at(0.5, 0.0, 1.0) * along_x);
  ASSERT_GE(cut.truth.items.size(), 1u);
  const Extent& extent = cut.truth.items[0].extent;
  const double visible_end = 319.5 / 570.3;  // where the outline, at z of about 1, leaves the image
  EXPECT_NEAR(extent.origin.x() + extent.size.z() / 2, visible_end, kTwoPixels);
  EXPECT_NEAR(extent.origin.x() - extent.size.z() / 2, 0.3, kTwoPixels);
}

TEST(Truth, ConeExtentGivesTheRadiiOfItsEnds) {
  const Eigen::AngleAxisd along_x(M_PI / 2, Vec3::UnitY());
  const Scene scene = observeOne(Frustum{0.3, 0.1, 0.3}, at(-0.2, 0.0, 1.0) * along_x);
  ASSERT_GE(scene.truth.items.size(), 1u);
  const Detection& detection = scene.truth.items[0];
  EXPECT_NEAR(detection.extent.radius, 0.3 * std::tan(0.3), kTwoPixels);
  EXPECT_NEAR(detection.extent.radius_small, 0.1 * std::tan(0.3), kTwoPixels);
  EXPECT_NEAR(detection.extent.size.z(), 0.2, kTwoPixels);
  EXPECT_LT((detection.extent.origin - Vec3(0.0, 0.0, 1.0)).norm(), kTwoPixels);
  EXPECT_TRUE(std::get<Cone>(detection.shape).axis.isApprox(Vec3::UnitX(), 1e-12));
  EXPECT_TRUE(std::get<Cone>(detection.shape).apex.isApprox(Vec3(-0.2, 0.0, 1.0), 1e-12));
  EXPECT_TRUE(detection.extent.rotation.col(2).isApprox(Vec3::UnitX(), 1e-12));
}

TEST(Truth, MissingPixelsDoNotCount) {
  World world;
  world.add("ball", Ball{0.1}, at(0.0, 0.0, 1.0));
  Rendering rendering;
  render(world, kCamera, kAtOrigin, rendering);
  const auto pixels = [&] {
    const Detections truth = truthOf(world, kCamera, kAtOrigin, rendering, {DepthRange{}, 1});
    return truth.items.empty() ? 0u : truth.items[0].inlier_count;
  };
  const std::uint32_t before = pixels();
  const std::size_t center = kCamera.pixelCount() / 2 + kCamera.width / 2;
  rendering.depth[center] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(pixels(), before - 1);
}

TEST(Outline, HullHasTheCornersOnlyAndGoesRoundCounterClockwise) {
  const std::vector<Pixel> hull = convexHull({{0, 0}, {4, 0}, {2, 0}, {4, 2}, {0, 2}, {2, 1}, {0, 1}, {4, 0}});
  ASSERT_EQ(hull.size(), 4u);
  int doubled_area = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Pixel& a = hull[i];
    const Pixel& b = hull[(i + 1) % 4];
    doubled_area += a.u * b.v - a.v * b.u;
  }
  EXPECT_EQ(doubled_area, -16) << "clockwise in u, v is counter-clockwise as seen, as v points down";
  EXPECT_LT(convexHull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 3u);
  EXPECT_TRUE(convexHull({}).empty());
}

TEST(Outline, SmallestRectangleFollowsATurnedOne) {
  const Eigen::Rotation2Dd turn(0.3);
  std::vector<Eigen::Vector2d> outline;
  for (const auto& corner :
       {Eigen::Vector2d(-2, -1), Eigen::Vector2d(2, -1), Eigen::Vector2d(2, 1), Eigen::Vector2d(-2, 1)}) {
    outline.push_back(turn * corner + Eigen::Vector2d(5.0, 6.0));
  }
  const Rectangle rectangle = smallestRectangle(outline);
  EXPECT_NEAR(rectangle.size_x, 4.0, 1e-12);
  EXPECT_NEAR(rectangle.size_y, 2.0, 1e-12);
  EXPECT_LT((rectangle.center - Eigen::Vector2d(5.0, 6.0)).norm(), 1e-12);
  EXPECT_NEAR(std::abs(rectangle.x_axis.dot(turn * Eigen::Vector2d::UnitX())), 1.0, 1e-12);
}

}  // namespace
}  // namespace primitect::synthetic::ground_truth_test
