// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A frame to try `detect` with, where no camera is at hand.
#pragma once

#include <string>

namespace primitect::tools {

/// Writes what the demo's simulated camera sees first of its table: 640 x 480 points, as an organized PCD or a depth
/// PNG (mm), as the name ends. Returns the arguments with which `detect` makes a picture of it. Throws
/// std::invalid_argument where the file exists or its name ends otherwise, std::runtime_error where it cannot be
/// written.
std::string writeExample(const std::string& path);

}  // namespace primitect::tools
