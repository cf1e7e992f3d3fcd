// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Candidates as the votes of one reference would propose them.
#pragma once

#include "core/candidate.h"
#include "test/support/exact_shapes.h"

namespace primitect::test {

inline Candidate candidate(const Shape& shape, const SurfacePoint& reference, double votes) {
  Candidate proposed;
  proposed.shape = shape;
  proposed.point = reference.point;
  proposed.normal = reference.normal;
  proposed.votes = votes;
  return proposed;
}

}  // namespace primitect::test
