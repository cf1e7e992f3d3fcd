// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The header of a PLY against the size of its file, and against what PCL's reader can take.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "io/file_checks.h"
#include "io/ply_grid.h"

namespace primitect::io {
namespace {

struct Property {
  std::string name;
  std::string type;         ///< firstName()
  std::uint64_t bytes = 0;  ///< a list: of its length alone, the least it takes
  std::string item_type;    ///< of a list, firstName()
  bool list = false;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  std::string format;
  std::vector<Element> elements;
  std::map<std::string, std::string> object_info;
  std::uint64_t data_begin = 0;
};

[[noreturn]] void refuseHeader(const std::string& path, const std::string& cause) {
  throw FileError(path, "broken PLY header: " + cause);
}

std::uint64_t typeBytes(const std::string& path, const std::string& type) {
  static const std::map<std::string, std::uint64_t> kBytes = {
      {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
      {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
      {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = kBytes.find(type);
  if (found == kBytes.end()) refuseHeader(path, "unknown type '" + type + "'");
  return found->second;
}

/// "uchar" and "int" for their other names: those of types that something is asked about.
std::string firstName(const std::string& type) {
  if (type == "uint8") return "uchar";
  return type == "int32" ? "int" : type;
}

std::uint64_t elementCount(const std::string& path, const std::string& name, const std::string& word) {
  constexpr std::uint64_t kMax = 2147483647;  // PCL counts in int
  const bool digits = !word.empty() && word.size() <= 10 && word.find_first_not_of("0123456789") == std::string::npos;
  if (!digits || std::stoull(word) > kMax) {
    refuseHeader(path, "element " + name + " '" + word + "', expected 0 to " + std::to_string(kMax));
  }
  return std::stoull(word);
}

Property parseProperty(const std::string& path, std::istringstream& words) {
  Property property;
  std::string type, item_type;
  words >> type;
  property.list = type == "list";
  if (property.list) words >> type >> item_type;
  property.bytes = typeBytes(path, type);
  if (property.list) typeBytes(path, item_type);
  property.type = firstName(type);
  property.item_type = firstName(item_type);
  if (!(words >> property.name)) refuseHeader(path, "a property without a name");
  return property;
}

void addProperty(const std::string& path, PlyHeader& header, Property property) {
  if (header.elements.empty()) refuseHeader(path, "a property before the first element");
  std::vector<Property>& properties = header.elements.back().properties;
  for (const Property& other : properties) {
    if (other.name == property.name) refuseHeader(path, "property " + property.name + " twice");
  }
  properties.push_back(std::move(property));
}

void addElement(const std::string& path, PlyHeader& header, std::istringstream& words) {
  Element element;
  std::string count;
  words >> element.name >> count;
  element.count = elementCount(path, element.name, count);
  for (const Element& other : header.elements) {
    if (other.name == element.name) refuseHeader(path, "element " + element.name + " twice");
  }
  header.elements.push_back(std::move(element));
}

PlyHeader parsePlyHeader(const std::string& path, const std::string& bytes) {
  PlyHeader header;
  std::istringstream stream(bytes);
  std::string line, key, name, value;
  if (!std::getline(stream, line) || (line != "ply" && line != "ply\r")) throw FileError(path, "is not a PLY");
  while (std::getline(stream, line)) {
    std::istringstream words(line);
    if (!(words >> key) || key == "comment") continue;
    if (key == "format") {
      words >> header.format;
    } else if (key == "obj_info") {
      if (words >> name >> value && !header.object_info.emplace(name, value).second)
        refuseHeader(path, name + " twice");
    } else if (key == "element") {
      addElement(path, header, words);
    } else if (key == "property") {
      addProperty(path, header, parseProperty(path, words));
    } else if (key == "end_header") {
      header.data_begin = stream.eof() ? bytes.size() : static_cast<std::uint64_t>(stream.tellg());
      return header;
    } else {
      refuseHeader(path, "unknown line '" + key.substr(0, 20) + "'");
    }
  }
  throw FileError(path, "broken PLY: the header is cut off");
}

const Element* findElement(const PlyHeader& header, const std::string& name) {
  for (const Element& element : header.elements) {
    if (element.name == name) return &element;
  }
  return nullptr;
}

/// PCL packs colour bytes into one field; it loses its place or aborts when they are not three of a kind in a row, or
/// blue comes before red.
void checkColors(const std::string& path, const Element& vertex) {
  static const std::set<std::string> kPlain = {"red", "green", "blue"};
  static const std::set<std::string> kDiffuse = {"diffuse_red", "diffuse_green", "diffuse_blue"};
  std::set<std::string> names;
  std::vector<std::size_t> places;
  std::size_t red = 0, blue = 0;
  bool some_bytes = false, all_bytes = true;
  for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
    const Property& property = vertex.properties[i];
    const bool color = kPlain.count(property.name) || kDiffuse.count(property.name);
    if (color || property.name == "alpha") some_bytes = some_bytes || property.bytes == 1;
    if (!color) continue;
    all_bytes = all_bytes && property.type == "uchar";
    names.insert(property.name);
    places.push_back(i);
    if (property.name == "red" || property.name == "diffuse_red") red = i;
    if (property.name == "blue" || property.name == "diffuse_blue") blue = i;
  }
  if (!some_bytes) return;
  const bool in_a_row = (names == kPlain || names == kDiffuse) && places.back() - places.front() == 2;
  if (all_bytes && in_a_row && red < blue) return;
  throw FileError(path,
                  "PLY colours are read only as three uchar properties red, green, blue next to each other, "
                  "blue behind red");
}

/// PCL reads what follows a list from the wrong place.
void refuseLists(const std::string& path, const Element& vertex) {
  for (const Property& property : vertex.properties) {
    if (property.list) throw FileError(path, "PLY vertices with a list ('" + property.name + "') are not supported");
  }
}

/// num_cols * num_rows, or the number of vertices when the file does not say it is a grid.
std::uint64_t pointCount(const std::string& path, const PlyHeader& header, const Element& vertex) {
  const auto columns = header.object_info.find("num_cols"), rows = header.object_info.find("num_rows");
  const bool grid = columns != header.object_info.end() && rows != header.object_info.end();
  if (!grid && (columns != rows || findElement(header, "range_grid"))) {
    refuseHeader(path, "a grid needs both obj_info num_cols and num_rows");
  }
  if (!grid) return vertex.count;
  return elementCount(path, "num_cols", columns->second) * elementCount(path, "num_rows", rows->second);
}

/// PCL makes room for num_cols * num_rows points and aborts when there are more.
void checkRangeGrid(const std::string& path, const PlyHeader& header, const Element& vertex, std::uint64_t cells) {
  const Element* grid = findElement(header, "range_grid");
  const std::string size = " is not num_cols * num_rows = " + std::to_string(cells);
  if (!grid && vertex.count != cells) refuseHeader(path, "vertex " + std::to_string(vertex.count) + size);
  if (!grid) return;
  if (grid->count != cells) refuseHeader(path, "range_grid " + std::to_string(grid->count) + size);
  if (vertex.count > cells) refuseHeader(path, "more vertices than cells of the range_grid");
  if (grid->properties.size() != 1 || !grid->properties[0].list || grid->properties[0].name != "vertex_indices") {
    refuseHeader(path, "a range_grid without its list vertex_indices");
  }
}

/// PCL writes to wherever its indices point. Its own writer puts the grid behind the vertices, and an empty element
/// between them.
void checkGridIndices(const std::string& path, const PlyHeader& header, const Element& vertex) {
  const Element* grid = findElement(header, "range_grid");
  if (!grid) return;
  const Property& list = grid->properties[0];
  const bool of_int = list.type == "uchar" && list.item_type == "int";
  const bool behind_vertices = vertex.count == 0 || &vertex < grid;
  const auto stands_between = [&](const Element& other) {
    return &other < grid && &other != &vertex && other.count > 0;
  };
  if (!of_int || !behind_vertices || std::any_of(header.elements.begin(), header.elements.end(), stands_between)) {
    throw FileError(path, "a PLY's range_grid is read only next to its vertices, of lists of uchar and int");
  }
  PlyGrid place = {
      header.data_begin, vertex.count, 0, grid->count, header.format == "ascii", header.format == "binary_big_endian"};
  for (const Property& property : vertex.properties) place.vertex_bytes += property.bytes;
  checkPlyGrid(path, place);
}

/// The least that the data can take.
std::uint64_t leastBytes(const PlyHeader& header) {
  std::uint64_t bytes = 0;
  for (const Element& element : header.elements) {
    std::uint64_t each = 0;
    for (const Property& property : element.properties) each += header.format == "ascii" ? 2 : property.bytes;
    bytes += each * element.count;
  }
  return header.format == "ascii" && bytes > 0 ? bytes - 1 : bytes;
}

}  // namespace

std::uint64_t checkPlyHead(const std::string& path, const FileHead& head) {
  const PlyHeader header = parsePlyHeader(path, head.bytes);
  if (header.format != "ascii" && header.format != "binary_little_endian" && header.format != "binary_big_endian") {
    refuseHeader(path, "format '" + header.format + "', expected ascii, binary_little_endian or binary_big_endian");
  }
  const Element* vertex = findElement(header, "vertex");
  if (!vertex) refuseHeader(path, "no element vertex");
  for (const Element& element : header.elements) {
    if (element.properties.empty() && element.count > 0)
      refuseHeader(path, "element " + element.name + " has no property");
  }
  refuseLists(path, *vertex);
  checkColors(path, *vertex);
  const std::uint64_t points = pointCount(path, header, *vertex);
  checkRangeGrid(path, header, *vertex, points);
  const std::uint64_t needed = leastBytes(header), there = head.file_size - header.data_begin;
  if (needed > there) {
    throw FileError(path, "truncated PLY: its elements need at least " + std::to_string(needed) +
                              " bytes, the file has " + std::to_string(there));
  }
  if (header.format == "ascii") checkAsciiBody(path, header.data_begin, {});
  checkGridIndices(path, header, *vertex);
  return points;
}

}  // namespace primitect::io
