// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours among things of one kind; see tracker.h.
#include "primitect/tracker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "core/extent.h"

namespace primitect {
namespace {

/// How much may change from frame to frame: above what noise does to small things at 2 m, below what tells neighbours
/// apart.
constexpr double kMostTurn = 0.26, kMostTurnOfPlanes = 0.17;  // rad
constexpr double kMostGrowth = 0.3;                           // log of the ratio of radii
constexpr double kMostStep = 0.05;                            // m, across a surface or of a centre
constexpr double kMostSpeed = 0.3;                            // m/s, besides
/// Of the reach along a surface: what hides an end moves the middle of what is seen.
constexpr double kMostSlide = 0.6;

bool mayBeSame(const Sighting& a, const Sighting& b) {
  const bool alike = a.kind == b.kind || (hasAxis(a.kind) && hasAxis(b.kind));
  return alike && a.concave == b.concave;
}

double square(double value) { return value * value; }

/// Sum of squares, each as a share of the most; nothing when one is above it.
class Cost {
 public:
  void add(double value, double most) {
    const double share = std::abs(value) / most;
    within_ = within_ && share <= 1.0;  // not of NaN
    sum_ += square(share);
  }
  std::optional<double> sum() const { return within_ ? std::optional<double>(sum_) : std::nullopt; }

 private:
  double sum_ = 0.0;
  bool within_ = true;
};

double lineAngle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }
double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// How unlike two sightings are that lie so many seconds apart; nothing: too much to be one thing.
std::optional<double> costOf(const Sighting& before, const Sighting& now, double seconds) {
  if (!mayBeSame(before, now)) return std::nullopt;
  Cost cost;
  const Vec3 moved = now.origin - before.origin;
  const double step = kMostStep + kMostSpeed * seconds, slide = step + kMostSlide * std::max(before.reach, now.reach);
  const double along = before.direction.dot(moved);
  const double across = std::sqrt(std::max(0.0, moved.squaredNorm() - square(along)));
  if (before.kind == Kind::plane) {
    cost.add(angle(before.direction, now.direction), kMostTurnOfPlanes);
    cost.add(along, step);
    cost.add(across, slide);
    return cost.sum();
  }
  cost.add(std::log(now.radius / before.radius), kMostGrowth);
  if (before.kind == Kind::sphere) {
    cost.add(moved.norm(), step + kMostSlide * before.radius);
    return cost.sum();
  }
  // A cylinder's axis has no sign, and a cone's may be that of a cylinder before.
  cost.add(lineAngle(before.direction, now.direction), kMostTurn);
  cost.add(across, step);
  cost.add(along, slide);
  return cost.sum();
}

/// The direction that may turn while the thing rests, or that of the axis of a cone.
Vec3 wayOf(const Sighting& sighting) { return sighting.kind == Kind::plane ? sighting.across : sighting.direction; }

}  // namespace

Sighting sightingOf(Kind kind, bool concave, const Extent& extent) {
  Sighting sighting;
  sighting.kind = kind;
  sighting.concave = concave;
  sighting.origin = extent.origin;
  sighting.direction = extent.rotation.col(2);
  sighting.radius = extent.radius;
  sighting.reach = 0.5 * extent.size.maxCoeff();
  if (kind == Kind::plane) sighting.across = extent.rotation.col(0);
  return sighting;
}

/// The best ones first.
void Tracker::findMatches(const std::vector<Sighting>& sightings, double seconds) {
  matches_.clear();
  for (std::size_t t = 0; t < things_.size(); ++t) {
    for (std::size_t s = 0; s < sightings.size(); ++s) {
      const Thing& thing = things_[t];
      // As if both were of that time: one that is older would reach farther, and seem nearer.
      const double since = std::max(0.0, seconds - thing.seen);
      const auto from_last = costOf(thing.last, sightings[s], since);
      const auto from_before = costOf(thing.before, sightings[s], since);
      if (!from_last && !from_before) continue;
      constexpr double kNone = std::numeric_limits<double>::infinity();
      matches_.push_back({std::min(from_last.value_or(kNone), from_before.value_or(kNone)), t, s});
    }
  }
  std::sort(matches_.begin(), matches_.end(), [](const Match& a, const Match& b) {
    return std::tie(a.cost, a.thing, a.sighting) < std::tie(b.cost, b.thing, b.sighting);
  });
}

/// The best matches first, each thing and each sighting once.
void Tracker::assign(std::size_t sightings) {
  thing_of_.assign(sightings, kNone);
  taken_.assign(things_.size(), false);
  for (const Match& match : matches_) {
    if (taken_[match.thing] || thing_of_[match.sighting] != kNone) continue;
    taken_[match.thing] = true;
    thing_of_[match.sighting] = match.thing;
  }
}

/// Of a floor with things on it now this part is seen, now that one, now both: while one of its numbers has no sighting
/// of its own, the oldest one goes on. Tops of boxes side by side are too small for that.
void Tracker::preferOlder(const std::vector<Sighting>& sightings) {
  constexpr double kLarge = 0.3;  // m
  const auto isLarge = [](const Sighting& s) { return s.kind == Kind::plane && s.reach >= kLarge; };
  for (const Match& match : matches_) {
    std::size_t& thing = thing_of_[match.sighting];
    if (taken_[match.thing] || thing == kNone || things_[match.thing].track.id > things_[thing].track.id) continue;
    if (!isLarge(sightings[match.sighting]) || !isLarge(things_[match.thing].last)) continue;
    taken_[thing] = false;
    taken_[match.thing] = true;
    thing = match.thing;
  }
}

const std::vector<Track>& Tracker::update(const std::vector<Sighting>& sightings, double seconds) {
  // Where stamps stand still, or run back, frames alone tell how long ago it was.
  constexpr std::uint32_t kMostFramesWithoutTime = 60;
  const auto forgotten = [&](const Thing& thing) {
    const double since = seconds - thing.seen;
    return !(since <= patience_) || (since <= 0.0 && thing.unseen >= kMostFramesWithoutTime);
  };
  things_.erase(std::remove_if(things_.begin(), things_.end(), forgotten), things_.end());
  for (Thing& thing : things_) ++thing.track.age, ++thing.unseen;
  findMatches(sightings, seconds);
  assign(sightings.size());
  preferOlder(sightings);
  tracks_.assign(sightings.size(), Track());
  for (std::size_t s = 0; s < sightings.size(); ++s) {
    Track& track = tracks_[s];
    if (thing_of_[s] == kNone) {
      track.id = next_id_++;
      thing_of_[s] = things_.size();
      things_.push_back({track, sightings[s], sightings[s], wayOf(sightings[s]), seconds});
      continue;
    }
    Thing& thing = things_[thing_of_[s]];
    thing.before = thing.last;
    thing.last = sightings[s];
    thing.seen = seconds;
    thing.unseen = 0;
    track = thing.track;
    const Kind kind = thing.last.kind;
    if (kind == Kind::cylinder || kind == Kind::plane) track.direction_before = thing.way;
    const Vec3 way = wayOf(thing.last);
    thing.way = way.dot(thing.way) < 0.0 ? Vec3(-way) : way;
  }
  return tracks_;
}

void Tracker::turned(std::size_t sighting, const Vec3& direction) {
  if (sighting < thing_of_.size()) things_[thing_of_[sighting]].way = direction;
}

void Tracker::forget() {
  things_.clear();
  thing_of_.clear();
}

void Tracker::startAnew() {
  forget();
  next_id_ = 1;
}

}  // namespace primitect
