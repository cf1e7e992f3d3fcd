// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points for PCL's writer.
#include "io/pcd_writer.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <exception>
#include <stdexcept>

namespace primitect::io {

void writePcd(const std::string& path, const Cloud& cloud) {
  pcl::PointCloud<pcl::PointXYZ> points;
  for (std::size_t i = 0; i < cloud.size(); ++i) points.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
  points.width = cloud.width, points.height = cloud.height, points.is_dense = false;
  bool written = false;
  try {
    written = pcl::PCDWriter().writeBinary(path, points) == 0;
  } catch (const std::exception&) {
    written = false;  // reported like any other file that cannot be written
  }
  if (!written) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace primitect::io
