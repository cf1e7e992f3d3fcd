// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Who tells apart what the truth takes for one: tops of boxes a millimetre apart in height.
#pragma once

#include <vector>

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// Which detection each one counts with: itself, or the first of several planes that each lie, by overlap in both
/// directions, on a face of its own of one true shape. Two detections of one face are none of these. labels: of
/// assign().
std::vector<int> joinedOnFaces(const LabelledCloud& input, const std::vector<Shape>& found,
                               const std::vector<int>& labels);

}  // namespace primitect::eval
