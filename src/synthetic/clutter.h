// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A crowded table, different for every seed: things hide one another, lie, are hollow, or are no primitive at all.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "synthetic/world.h"

namespace primitect::synthetic {

/// Floor, one or two walls, a table (its top at kTableHeight), and on it 6 to 14 things close together, some of them
/// on top of a box: balls, standing and lying cylinders, open cups, pots and bowls (concave inside), cones pointed or
/// cut off, boxes, and 1 to 3 that are none of the four kinds ("ellipsoid", "torus", "lump": Surface::primitive is
/// false). They do not intersect. The wall is beyond 2 m from clutterPose(), in one of four seeds right behind the
/// table. World frame as in tabletop.h. Throws std::runtime_error when the things find no place (no seed is known).
World clutteredTable(std::uint64_t seed);

/// The same room and table with nothing on it that is a sphere, a cylinder or a cone: 2 to 4 boxes, 2 to 4 ellipsoids,
/// tori and lumps, and 3 to 5 of folded cloths, cables, plants in boxes and hands ("cloth", "cable", "leaf", "hand").
World shapelessTable(std::uint64_t seed);

/// The same room and table with 6 to 11 things of a household, two in three of them of several parts: jars, bottles and
/// spray cans with shoulder and lid, standing or lying, flower pots with a rim, tins with a lid, piled cans, each wider
/// or narrower than the one below by 4 mm or more, piled books, and mugs with a handle (Surface::primitive is false).
/// The others are a ball, cylinder, cup, bowl, cone, pot or box each. None is without a shape.
World householdTable(std::uint64_t seed);

/// world_from_camera (optical frame): 0.8 to 1.3 m from the middle of the things, 25 to 55 deg from above, any side
/// within 50 deg, rolled by up to 5 deg. Objects may reach out of the image.
Eigen::Isometry3d clutterPose(std::uint64_t seed);

}  // namespace primitect::synthetic
