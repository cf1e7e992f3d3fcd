// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lengths in words, the same in tables, pictures and markers.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

namespace primitect::io {

/// In metres with two digits, or in millimetres; below 10 of these with one digit.
inline std::string digits(double metres, bool in_metres) {
  char text[64];
  const char* const pattern = in_metres ? "%.2f" : metres < 0.00995 ? "%.1f" : "%.0f";
  std::snprintf(text, sizeof(text), pattern, in_metres ? metres : 1000.0 * metres);
  return text;
}

/// Whether whole millimetres would be a thousand or more.
inline bool saidInMetres(double metres) { return metres >= 0.9995; }

/// "39 mm", below 10 mm "4.3 mm", from 1 m on "1.71 m".
inline std::string lengthText(double metres) {
  const bool in_metres = saidInMetres(metres);
  return digits(metres, in_metres) + (in_metres ? " m" : " mm");
}

/// Two sides in the unit that suits the larger: "390 x 120 mm", "1.40 x 0.82 m".
inline std::string lengthsText(double a, double b) {
  const bool in_metres = saidInMetres(std::max(a, b));
  return digits(a, in_metres) + " x " + digits(b, in_metres) + (in_metres ? " m" : " mm");
}

}  // namespace primitect::io
