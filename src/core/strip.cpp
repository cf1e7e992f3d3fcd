// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How long and how connected; see strip.h.
#include "core/strip.h"

#include <algorithm>

namespace primitect {
namespace {

/// 0 up to the first bound, 1 from the second one on.
double between(double low, double high, double value) { return std::clamp((value - low) / (high - low), 0.0, 1.0); }

}  // namespace

double trustInStrip(const Extent& extent, const Evidence& evidence) {
  const double longer = extent.size.head<2>().maxCoeff(), shorter = extent.size.head<2>().minCoeff();
  // Measured on simulated frames: strips on tubes are 3.5 to 16 times as long as wide and run into others by 1 to 2; of
  // planes that are there 99 % run into others by less than 0.4.
  const double strip = between(2.0 * shorter, 3.5 * shorter, longer);
  return 1.0 - strip * between(0.5, 1.0, evidence.runs_into);
}

}  // namespace primitect
