// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points as PCL wants them.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "primitect/cloud.h"

namespace primitect::eval {

using PclPoints = pcl::PointCloud<pcl::PointXYZ>;
using PclNormals = pcl::PointCloud<pcl::Normal>;

inline pcl::PointXYZ pclPoint(const Cloud& cloud, std::size_t i) { return {cloud.x[i], cloud.y[i], cloud.z[i]}; }
inline pcl::Normal pclNormal(const Cloud& cloud, std::size_t i) { return {cloud.nx[i], cloud.ny[i], cloud.nz[i]}; }

}  // namespace primitect::eval
