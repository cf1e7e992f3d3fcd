// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which end of a shape was seen, along its axis or the longer side of a plane, and where it may go on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "primitect/primitives.h"

namespace primitect {

/// Of a cylinder, a cone or a plane, from walks over the image that begin at the border of its points.
class UnseenEnds {
 public:
  UnseenEnds(Kind kind, const Extent& extent);

  /// A walk that begins on a point of the surface (m), whose next pixel would see it `step` (m) farther, and the bit of
  /// why the sensor could not see on (truncation.h), 0 where it could. It tells of an end if it runs along the axis and
  /// begins near it.
  void add(const Vec3& from, const Vec3& step, std::uint8_t cut_off_by);

  /// Bits of End: of those where half of the walks were cut off, or that none tells of. Of planes, which have no such
  /// ends, they mean nothing.
  std::uint8_t bits() const;

  /// Bits of why the walks at these were cut off; 0 where none was, as of what is seen along its axis.
  std::uint8_t cutOffBy() const;

 private:
  struct Walks {
    std::size_t count = 0, cut_off = 0;
    std::uint8_t by = 0;
    bool unseen() const { return 2 * cut_off >= count; }
  };

  Vec3 origin_, axis_;
  double length_;
  Walks minus_, plus_;
};

}  // namespace primitect
