// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One colour a kind of shape, the same in pictures, label clouds and RViz.
#pragma once

#include <array>
#include <cstdint>

#include "primitect/primitives.h"

namespace primitect::io {

/// Red, green, blue, 0 to 255.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

/// In the order of Kind: plane, sphere, cylinder, cone.
constexpr std::array<Rgb, kKindCount> kKindColors = {{{66, 133, 244}, {234, 100, 53}, {52, 168, 83}, {156, 39, 176}}};

/// Points that belong to no detection.
constexpr Rgb kUnlabelledColor = {150, 150, 150};

constexpr Rgb kindColor(Kind kind) { return kKindColors[static_cast<std::size_t>(kind)]; }

}  // namespace primitect::io
