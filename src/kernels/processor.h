// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What this processor has; only for files compiled with the common flags.
#pragma once

namespace primitect::kernels {

#if defined(__x86_64__)
/// All that the files for avx512 are compiled with, but FMA.
inline bool hasAvx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}
#endif

}  // namespace primitect::kernels
