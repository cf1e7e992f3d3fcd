// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The loops of loops.h, compiled with the flags of every machine of its kind; see CMakeLists.txt.
#define PRIMITECT_LOOPS kLoopsBaseline
#define PRIMITECT_LOOPS_NAME "baseline"
#include "kernels/loops.inc"
