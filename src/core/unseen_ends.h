// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which end of an axis was seen, and where the shape may go on.
#pragma once

#include <cstddef>
#include <cstdint>

#include "primitect/primitives.h"

namespace primitect {

/// Of a cylinder or a cone, from walks over the image that begin at the border of its points.
class UnseenEnds {
 public:
  explicit UnseenEnds(const Extent& extent);

  /// A walk that begins on a point of the surface (m), whose next pixel would see it `step` (m) farther, and whether
  /// the sensor could not see on (truncation.h). It tells of an end if it runs along the axis and begins near it.
  void add(const Vec3& from, const Vec3& step, bool cut_off);

  /// Bits of End: of those where half of the walks were cut off, or that none tells of.
  std::uint8_t bits() const;

 private:
  struct Walks {
    std::size_t count = 0, cut_off = 0;
  };

  const Extent& extent_;
  Walks minus_, plus_;
};

}  // namespace primitect
