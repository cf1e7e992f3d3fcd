// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// /proc; see memory.h.
#include "eval/bench/memory.h"

#include <malloc.h>

#include <fstream>
#include <stdexcept>

namespace primitect::bench {

long statusKilobytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(name + ":", 0) == 0) return std::stol(line.substr(name.size() + 1));
  }
  throw std::runtime_error("/proc/self/status says nothing of " + name);
}

bool forgetPeak() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream refs("/proc/self/clear_refs");
  refs << "5" << std::flush;  // proc(5): resets the peak resident set size
  return static_cast<bool>(refs);
}

}  // namespace primitect::bench
