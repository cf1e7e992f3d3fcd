// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points for PCL's writer.
#include "io/pcd_writer.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "io/quiet_pcl.h"

namespace primitect::io {

void writePcd(const std::string& path, const Cloud& cloud) {
  pcl::PointCloud<pcl::PointXYZ> points;
  points.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) points.push_back({cloud.x[i], cloud.y[i], cloud.z[i]});
  points.width = cloud.width, points.height = cloud.height, points.is_dense = false;
  const QuietPcl quiet;
  std::string cause;
  try {
    if (pcl::PCDWriter().writeBinary(path, points) == 0) return;
  } catch (const std::exception& error) {
    cause = std::string(" (") + error.what() + ")";
  }
  std::replace(cause.begin(), cause.end(), '\n', ' ');
  throw std::runtime_error(path + ": cannot be written" + cause);
}

}  // namespace primitect::io
