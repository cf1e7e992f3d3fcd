// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect` prints for people.
#pragma once

#include <string>

#include "io/point_files.h"
#include "io/report.h"
#include "primitect/cloud.h"

namespace primitect::tools {

/// The file, a table of its detections or the reason why there are none, and the times. `read`: what was read, `range`:
/// what the detector got of it.
std::string resultText(const io::FileReport& report, const io::PointFile& read, const DepthRange& range);

}  // namespace primitect::tools
