// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of the observed part, their outlines, axes and texts.
#include "marker_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/kind_color.h"

namespace primitect::ros_layer {
namespace {

using visualization_msgs::Marker;

constexpr int kConeSides = 36;

/// Planes are large and lie behind everything else: less opaque by this.
constexpr double kPlaneShare = 0.45;

Vec3 toVec3(const geometry_msgs::Point& p) { return Vec3(p.x, p.y, p.z); }
Vec3 toVec3(const geometry_msgs::Point32& p) { return Vec3(p.x, p.y, p.z); }

geometry_msgs::Point pointMessage(const Vec3& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

/// A primitive's pose as vectors.
struct Body {
  Vec3 origin;
  Eigen::Matrix3d rotation;
  Vec3 axis;

  explicit Body(const Primitive& primitive) {
    const geometry_msgs::Quaternion& q = primitive.pose.pose.orientation;
    origin = toVec3(primitive.pose.pose.position);
    rotation = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
    axis = rotation.col(2);
  }
};

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

void addTriangle(Marker& marker, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (const Vec3& p : {a, b, c}) marker.points.push_back(pointMessage(p));
}

Marker triangles(const MarkerMaker& maker, double alpha) {
  Marker marker = maker.make("", Marker::TRIANGLE_LIST, alpha);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  return marker;
}

void addPlane(const MarkerMaker& maker, const Primitive& primitive, double alpha, std::vector<Marker>& markers) {
  if (primitive.hull.size() < 3) return;
  Marker surface = triangles(maker, alpha);
  Marker outline = maker.make("_outline", Marker::LINE_STRIP, 1.0);
  outline.scale.x = 0.005;
  const Vec3 first = toVec3(primitive.hull.front());
  for (std::size_t i = 0; i < primitive.hull.size(); ++i) {
    const Vec3 here = toVec3(primitive.hull[i]);
    if (i >= 2) addTriangle(surface, first, toVec3(primitive.hull[i - 1]), here);
    outline.points.push_back(pointMessage(here));
  }
  outline.points.push_back(pointMessage(first));
  const Body body(primitive);
  const double length = std::clamp(0.2 * std::max(primitive.size[0], primitive.size[1]), 0.03, 0.15);
  markers.push_back(surface);
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

void addCone(const MarkerMaker& maker, const Primitive& primitive, double alpha, std::vector<Marker>& markers) {
  const double length = primitive.size[2];
  if (!(length > 0.0 && primitive.radius > 0.0f)) return;
  const Body body(primitive);
  const Vec3 narrow = body.origin - 0.5 * length * body.axis;
  const Vec3 wide = body.origin + 0.5 * length * body.axis;
  Marker surface = triangles(maker, alpha);
  const auto rim = [&](int side) {
    const double angle = 2.0 * M_PI * side / kConeSides;
    return Vec3(std::cos(angle) * body.rotation.col(0) + std::sin(angle) * body.rotation.col(1));
  };
  for (int side = 0; side < kConeSides; ++side) {  // counter-clockwise from outside, where RViz's light comes from
    const Vec3 here = rim(side), next = rim(side + 1);
    const Vec3 wide_here = wide + primitive.radius * here, wide_next = wide + primitive.radius * next;
    const Vec3 narrow_here = narrow + primitive.radius_small * here;
    addTriangle(surface, narrow_here, wide_next, wide_here);
    if (primitive.radius_small > 0.0f) {
      addTriangle(surface, narrow_here, narrow + primitive.radius_small * next, wide_next);
    }
  }
  // From the apex, unless it is far from what was seen.
  const double to_apex = std::min((body.origin - toVec3(primitive.apex)).norm(), 0.5 * length + axisOverhang(length));
  markers.push_back(surface);
  markers.push_back(maker.arrow(body.origin - to_apex * body.axis, wide + axisOverhang(length) * body.axis));
}

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

/// Planes carry their text near the lower edge, where nothing stands on them; bodies on top.
Vec3 textPosition(const Primitive& primitive, const MarkerStyle& style, double height) {
  const Body body(primitive);
  if (primitive.type != Primitive::PLANE) {
    return body.origin + (reach(primitive, body, style.up) + 1.2 * height) * style.up;
  }
  const Vec3 down = -style.up + style.up.dot(body.axis) * body.axis;  // within the plane
  const Vec3 lifted = body.origin + height * body.axis;
  if (!(down.norm() > 1e-3)) return lifted;
  return lifted + 0.9 * reach(primitive, body, down.normalized()) * down.normalized();
}

Marker textMarker(const MarkerMaker& maker, const Primitive& primitive, const MarkerStyle& style) {
  Marker text = maker.make("_text", Marker::TEXT_VIEW_FACING, 1.0);
  const double distance = (toVec3(primitive.pose.pose.position) - style.viewpoint).norm();
  text.scale.z = std::clamp(0.025 * distance, 0.01, 0.25);
  text.pose.position = pointMessage(textPosition(primitive, style, text.scale.z));
  text.color = lightened(text.color);
  text.text = describe(primitive);
  return text;
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

}  // namespace

std::string describe(const Primitive& primitive) {
  char text[32];
  switch (primitive.type) {
    case Primitive::PLANE:
      std::snprintf(text, sizeof text, "plane\n%.2f x %.2f m", primitive.size[0], primitive.size[1]);
      return text;
    case Primitive::SPHERE:
      return "sphere r " + length(primitive.radius);
    case Primitive::CYLINDER:
      return "cylinder r " + length(primitive.radius) + "\nlength " + length(primitive.size[2]);
    default:
      std::snprintf(text, sizeof text, "cone %.0f deg", primitive.half_angle * 180.0 / M_PI);
      return text + ("\nlength " + length(primitive.size[2]));
  }
}

std::vector<Marker> primitiveMarkers(const std_msgs::Header& header, const Primitive& primitive,
                                     const MarkerStyle& style) {
  std::vector<Marker> markers;
  if (primitive.type >= kKindCount) return markers;
  const MarkerMaker maker(header, primitive, style);
  if (primitive.type == Primitive::PLANE) addPlane(maker, primitive, kPlaneShare * style.alpha, markers);
  if (primitive.type == Primitive::SPHERE && primitive.radius > 0.0f) {
    markers.push_back(maker.solid(Marker::SPHERE, 2.0 * primitive.radius, 2.0 * primitive.radius));
  }
  if (primitive.type == Primitive::CYLINDER) addCylinder(maker, primitive, markers);
  if (primitive.type == Primitive::CONE) addCone(maker, primitive, style.alpha, markers);
  markers.push_back(textMarker(maker, primitive, style));
  return markers;
}

}  // namespace primitect::ros_layer
