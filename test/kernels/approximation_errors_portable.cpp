// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Compiled as the kernel portable.
#include "kernels/portable_lanes.h"
//
#include "kernels/vector_math.h"
#include "test/kernels/approximation_errors.h"
#include "test/kernels/approximation_errors.inc"

namespace primitect::test {

ApproximationErrors errorsOfPortable() { return kernels::approximationErrors(); }

}  // namespace primitect::test
