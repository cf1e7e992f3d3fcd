// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Blocks come back, do not overlap, and belong to the memory that they are from.
#include "core/frame_memory.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "primitect/detector.h"
#include "test/support/scenes.h"

namespace primitect::frame_memory_test {
namespace {

/// Whether lists take a detector's memory: not with an address sanitizer, of this program or only of the library.
bool keeps() { return dlsym(RTLD_DEFAULT, "__asan_init") == nullptr; }

/// Nothing may rest on the memory of a detector that is gone: a static List would. The first test of this program, so
/// that the first detector is the one which makes what is made once.
TEST(Detector, RepeatsItselfWhenTheOneBeforeIsGoneWithItsMemory) {
  Random random(41);
  const Cloud cloud = test::cloudOf(test::tabletop({4000, 1300, 1300, 1400}, random));
  const auto found = [&cloud] { return Detections(Detector(Params()).detect(cloud)); };
  const Detections of_first = found();
  const std::vector<std::string> elsewhere(64, std::string(std::size_t{1} << 18, '\xff'));
  const Detections of_second = found();
  ASSERT_EQ(of_first.items.size(), of_second.items.size());
  for (std::size_t k = 0; k < of_first.items.size(); ++k) {
    EXPECT_EQ(of_first.items[k].coverage, of_second.items[k].coverage);
    EXPECT_EQ(of_first.items[k].covariance, of_second.items[k].covariance);
    EXPECT_EQ(of_first.items[k].inlier_count, of_second.items[k].inlier_count);
  }
}

TEST(FrameMemory, GivesABlockAgain) {
  FrameMemory memory;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{100}, std::size_t{20000}, std::size_t{1} << 22}) {
    void* const block = memory.take(bytes);
    memory.giveBack(block, bytes);
    EXPECT_EQ(memory.take(bytes), block);
    memory.giveBack(block, bytes);
  }
}

struct Block {
  unsigned char* begin;
  std::size_t size;
  unsigned char filling;

  bool holds() const {
    for (std::size_t i = 0; i < size; ++i) {
      if (begin[i] != filling) return false;
    }
    return true;
  }
};

TEST(FrameMemory, KeepsBlocksApart) {
  FrameMemory memory;
  Random random(1);
  std::vector<Block> blocks;
  for (int k = 0; k < 3000; ++k) {
    if (blocks.size() > 200 || (!blocks.empty() && random.below(3) == 0)) {
      std::swap(blocks[random.below(blocks.size())], blocks.back());
      EXPECT_TRUE(blocks.back().holds());
      memory.giveBack(blocks.back().begin, blocks.back().size);
      blocks.pop_back();
      continue;
    }
    const std::size_t size = 1 + random.below(std::uint64_t{1} << random.below(17));
    auto* const begin = static_cast<unsigned char*>(memory.take(size));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(begin) % FrameMemory::kAlignment, 0u);
    blocks.push_back({begin, size, static_cast<unsigned char>(k)});
    std::memset(begin, blocks.back().filling, size);
  }
  for (const Block& block : blocks) {
    EXPECT_TRUE(block.holds());
    memory.giveBack(block.begin, block.size);
  }
}

TEST(List, TakesItsMemoryWhereItIsMade) {
  FrameMemory outer, inner;
  const List<int> before;
  const FrameMemoryScope scope(&outer);
  const List<int> in_outer;
  {
    const FrameMemoryScope within(&inner);
    EXPECT_EQ(List<int>().get_allocator().memory(), keeps() ? &inner : nullptr);
  }
  EXPECT_EQ(before.get_allocator().memory(), nullptr);
  EXPECT_EQ(in_outer.get_allocator().memory(), keeps() ? &outer : nullptr);
  EXPECT_EQ(List<int>().get_allocator().memory(), keeps() ? &outer : nullptr);
}

TEST(List, IsFreedAnywhere) {
  FrameMemory memory;
  const auto make = [&memory] {
    const FrameMemoryScope scope(&memory);
    return List<int>(1000, 7);
  };
  List<int> made = make();
  made.push_back(8);
  EXPECT_EQ(std::accumulate(made.begin(), made.end(), 0), 7008);
}

TEST(List, KeepsItsOwnMemoryWhenItIsCopiedAndTakesTheOtherWhenItIsMoved) {
  FrameMemory memory;
  List<int> in_memory = [&memory] {
    const FrameMemoryScope scope(&memory);
    return List<int>(10, 1);
  }();
  List<int> copy(in_memory), assigned;
  assigned = in_memory;
  EXPECT_EQ(copy.get_allocator().memory(), nullptr);
  EXPECT_EQ(assigned.get_allocator().memory(), nullptr);
  const int* const first = in_memory.data();
  assigned = std::move(in_memory);
  EXPECT_EQ(assigned.data(), first);
  EXPECT_EQ(assigned, copy);
}

TEST(List, OfListsIsFreedIntoEachOnesMemory) {
  FrameMemory memory;
  List<List<int>> lists;
  for (int k = 0; k < 20; ++k) {
    const FrameMemoryScope scope(k % 2 == 0 ? &memory : nullptr);
    lists.push_back(List<int>(static_cast<std::size_t>(k) + 1, k));
  }
  std::reverse(lists.begin(), lists.end());
  lists.erase(lists.begin() + 3, lists.begin() + 9);
  for (const List<int>& list : lists) EXPECT_EQ(list.size(), static_cast<std::size_t>(list.front()) + 1);
}

}  // namespace
}  // namespace primitect::frame_memory_test
