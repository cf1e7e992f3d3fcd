// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// malloc and its kin in front of glibc's own, for this program and all libraries that it loads; see allocations.h.
#include "eval/bench/allocations.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define PRIMITECT_COUNTS_ALLOCATIONS 1
#else
#define PRIMITECT_COUNTS_ALLOCATIONS 0
#endif

namespace {

std::atomic<bool> counting{false};
std::atomic<std::size_t> total_count{0}, total_bytes{0};

#if PRIMITECT_COUNTS_ALLOCATIONS
void note(std::size_t bytes) {
  if (!counting.load(std::memory_order_relaxed)) return;
  total_count.fetch_add(1, std::memory_order_relaxed);
  total_bytes.fetch_add(bytes, std::memory_order_relaxed);
}
#endif

}  // namespace

#if PRIMITECT_COUNTS_ALLOCATIONS
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t bytes) {
  note(bytes);
  return __libc_malloc(bytes);
}

void* calloc(std::size_t count, std::size_t size) {
  note(count * size);
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t bytes) {
  note(bytes);
  return __libc_realloc(old, bytes);
}

void* memalign(std::size_t alignment, std::size_t bytes) {
  note(bytes);
  return __libc_memalign(alignment, bytes);
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) { return memalign(alignment, bytes); }

int posix_memalign(void** result, std::size_t alignment, std::size_t bytes) {
  void* memory = memalign(alignment, bytes);
  if (!memory) return ENOMEM;
  *result = memory;
  return 0;
}
}
#endif

namespace primitect::bench {

bool canCountAllocations() { return PRIMITECT_COUNTS_ALLOCATIONS; }

void beginCounting() {
  total_count = total_bytes = 0;
  counting = true;
}

Allocations endCounting() {
  counting = false;
  return {total_count, total_bytes};
}

}  // namespace primitect::bench
