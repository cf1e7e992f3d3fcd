// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Raw files beside a JSON; see dump.h.
#include "eval/dump.h"

#include <fstream>
#include <stdexcept>

#include "eval/metrics.h"
#include "io/shape_json.h"

namespace primitect::eval {
namespace {

using Json = nlohmann::ordered_json;

void writeBytes(const std::string& path, const char* bytes, std::size_t count) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes, static_cast<std::streamsize>(count));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

template <typename Value>
void writeValues(const std::string& path, const std::vector<Value>& values) {
  writeBytes(path, reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

std::vector<float> rowsOf(const Cloud& cloud) {
  std::vector<float> rows;
  rows.reserve(6 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    rows.insert(rows.end(), {cloud.x[i], cloud.y[i], cloud.z[i], cloud.nx[i], cloud.ny[i], cloud.nz[i]});
  }
  return rows;
}

Json shapesJson(const std::vector<Shape>& shapes) {
  Json json = Json::array();
  for (const Shape& shape : shapes) json.push_back(io::shapeJson(shape));
  return json;
}

Json truthJson(const std::vector<TrueShape>& truth) {
  Json json = Json::array();
  for (const TrueShape& item : truth) {
    Json entry = io::shapeJson(item.shape);
    entry["must"] = item.must;
    entry["concave"] = item.concave;
    json.push_back(entry);
  }
  return json;
}

}  // namespace

void writeDump(const LabelledCloud& input, const std::vector<NamedResult>& results, const std::string& folder) {
  const std::string stem = input.recipe.set + "_" + std::to_string(input.recipe.seed);
  const std::string start = folder + "/" + stem;
  Json json = {{"width", input.scored.width},
               {"height", input.scored.height},
               {"points", stem + ".f32"},
               {"surface", stem + ".i32"},
               {"truth", truthJson(input.truth)}};
  writeValues(start + ".f32", rowsOf(input.scored));
  writeValues(start + ".i32", input.surface);
  json["methods"] = Json::object();
  for (const NamedResult& result : results) {
    const std::vector<int> labels = assign(input.scored, result.shapes, input.rules);
    const std::string name = stem + "_" + result.method;
    writeValues(folder + "/" + name + ".i32", labels);
    writeValues(folder + "/" + name + ".f32", measureDistances(input.scored, result.shapes, labels).closest);
    json["methods"][result.method] = {
        {"primitives", shapesJson(result.shapes)}, {"labels", name + ".i32"}, {"distance", name + ".f32"}};
  }
  const std::string text = json.dump(1);
  writeBytes(start + ".json", text.data(), text.size());
}

}  // namespace primitect::eval
