// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Compiled as the kernel avx2.
#if defined(__x86_64__)
#include "kernels/avx2_lanes.h"
//
#include "kernels/vector_math.h"
#include "test/kernels/approximation_errors.h"
#include "test/kernels/approximation_errors.inc"

namespace primitect::test {

ApproximationErrors errorsOfAvx2() { return kernels::approximationErrors(); }

}  // namespace primitect::test
#endif
