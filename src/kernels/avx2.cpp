// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The voting kernel for x86-64 with AVX2 and FMA. Compiled with flags of its own: nothing but kAvx2 may leave this
// file.
#if defined(__x86_64__)
#include "kernels/avx2_lanes.h"
//
#include "kernels/vector_votes.h"

namespace primitect::kernels {

const Kernels kAvx2 = {"avx2", voteInLanes};

}  // namespace primitect::kernels
#endif
