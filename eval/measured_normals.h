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

/// Sets the normals of these measured points as our detector would estimate those of its samples (image window, or
/// nearest neighbours when unorganized; default parameters), NaN where there is none to be had. The cloud's other
/// normals stay, and are not used. Needs room for normals.
void measureNormals(const std::vector<std::uint32_t>& points, Cloud& cloud);

}  // namespace primitect::eval
