// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Kind, size and confidence in words, and a place where they hide nothing.
#include "marker_text.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry_messages.h"
#include "io/length_text.h"
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

/// From the middle of a plane's text to where it stands: as far as the text is longer than the plane is wide, to the
/// side that the plane is turned to. On the two faces of a box it then begins or ends at their common edge.
Vec3 besideNarrow(const Primitive& primitive, const Body& body, const TextView& view) {
  constexpr double kWidth = 0.5;   // of a letter, in its height
  constexpr double kTurned = 0.2;  // sine of the angle to the side from which on all of it is moved
  const Vec3 across = (body.origin - view.viewpoint).cross(view.up);
  if (!(across.norm() > 1e-3)) return Vec3::Zero();
  const Vec3 right = across.normalized();
  const double half = 0.5 * kWidth * view.height * static_cast<double>(view.letters);
  const double lacking = half - std::max(reach(primitive, body, right), reach(primitive, body, -right));
  return std::clamp(body.axis.dot(right) / kTurned, -1.0, 1.0) * std::max(lacking, 0.0) * right;
}

/// On one line: texts of things that are side by side would hide each other.
std::string describeShape(const Primitive& primitive) {
  constexpr double kDegrees = 180.0 / M_PI;
  if (primitive.type == Primitive::PLANE) return "plane " + io::lengthsText(primitive.size[0], primitive.size[1]);
  if (primitive.type == Primitive::SPHERE) return "sphere r " + io::lengthText(primitive.radius);
  if (primitive.type == Primitive::CYLINDER)
    return "cylinder r " + io::lengthText(primitive.radius) + " x " + io::lengthText(primitive.size[2]);
  const long half_angle = std::lround(kDegrees * primitive.half_angle);
  return "cone " + std::to_string(half_angle) + " deg x " + io::lengthText(primitive.size[2]);
}

}  // namespace

std::string describe(const Primitive& primitive) {
  constexpr float kSure = 0.9f;  // what most are need not be read
  const std::string confidence = primitive.confidence < kSure ? io::percentText(primitive.confidence) : "";
  return (primitive.concave ? "concave " : "") + describeShape(primitive) +
         (confidence.empty() ? "" : " " + confidence);
}

Vec3 textPosition(const Primitive& primitive, const TextView& view) {
  const Body body(primitive);
  if (primitive.type != Primitive::PLANE) {
    return body.origin + (reach(primitive, body, view.up) + 1.2 * view.height) * view.up;
  }
  const Vec3 lifted = body.origin + view.height * body.axis + besideNarrow(primitive, body, view);
  const Vec3 down = -view.up + view.up.dot(body.axis) * body.axis;  // within the plane
  if (!(down.norm() > 1e-3)) return lifted;
  return lifted + 0.9 * reach(primitive, body, down.normalized()) * down.normalized();
}

}  // namespace primitect::ros_layer
