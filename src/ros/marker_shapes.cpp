// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of the observed part, their outlines and axes; the texts come from marker_text.h.
#include "marker_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry_messages.h"
#include "io/kind_color.h"
#include "marker_text.h"

namespace primitect::ros_layer {
namespace {

using visualization_msgs::Marker;

constexpr int kConeSides = 36;

/// Planes are large and lie behind everything else: less opaque by this.
constexpr double kPlaneShare = 0.45;

std_msgs::ColorRGBA kindColorMessage(Kind kind, double alpha) {
  const io::Rgb color = io::kindColor(kind);
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(color.red / 255.0);
  message.g = static_cast<float>(color.green / 255.0);
  message.b = static_cast<float>(color.blue / 255.0);
  message.a = static_cast<float>(alpha);
  return message;
}

/// Bright enough to be read, and still telling which surface a text belongs to.
std_msgs::ColorRGBA lightened(std_msgs::ColorRGBA color) {
  for (float* channel : {&color.r, &color.g, &color.b}) *channel = 0.35f * *channel + 0.65f;
  return color;
}

/// Makes markers that share header, id and lifetime.
class MarkerMaker {
 public:
  MarkerMaker(const std_msgs::Header& header, const Primitive& primitive, const MarkerStyle& style)
      : header_(header), primitive_(primitive), style_(style), kind_(static_cast<Kind>(primitive.type)) {}

  Marker make(const std::string& suffix, int type, double alpha) const {
    Marker marker;
    marker.header = header_;
    marker.ns = kindName(kind_) + suffix;
    marker.id = static_cast<int>(primitive_.track_id != 0 ? primitive_.track_id : primitive_.id);
    marker.type = type;
    marker.action = Marker::ADD;
    marker.pose.orientation.w = 1.0;
    marker.color = kindColorMessage(kind_, alpha);
    marker.lifetime = ros::Duration(style_.lifetime);
    return marker;
  }

  Marker solid(int type, double diameter, double length) const {
    Marker marker = make("", type, style_.alpha);
    marker.pose = primitive_.pose.pose;
    marker.scale.x = marker.scale.y = diameter;
    marker.scale.z = length;
    return marker;
  }

  Marker arrow(const Vec3& from, const Vec3& to) const {
    Marker marker = make("_axis", Marker::ARROW, 1.0);
    const double length = (to - from).norm();
    const double head = std::min(0.35 * length, 0.03);
    marker.points = {pointMessage(from), pointMessage(to)};
    marker.scale.x = 0.25 * head;  // shaft diameter
    marker.scale.y = 0.6 * head;   // head diameter
    marker.scale.z = head;         // head length
    return marker;
  }

