// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The loops of loops.h, compiled with the flags for avx512; see CMakeLists.txt.
#define PRIMITECT_LOOPS kLoopsAvx512
#define PRIMITECT_LOOPS_NAME "avx512"
#include "kernels/loops.inc"
