// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What rooms are made of: floor, walls, a table.
#pragma once

#include "synthetic/world.h"

namespace primitect::synthetic {

/// The plane z = 0, 12 m wide.
void addFloor(World& world);

/// Across x at this distance (m), 3 m high, turned by yaw (rad) about the vertical through the middle of the room.
void addWall(double distance, double yaw, World& world);

/// Its top at kTableHeight, its sides 2 half_x and 2 half_y long (m).
void addTable(double half_x, double half_y, World& world);

}  // namespace primitect::synthetic
