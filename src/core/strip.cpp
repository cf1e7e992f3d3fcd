// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How long and how connected; see strip.h.
#include "core/strip.h"

#include "core/ramp.h"

namespace primitect {

bool isLine(const Detection& detection, const NoiseModel& noise) {
  constexpr double kWidth = 2.0;  // standard deviations of the noise
  if (kindOf(detection.shape) != Kind::plane) return false;
  return detection.extent.size.head<2>().minCoeff() <= kWidth * noise.at(detection.extent.origin);
}

bool isStrip(const Extent& extent) {
  constexpr double kLonger = 2.0;
  return extent.size.head<2>().maxCoeff() > kLonger * extent.size.head<2>().minCoeff();
}

double trustInStrip(const Extent& extent, const Evidence& evidence) {
  const double longer = extent.size.head<2>().maxCoeff(), shorter = extent.size.head<2>().minCoeff();
  // Measured on simulated frames: strips on tubes are 3.5 to 16 times as long as wide, and most run into others by 1.4
  // to 3.8; flat slats on a table by 1.28 at most, of all other planes 99 % by less than 0.4.
  if (!isStrip(extent)) return 1.0;
  return 1.0 - ramp(2.0 * shorter, 3.5 * shorter, longer) * ramp(1.3, 1.5, evidence.runs_into);
}

}  // namespace primitect
