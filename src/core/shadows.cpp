// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A search for the lamp; see shadows.h.
#include "core/shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/ground.h"
#include "core/hidden_share.h"
#include "core/shadow_map.h"
#include "primitect/primitives.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

constexpr double kMostHidden = 0.03;  // behind edges, which noise and lenses blur

std::vector<Point> pointsOf(const Cloud& cloud) {
  std::vector<Point> points;
  points.reserve(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) points.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  return points;
}

struct Lamp {
  Point place;
  float misfit;
  bool operator<(const Lamp& other) const { return misfit < other.misfit; }
};

/// Around what stands there, up to 2.5 m from it.
std::vector<Lamp> manyLamps(ShadowMap& shadows, std::size_t points) {
  constexpr std::array<float, 8> kHeights = {0.25f, 0.35f, 0.5f, 0.7f, 0.95f, 1.3f, 1.8f, 2.4f};  // m
  constexpr std::array<float, 6> kAside = {0.3f, 0.6f, 0.9f, 1.2f, 1.6f, 2.1f};                   // m
  constexpr int kTurns = 20;
  const Point middle = shadows.middleOfStanding();
  std::vector<Lamp> lamps;
  const auto add = [&](const Point& place) { lamps.push_back({place, shadows.misfit(place, points)}); };
  for (const float height : kHeights) {
    add({middle.x(), middle.y(), height});
    for (const float aside : kAside) {
      for (int k = 0; k < kTurns; ++k) {
        const float turn = static_cast<float>(2.0 * M_PI * k / kTurns);
        add({middle.x() + aside * std::cos(turn), middle.y() + aside * std::sin(turn), height});
      }
    }
  }
  std::sort(lamps.begin(), lamps.end());
  return lamps;
}

/// To and fro and to the sides, as long as that helps, by steps that are shares of the distance.
void improve(ShadowMap& shadows, std::size_t points, float step, float least_step, Lamp& lamp) {
  lamp.misfit = shadows.misfit(lamp.place, points);
  while (step > least_step) {
    const Point away = lamp.place - shadows.middleOfGround();
    const float size = step * away.norm();
    const Point ahead = away.normalized(), aside = ahead.unitOrthogonal(), up = ahead.cross(aside);
    Lamp best = lamp;
    for (int k = 0; k < 27; ++k) {
      const Point way(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1), static_cast<float>(k / 9 - 1));
      const Point place = lamp.place + size * (way.x() * 2.0f * ahead + way.y() * aside + way.z() * up);
      const bool edge = way.cwiseAbs().sum() == 2.0f;
      if (k == 13 || edge || !(place.z() > kAboveGround)) continue;
      const float misfit = shadows.misfit(place, points);
      if (misfit < best.misfit) best = {place, misfit};
    }
    if (best.misfit < lamp.misfit) {
      lamp = best;
    } else {
      step *= 0.5f;
    }
  }
}

/// z to the point, y down.
Eigen::Isometry3d lookingAt(const Vec3& point, const Vec3& from, const Vec3& up) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Vec3 ahead = (point - from).normalized();
  const Vec3 across = ahead.cross(up);
  const Vec3 right = across.norm() > 1e-3 ? Vec3(across.normalized()) : ahead.unitOrthogonal();
  pose.linear().col(0) = right;
  pose.linear().col(1) = ahead.cross(right);
  pose.linear().col(2) = ahead;
  pose.translation() = from;
  return pose;
}

/// Whose shadows are the holes of the ground.
std::optional<Eigen::Isometry3d> findCameraAbove(const Ground& ground, const std::vector<Point>& points) {
  constexpr std::size_t kRoughly = 700, kBetter = 1200, kWell = 4096, kAll = ShadowMap::kMostStanding;  // points
  constexpr std::size_t kTaken = 4;
  constexpr float kMostMisfit = 0.35f, kAsGood = 0.15f;
  constexpr float kFarthest = 2.6f;  // m
  ShadowMap shadows(ground, points);
  if (!shadows.isWorthASearch()) return std::nullopt;
  std::vector<Lamp> lamps = manyLamps(shadows, kRoughly);
  lamps.resize(kTaken);
  for (Lamp& lamp : lamps) improve(shadows, kBetter, 0.1f, 0.02f, lamp);
  Lamp best = *std::min_element(lamps.begin(), lamps.end());
  improve(shadows, kWell, 0.03f, 0.004f, best);
  improve(shadows, kAll, 0.01f, 0.006f, best);
  const Point origin = shadows.inFrameOfGround(Point::Zero());
  const bool origin_is_as_good = origin.z() > kAboveGround && shadows.misfit(origin, kAll) < best.misfit + kAsGood;
  if (!(best.misfit < kMostMisfit) || origin_is_as_good) return std::nullopt;
  const Point middle = shadows.inFrameOfCloud(shadows.middleOfGround()), place = shadows.inFrameOfCloud(best.place);
  const Point way = middle - place;
  if (!(way.norm() < kFarthest) || hiddenShare(points, place, way.normalized()) > kMostHidden) return std::nullopt;
  return lookingAt(middle.cast<double>(), place.cast<double>(), ground.normal.cast<double>());
}

bool mayBeSeenFromOrigin(const std::vector<Point>& points) {
  return hiddenShare(points, Point::Zero(), Point::UnitZ()) <= kMostHidden;
}

}  // namespace

bool mayBeSeenFromOrigin(const Cloud& list) { return mayBeSeenFromOrigin(pointsOf(list)); }

std::optional<Eigen::Isometry3d> findCameraByShadows(const Cloud& list) {
  constexpr std::size_t kFewest = 500;
  const std::vector<Point> points = pointsOf(list);
  if (points.size() < kFewest || mayBeSeenFromOrigin(points)) return std::nullopt;
  const std::optional<Ground> ground = findGround(points);
  if (!ground) return std::nullopt;
  // More of a floor may be seen beside a table than of what stands on it.
  const auto camera = findCameraAbove(*ground, points);
  return camera ? camera : findCameraAbove(ground->turnedRound(), points);
}

}  // namespace primitect
