// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the kernels say about themselves, for those above who cannot see them.
#include "primitect/kernel_choice.h"

#include "kernels/kernels.h"
#include "kernels/loops.h"

namespace primitect {

std::vector<std::string> kernelNames() {
  const kernels::Available available = kernels::availableKernels();
  std::vector<std::string> names;
  for (int k = 0; k < available.count; ++k) names.push_back(available.kernels[k]->name);
  return names;
}

std::string kernelInUse() { return kernels::chosenKernels().name; }

std::string loopsInUse() { return kernels::loops().name; }

}  // namespace primitect
