// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a detection is called where people read it: pictures, tables, markers.
#pragma once

#include <string>

#include "primitect/params.h"
#include "primitect/primitives.h"

namespace primitect::io {

/// "610 x 420 mm", "r 203 mm", "r 39 mm", "half angle 12.3 deg"; a plane of unknown extent has no size: "".
std::string sizeText(const Detection& detection);

/// "cylinder"; seen from inside "concave cylinder".
std::string kindText(const Detection& detection);

/// Kind and size: "cylinder r 39 mm".
std::string nameText(const Detection& detection);

/// Standard deviation of radius or half angle: "0.3 mm", "0.12 deg"; "" for planes and where it is unknown.
std::string deviationText(const Detection& detection);

/// Why the extent is only a lower bound: "image, occlusion"; "" if it is not, or where it is unknown.
std::string truncationText(std::uint8_t truncated);

/// "12 few inliers (see min_inliers), 3 too large (see max_radius)": with the parameters that may be the reason, where
/// they are on; "" if there was none.
std::string refusalsText(const Refusals& refusals, const Params& params);

/// Why there is nothing to see: one line for a person, for any status.
std::string reasonText(const Detections& detections);

}  // namespace primitect::io
