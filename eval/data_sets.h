// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Labelled clouds from recipes; nothing is read from files.
#pragma once

#include <string>
#include <vector>

#include "eval/labelled_cloud.h"

namespace primitect::eval {

/// "paper-spheres", "-cylinders", "-cones", "-planes", "-mixed": the paper's data set, 160,801 points with normals.
/// "concave-...": the same scenes turned inside out, z -> -z, so that every object is a cavity seen from inside.
/// "small": the paper's grid with objects that own 0.3 to 2 % of the points; hidden below that they need not be found.
/// "tabletop": a cluttered table as a depth camera sees it, 640 x 480, without normals; scored without noise.
/// "clutter": such frames without any sphere, cylinder or cone: boxes, ellipsoids, tori, lumps, folded cloth, cables,
/// plants, hands. Whatever curved shape is found there is a false alarm.
/// "household": a table with things of several parts: jars, bottles, piled cans and books; scored as "tabletop".
/// "heap": 12 to 28 things in all poses upon and before one another, seen and scored as "tabletop".
/// "hall": traffic cones, balls, bins, pillars, tubes, crates on the floor, many cut by the image's border, as a robot
/// sees them that drives among them; scored as "tabletop".
/// "objects": one ball, cylinder or cone cut out of a "tabletop" frame, with what is within 3 cm of the box around it.
/// "parts": mechanical parts, 8096 points from all sides, with normals; scored without noise.
std::vector<std::string> dataSetNames();

/// The same recipe gives the same cloud. Throws std::invalid_argument naming the value and its range, and for values
/// that the set does not use (see recipe.h).
LabelledCloud makeLabelledCloud(const Recipe& recipe);

}  // namespace primitect::eval
