// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How much noisier a depth image is than one of structured light.
#pragma once

#include "core/normals.h"
#include "core/samples.h"
#include "primitect/cloud.h"

namespace primitect {

/// How far the points of a depth image stray from surfaces that are fitted to windows around some of them, in standard
/// deviations of axialNoise(), up to about five; six at most. Of all windows the lower quartile: many hold edges and
/// what is rough. 0 where fewer than a dozen can be fitted.
double measureImageNoise(const Cloud& image, NormalSource& source, const Samples& samples);

}  // namespace primitect
