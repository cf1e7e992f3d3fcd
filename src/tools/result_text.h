// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect` prints for people.
#pragma once

#include <string>

#include "io/report.h"
#include "tools/detect_input.h"

namespace primitect::tools {

/// The file, what is strange about it, a table of its detections or the reason why there are none, and the times.
std::string resultText(const io::FileReport& report, const DetectInput& input);

}  // namespace primitect::tools
