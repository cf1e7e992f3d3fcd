// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sizes in words.
#include "io/shape_text.h"

#include <cstdio>

#include "io/length_text.h"
#include "primitect/detector.h"

namespace primitect::io {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

/// The parameters whose limits a refusal may have broken; empty where there are none, or these are off.
std::string limitsText(Refusal refusal, const Params& params) {
  switch (refusal) {
    case Refusal::few_inliers:
      return "min_inliers";
    case Refusal::too_large:
      return params.max_radius > 0.0 ? "max_radius" : "";
    case Refusal::too_small:
      return params.min_radius > 0.0 ? "min_radius" : "";
    case Refusal::half_angle:
      return "min_half_angle_deg, max_half_angle_deg";
    case Refusal::unlikely:
      return "min_confidence";
    case Refusal::edge_on:
    case Refusal::not_seen:
      break;
  }
  return "";
}

std::string shapeSize(const Plane&, const Extent& extent) {
  const bool known = extent.size.x() > 0.0 && extent.size.y() > 0.0;
  return known ? lengthsText(extent.size.head<2>().maxCoeff(), extent.size.head<2>().minCoeff()) : "";
}

std::string shapeSize(const Sphere& sphere, const Extent&) { return "r " + lengthText(sphere.radius); }

std::string shapeSize(const Cylinder& cylinder, const Extent&) { return "r " + lengthText(cylinder.radius); }

std::string shapeSize(const Cone& cone, const Extent&) {
  return "half angle " + format("%.1f deg", cone.half_angle * kDegrees);
}

}  // namespace

std::string sizeText(const Detection& detection) {
  return std::visit([&](const auto& shape) { return shapeSize(shape, detection.extent); }, detection.shape);
}

std::string kindText(const Detection& detection) {
  const std::string kind = kindName(kindOf(detection.shape));
  return detection.concave ? "concave " + kind : kind;
}

std::string nameText(const Detection& detection) {
  const std::string size = sizeText(detection);
  const std::string kind = kindText(detection);
  return size.empty() ? kind : kind + " " + size;
}

std::string deviationText(const Detection& detection) {
  const Kind kind = kindOf(detection.shape);
  const float deviation = kind == Kind::cone ? detection.half_angle_stddev : detection.radius_stddev;
  if (kind == Kind::plane || deviation == kUnknown) return "";
  return kind == Kind::cone ? format("%.2f deg", kDegrees * deviation) : format("%.2f mm", 1000.0 * deviation);
}

std::string truncationText(std::uint8_t truncated) {
  if (truncated & kTruncationUnknown) truncated &= kTruncatedByDepth;  // then only this is told
  std::string text;
  const auto add = [&](Truncation bit, const char* word) {
    if (truncated & bit) text += (text.empty() ? "" : ", ") + std::string(word);
  };
  add(kTruncatedByImage, "image");
  add(kTruncatedByDepth, "depth");
  add(kTruncatedByOcclusion, "occlusion");
  return text;
}

std::string refusalsText(const Refusals& refusals, const Params& params) {
  std::string text;
  for (std::size_t i = 0; i < kRefusalCount; ++i) {
    const Refusal refusal = static_cast<Refusal>(i);
    if (refusals[refusal] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(refusals[refusal]) + " " + refusalName(refusal);
    const std::string limits = limitsText(refusal, params);
    if (!limits.empty()) text += " (see " + limits + ")";
  }
  return text;
}

std::string reasonText(const Detections& detections) {
  switch (detections.status) {
    case Status::ok:
      return detections.items.empty()
                 ? "no shape got enough votes (min_votes), inliers (min_inliers) and confidence (min_confidence)"
                 : "";
    case Status::empty_input:
      return "of " + std::to_string(detections.points_in) +
             " points none is measured and within the depth range (min_depth, max_depth)";
    case Status::too_few_points:
      if (detections.points_used >= kFewestPoints) return "all points are in one place";
      return "too few points: only " + std::to_string(detections.points_used) + " of " +
             std::to_string(detections.points_in) + " are measured and within the depth range, at least " +
             std::to_string(kFewestPoints) + " are needed";
    case Status::rejected_input:
      return "the input was rejected: its points or normals are not as many as its width and height say";
    case Status::no_transform:
      return "no transform to the target frame";
  }
  return "";
}

}  // namespace primitect::io
