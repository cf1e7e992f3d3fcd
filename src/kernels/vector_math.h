// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Angles by polynomials, for a kernel file that has included its lanes. Coefficients: least maximum error, fitted with
// Lawson's iteration. The errors are those of float arithmetic over the whole range, as tested against libm.
#pragma once

namespace primitect::kernels {
namespace {

constexpr float kTiny = 1e-30f;  // stands in for a zero to divide by
constexpr float kPi = 3.14159265358979f;

/// asin x for |x| <= 1/2, within 7e-7 rad. Deviations of up to epsilon need no more, which is at most 30 deg.
inline Floats smallArcSine(Floats x) {
  const Floats x2 = x * x;
  return x + x * x2 * (0.16685562f + x2 * (0.07127701f + x2 * 0.06577032f));
}

/// sin x for 0 <= x <= 1.3, within 3e-7.
inline Floats smallSine(Floats x) {
  const Floats x2 = x * x;
  return x + x * x2 * (-0.16666345f + x2 * (0.00832336f + x2 * -0.00018908f));
}

/// atan2(y, x) in [0, pi/2] for x and y >= 0, within 2.5e-6 rad; 0 for (0, 0).
inline Floats angleInQuadrant(Floats y, Floats x) {
  const Ints steep = y > x;
  const Floats ratio = (steep ? x : y) / larger(steep ? y : x, Floats{} + kTiny);
  const Floats r2 = ratio * ratio;
  const Floats angle =
      ratio * (0.99997722f +
               r2 * (-0.33262283f + r2 * (0.19354037f + r2 * (-0.11642646f + r2 * (0.05264733f + r2 * -0.01171913f)))));
  return steep ? 0.5f * kPi - angle : angle;
}

/// atan2(y, x) in [0, pi] for y >= 0, within 2.5e-6 rad.
inline Floats angleInHalfPlane(Floats y, Floats x) {
  const Floats angle = angleInQuadrant(y, absolute(x));
  return x < 0.0f ? kPi - angle : angle;
}

/// atan2(y, x) in [0, 2 pi], within 2.5e-6 rad.
inline Floats angleInPlane(Floats y, Floats x) {
  const Floats angle = angleInHalfPlane(absolute(y), x);
  return y < 0.0f ? 2.0f * kPi - angle : angle;
}

}  // namespace
}  // namespace primitect::kernels
