// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How far the kernels' polynomials are from libm, each compiled as its kernel is.
#pragma once

namespace primitect::test {

/// The largest absolute errors over the whole range, of all lanes.
struct ApproximationErrors {
  double small_arc_sine, small_sine, angle_in_plane, angle_in_half_plane;
  bool zero_without_direction;  ///< angleInQuadrant(0, 0)
};

ApproximationErrors errorsOfPortable();
ApproximationErrors errorsOfAvx2();    ///< only where the processor has AVX2 and FMA
ApproximationErrors errorsOfAvx512();  ///< only where it has AVX-512 (F, DQ, VL, BW)

}  // namespace primitect::test
