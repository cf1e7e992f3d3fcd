// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PCL's readers made quiet and safe, and their fields converted to a cloud.
#include "io/point_files.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "io/depth_image.h"
#include "io/file_checks.h"
#include "io/quiet_pcl.h"

namespace primitect::io {
namespace {

template <typename Reader>
pcl::PCLPointCloud2 readWithPcl(const std::string& path, const char* format, std::uint64_t points) {
  const QuietPcl quiet;
  pcl::PCLPointCloud2 message;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  int result = -1;
  std::string reason;
  try {
    result = Reader().read(path, message, origin, orientation, version, 0);
  } catch (const std::exception& error) {
    reason = std::string(" (") + error.what() + ")";
  } catch (...) {
    reason = " (unknown error)";
  }
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  const std::uint64_t found = std::uint64_t{message.width} * message.height;
  if (result < 0 || found != points || message.data.size() < found * message.point_step) {
    throw FileError(path, std::string("broken or truncated ") + format + " data" + reason);
  }
  return message;
}

/// Where a float32 or float64 field sits in a point.
struct RealField {
  std::size_t offset = 0;
  bool wide = false;

  float read(const std::uint8_t* point) const {
    if (!wide) return load<float>(point);
    return static_cast<float>(load<double>(point));
  }

 private:
  template <typename Real>
  Real load(const std::uint8_t* point) const {
    Real value;
    std::memcpy(&value, point + offset, sizeof(value));
    return value;
  }
};

const pcl::PCLPointField* findField(const pcl::PCLPointCloud2& message, const std::string& name) {
  for (const pcl::PCLPointField& field : message.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

RealField realField(const std::string& path, const pcl::PCLPointCloud2& message, const std::string& name) {
  const pcl::PCLPointField* field = findField(message, name);
  if (!field) throw FileError(path, "has no field " + name);
  const bool wide = field->datatype == pcl::PCLPointField::FLOAT64;
  if ((!wide && field->datatype != pcl::PCLPointField::FLOAT32) || field->count > 1) {
    throw FileError(path, "field " + name + " is not one float32 or float64");
  }
  if (field->offset + (wide ? 8u : 4u) > message.point_step)
    throw FileError(path, "field " + name + " outside the point");
  return {field->offset, wide};
}

/// True with all of the three fields, false with none.
bool bringsNormals(const std::string& path, const pcl::PCLPointCloud2& message) {
  int found = 0;
  for (const char* name : {"normal_x", "normal_y", "normal_z"}) found += findField(message, name) != nullptr;
  if (found == 1 || found == 2) throw FileError(path, "has only a part of normal_x, normal_y, normal_z");
  return found == 3;
}

Cloud convert(const std::string& path, const pcl::PCLPointCloud2& message) {
  const bool with_normals = bringsNormals(path, message);
  const RealField x = realField(path, message, "x"), y = realField(path, message, "y"),
                  z = realField(path, message, "z");
  RealField nx, ny, nz;
  if (with_normals) {
    nx = realField(path, message, "normal_x");
    ny = realField(path, message, "normal_y");
    nz = realField(path, message, "normal_z");
  }
  Cloud cloud;
  cloud.reset(message.width, message.height, with_normals);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint8_t* point = message.data.data() + i * message.point_step;
    cloud.setPoint(i, x.read(point), y.read(point), z.read(point), DepthRange{});
    if (with_normals) cloud.setNormal(i, nx.read(point), ny.read(point), nz.read(point));
  }
  cloud.dropFilledIn();
  return cloud;
}

}  // namespace

bool isDepthImage(const std::string& path) { return lowerExtension(path) == ".png"; }

PointFile readPointFile(const std::string& path, const DepthImageOptions& options) {
  const FileHead head = readFileHead(path);
  const std::string extension = lowerExtension(path);
  PointFile file;
  if (extension == ".png") {
    file.cloud = readDepthImage(path, head, options);
    file.intrinsics = options.intrinsics;
  } else if (extension == ".pcd") {
    const std::uint64_t points = checkPcdHead(path, head);
    if (points > 0) file.cloud = convert(path, readWithPcl<pcl::PCDReader>(path, "PCD", points));
    file.viewpoint = pcdViewpoint(path, head);
  } else if (extension == ".ply") {
    const std::uint64_t points = checkPlyHead(path, head);
    if (points > 0) file.cloud = convert(path, readWithPcl<pcl::PLYReader>(path, "PLY", points));
  } else {
    throw FileError(path, "unknown extension '" + extension + "', expected .pcd, .ply or .png" +
                              (extension == ".bag" ? "; detect_bag takes bags" : ""));
  }
  return file;
}

void cutAtDepth(const Cloud& cloud, const DepthRange& range, Cloud& cut) {
  cut.reset(cloud.width, cloud.height, cloud.hasNormals());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cut.setPoint(i, cloud.x[i], cloud.y[i], cloud.z[i], range);
    if (cloud.hasNormals()) cut.setNormal(i, cloud.nx[i], cloud.ny[i], cloud.nz[i]);
  }
}

}  // namespace primitect::io
