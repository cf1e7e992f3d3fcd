// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that things keep from frame to frame.
#pragma once

#include <cstdint>
#include <vector>

#include "primitect/primitives.h"

namespace primitect {

/// What tells a thing from others, in a frame in which things rest or move slowly (m).
struct Sighting {
  Kind kind = Kind::plane;
  bool concave = false;
  Vec3 origin = Vec3::Zero();      ///< middle of the observed part, as Extent::origin
  Vec3 direction = Vec3::UnitZ();  ///< plane: normal; cylinder and cone: axis; unit
  double radius = 0.0;             ///< sphere, cylinder; cone: at the wide end of the observed part
  double reach = 0.0;              ///< half of the longest side of what was seen of a plane, cylinder or cone
  Vec3 across = Vec3::Zero();      ///< plane: x of its extent; unit, or zero: unknown
};

/// In the frame of the extent.
Sighting sightingOf(Kind kind, bool concave, const Extent& extent);
inline Sighting sightingOf(const Detection& detection) {
  return sightingOf(kindOf(detection.shape), detection.concave, detection.extent);
}

/// A thing of one frame after the other.
struct Track {
  std::uint32_t id = 0;   ///< from 1 on, each given once
  std::uint32_t age = 0;  ///< frames since the first one with it
  /// Of a cylinder or a plane that was in a frame before: where its axis or its x pointed then, for turnAsBefore()
  /// (steady_pose.h); unit. Else zero.
  Vec3 direction_before = Vec3::Zero();
};

/// Finds the things of the last frames again: the nearest ones of the same kind, position, direction and size, each at
/// most once. Cylinders and cones, which noise may exchange, continue each other. The last two sightings of a thing
/// count, or one that is off would end its track. Of a large plane that is seen in parts the oldest number goes on.
class Tracker {
 public:
  /// patience (s): what was not seen for longer, or for 60 frames of one time, is a new thing.
  explicit Tracker(double patience = 2.0) : patience_(patience) {}

  void setPatience(double patience) { patience_ = patience; }

  /// The track of each sighting of the next frame, which was taken at this time (s). Valid until the next call.
  const std::vector<Track>& update(const std::vector<Sighting>& sightings, double seconds);

  /// Where the axis of a cylinder or x of a plane of the last update() points, when it was turned as before; without
  /// this as it was seen, or round. No effect once all is forgotten.
  void turned(std::size_t sighting, const Vec3& direction);

  /// Forgets all things; numbers go on.
  void forget();

  /// Forgets all things; numbers begin with 1 again.
  void startAnew();

 private:
  struct Thing {
    Track track;
    Sighting last, before;     ///< the last two
    Vec3 way;                  ///< that its axis as a cylinder, or its x, points to; a cone in between may not
    double seen = 0.0;         ///< s, the last one
    std::uint32_t unseen = 0;  ///< frames since then
  };
  /// A thing of before that may be a sighting.
  struct Match {
    double cost;
    std::size_t thing, sighting;
  };

  static constexpr std::size_t kNone = ~std::size_t{0};

  void findMatches(const std::vector<Sighting>& sightings, double seconds);
  void assign(std::size_t sightings);
  void preferOlder(const std::vector<Sighting>& sightings);

  double patience_;
  std::uint32_t next_id_ = 1;
  std::vector<Thing> things_;
  std::vector<Match> matches_;
  std::vector<Track> tracks_;
  std::vector<std::size_t> thing_of_;  ///< each sighting, or kNone
  std::vector<bool> taken_;            ///< things that have a sighting in this frame
};

}  // namespace primitect
