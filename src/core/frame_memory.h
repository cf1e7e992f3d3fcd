// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists whose memory serves frame after frame: once a detector has seen a few frames, it takes nothing from the heap.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace primitect {

/// Blocks of memory that are kept when they are given back, until its end; of one detector, for one thread at a time.
/// With an address sanitizer nothing is kept, so that it sees each list end where it ends.
class FrameMemory {
 public:
  FrameMemory() = default;
  FrameMemory(const FrameMemory&) = delete;
  FrameMemory& operator=(const FrameMemory&) = delete;
  /// All blocks must have been given back.
  ~FrameMemory();

  /// At least so many bytes, aligned to kAlignment. Throws std::bad_alloc.
  void* take(std::size_t bytes);
  /// bytes: as asked for.
  void giveBack(void* block, std::size_t bytes) noexcept;

  static constexpr std::size_t kAlignment = 64;

 private:
  /// What is in a block that nobody uses.
  struct Free {
    Free* next;
  };
  void* carve(std::size_t size);

  std::array<Free*, 64> free_ = {};  ///< by the logarithm of their size
  std::vector<void*> slabs_;         ///< what small blocks are carved from
  char* rest_ = nullptr;             ///< of the last slab
  std::size_t rest_size_ = 0;
};

/// While it lives, the lists that this thread makes use this memory; null: the heap.
class FrameMemoryScope {
 public:
  explicit FrameMemoryScope(FrameMemory* memory);
  FrameMemoryScope(const FrameMemoryScope&) = delete;
  FrameMemoryScope& operator=(const FrameMemoryScope&) = delete;
  ~FrameMemoryScope();

  /// Of this thread.
  static FrameMemory* current() noexcept;

 private:
  FrameMemory* before_;
};

/// The memory that was the thread's when the list was made; it stays the list's, whoever frees it. What outlives the
/// detector (a static, a result) is no List but a std::vector.
template <class T>
class FrameAllocator {
 public:
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  using is_always_equal = std::false_type;

  FrameAllocator() noexcept : memory_(FrameMemoryScope::current()) {}
  template <class Other>
  FrameAllocator(const FrameAllocator<Other>& other) noexcept : memory_(other.memory()) {}

  T* allocate(std::size_t count) {
    static_assert(alignof(T) <= FrameMemory::kAlignment);
    return memory_ ? static_cast<T*>(memory_->take(count * sizeof(T))) : std::allocator<T>().allocate(count);
  }
  void deallocate(T* list, std::size_t count) noexcept {
    memory_ ? memory_->giveBack(list, count * sizeof(T)) : std::allocator<T>().deallocate(list, count);
  }
  /// A copy is a list of its own.
  FrameAllocator select_on_container_copy_construction() const noexcept { return {}; }

  FrameMemory* memory() const noexcept { return memory_; }

 private:
  FrameMemory* memory_;
};

template <class T, class Other>
bool operator==(const FrameAllocator<T>& a, const FrameAllocator<Other>& b) noexcept {
  return a.memory() == b.memory();
}
template <class T, class Other>
bool operator!=(const FrameAllocator<T>& a, const FrameAllocator<Other>& b) noexcept {
  return !(a == b);
}

template <class T>
using List = std::vector<T, FrameAllocator<T>>;

}  // namespace primitect
