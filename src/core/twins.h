// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Two balls for one thing that is not quite a ball.
#pragma once

#include "core/hypothesis.h"

namespace primitect {

/// Balls that are seen from the same side and run through each other all along: their middles no farther apart than a
/// quarter of the larger radius, their radii differ by no more than a fifth of it. No two things are there, but one,
/// such as a bowl or an egg. The outside and the inside of a shell are no twins.
bool areTwins(const Hypothesis& a, const Hypothesis& b);

}  // namespace primitect
