// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What time is measured on: clouds of the paper's set and simulated depth frames, whole series for the curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "primitect/cloud.h"

namespace primitect::bench {

/// Seeds of development; measuring several scenes keeps one lucky cloud from deciding.
constexpr std::uint64_t kFirstSeed = 2000;

/// The paper's mixed set, noise 0.01 m: 160,801 points with normals each.
std::vector<Cloud> paperClouds(std::size_t count);

/// One scene of that set with so many points, evenly spread over its surfaces, with the noise of the set on points and
/// normals. The same surfaces whatever the count.
Cloud paperCloudOf(std::size_t points);

/// What a frame shows. Depth frames are whole: nothing is cut at any depth.
enum class View { tabletop, clutter, wall };

/// Depth frames of a cluttered table, of such a table without any curved shape, or of a wall alone, with the noise of
/// a structured-light camera; each of another seed.
std::vector<Cloud> depthFrames(View view, int width, int height, std::size_t count);

/// A 640 x 480 frame of a table with 1 to 24 balls, standing rods, cones and boxes on it, in turn, which do not hide
/// one another.
Cloud frameWithObjects(int objects);

}  // namespace primitect::bench
