// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points that lie near a shape where the camera cannot see it: the other side of a thin wall.
#pragma once

#include <cstdint>
#include <vector>

#include "core/frame_memory.h"
#include "core/label_runs.h"
#include "core/tolerance.h"
#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Added to the label of a point on the far side.
constexpr std::uint32_t kFarSide = 1u << 31;

/// Finds points of curved shapes, labelled by index + 1 of their detection, that lie on the side which a camera at the
/// origin cannot see: a wall as thin as the noise is seen from inside there. Where its other surface is a detection,
/// too, within the tolerance, they become points of that one; else they are marked. Returns which detections have
/// marked points. kept: which detections have a say; empty: all. runs: of these labels.
List<bool> markFarSides(const Cloud& cloud, const std::vector<Detection>& detections, const List<bool>& kept,
                        const Tolerance& tolerance, const List<LabelRun>& runs, std::vector<std::uint32_t>& labels);

/// The same, but takes the labels from the points that would be marked.
void dropFarSides(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                  std::vector<std::uint32_t>& labels);

}  // namespace primitect
