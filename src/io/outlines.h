// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The lines that show a shape in a picture.
#pragma once

#include <vector>

#include "io/view.h"
#include "primitect/primitives.h"

namespace primitect::io {

using Line3 = std::vector<Vec3>;             ///< corners (m)
using Line2 = std::vector<Eigen::Vector2d>;  ///< corners (px)

/// Plane: its hull. Sphere: the circle that bounds what the viewer sees of it. Cylinder and cone: both ends of the
/// observed part and the sides between them. Nothing where the extent is unknown or the viewer is inside.
std::vector<Line3> outlineOf(const Detection& detection, const View& view);

/// Projects, cutting off what is behind the viewer; one line may become several.
std::vector<Line2> projectLines(const std::vector<Line3>& lines, const View& view);

}  // namespace primitect::io
