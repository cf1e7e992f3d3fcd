// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The loops of loops.h, compiled with the flags for avx2; see CMakeLists.txt.
#define PRIMITECT_LOOPS kLoopsAvx2
#define PRIMITECT_LOOPS_NAME "avx2"
#include "kernels/loops.inc"
