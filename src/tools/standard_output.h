// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What was printed may be lost: a full disk, a reader that has gone.
#pragma once

#include <iostream>
#include <stdexcept>

namespace primitect::tools {

/// Writes what is still to be written; throws std::runtime_error where any of it could not be.
inline void flushOutput() {
  if (!(std::cout << std::flush)) throw std::runtime_error("standard output cannot be written");
}

}  // namespace primitect::tools
