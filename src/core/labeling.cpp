// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// One pass over the cloud for each detection; see labeling.h.
#include "core/labeling.h"

#include <cmath>
#include <limits>

#include "core/extent.h"
#include "core/matchers.h"

namespace primitect {
namespace {

/// The observed part of a plane, in its own coordinates.
class Outline {
 public:
  explicit Outline(const Extent& extent)
      : origin_(toFloat(extent.origin)), x_(toFloat(extent.rotation.col(0))), y_(toFloat(extent.rotation.col(1))) {
    for (std::size_t k = 0; k < extent.hull.size(); ++k) {
      const Vec3 from = extent.rotation.transpose() * (extent.hull[k] - extent.origin);
      const Vec3 to = extent.rotation.transpose() * (extent.hull[(k + 1) % extent.hull.size()] - extent.origin);
      const double length = (to - from).head<2>().norm();
      if (!(length > 0.0)) continue;
      // Counter-clockwise: what is to the left of every edge is inside.
      const double a = (from.y() - to.y()) / length, b = (to.x() - from.x()) / length;
      edges_.push_back({static_cast<float>(a), static_cast<float>(b), static_cast<float>(a * from.x() + b * from.y())});
      inside_ = std::min(inside_, -edges_.back().offset);
    }
    if (edges_.empty()) inside_ = -1.0f;
  }

  bool holds(const FloatVector& p, float margin) const {
    const FloatVector offset = minus(p, origin_);
    const float x = dot(offset, x_), y = dot(offset, y_);
    // Most points of a large plane lie within the circle that touches the nearest edge.
    if (inside_ > 0.0f && x * x + y * y < inside_ * inside_) return true;
    for (const Edge& edge : edges_) {
      if (edge.a * x + edge.b * y - edge.offset < -margin) return false;
    }
    return true;
  }

 private:
  struct Edge {
    float a, b, offset;
  };
  FloatVector origin_, x_, y_;
  std::vector<Edge> edges_;
  float inside_ = std::numeric_limits<float>::infinity();  ///< radius around the origin, m
};

/// Everywhere: a sphere.
struct Everywhere {
  bool holds(const FloatVector&, float) const { return true; }
};

/// Between the ends of an axis.
class AxisPart {
 public:
  explicit AxisPart(const Extent& extent)
      : origin_(toFloat(extent.origin)),
        axis_(toFloat(extent.rotation.col(2))),
        half_(static_cast<float>(0.5 * extent.size.z())) {}
  bool holds(const FloatVector& p, float margin) const {
    return std::fabs(dot(minus(p, origin_), axis_)) <= half_ + margin;
  }

 private:
  FloatVector origin_, axis_;
  float half_;
};

Outline partOf(const Plane&, const Extent& extent) { return Outline(extent); }
Everywhere partOf(const Sphere&, const Extent&) { return {}; }
AxisPart partOf(const Cylinder&, const Extent& extent) { return AxisPart(extent); }
AxisPart partOf(const Cone&, const Extent& extent) { return AxisPart(extent); }

}  // namespace

void labelPoints(const Cloud& cloud, const std::vector<Detection>& detections, const Tolerance& tolerance,
                 std::vector<std::uint32_t>& labels) {
  labels.assign(cloud.size(), 0);
  // Distance of each point to the shape whose label it has; at first what is allowed.
  std::vector<float> nearest(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    nearest[i] = static_cast<float>(tolerance.distanceAt(Vec3(cloud.x[i], cloud.y[i], cloud.z[i])));
  }
  const std::vector<float> margin = nearest;
  for (std::size_t k = 0; k < detections.size(); ++k) {
    const auto labelWith = [&](const auto& shape) {
      const auto matcher = matcherOf(shape);
      const auto part = partOf(shape, detections[k].extent);
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        const FloatVector p = {cloud.x[i], cloud.y[i], cloud.z[i]};
        const float away = std::fabs(matcher.distanceTo(p));
        if (!(away < nearest[i]) || !part.holds(p, margin[i])) continue;
        nearest[i] = away;
        labels[i] = static_cast<std::uint32_t>(k + 1);
      }
    };
    std::visit(labelWith, detections[k].shape);
  }
}

}  // namespace primitect
