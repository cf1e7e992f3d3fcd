// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes that samples cannot tell from something else that is there more often.
#pragma once

#include <optional>

#include "core/fitting.h"
#include "core/noise.h"
#include "primitect/primitives.h"

namespace primitect {

/// What the samples are that a shape was fitted to.
struct FittedSamples {
  const Moments& moments;
  double sigma;  ///< m, noise of their distance to a surface
  const NoiseModel& noise;
  bool fitted_normals;  ///< normals are those of many points each
};

/// too_small: a tube or a cone as thin as the edge of a table looks that a depth camera, or how normals are fitted, has
/// rounded; edge_on: a plane through the camera, which sees it as one row or column of pixels. Nothing of others.
std::optional<Refusal> whyIndistinct(const Shape& shape, const FittedSamples& samples);

/// A band of a ball so narrow that noise hides how it curves across. The rim of a pot looks the same, as the normals
/// from windows wider than the rim turn away at its edges. Only of depth cameras.
bool mayBeRing(const Shape& shape, const FittedSamples& samples);

}  // namespace primitect
