// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The noise of every sample; see noise.h.
#include "core/noise.h"

#include "core/samples.h"

namespace primitect {

void applyNoise(const NoiseModel& noise, Samples& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples.sigma[i] = static_cast<float>(noise.at(samples.point(i)));
    const double known = kNormalDeviations * samples.normal_sigma[i];
    samples.normal_limit[i] = static_cast<float>(std::max(noise.angle, known));
  }
}

}  // namespace primitect
