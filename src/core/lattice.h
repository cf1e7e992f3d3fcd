// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that lie, but for a few, on a lattice: those of columns and rows of an image do.
#pragma once

#include <cstddef>
#include <optional>

#include "core/frame_memory.h"

namespace primitect {

/// offset + spacing * (whole numbers)
struct Lattice {
  double offset = 0.0, spacing = 0.0;

  double place(double value) const { return (value - offset) / spacing; }
};

/// As the number of spacings between two values in different places is: less than `near` from a whole one.
bool isWholeAndNotZero(double number, double near);

/// Of the steps between values that follow each other, and are longer than `least`, this share is shorter; 0: there are
/// fewer than 25.
double stepAt(double share, const List<double>& values, double least);

/// Spacing and offset of values that follow each other within a few spacings, from about that spacing: differences of
/// those that are so many places apart are fitted, again with more of them, and from values farther apart.
Lattice latticeFrom(const List<double>& values, double about);

/// Of values in any order, some of them alike; nothing unless nineteen of twenty lie within a tenth of a spacing.
std::optional<Lattice> findLattice(List<double> values);

}  // namespace primitect
