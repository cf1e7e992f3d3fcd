// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of the compiled loops this machine can run.
#include "kernels/loops.h"

namespace primitect::kernels {

extern const Loops loops_baseline;
#if defined(__x86_64__)
extern const Loops loops_avx2, loops_avx512;

const Loops& loops() {
  static const Loops& chosen = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                                       __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")
                                   ? loops_avx512
                               : __builtin_cpu_supports("avx2") ? loops_avx2
                                                                : loops_baseline;
  return chosen;
}
#else
const Loops& loops() { return loops_baseline; }
#endif

}  // namespace primitect::kernels
