// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Field by field, as Primitive.msg describes it.
#include "messages.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry_messages.h"
#include "primitect/transforms.h"

namespace primitect::ros_layer {
namespace {

static_assert(static_cast<int>(Kind::plane) == Primitive::PLANE && static_cast<int>(Kind::sphere) == Primitive::SPHERE);
static_assert(static_cast<int>(Kind::cylinder) == Primitive::CYLINDER);
static_assert(static_cast<int>(Kind::cone) == Primitive::CONE);
static_assert(kKindCount <= Primitive::NO_RIVAL);
static_assert(int{kTruncatedByImage} == Primitive::TRUNCATED_BY_IMAGE);
static_assert(int{kTruncatedByDepth} == Primitive::TRUNCATED_BY_DEPTH);
static_assert(int{kTruncatedByOcclusion} == Primitive::TRUNCATED_BY_OCCLUSION);
static_assert(int{kTruncationUnknown} == Primitive::TRUNCATED_UNKNOWN);
static_assert(static_cast<int>(Status::ok) == PrimitiveArray::OK);
static_assert(static_cast<int>(Status::empty_input) == PrimitiveArray::EMPTY_INPUT);
static_assert(static_cast<int>(Status::too_few_points) == PrimitiveArray::TOO_FEW_POINTS);
static_assert(static_cast<int>(Status::rejected_input) == PrimitiveArray::REJECTED_INPUT);
static_assert(static_cast<int>(Status::no_transform) == PrimitiveArray::NO_TRANSFORM);

/// Of outlines: so that most never need more memory.
constexpr std::size_t kUsualCorners = 64;

geometry_msgs::Point32 point32Message(const Vec3& p) {
  geometry_msgs::Point32 point;
  point.x = static_cast<float>(p.x());
  point.y = static_cast<float>(p.y());
  point.z = static_cast<float>(p.z());
  return point;
}

Shape shapeOf(const Primitive& message, const Extent& extent) {
  const Vec3 axis = extent.rotation.col(2);
  switch (message.type) {
    case Primitive::PLANE:
      return Plane{extent.origin, axis};
    case Primitive::SPHERE:
      return Sphere{extent.origin, message.radius};
    case Primitive::CYLINDER:
      return Cylinder{extent.origin, axis, message.radius};
    case Primitive::CONE:
      return Cone{toVec3(message.apex), axis, message.half_angle};
  }
  throw std::invalid_argument("Primitive.type is " + std::to_string(message.type) +
                              "; expected 0 (plane), 1 (sphere), 2 (cylinder) or 3 (cone)");
}

std::uint8_t rivalNumber(const std::optional<Kind>& rival) {
  return rival ? static_cast<std::uint8_t>(*rival) : std::uint8_t{Primitive::NO_RIVAL};
}

Detection fromMessage(const Primitive& message) {
  Detection detection;
  readExtent(message, detection.extent);
  detection.shape = shapeOf(message, detection.extent);
  detection.votes = message.votes;
  detection.inlier_count = message.inlier_count;
  detection.rms_error = message.rms_error;
  detection.confidence = message.confidence;
  if (message.rival < kKindCount) detection.rival = static_cast<Kind>(message.rival);
  detection.coverage = message.coverage;
  detection.radius_stddev = message.radius_stddev;
  detection.half_angle_stddev = message.half_angle_stddev;
  detection.position_stddev = message.position_stddev;
  detection.axis_stddev = message.axis_stddev;
  std::copy(message.pose.covariance.begin(), message.pose.covariance.end(), detection.covariance.begin());
  detection.concave = message.concave;
  detection.truncated = message.truncated;
  detection.track_id = message.track_id;
  detection.age = message.age;
  return detection;
}

/// All but the memory of the outline.
void clear(Primitive& message) {
  Primitive::_hull_type hull = std::move(message.hull);
  hull.clear();
  message = Primitive();
  message.hull = std::move(hull);
}

void fill(const Detection& detection, std::uint32_t id, Primitive& message) {
  clear(message);
  const Extent& extent = detection.extent;
  message.type = static_cast<std::uint8_t>(kindOf(detection.shape));
  message.id = id;
  message.track_id = detection.track_id;
  message.age = detection.age;
  writePose(extent, message);
  std::copy(detection.covariance.begin(), detection.covariance.end(), message.pose.covariance.begin());
  message.radius = static_cast<float>(extent.radius);
  message.radius_small = static_cast<float>(extent.radius_small);
  if (const Cone* cone = std::get_if<Cone>(&detection.shape)) {
    message.half_angle = static_cast<float>(cone->half_angle);
    message.apex = pointMessage(cone->apex);
  }
  if (!extent.hull.empty()) message.hull.reserve(std::max(kUsualCorners, extent.hull.size()));
  for (const Vec3& p : extent.hull) message.hull.push_back(point32Message(p));
  message.radius_stddev = detection.radius_stddev;
  message.half_angle_stddev = detection.half_angle_stddev;
  message.position_stddev = detection.position_stddev;
  message.axis_stddev = detection.axis_stddev;
  message.confidence = detection.confidence;
  message.rival = rivalNumber(detection.rival);
  message.votes = detection.votes;
  message.inlier_count = detection.inlier_count;
  message.rms_error = detection.rms_error;
  message.coverage = detection.coverage;
  message.concave = detection.concave;
  message.truncated = detection.truncated;
}

/// Makes it so many; what there is too much of waits among the spare ones, whose memory serves when there are more.
void resize(std::size_t count, std::vector<Primitive>& primitives, std::vector<Primitive>& spare) {
  for (; primitives.size() > count; primitives.pop_back()) spare.push_back(std::move(primitives.back()));
  for (; primitives.size() < count && !spare.empty(); spare.pop_back()) primitives.push_back(std::move(spare.back()));
  primitives.resize(count);
}

}  // namespace

Primitive toMessage(const Detection& detection, std::uint32_t id) {
  Primitive message;
  fill(detection, id, message);
  return message;
}

PrimitiveArray& MessageWriter::write(const Detections& detections, const std_msgs::Header& header) {
  message_.header = header;
  resize(detections.items.size(), message_.primitives, spare_);
  for (std::uint32_t id = 0; id < detections.items.size(); ++id)
    fill(detections.items[id], id, message_.primitives[id]);
  message_.points_in = detections.points_in;
  message_.points_used = detections.points_used;
  message_.samples = detections.samples;
  message_.processing_time = 0.0f;
  message_.seen_from_origin = detections.seen_from_origin;
  message_.depth_waves = static_cast<float>(detections.depth_waves);
  message_.status = static_cast<std::uint8_t>(detections.status);
  return message_;
}

PrimitiveArray toMessage(const Detections& detections, const std_msgs::Header& header) {
  return std::move(MessageWriter().write(detections, header));
}

Detections fromMessage(const PrimitiveArray& message) {
  Detections detections;
  for (const Primitive& primitive : message.primitives) detections.items.push_back(fromMessage(primitive));
  detections.status = static_cast<Status>(message.status);
  detections.points_in = message.points_in;
  detections.points_used = message.points_used;
  detections.samples = message.samples;
  detections.seen_from_origin = message.seen_from_origin;
  detections.depth_waves = message.depth_waves;
  return detections;
}

void readExtent(const Primitive& message, Extent& extent) {
  extent.origin = toVec3(message.pose.pose.position);
  extent.rotation = toRotation(message.pose.pose.orientation);
  extent.size = Vec3(message.size[0], message.size[1], message.size[2]);
  extent.radius = message.radius;
  extent.radius_small = message.radius_small;
  extent.unseen_ends = message.unseen_ends;
  extent.face_at_minus_z = message.face_at_minus_z;
  extent.face_at_plus_z = message.face_at_plus_z;
  extent.hull.clear();
  for (const geometry_msgs::Point32& p : message.hull) extent.hull.push_back(toVec3(p));
}

void writePose(const Extent& extent, Primitive& message) {
  message.pose.pose.position = pointMessage(extent.origin);
  message.pose.pose.orientation = quaternionMessage(extent.rotation);
  for (std::size_t i = 0; i < 3; ++i) message.size[i] = static_cast<float>(extent.size[static_cast<int>(i)]);
  message.unseen_ends = extent.unseen_ends;
  message.face_at_minus_z = extent.face_at_minus_z;
  message.face_at_plus_z = extent.face_at_plus_z;
}

void transformPrimitives(const Eigen::Isometry3d& target_from_source, PrimitiveArray& message) {
  for (Primitive& primitive : message.primitives) {
    geometry_msgs::Pose& pose = primitive.pose.pose;
    pose.position = pointMessage(target_from_source * toVec3(pose.position));
    pose.orientation = quaternionMessage(target_from_source.rotation() * toRotation(pose.orientation));
    turnCovariance(target_from_source.rotation(), primitive.pose.covariance.data());
    if (primitive.type == Primitive::CONE) primitive.apex = pointMessage(target_from_source * toVec3(primitive.apex));
    for (geometry_msgs::Point32& p : primitive.hull) p = point32Message(target_from_source * toVec3(p));
  }
}

}  // namespace primitect::ros_layer
