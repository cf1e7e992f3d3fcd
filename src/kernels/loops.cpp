// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of the compiled loops this machine can run: the last of the list is the fastest.
#include "kernels/loops.h"

#include <cstdlib>
#include <cstring>

#include "kernels/processor.h"

namespace primitect::kernels {

extern const Loops kLoopsBaseline;
#if defined(__x86_64__)
extern const Loops kLoopsAvx2, kLoopsAvx512;

LoopsList allLoops() {
  LoopsList list = {{&kLoopsBaseline}, 1};
  if (__builtin_cpu_supports("avx2")) list.tables[list.count++] = &kLoopsAvx2;
  if (hasAvx512()) list.tables[list.count++] = &kLoopsAvx512;
  return list;
}
#else
LoopsList allLoops() { return {{&kLoopsBaseline}, 1}; }
#endif

/// Those of this name; of a kernel without loops of its own (scalar, portable): what every processor can run.
static const Loops& loopsNamed(const char* name) {
  const LoopsList list = allLoops();
  if (!name || !*name) return *list.end()[-1];
  for (const Loops* table : list) {
    if (std::strcmp(table->name, name) == 0) return *table;
  }
  return **list.begin();
}

const Loops& loops() {
  static const Loops& chosen = loopsNamed(std::getenv("PRIMITECT_KERNELS"));
  return chosen;
}

}  // namespace primitect::kernels
