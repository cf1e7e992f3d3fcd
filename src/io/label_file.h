// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds with one colour a kind, in shades, and the label of each point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect::io {

/// Binary PLY: x y z, red green blue (grey = no detection), label (index of the detection + 1, 0 = none) of every
/// measured point; an organized cloud keeps its rows as a range grid. `labels` is as long as the cloud. Throws
/// std::runtime_error naming the file when it cannot be written.
void writeLabels(const std::string& path, const Cloud& cloud, const Detections& detections,
                 const std::vector<std::uint32_t>& labels);

}  // namespace primitect::io