 private:
  const std_msgs::Header& header_;
  const Primitive& primitive_;
  const MarkerStyle& style_;
  Kind kind_;
};

/// Counter-clockwise from outside, where RViz's light comes from.
using Triangle = std::array<Vec3, 3>;

bool facesAway(const Triangle& triangle, const Vec3& viewpoint) {
  const Vec3 outwards = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  return outwards.dot(triangle[0] - viewpoint) > 0.0;
}

/// RViz draws what can be looked through in the order of how far the poses of markers are, and of one marker the
/// triangles in the order in which they come: what is behind must be drawn first, or it hides what is before it.
Marker drawnAt(const MarkerMaker& maker, double alpha, const Vec3& place, const Vec3& viewpoint,
               std::vector<Triangle> triangles) {
  Marker marker = maker.make("", Marker::TRIANGLE_LIST, alpha);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.pose.position = pointMessage(place);
  std::stable_partition(triangles.begin(), triangles.end(),
                        [&viewpoint](const Triangle& triangle) { return facesAway(triangle, viewpoint); });
  for (const Triangle& triangle : triangles) {
    for (const Vec3& corner : triangle) marker.points.push_back(pointMessage(corner - place));
  }
  return marker;
}

/// Its surface is drawn as if it were all where its farthest corner is: before what stands on it.
void addPlane(const MarkerMaker& maker, const Primitive& primitive, const MarkerStyle& style,
              std::vector<Marker>& markers) {
  if (primitive.hull.size() < 3) return;
  std::vector<Triangle> triangles;
  Marker outline = maker.make("_outline", Marker::LINE_STRIP, 1.0);
  outline.scale.x = 0.005;
  const Vec3 first = toVec3(primitive.hull.front());
  Vec3 farthest = first;
  for (std::size_t i = 0; i < primitive.hull.size(); ++i) {
    const Vec3 here = toVec3(primitive.hull[i]);
    if (i >= 2) triangles.push_back({first, toVec3(primitive.hull[i - 1]), here});
    if ((here - style.viewpoint).norm() > (farthest - style.viewpoint).norm()) farthest = here;
    outline.points.push_back(pointMessage(here));
  }
  outline.points.push_back(pointMessage(first));
  const Body body(primitive);
  const double length = std::clamp(0.2 * std::max(primitive.size[0], primitive.size[1]), 0.03, 0.15);
  markers.push_back(drawnAt(maker, kPlaneShare * style.alpha, farthest, style.viewpoint, std::move(triangles)));
  markers.push_back(outline);
  markers.push_back(maker.arrow(body.origin, body.origin + length * body.axis));
}

/// How far the axis arrow looks out of a body of that length.
double axisOverhang(double length) { return std::clamp(0.25 * length, 0.02, 0.1); }

void addCylinder(const MarkerMaker& maker, const Primitive& primitive, std::vector<Marker>& markers) {
  const double length = primitive.size[2];
  if (!(length > 0.0f && primitive.radius > 0.0f)) return;
  const Body body(primitive);
  const Vec3 half = (0.5 * length + axisOverhang(length)) * body.axis;
  markers.push_back(maker.solid(Marker::CYLINDER, 2.0 * primitive.radius, length));
  markers.push_back(maker.arrow(body.origin - half, body.origin + half));
}

void addCone(const MarkerMaker& maker, const Primitive& primitive, const MarkerStyle& style,
             std::vector<Marker>& markers) {
  const double length = primitive.size[2];
  if (!(length > 0.0 && primitive.radius > 0.0f)) return;
  const Body body(primitive);
  const Vec3 narrow = body.origin - 0.5 * length * body.axis;
  const Vec3 wide = body.origin + 0.5 * length * body.axis;
  std::vector<Triangle> triangles;
  const auto rim = [&](int side) {
    const double angle = 2.0 * M_PI * side / kConeSides;
    return Vec3(std::cos(angle) * body.rotation.col(0) + std::sin(angle) * body.rotation.col(1));
  };
  for (int side = 0; side < kConeSides; ++side) {
    const Vec3 here = rim(side), next = rim(side + 1);
    const Vec3 wide_here = wide + primitive.radius * here, wide_next = wide + primitive.radius * next;
    const Vec3 narrow_here = narrow + primitive.radius_small * here;
    triangles.push_back({narrow_here, wide_next, wide_here});
    triangles.push_back({wide, wide_here, wide_next});  // closed, as RViz's cylinders are: the inside has no light
    if (primitive.radius_small > 0.0f) {
      const Vec3 narrow_next = narrow + primitive.radius_small * next;
      triangles.push_back({narrow_here, narrow_next, wide_next});
      triangles.push_back({narrow, narrow_next, narrow_here});
    }
  }
  // From the apex, unless it is far from what was seen.
  const double to_apex = std::min((body.origin - toVec3(primitive.apex)).norm(), 0.5 * length + axisOverhang(length));
  markers.push_back(drawnAt(maker, style.alpha, body.origin, style.viewpoint, std::move(triangles)));
  markers.push_back(maker.arrow(body.origin - to_apex * body.axis, wide + axisOverhang(length) * body.axis));
}

Marker textMarker(const MarkerMaker& maker, const Primitive& primitive, const MarkerStyle& style) {
  Marker text = maker.make("_text", Marker::TEXT_VIEW_FACING, 1.0);
  const double distance = (toVec3(primitive.pose.pose.position) - style.viewpoint).norm();
  text.scale.z = std::clamp(0.022 * distance, 0.01, 0.25);
  text.color = lightened(text.color);
  text.text = describe(primitive);
  text.pose.position =
      pointMessage(textPosition(primitive, {style.up, style.viewpoint, text.scale.z, text.text.size()}));
  return text;
}

}  // namespace

std::vector<Marker> primitiveMarkers(const std_msgs::Header& header, const Primitive& primitive,
                                     const MarkerStyle& style) {
  std::vector<Marker> markers;
  if (primitive.type >= kKindCount) return markers;
  const MarkerMaker maker(header, primitive, style);
  if (primitive.type == Primitive::PLANE) addPlane(maker, primitive, style, markers);
  if (primitive.type == Primitive::SPHERE && primitive.radius > 0.0f) {
    markers.push_back(maker.solid(Marker::SPHERE, 2.0 * primitive.radius, 2.0 * primitive.radius));
  }
  if (primitive.type == Primitive::CYLINDER) addCylinder(maker, primitive, markers);
  if (primitive.type == Primitive::CONE) addCone(maker, primitive, style, markers);
  markers.push_back(textMarker(maker, primitive, style));
  return markers;
}

}  // namespace primitect::ros_layer
