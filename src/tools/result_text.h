// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect` prints for people.
#pragma once

#include <string>

#include "io/report.h"
#include "tools/stage_timing.h"

namespace primitect::tools {

/// The file, a table of its detections or the reason why there are none, and the times; `size` says what was read.
std::string resultText(const io::FileReport& report, const std::string& size);

}  // namespace primitect::tools
