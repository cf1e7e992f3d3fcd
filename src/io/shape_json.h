// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A shape as JSON, the same wherever one is written.
#pragma once

#include <nlohmann/json.hpp>

#include "primitect/primitives.h"

namespace primitect::io {

/// [x, y, z].
inline nlohmann::ordered_json vectorJson(const Vec3& v) { return nlohmann::ordered_json::array({v.x(), v.y(), v.z()}); }

/// {"type": "plane", "point", "normal"} | {"type": "sphere", "center", "radius"} | {"type": "cylinder", "point",
/// "axis", "radius"} | {"type": "cone", "apex", "axis", "half_angle"}; m, rad.
nlohmann::ordered_json shapeJson(const Shape& shape);

/// The shape that shapeJson() wrote; other keys do not matter. Throws std::runtime_error naming what is missing or
/// wrong.
Shape shapeFromJson(const nlohmann::ordered_json& json);

}  // namespace primitect::io
