// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs of labels against one label after the other.
#include "core/label_runs.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/random.h"
#include "kernels/loops.h"

namespace primitect::label_runs_test {
namespace {

/// Labels up to 3 and one with the highest bit, in runs of up to so many.
std::vector<std::uint32_t> randomLabels(std::size_t count, double longest, Random& random) {
  std::vector<std::uint32_t> labels;
  while (labels.size() < count) {
    const auto label = static_cast<std::uint32_t>(random.uniform(0.0, 5.0));
    const auto length = 1 + static_cast<std::size_t>(random.uniform(0.0, longest));
    labels.insert(labels.end(), length, label < 4 ? label : (1u << 31 | 1u));
  }
  labels.resize(count);
  return labels;
}

TEST(LabelRuns, HoldEveryLabelOnce) {
  Random random(3);
  for (const double longest : {1.0, 5.0, 200.0}) {
    for (const std::size_t count : {0, 1, 2, 63, 64, 65, 66, 127, 128, 129, 1000}) {
      const std::vector<std::uint32_t> labels = randomLabels(count, longest, random);
      std::vector<std::uint32_t> again(count, 0);
      std::uint32_t end = 0, before = 0;
      for (const LabelRun& run : labelRuns(labels)) {
        ASSERT_LT(run.begin, run.end);
        EXPECT_TRUE(run.begin > end || (run.begin == end && run.label != before)) << count;
        for (std::uint32_t i = run.begin; i < run.end; ++i) again[i] = run.label;
        end = run.end, before = run.label;
      }
      EXPECT_EQ(again, labels);
    }
  }
}

TEST(LabelRuns, AreThoseOfAllLabelsAgainWhereSomeHaveChanged) {
  Random random(5);
  const List<bool> changed = {true, false, true};
  for (int draw = 0; draw < 50; ++draw) {
    std::vector<std::uint32_t> labels = randomLabels(700, draw % 2 == 0 ? 2.0 : 60.0, random);
    for (std::uint32_t& label : labels) label = label > 3 ? 0 : label;
    const List<LabelRun> before = labelRuns(labels);
    const std::uint32_t to[] = {0, 1, 2, 3, 1u << 31 | 1u};
    for (std::uint32_t& label : labels) {
      const bool may_change = label > 0 && changed[label - 1];
      if (may_change && random.uniform(0.0, 1.0) < 0.3) label = to[static_cast<int>(random.uniform(0.0, 5.0))];
    }
    const List<LabelRun> again = labelRunsAgain(before, changed, labels), expected = labelRuns(labels);
    ASSERT_EQ(again.size(), expected.size());
    for (std::size_t k = 0; k < again.size(); ++k) {
      EXPECT_EQ(again[k].label, expected[k].label);
      EXPECT_EQ(again[k].begin, expected[k].begin);
      EXPECT_EQ(again[k].end, expected[k].end);
    }
  }
}

TEST(LabelRuns, AreFoundByBitsOfEveryInstructionSet) {
  constexpr std::size_t kRun = kernels::kPointsPerRun;
  Random random(4);
  for (int draw = 0; draw < 50; ++draw) {
    const std::vector<std::uint32_t> labels = randomLabels(kRun + 1, 4.0, random);
    std::vector<float> values;
    for (std::size_t i = 0; i < kRun; ++i) {
      values.push_back(labels[i] > 1 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i));
    }
    std::uint64_t changes = 0, measured = 0;
    for (std::size_t i = 0; i < kRun; ++i) {
      changes |= static_cast<std::uint64_t>(labels[i] != labels[i + 1]) << i;
      measured |= static_cast<std::uint64_t>(labels[i] <= 1) << i;
    }
    for (const kernels::Loops* loops : kernels::allLoops()) {
      EXPECT_EQ(loops->changes(labels.data()), changes) << loops->name;
      const kernels::RunOfPoints run = {values.data(), values.data(), values.data(), kernels::kPointsPerRow};
      EXPECT_EQ(loops->ballOfRun(run).measured, measured) << loops->name;
    }
  }
}

TEST(BoxesOfLabels, HoldTheirRunsOverSeveralRows) {
  // 4 x 3 pixels.
  const std::vector<std::uint32_t> labels = {0, 0, 0, 1,  //
                                             1, 0, 2, 2,  //
                                             0, 0, 2, 9};
  const List<PixelBox> boxes = boxesOfLabels(labelRuns(labels), 3, 4);
  ASSERT_EQ(boxes.size(), 3u);
  const auto expectBox = [&](std::size_t k, const PixelBox& box) {
    EXPECT_EQ(boxes[k].left, box.left) << k;
    EXPECT_EQ(boxes[k].right, box.right) << k;
    EXPECT_EQ(boxes[k].top, box.top) << k;
    EXPECT_EQ(boxes[k].bottom, box.bottom) << k;
  };
  expectBox(0, {0, 3, 0, 1});
  expectBox(1, {2, 3, 1, 2});
  EXPECT_GT(boxes[2].left, boxes[2].right) << "no point has this label";
}

}  // namespace
}  // namespace primitect::label_runs_test
