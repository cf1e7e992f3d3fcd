// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Colours of points by their labels.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "io/kind_color.h"
#include "primitect/primitives.h"

namespace primitect::io {

/// Of the n-th of its kind: the kind's own, then darker and lighter, so that faces of a box can be told apart.
inline Rgb shaded(Rgb color, std::size_t n) {
  constexpr std::array<double, 4> kTowards = {0.0, -0.4, 0.45, -0.2};  // black below 0, white above
  const double towards = kTowards[n % kTowards.size()];
  const auto mixed = [towards](std::uint8_t channel) {
    return static_cast<std::uint8_t>(towards < 0.0 ? (1.0 + towards) * channel : channel + towards * (255 - channel));
  };
  return {mixed(color.red), mixed(color.green), mixed(color.blue)};
}

/// The colour of each label: of none, then of each detection.
inline std::vector<Rgb> labelColors(const Detections& detections) {
  std::vector<Rgb> colors = {kUnlabelledColor};
  std::array<std::size_t, kKindCount> counts = {};
  for (const Detection& detection : detections.items) {
    const Kind kind = kindOf(detection.shape);
    colors.push_back(shaded(kindColor(kind), counts[static_cast<std::size_t>(kind)]++));
  }
  return colors;
}

}  // namespace primitect::io
