// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Checks every size in 64 bits against the bytes that are there, then reads them once.
#include "cloud_reader.h"

#include <array>
#include <cstring>

#include "primitect/image_step.h"

namespace primitect::ros_layer {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// Where a number stands in a point.
struct Slot {
  std::uint32_t offset = 0;
  bool is_double = false;
};
using Slots = std::array<Slot, 3>;

const PointField* findField(const PointCloud2& message, const char* name) {
  for (const PointField& field : message.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::string typeName(std::uint8_t datatype) {
  const char* const names[] = {"none", "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  return datatype < 9 ? names[datatype] : "unknown type " + std::to_string(datatype);
}

std::string fieldList(const PointCloud2& message) {
  std::string list;
  for (const PointField& field : message.fields) list += (list.empty() ? "" : ", ") + field.name;
  return list.empty() ? "none" : list;
}

/// What a cloud may have three of.
struct Triple {
  std::array<const char*, 3> names;
  const char* expected;
};
constexpr Triple kPosition = {{"x", "y", "z"}, "x, y, z as float32 or float64"};
constexpr Triple kNormal = {{"normal_x", "normal_y", "normal_z"}, "normal_x, normal_y, normal_z, or none of them"};

/// Fills the slot, or says what is wrong with the field.
std::string checkField(const PointCloud2& message, const char* name, const char* expected, Slot& slot) {
  const PointField* field = findField(message, name);
  const auto label = [name] { return std::string("field '") + name + "'"; };
  if (!field) return label() + " is missing (fields: " + fieldList(message) + "); expected " + expected;
  slot.is_double = field->datatype == PointField::FLOAT64;
  if (!slot.is_double && field->datatype != PointField::FLOAT32) {
    return label() + " is " + typeName(field->datatype) + "; expected float32 or float64";
  }
  if (field->count != 1) return label() + " has count " + std::to_string(field->count) + "; expected 1";
  const std::uint64_t end = std::uint64_t{field->offset} + (slot.is_double ? sizeof(double) : sizeof(float));
  if (end > message.point_step) {
    return label() + " ends at byte " + std::to_string(end) +
           " of a point; expected at most point_step = " + std::to_string(message.point_step);
  }
  slot.offset = field->offset;
  return {};
}

std::string checkFields(const PointCloud2& message, const Triple& triple, Slots& slots) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::string error = checkField(message, triple.names[i], triple.expected, slots[i]);
    if (!error.empty()) return error;
  }
  return {};
}

std::string checkSizes(const PointCloud2& message) {
  const std::uint64_t points = std::uint64_t{message.width} * message.height;
  if (points > kMaxPoints) {
    return "width * height is " + std::to_string(points) + " points; expected at most " + std::to_string(kMaxPoints);
  }
  const std::uint64_t row_bytes = std::uint64_t{message.width} * message.point_step;
  if (message.row_step < row_bytes) {
    return "row_step is " + std::to_string(message.row_step) +
           " bytes; expected at least width * point_step = " + std::to_string(row_bytes);
  }
  // The padding after the last row is not needed.
  const std::uint64_t needed = std::uint64_t{message.row_step} * (message.height - 1) + row_bytes;
  if (message.data.size() < needed) {
    return "data holds " + std::to_string(message.data.size()) + " bytes; expected at least " + std::to_string(needed) +
           " for " + std::to_string(message.width) + " x " + std::to_string(message.height) + " points";
  }
  return {};
}

bool bringsNormals(const PointCloud2& message) {
  for (const char* name : kNormal.names) {
    if (findField(message, name)) return true;
  }
  return false;
}

std::string checkMessage(const PointCloud2& message, bool with_normals, Slots& position, Slots& normal) {
  if (message.is_bigendian) return "data is big-endian; expected little-endian";
  std::string error = checkFields(message, kPosition, position);
  if (error.empty() && with_normals) error = checkFields(message, kNormal, normal);
  return error.empty() ? checkSizes(message) : error;
}

float readSlot(const std::uint8_t* point, Slot slot) {
  if (slot.is_double) {
    double value;
    std::memcpy(&value, point + slot.offset, sizeof value);
    return static_cast<float>(value);
  }
  float value;
  std::memcpy(&value, point + slot.offset, sizeof value);
  return value;
}

/// Every so many-th column and row of the points of a message.
struct PointGrid {
  const std::uint8_t* data;
  std::uint32_t width, height;
  std::size_t point_step, row_step;  // bytes

  PointGrid(const PointCloud2& message, std::uint32_t step)
      : data(message.data.data()),
        width((message.width + step - 1) / step),
        height((message.height + step - 1) / step),
        point_step(std::size_t{message.point_step} * step),
        row_step(std::size_t{message.row_step} * step) {}

  const std::uint8_t* row(std::size_t number) const { return data + number * row_step; }
};

bool areFloats(const Slots& slots) { return !slots[0].is_double && !slots[1].is_double && !slots[2].is_double; }

/// Floats that follow each other, as nearly all messages bring them.
bool areInARow(const Slots& slots) {
  return areFloats(slots) && slots[1].offset == slots[0].offset + sizeof(float) &&
         slots[2].offset == slots[1].offset + sizeof(float);
}

/// Each row is taken apart, then checked, in vectors.
void readRows(const PointGrid& grid, const Slots& slots, const DepthRange& range, Cloud& cloud) {
  for (std::size_t row = 0; row < grid.height; ++row) {
    cloud.setPoints(row * grid.width, grid.width, grid.row(row) + slots[0].offset, grid.point_step, range);
  }
}

/// Calls store(index, a, b, c) for every point; without doubles the inner loop has no branch on the type.
template <typename Store>
void readTriples(const PointGrid& grid, Slots slots, Store store) {
  const bool floats_only = areFloats(slots);
  std::size_t index = 0;
  for (std::uint32_t row = 0; row < grid.height; ++row) {
    const std::uint8_t* point = grid.row(row);
    if (floats_only) {
      for (std::uint32_t column = 0; column < grid.width; ++column, ++index, point += grid.point_step) {
        float a, b, c;
        std::memcpy(&a, point + slots[0].offset, sizeof a);
        std::memcpy(&b, point + slots[1].offset, sizeof b);
        std::memcpy(&c, point + slots[2].offset, sizeof c);
        store(index, a, b, c);
      }
    } else {
      for (std::uint32_t column = 0; column < grid.width; ++column, ++index, point += grid.point_step) {
        store(index, readSlot(point, slots[0]), readSlot(point, slots[1]), readSlot(point, slots[2]));
      }
    }
  }
}

/// The memory of the cloud stays, also that of earlier points.
void readPositions(const PointGrid& grid, const Slots& slots, const DepthRange& range, bool with_normals,
                   Cloud& cloud) {
  cloud.prepare(grid.width, grid.height, with_normals);
  if (areInARow(slots)) return readRows(grid, slots, range, cloud);
  readTriples(grid, slots, [&](std::size_t i, float x, float y, float z) { cloud.setPoint(i, x, y, z, range); });
}

}  // namespace

std::string readCloud(const PointCloud2& message, const DepthRange& range, const Wanted& wanted, Cloud& cloud) {
  const bool with_normals = wanted.normals && bringsNormals(message);
  const bool empty = message.width == 0 || message.height == 0;
  Slots position, normal;
  std::string error = empty ? std::string() : checkMessage(message, with_normals, position, normal);
  if (empty || !error.empty()) {
    cloud.prepare(0, 0, false);
    return error;
  }
  int step = wanted.all_points ? 1 : largestImageStep(message.width, message.height);
  for (int before = 0; step != before;) {
    readPositions(PointGrid(message, static_cast<std::uint32_t>(step)), position, range, with_normals, cloud);
    cloud.dropFilledIn();
    before = step;
    step = imageStepFor(step, cloud.valid_count);
  }
  cloud.step = static_cast<std::uint32_t>(step);
  if (with_normals) {
    readTriples(PointGrid(message, cloud.step), normal,
                [&](std::size_t i, float x, float y, float z) { cloud.setNormal(i, x, y, z); });
  }
  return {};
}

}  // namespace primitect::ros_layer
