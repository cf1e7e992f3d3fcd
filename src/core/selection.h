// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which hypotheses explain the samples best together: each sample counts for one of them.
#pragma once

#include <cstdint>

#include "core/choice.h"
#include "core/frame_memory.h"
#include "core/hypothesis.h"

namespace primitect {

struct Selection {
  List<std::uint32_t> chosen;  ///< indices in the pool, in the order in which they were chosen
  List<std::uint32_t> owner;   ///< of each sample: index in the pool, or kNobody
};

/// What explains less than this times as much explains no more.
constexpr double kMore = 1.003;

/// Of the same kind, and nearly the same samples explained.
bool alike(const Hypothesis& a, const Hypothesis& b);

/// One of the pool is like the hypothesis, and explains about as much.
bool isKnown(const Hypothesis& hypothesis, const List<Hypothesis>& pool);

/// Chooses a subset of the pool with a large sum over the samples of the best gain of any chosen one, less what each
/// chosen one costs: its price and the samples near it that it does not fit and nobody explains. Greedy, then with
/// exchanges until nothing improves. Each chosen one owns at least min_inliers samples.
Selection selectHypotheses(const Samples& samples, const List<Hypothesis>& pool, std::size_t min_inliers);

/// The same from where the last selection ended, once some of those that it chose explain nothing any more (no support)
/// and others may have joined the pool: only what lies beside what left, or is newly chosen, is tried again.
Selection selectAgain(const Samples& samples, const List<Hypothesis>& pool, std::size_t min_inliers,
                      const List<std::uint32_t>& before);

}  // namespace primitect
