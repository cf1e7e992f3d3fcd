// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The voting kernel for any processor.
#include "kernels/portable_lanes.h"
//
#include "kernels/vector_votes.h"

namespace primitect::kernels {

const Kernels kPortable = {"portable", voteInLanes};

}  // namespace primitect::kernels
