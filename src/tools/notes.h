// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect` asks a user whose points cannot be what they are taken for.
#pragma once

#include <string>

#include "io/report.h"
#include "tools/detect_input.h"

namespace primitect::tools {

/// A line for each tf frame that parameters name: a program without tf does without. Empty where they name none.
std::string ignoredFramesText(const DetectOptions& options);

/// Lines that begin with "  note: "; empty where nothing is strange.
std::string notesText(const Detections& found, const DetectInput& input);

}  // namespace primitect::tools
