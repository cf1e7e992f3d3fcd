// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Kind, size and confidence in words, and a place where they hide nothing.
#include "marker_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry_messages.h"
#include "io/percent_text.h"

namespace primitect::ros_layer {
namespace {

/// How far the primitive reaches from its origin in a direction of unit length (m).
double reach(const Primitive& primitive, const Body& body, const Vec3& direction) {
  if (primitive.type == Primitive::PLANE) {
    double farthest = 0.0;
    for (const auto& p : primitive.hull) farthest = std::max(farthest, (toVec3(p) - body.origin).dot(direction));
    return farthest;
  }
  if (primitive.type == Primitive::SPHERE) return primitive.radius;
  const double along = std::abs(body.axis.dot(direction));
  return 0.5 * primitive.size[2] * along + primitive.radius * std::sqrt(std::max(0.0, 1.0 - along * along));
}

std::string length(double metres) {
  char text[32];
  if (metres < 1.0) {
    std::snprintf(text, sizeof text, "%.0f mm", 1000.0 * metres);
  } else {
    std::snprintf(text, sizeof text, "%.2f m", metres);
  }
  return text;
}

std::string describeShape(const Primitive& primitive) {
  if (primitive.type == Primitive::PLANE) return "plane";
  if (primitive.type == Primitive::SPHERE) return "sphere r " + length(primitive.radius);
  if (primitive.type == Primitive::CYLINDER) return "cylinder r " + length(primitive.radius);
  char text[32];
  std::snprintf(text, sizeof text, "cone %.0f deg", primitive.half_angle * 180.0 / M_PI);
  return text;
}

/// What does not fit into the first line.
std::string describeExtent(const Primitive& primitive) {
  if (primitive.type == Primitive::SPHERE) return "";
  if (primitive.type != Primitive::PLANE) return "\nlength " + length(primitive.size[2]);
  char text[32];
  std::snprintf(text, sizeof text, "\n%.2f x %.2f m", primitive.size[0], primitive.size[1]);
  return text;
}

}  // namespace

std::string describe(const Primitive& primitive) {
  const std::string confidence = io::percentText(primitive.confidence);
  return (primitive.concave ? "concave " : "") + describeShape(primitive) +
         (confidence.empty() ? "" : " " + confidence) + describeExtent(primitive);
}

Vec3 textPosition(const Primitive& primitive, const Vec3& up, double height) {
  const Body body(primitive);
  if (primitive.type != Primitive::PLANE) {
    return body.origin + (reach(primitive, body, up) + 1.2 * height) * up;
  }
  const Vec3 down = -up + up.dot(body.axis) * body.axis;  // within the plane
  const Vec3 lifted = body.origin + height * body.axis;
  if (!(down.norm() > 1e-3)) return lifted;
  return lifted + 0.9 * reach(primitive, body, down.normalized()) * down.normalized();
}

}  // namespace primitect::ros_layer
