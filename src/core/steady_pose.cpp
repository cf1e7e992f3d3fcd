// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Half turns of cylinders, rectangles around planes; see steady_pose.h.
#include "primitect/steady_pose.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "core/hull.h"

namespace primitect {
namespace {

/// Of sides, and of areas of rectangles.
constexpr double kAlike = 1.25;

/// About x: the side that was seen stays where it is.
void turnRound(Extent& extent) {
  extent.rotation.rightCols<2>() *= -1.0;
  const unsigned ends = extent.unseen_ends;
  const unsigned turned = (ends & kEndAtMinusZ) << 1 | (ends & kEndAtPlusZ) >> 1;
  extent.unseen_ends = static_cast<std::uint8_t>((ends & kEndsUnknown) | turned);
  std::swap(extent.face_at_minus_z, extent.face_at_plus_z);
}

Vec2 quarterTurn(const Vec2& direction) { return {-direction.y(), direction.x()}; }

bool areAlike(const Vec2& size) { return size.x() <= kAlike * size.y() && size.y() <= kAlike * size.x(); }

/// Of the rectangle around a plane's hull that its extent tells; all in the frame of that.
Rectangle sidesNear(const Vec2& before, const Vec2& size) {
  Rectangle sides = {Vec2::UnitX(), Vec2::Zero(), size};
  if (areAlike(size) && std::abs(before.y()) > std::abs(before.x()))
    sides = {Vec2::UnitY(), Vec2::Zero(), size.reverse()};
  if (sides.x.dot(before) < 0.0) sides.x = -sides.x;
  return sides;
}

/// Around the hull, in the frame of the extent.
Rectangle aroundHull(const Vec2& x, const Extent& extent) {
  const auto corner = [&extent](std::size_t k) -> Vec2 {
    return extent.rotation.leftCols<2>().transpose() * (extent.hull[k] - extent.origin);
  };
  return rectangleAlong(x, extent.hull.size(), corner);
}

/// What has no sides: no rectangle between them is much larger.
bool isRound(const Extent& extent) {
  constexpr double kEighth = M_PI / 8.0;
  const Vec2 size = extent.size.head<2>();
  if (extent.hull.empty() || !areAlike(size)) return false;
  for (const double turn : {kEighth, 2.0 * kEighth, 3.0 * kEighth}) {
    const Rectangle between = aroundHull({std::cos(turn), std::sin(turn)}, extent);
    if (between.size.prod() > kAlike * size.prod()) return false;
  }
  return true;
}

/// With x near the one before, a unit vector in the plane, in the frame of the extent.
Rectangle steadySides(const Vec2& before, const Extent& extent) {
  return isRound(extent) ? aroundHull(before, extent) : sidesNear(before, extent.size.head<2>());
}

void turnPlane(const Vec3& before, Extent& extent) {
  constexpr double kWithin = 0.5;  // of a direction that turned with the plane, in the plane
  const Eigen::Matrix<double, 3, 2> in_space = extent.rotation.leftCols<2>();
  const Vec2 in_plane = in_space.transpose() * before;
  if (!(in_plane.norm() >= kWithin)) return;
  const Rectangle sides = steadySides(in_plane.normalized(), extent);
  extent.origin += in_space * sides.middle;
  extent.rotation.col(0) = in_space * sides.x;
  extent.rotation.col(1) = in_space * quarterTurn(sides.x);
  extent.size.head<2>() = sides.size;
}

}  // namespace

Vec3 waveringDirection(Kind kind, const Extent& extent) {
  if (kind == Kind::cylinder) return extent.rotation.col(2);
  return kind == Kind::plane ? Vec3(extent.rotation.col(0)) : Vec3::Zero();
}

void turnAsBefore(Kind kind, const Vec3& before, Extent& extent) {
  if (kind == Kind::cylinder && extent.rotation.col(2).dot(before) < 0.0) turnRound(extent);
  if (kind == Kind::plane) turnPlane(before, extent);
}

}  // namespace primitect
