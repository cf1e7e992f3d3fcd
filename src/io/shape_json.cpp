// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Shapes to JSON and back; see shape_json.h.
#include "io/shape_json.h"

#include <array>
#include <stdexcept>
#include <string>

namespace primitect::io {
namespace {

using Json = nlohmann::ordered_json;

void write(const Plane& plane, Json& json) {
  json["point"] = vectorJson(plane.point);
  json["normal"] = vectorJson(plane.normal);
}

void write(const Sphere& sphere, Json& json) {
  json["center"] = vectorJson(sphere.center);
  json["radius"] = sphere.radius;
}

void write(const Cylinder& cylinder, Json& json) {
  json["point"] = vectorJson(cylinder.point);
  json["axis"] = vectorJson(cylinder.axis);
  json["radius"] = cylinder.radius;
}

void write(const Cone& cone, Json& json) {
  json["apex"] = vectorJson(cone.apex);
  json["axis"] = vectorJson(cone.axis);
  json["half_angle"] = cone.half_angle;
}

Vec3 vectorAt(const Json& json, const char* key) {
  const auto numbers = json.at(key).get<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

Shape shapeOfType(const std::string& type, const Json& json) {
  if (type == kindName(Kind::plane)) return Plane{vectorAt(json, "point"), vectorAt(json, "normal")};
  if (type == kindName(Kind::sphere)) return Sphere{vectorAt(json, "center"), json.at("radius").get<double>()};
  if (type == kindName(Kind::cylinder)) {
    return Cylinder{vectorAt(json, "point"), vectorAt(json, "axis"), json.at("radius").get<double>()};
  }
  if (type == kindName(Kind::cone)) {
    return Cone{vectorAt(json, "apex"), vectorAt(json, "axis"), json.at("half_angle").get<double>()};
  }
  throw std::runtime_error("shape: type '" + type + "' must be plane, sphere, cylinder or cone");
}

}  // namespace

Json shapeJson(const Shape& shape) {
  Json json;
  json["type"] = kindName(kindOf(shape));
  std::visit([&json](const auto& s) { write(s, json); }, shape);
  return json;
}

Shape shapeFromJson(const Json& json) {
  try {
    return shapeOfType(json.at("type").get<std::string>(), json);
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("shape: ") + error.what());
  }
}

}  // namespace primitect::io
