// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes of the paper's data set as files, for `detect` and other programs.
#pragma once

#include <string>

#include "synthetic/paper_dataset.h"

namespace primitect::eval {

/// Writes STEM.ply (binary, with normals) and STEM.json (the true shapes, as `detect --json` writes those found).
/// Throws std::runtime_error naming the file that could not be written.
void writeScene(const synthetic::PaperScene& scene, const std::string& stem);

}  // namespace primitect::eval
