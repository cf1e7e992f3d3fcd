// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// CGAL Efficient RANSAC, in a program of its own: CGAL is GPL.
#pragma once

#include <optional>
#include <string>

#include "eval/methods.h"

namespace primitect::eval {

/// "cgal", "cgal-COUNT", "cgal-3sigma", each with ":planes", ":spheres", ":cylinders" or ":cones" behind it; nothing
/// for any other name. On each cloud it runs the program peer_cgal of toolsFolder(), see peer_cgal.cpp; a run that
/// fails or takes more than two minutes is a failure of the method on that cloud. Throws std::runtime_error when that
/// program is not there.
std::optional<Method> makeCgal(const std::string& name);

/// Whether the program is there.
bool cgalBuilt();

}  // namespace primitect::eval
