// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// When to say that a depth image is noisy.
#pragma once

namespace primitect {

/// Of Detections::image_noise; about where tolerances begin to grow.
constexpr double kNoisyImage = 1.5;

}  // namespace primitect
