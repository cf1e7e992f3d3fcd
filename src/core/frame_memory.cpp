// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Blocks by powers of two, free ones in lists; see frame_memory.h.
#include "core/frame_memory.h"

#include <algorithm>
#include <new>

namespace primitect {
namespace {

#if !defined(__has_feature)
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr bool kKeeps = false;
#else
constexpr bool kKeeps = true;
#endif

constexpr std::size_t kAlignment = FrameMemory::kAlignment;
constexpr std::size_t kSlab = std::size_t{1} << 18;
/// Larger ones are no part of a slab.
constexpr std::size_t kLargestInSlab = std::size_t{1} << 14;

thread_local FrameMemory* memory_of_thread = nullptr;

/// Logarithm of the size of a block for so many bytes.
std::size_t classOf(std::size_t bytes) {
  const unsigned long long last = std::max(bytes, kAlignment) - 1;
  return static_cast<std::size_t>(64 - __builtin_clzll(last));
}

void* fromHeap(std::size_t size) { return ::operator new (size, std::align_val_t{kAlignment}); }
void toHeap(void* memory) noexcept { ::operator delete (memory, std::align_val_t{kAlignment}); }

}  // namespace

FrameMemory::~FrameMemory() {
  for (std::size_t k = classOf(kLargestInSlab) + 1; k < free_.size(); ++k) {
    while (Free* const block = free_[k]) {
      free_[k] = block->next;
      toHeap(block);
    }
  }
  for (void* slab : slabs_) toHeap(slab);
}

void* FrameMemory::take(std::size_t bytes) {
  const std::size_t k = classOf(bytes), size = std::size_t{1} << k;
  if (Free* const block = free_[k]) {
    free_[k] = block->next;
    return block;
  }
  return size <= kLargestInSlab ? carve(size) : fromHeap(size);
}

void* FrameMemory::carve(std::size_t size) {
  // Lists of one length, which loops often read side by side, must not all begin at the same place of a page.
  const std::size_t apart = size + (size >= kLargestInSlab / 16 ? kAlignment : 0);
  if (rest_size_ < apart) {
    slabs_.reserve(slabs_.size() + 1);
    rest_ = static_cast<char*>(fromHeap(kSlab));
    rest_size_ = kSlab;
    slabs_.push_back(rest_);
  }
  void* const block = rest_;
  rest_ += apart;
  rest_size_ -= apart;
  return block;
}

void FrameMemory::giveBack(void* block, std::size_t bytes) noexcept {
  Free*& first = free_[classOf(bytes)];
  first = new (block) Free{first};
}

FrameMemoryScope::FrameMemoryScope(FrameMemory* memory) : before_(memory_of_thread) {
  memory_of_thread = kKeeps ? memory : nullptr;
}

FrameMemoryScope::~FrameMemoryScope() { memory_of_thread = before_; }

FrameMemory* FrameMemoryScope::current() noexcept { return memory_of_thread; }

}  // namespace primitect
