// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts what this program takes from the heap, whoever in it asks; linking allocations.cpp is all it needs.
#pragma once

#include <cstddef>

namespace primitect::bench {

struct Allocations {
  std::size_t count = 0;
  std::size_t bytes = 0;
};

/// False where malloc cannot be replaced (not glibc, or a sanitizer has replaced it): all counts are 0 then.
bool canCountAllocations();

/// Counting begins at zero. One thread at a time may count; what other threads take is counted, too.
void beginCounting();

/// Ends it: calls of malloc, calloc, realloc and the aligned ones since beginCounting(), operator new included.
Allocations endCounting();

}  // namespace primitect::bench
