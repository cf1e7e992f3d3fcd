// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds to PCD.
#pragma once

#include <string>

#include "primitect/cloud.h"

namespace primitect::io {

/// Binary; x, y and z of all points (m), missing ones as NaN; width and height are kept. Throws std::runtime_error
/// naming the file when it cannot be written.
void writePcd(const std::string& path, const Cloud& cloud);

}  // namespace primitect::io
