// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points and normals of a cloud as vectors.
#pragma once

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::eval {

inline Vec3 pointAt(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }

/// Only for clouds with normals.
inline Vec3 normalAt(const Cloud& cloud, std::size_t i) { return {cloud.nx[i], cloud.ny[i], cloud.nz[i]}; }

}  // namespace primitect::eval
