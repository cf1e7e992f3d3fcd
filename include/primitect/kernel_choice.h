// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which voting kernels this machine can run, and which one runs.
#pragma once

#include <string>
#include <vector>

namespace primitect {

/// Names of the voting kernels that this machine can run, slowest first.
std::vector<std::string> kernelNames();

/// The name of the kernel that all detectors of this process use: what the environment variable PRIMITECT_KERNELS
/// says, or the fastest. Throws std::invalid_argument naming the variable, its value and kernelNames() when that is not
/// one of them.
std::string kernelInUse();

/// The instruction set of the other loops over many points (fits, labels, normals): the widest there is, or the one
/// that PRIMITECT_KERNELS names. All give the same bits.
std::string loopsInUse();

}  // namespace primitect
