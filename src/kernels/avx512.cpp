// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The voting kernel for x86-64 with AVX-512 (F, DQ, VL, BW). Compiled with flags of its own: nothing but kAvx512 may
// leave this file.
#if defined(__x86_64__)
#include "kernels/avx512_lanes.h"
//
#include "kernels/vector_votes.h"

namespace primitect::kernels {

const Kernels kAvx512 = {"avx512", voteInLanes};

}  // namespace primitect::kernels
#endif
