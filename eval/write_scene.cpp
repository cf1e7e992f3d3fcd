// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Scenes as PLY and JSON; see write_scene.h.
#include "eval/write_scene.h"

#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace primitect::eval {
namespace {

using nlohmann::json;

json toJson(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

json toJson(const Plane& s) { return {{"point", toJson(s.point)}, {"normal", toJson(s.normal)}}; }
json toJson(const Sphere& s) { return {{"center", toJson(s.center)}, {"radius", s.radius}}; }
json toJson(const Cylinder& s) { return {{"point", toJson(s.point)}, {"axis", toJson(s.axis)}, {"radius", s.radius}}; }
json toJson(const Cone& s) {
  return {{"apex", toJson(s.apex)}, {"axis", toJson(s.axis)}, {"half_angle", s.half_angle}};
}

pcl::PointCloud<pcl::PointNormal> toPcl(const Cloud& cloud) {
  pcl::PointCloud<pcl::PointNormal> points;
  points.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    points.push_back({cloud.x[i], cloud.y[i], cloud.z[i], cloud.nx[i], cloud.ny[i], cloud.nz[i]});
  }
  return points;
}

}  // namespace

void writeScene(const synthetic::PaperScene& scene, const std::string& stem) {
  const std::string ply = stem + ".ply";
  // PCL throws for some failures and returns for others.
  try {
    if (pcl::io::savePLYFileBinary(ply, toPcl(scene.cloud)) < 0) throw std::runtime_error("");
  } catch (const std::exception&) {
    throw std::runtime_error(ply + ": cannot be written");
  }
  json primitives = json::array();
  for (const Shape& shape : scene.truth) {
    json entry = std::visit([](const auto& s) { return toJson(s); }, shape);
    entry["type"] = kindName(kindOf(shape));
    primitives.push_back(entry);
  }
  std::ofstream file(stem + ".json");
  file << json{{"primitives", primitives}}.dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error(stem + ".json: cannot be written");
}

}  // namespace primitect::eval
