// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One thing cut out of a depth frame, as a crop box or a cluster filter does it.
#pragma once

#include <cstdint>

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// Keeps what lies within 3 cm of the box, along the camera's axes, around one of the spheres, cylinders and cones that
/// must be found, chosen by the seed; of planes, where there are no others. All other points go missing, also where the
/// frame is scored. A frame in which nothing must be found stays whole.
void cutOut(std::uint64_t seed, LabelledCloud& frame);

}  // namespace primitect::eval
