// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Chooses the fastest kernels that this processor has the instructions for.
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "kernels/kernels.h"
#include "kernels/processor.h"

namespace primitect::kernels {
namespace {

constexpr const char* kVariable = "PRIMITECT_KERNELS";

}  // namespace

Available availableKernels() {
  Available available = {{&kScalar, &kPortable}, 2};
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    available.kernels[available.count++] = &kAvx2;
    if (hasAvx512()) available.kernels[available.count++] = &kAvx512;
  }
#endif
  return available;
}

const Kernels& kernelsNamed(const char* name) {
  const Available available = availableKernels();
  const std::string wanted = name ? name : "";
  if (wanted.empty()) return *available.kernels[available.count - 1];
  std::string names;
  for (int k = 0; k < available.count; ++k) {
    if (wanted == available.kernels[k]->name) return *available.kernels[k];
    names += (k == 0 ? "" : " or ") + std::string(available.kernels[k]->name);
  }
  throw std::invalid_argument("environment variable " + std::string(kVariable) + " is '" + wanted +
                              "', allowed on this machine: " + names);
}

const Kernels& chosenKernels() {
  static const Kernels& kChosen = kernelsNamed(std::getenv(kVariable));
  return kChosen;
}

}  // namespace primitect::kernels
