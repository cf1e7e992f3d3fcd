// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The things that stand on the table, drawn at random.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/random.h"
#include "synthetic/world.h"

namespace primitect::synthetic {

/// An object as it stands around (0, 0) on the table, and the stadium (all within radius of a line from -half_line to
/// half_line along x) that holds its outline from above.
struct Object {
  const char* name;
  Solid solid;
  Eigen::Isometry3d pose;
  double half_line, radius;
};

/// 1-2 boxes, 1-2 cones, 2-3 cylinders, 2-3 balls; sizes as promised by tabletop().
std::vector<Object> drawObjects(Random& random);

}  // namespace primitect::synthetic
