// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A shape proposed by votes, not yet checked on the cloud.
#pragma once

#include "primitect/primitives.h"

namespace primitect {

struct Candidate {
  Shape shape;
  bool concave = false;         ///< seen from inside: normals of samples are against the shape's outward ones
  Vec3 point = Vec3::Zero();    ///< the reference that proposed it
  Vec3 normal = Vec3::UnitZ();  ///< of the reference
  double votes = 0.0;           ///< of all proposals merged into it
  std::uint32_t sample = 0;     ///< index of the reference among the samples
  int proposals = 1;            ///< how many references proposed it
};

/// Unit normal of the shape's surface nearest to p on the side that is seen: outward, or inward where it is concave.
inline Vec3 seenNormalAt(const Shape& shape, bool concave, const Vec3& p) {
  return concave ? Vec3(-normalAt(shape, p)) : normalAt(shape, p);
}

}  // namespace primitect
