// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Label clouds through PCL's PLY writer.
#include "io/label_file.h"

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "io/label_colors.h"

namespace primitect::io {
namespace {

pcl::PointXYZRGBL labelledPoint(const Cloud& cloud, std::size_t i, const std::vector<Rgb>& colors,
                                std::uint32_t label) {
  pcl::PointXYZRGBL point;
  point.x = cloud.x[i];
  point.y = cloud.y[i];
  point.z = cloud.z[i];
  point.label = label;
  const Rgb color = label < colors.size() ? colors[label] : kUnlabelledColor;
  point.r = color.red;
  point.g = color.green;
  point.b = color.blue;
  return point;
}

/// Organized clouds with their missing points, others without.
pcl::PointCloud<pcl::PointXYZRGBL> labelledCloud(const Cloud& cloud, const Detections& detections,
                                                 const std::vector<std::uint32_t>& labels) {
  pcl::PointCloud<pcl::PointXYZRGBL> points;
  const std::vector<Rgb> colors = labelColors(detections);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.organized() || cloud.valid(i)) points.push_back(labelledPoint(cloud, i, colors, labels.at(i)));
  }
  points.is_dense = cloud.valid_count == points.size();
  if (cloud.organized()) {
    points.width = cloud.width;
    points.height = cloud.height;
  }
  return points;
}

/// PCL writes no file without points.
void writeHeaderAlone(std::ofstream& file) {
  file << "ply\nformat binary_little_endian 1.0\nelement vertex 0\n";
  for (const char* property :
       {"float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "uint label"}) {
    file << "property " << property << "\n";
  }
  file << "end_header\n";
}

/// That all of it is there: on a full disk PCL says nothing. Only of files, not of what is written to a pipe.
void checkWritten(const std::string& path, const Cloud& cloud) {
  if (!std::filesystem::is_regular_file(path)) return;
  constexpr std::size_t kVertex = 3 * sizeof(float) + 3 + sizeof(std::uint32_t);  // coordinates, colours, label
  std::ifstream file(path, std::ios::binary);
  std::size_t expected = 0;
  for (std::string line; expected == 0 && std::getline(file, line);) {
    if (line == "end_header") expected = static_cast<std::size_t>(file.tellg());
  }
  expected += kVertex * cloud.valid_count;
  // Of each cell a list of none or of one vertex.
  if (cloud.organized()) expected += cloud.size() + sizeof(std::int32_t) * cloud.valid_count;
  if (std::filesystem::file_size(path) < expected) throw std::runtime_error(path + ": cannot be written as a whole");
}

}  // namespace

void writeLabels(const std::string& path, const Cloud& cloud, const Detections& detections,
                 const std::vector<std::uint32_t>& labels) {
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(labelledCloud(cloud, detections, labels), message);
  // PCL calls the colour "rgba" and would write an alpha that means nothing here.
  for (pcl::PCLPointField& field : message.fields) {
    if (field.name == "rgba") {
      field.name = "rgb";
      field.datatype = pcl::PCLPointField::FLOAT32;
    }
  }
  std::ofstream file(path);
  if (message.data.empty()) writeHeaderAlone(file);
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
  if (message.data.empty()) return;
  // No camera element: with it, missing points would become vertices.
  if (pcl::PLYWriter().writeBinary(path, message, Eigen::Vector4f::Zero(), Eigen::Quaternionf::Identity(), false) < 0) {
    throw std::runtime_error(path + ": cannot be written");
  }
  checkWritten(path, cloud);
}

}  // namespace primitect::io
