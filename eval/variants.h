// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The same scene with fewer points, unevenly many, in another order, or in another frame.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "primitect/cloud.h"

namespace primitect::eval {

/// Takes points out of an unorganized cloud; those of an organized cloud go missing. A share of `keep` is left at one
/// side of the cloud, and less and less towards the other: `uneven` times fewer there, falling exponentially along a
/// direction across z that the seed chooses. Normals stay those of all points: what is looked at is the sampling.
void thinOut(Cloud& cloud, double keep, double uneven, std::uint64_t seed);

/// Without the missing ones and without rows, as most filters leave them.
void listPoints(Cloud& cloud);

/// Points in random order, without the missing ones and without rows.
void shufflePoints(Cloud& cloud, std::uint64_t seed);

/// The mean of the points in each cube of that side (m), as pcl::VoxelGrid leaves them: in the order of the cubes,
/// without rows. Normals are means, too.
void averageInVoxels(Cloud& cloud, double side);

/// Where the sensor's optical frame is in that of Recipe::robot_frame.
Eigen::Isometry3d robotFromSensor();

}  // namespace primitect::eval
