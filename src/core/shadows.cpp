// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A search for the lamp; see shadows.h.
#include "core/shadows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/ground.h"
#include "core/hidden_share.h"
#include "core/shadow_map.h"
#include "primitect/primitives.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

constexpr double kMostHidden = 0.03;  // behind edges, which noise and lenses blur
constexpr float kFarthest = 2.6f;     // m

/// Every so many, in a frame whose origin is among them: float would not do far from it.
struct LocalPoints {
  Vec3 origin = Vec3::Zero();  ///< in the frame of the cloud
  std::vector<Point> points;

  LocalPoints(const Cloud& cloud, std::size_t step) {
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < cloud.size(); i += step) {
      if (cloud.valid(i)) taken.push_back(i);
    }
    for (const std::size_t i : taken) origin += cloud.point(i) / static_cast<double>(taken.size());
    points.reserve(taken.size());
    for (const std::size_t i : taken) points.push_back((cloud.point(i) - origin).cast<float>());
  }

  Point originOfCloud() const { return (-origin).cast<float>(); }
};

struct Lamp {
  Point place;
  float misfit;
  bool operator<(const Lamp& other) const { return misfit < other.misfit; }
};

/// Around what stands there, up to 2.5 m from it; the best first. Of about so many of its points.
std::vector<Lamp> manyLamps(ShadowMap& shadows, std::size_t point_count) {
  constexpr std::array<float, 8> kHeights = {0.25f, 0.35f, 0.5f, 0.7f, 0.95f, 1.3f, 1.8f, 2.4f};  // m
  constexpr std::array<float, 6> kAside = {0.3f, 0.6f, 0.9f, 1.2f, 1.6f, 2.1f};                   // m
  constexpr int kTurns = 20;
  const Point middle = shadows.middleOfStanding();
  std::vector<Lamp> lamps;
  const auto add = [&](const Point& place) { lamps.push_back({place, shadows.misfit(place, point_count)}); };
  for (const float height : kHeights) {
    add({middle.x(), middle.y(), height});
    for (const float aside : kAside) {
      for (int k = 0; k < kTurns; ++k) {
        const float turn = static_cast<float>(2.0 * M_PI * k / kTurns);
        add({middle.x() + aside * std::cos(turn), middle.y() + aside * std::sin(turn), height});
      }
    }
  }
  std::stable_sort(lamps.begin(), lamps.end());
  return lamps;
}

/// Steps of a search, as shares of the distance: the first, and the one with which it ends.
struct SearchSteps {
  float first, last;
};

/// To and fro, to the sides and slantwise, as long as that helps.
Lamp improved(ShadowMap& shadows, std::size_t point_count, const SearchSteps& steps, Point place) {
  constexpr int kMostMoves = 40;
  Lamp lamp = {place, shadows.misfit(place, point_count)};
  float step = steps.first;
  for (int move = 0; move < kMostMoves && step > steps.last; ++move) {
    const Point away = lamp.place - shadows.middleOfGround();
    const float size = step * away.norm();
    const Point ahead = away.normalized(), aside = ahead.unitOrthogonal(), up = ahead.cross(aside);
    Lamp best = lamp;
    for (int k = 0; k < 27; ++k) {
      const Point way(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1), static_cast<float>(k / 9 - 1));
      place = lamp.place + size * (way.x() * 2.0f * ahead + way.y() * aside + way.z() * up);
      const bool stays = k == 13, between_two = way.cwiseAbs().sum() == 2.0f;
      if (stays || between_two || !(place.z() > kAboveGround) || shadows.distance(place) > kFarthest) continue;
      const float misfit = shadows.misfit(place, point_count);
      if (misfit < best.misfit) best = {place, misfit};
    }
    if (!(best.misfit < lamp.misfit)) step *= 0.5f;
    lamp = best;
  }
  return lamp;
}

/// From nearer and from twice as far away the shadows would fit worse. One small thing close to a wall hardly tells.
bool tellsHowFar(ShadowMap& shadows, const Lamp& lamp) {
  constexpr float kNearer = 0.7f, kFarther = 2.0f, kLeastWorse = 0.015f;
  const Point middle = shadows.middleOfGround();
  const auto worse = [&](float times) {
    return shadows.misfit(middle + times * (lamp.place - middle), ShadowMap::kMostStanding) - lamp.misfit;
  };
  return worse(kNearer) > kLeastWorse && worse(kFarther) > kLeastWorse;
}

/// z to the point, y down, if that is not where it looks.
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

/// Whose shadows are the holes of the ground, in the frame of the points.
std::optional<Eigen::Isometry3d> findCameraAbove(const Ground& ground, const LocalPoints& local) {
  constexpr std::size_t kRoughly = 700, kBetter = 1200, kWell = 4096, kAll = ShadowMap::kMostStanding;  // points
  constexpr std::size_t kTaken = 4;
  constexpr float kMostMisfit = 0.35f, kAsGood = 0.15f, kBetterThanFromAbove = 0.1f;
  constexpr float kHigh = 100.0f;  // m
  ShadowMap shadows(ground, local.points);
  if (!shadows.isWorthASearch()) return std::nullopt;
  Lamp best = {Point::Zero(), std::numeric_limits<float>::max()};
  const std::vector<Lamp> lamps = manyLamps(shadows, kRoughly);
  for (std::size_t k = 0; k < kTaken; ++k)
    best = std::min(best, improved(shadows, kBetter, {0.1f, 0.02f}, lamps[k].place));
  best = improved(shadows, kWell, {0.03f, 0.004f}, best.place);
  best = improved(shadows, kAll, {0.01f, 0.006f}, best.place);
  const Point origin = shadows.inFrameOfGround(local.originOfCloud());
  const float of_origin = origin.z() > kAboveGround ? shadows.misfit(origin, kAll) : 1.0f;
  if (of_origin < best.misfit + kAsGood) {
    best = {origin, of_origin};
  } else if (!tellsHowFar(shadows, best)) {
    return std::nullopt;
  }
  // What was seen from all sides has holes where things stand, and no others.
  const float from_above = shadows.misfit(shadows.middleOfGround() + Point(0.0f, 0.0f, kHigh), kAll);
  if (!(best.misfit < std::min(kMostMisfit, from_above - kBetterThanFromAbove))) return std::nullopt;
  const Point middle = shadows.inFrameOfCloud(shadows.middleOfGround()), place = shadows.inFrameOfCloud(best.place);
  if (hiddenShare(local.points, place, (middle - place).normalized()) > kMostHidden) return std::nullopt;
  return lookingAt(middle.cast<double>(), place.cast<double>(), ground.normal.cast<double>());
}

}  // namespace

bool mayTellByShadows(const Cloud& list) {
  constexpr std::size_t kFewest = 500, kMostLooked = 32768;
  if (list.organized() || list.hasNormals() || list.valid_count < kFewest) return false;
  const LocalPoints some(list, list.size() / kMostLooked + 1);
  return hiddenShare(some.points, some.originOfCloud(), Point::UnitZ()) > kMostHidden;
}

std::optional<Eigen::Isometry3d> findCameraByShadows(const Cloud& list) {
  const LocalPoints local(list, 1);
  for (const Ground& ground : findGrounds(local.points)) {
    std::optional<Eigen::Isometry3d> camera = findCameraAbove(ground, local);
    // More of a floor may be seen beside a table than of what stands on it.
    if (!camera) camera = findCameraAbove(ground.turnedRound(), local);
    if (camera) return camera->pretranslate(local.origin);
  }
  return std::nullopt;
}

}  // namespace primitect
