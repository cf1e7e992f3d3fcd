// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits about a given axis; see upright.h.
#include "core/upright.h"

#include <cmath>

#include "core/dense_fit.h"
#include "core/fitting.h"
#include "core/seen_side.h"

namespace primitect {
namespace {

/// Rad. Most fits to what stands lean by less.
constexpr double kLeans = 2.5 * M_PI / 180.0;

/// Where the surface is in the middle of what was seen, and which way the axis goes; nothing for other kinds.
struct Middle {
  SeenSide side;
  Vec3 axis;
};
std::optional<Middle> middleOf(const Shape& shape, const Vec3& of_points) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    return Middle{seenSide(*cylinder, of_points), cylinder->axis};
  }
  const Cone* cone = std::get_if<Cone>(&shape);
  const auto side = cone ? seenSide(*cone, of_points) : std::nullopt;
  return side ? std::optional<Middle>({*side, cone->axis}) : std::nullopt;
}

/// Away from an axis of this direction, in the middle of the seen side.
Vec3 outwardFrom(const Vec3& axis, const SeenSide& side) {
  return (side.outward - side.outward.dot(axis) * axis).normalized();
}

/// The cylinder and the cone about this axis through the middle of the seen side, as round there.
Cylinder cylinderAbout(const Vec3& axis, const SeenSide& side) {
  return {side.point - side.radius * outwardFrom(axis, side), axis, side.radius};
}
Cone coneAbout(const Vec3& axis, const SeenSide& side, double half_angle) {
  const double radius = side.radius * std::cos(half_angle);
  return {side.point - radius * outwardFrom(axis, side) - radius / std::tan(half_angle) * axis, axis, half_angle};
}

}  // namespace

std::optional<Shape> uprightShape(const Shape& found, const Vec3& face_normal, Leaning leaning, const FitPoints& points,
                                  const Limits& limits) {
  constexpr double kTaper = 0.1;  // rad, where fits start
  // Of the points. With .02 of cans 12 cm high that really lean by 6 deg towards a camera 1.2 m away or from it, in
  // noise that five pixels share, 17 in 18 would be upright cones.
  constexpr double kPriceOfTaper = 0.002, kPriceOfLeaning = 0.01;
  if (points.size() == 0) return std::nullopt;
  const auto middle = middleOf(found, points.middle());
  if (!middle) return std::nullopt;
  if (leaning == Leaning::clear && middle->axis.cross(face_normal).norm() < std::sin(kLeans)) return std::nullopt;
  const double count = static_cast<double>(points.size());
  double most = agreement(found, points) - kPriceOfLeaning * count;
  std::optional<Shape> best;
  const auto compare = [&](const Shape& start, double price) {
    const std::optional<Shape> fit = refineDense(start, points, PointErrors::across, true);
    if (!fit || !limits.hold(*fit)) return;
    const double worth = agreement(*fit, points) - price * count;
    if (worth < most) return;
    most = worth;
    best = fit;
  };
  compare(cylinderAbout(face_normal, middle->side), 0.0);
  // Most fits that begin the wrong way turn round.
  for (const double way : {-1.0, 1.0}) compare(coneAbout(way * face_normal, middle->side, kTaper), kPriceOfTaper);
  return best;
}

}  // namespace primitect
