// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals where a cloud brings none.
#pragma once

#include <cstdint>
#include <vector>

#include "primitect/cloud.h"

namespace primitect::eval {

/// Makes room for normals, all of them missing.
void clearNormals(Cloud& cloud);

/// Sets the normals of these measured points as our detector would estimate those of its samples where a cloud brings
/// none (image window, also of an unorganized cloud that gets its image back, or else nearest neighbours; default
/// parameters). Where there is none to be had it stays as it is. The cloud's other normals stay, and are not used.
/// Needs room for normals.
void measureNormals(const std::vector<std::uint32_t>& points, Cloud& cloud);

}  // namespace primitect::eval
