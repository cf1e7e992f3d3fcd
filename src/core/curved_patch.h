// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Patches of curved shapes that pass for planes: ridges level with a lid.
#pragma once

#include <cstdint>
#include <vector>

#include "core/frame_memory.h"
#include "core/noise.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// A shape and the label that its points carry in an image.
template <class T>
struct Labelled {
  const T& shape;
  std::uint32_t label;
};

/// Whether pixels of a plane, in rising order, are of a curved shape: nearly all lie within the noise on its observed
/// part, and the squared distances of what lies there, given to the one or the other as is nearer, are at most 1.4
/// times those to the plane. Of ridges level with a lid they are .7 to 1.2 times as large, of pads on a tube, 2 mm
/// high, 1.5 to 4.
bool isPatchOf(const Labelled<Detection>& curved, const Labelled<Plane>& plane, const List<std::uint32_t>& pixels,
               const Cloud& image, const std::vector<std::uint32_t>& labels, const NoiseModel& noise);

}  // namespace primitect
