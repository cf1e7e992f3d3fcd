// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Clouds and what methods found in them as raw files, for drawing and for other programs.
#pragma once

#include <string>
#include <vector>

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// A method's shapes in a cloud.
struct NamedResult {
  std::string method;
  std::vector<Shape> shapes;
};

/// Writes FOLDER/SET_SEED.json, .f32 (rows x y z nx ny nz, NaN = missing), .i32 (LabelledCloud::surface) and for each
/// result SET_SEED_METHOD.i32 (index of each point's detection, -1: none) and .f32 (distance to the closest detection,
/// m); native byte order. The JSON names these files and holds all shapes. Throws std::runtime_error naming the file
/// that could not be written.
void writeDump(const LabelledCloud& input, const std::vector<NamedResult>& results, const std::string& folder);

}  // namespace primitect::eval
