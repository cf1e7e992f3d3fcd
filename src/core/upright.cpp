// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits about a given axis; see upright.h.
#include "core/upright.h"

#include <cmath>

#include "core/fitting.h"
#include "core/seen_side.h"

namespace primitect {
namespace {

/// Rad. Fits to what stands are off by less, most of them.
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

RefineRules aboutThisAxis() {
  RefineRules rules;
  rules.small_step = 0.02;
  rules.hold_axis = true;
  return rules;
}

/// The cylinder about this axis through the middle of the seen side, as round there.
Cylinder cylinderAbout(const Vec3& axis, const SeenSide& side) {
  const Vec3 outward = (side.outward - side.outward.dot(axis) * axis).normalized();
  return {side.point - side.radius * outward, axis, side.radius};
}

/// The cone about this axis through the middle of the seen side, as round there.
Cone coneAbout(const Vec3& axis, const SeenSide& side, double half_angle) {
  const Vec3 outward = (side.outward - side.outward.dot(axis) * axis).normalized();
  const double radius = side.radius * std::cos(half_angle);
  return {side.point - radius * outward - radius / std::tan(half_angle) * axis, axis, half_angle};
}

}  // namespace

std::optional<Shape> uprightShape(const Shape& found, const Vec3& face_normal, Leaning leaning, const FitPoints& points,
                                  const Limits& limits) {
  constexpr double kTaper = 0.1;                                   // rad, where fits start
  constexpr double kPriceOfTaper = 0.002, kPriceOfLeaning = 0.02;  // of the points
  const auto middle = middleOf(found, points.middle());
  if (!middle) return std::nullopt;
  const Vec3 axis = middle->axis.dot(face_normal) < 0.0 ? Vec3(-face_normal) : face_normal;
  if (leaning == Leaning::clear && middle->axis.cross(axis).norm() < std::sin(kLeans)) return std::nullopt;
  const double count = static_cast<double>(points.size());
  double most = agreement(found, points) - kPriceOfLeaning * count;
  std::optional<Shape> best;
  const auto compare = [&](const Shape& start, double price) {
    const std::optional<Shape> fit = refine(start, points, aboutThisAxis());
    if (!fit || !limits.hold(*fit)) return;
    const double worth = agreement(*fit, points) - price * count;
    if (worth < most) return;
    most = worth;
    best = fit;
  };
  compare(cylinderAbout(axis, middle->side), 0.0);
  for (const double way : {-1.0, 1.0}) compare(coneAbout(way * axis, middle->side, kTaper), kPriceOfTaper);
  return best;
}

}  // namespace primitect
