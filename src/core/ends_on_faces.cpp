// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends of axes against planes; see ends_on_faces.h.
#include "core/ends_on_faces.h"

#include <cmath>
#include <limits>
#include <optional>

#include "core/axis_extent.h"
#include "core/observed_part.h"

namespace primitect {
namespace {

bool holds(const Detection& plane, const Vec3& place, double margin) {
  const Eigen::Vector3f p = place.cast<float>();
  return ObservedPart(plane.shape, plane.extent).holds(p.x(), p.y(), p.z(), static_cast<float>(margin));
}

/// How far (m) it is along the axis from the origin to the plane; nothing where the axis and the normal are farther
/// apart than by this cosine.
std::optional<double> alongToFace(const Detection& plane, const Extent& extent, double least_cosine) {
  const Plane& face = std::get<Plane>(plane.shape);
  const double cosine = face.normal.dot(extent.rotation.col(2));
  if (std::abs(cosine) < least_cosine) return std::nullopt;
  return (face.point - extent.origin).dot(face.normal) / cosine;
}

/// By how much (m) an axis would have to be longer on this side, -1 or 1, to end on the plane; nothing where it does
/// not.
std::optional<double> longerOnFace(const Detection& plane, double reach, double side, const Extent& extent) {
  constexpr double kLeastCosine = 0.966;  // 15 deg
  constexpr double kReachBefore = 0.6;    // with more, hidden ends come to faces that they are not on
  constexpr double kMostOfLength = 0.5;
  const std::optional<double> along = alongToFace(plane, extent, kLeastCosine);
  if (!along) return std::nullopt;
  const double half = 0.5 * extent.size.z(), longer = side * *along - half;
  const bool near = longer > -reach && longer < kReachBefore * reach;
  if (!near || std::abs(longer) > kMostOfLength * half) return std::nullopt;
  // What stands on a face, or ends with it, has its axis on it, as well as its outline is known.
  if (!holds(plane, extent.origin + *along * extent.rotation.col(2), reach)) return std::nullopt;
  return longer;
}

/// Index of the plane on which it ends.
std::int32_t faceOn(double side, double reach, const Extent& extent, const std::vector<Detection>& items) {
  std::int32_t nearest = kNoFace;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (kindOf(items[k].shape) != Kind::plane) continue;
    const std::optional<double> longer = longerOnFace(items[k], reach, side, extent);
    if (longer && std::abs(*longer) < least) least = std::abs(*longer), nearest = static_cast<std::int32_t>(k);
  }
  return nearest;
}

}  // namespace

void endOn(const Detection& plane, double reach, const Shape& shape, Extent& extent) {
  if (!hasAxis(kindOf(shape))) return;
  for (const double side : {-1.0, 1.0}) {
    const std::optional<double> longer = longerOnFace(plane, reach, side, extent);
    if (longer) moveEnds(side < 0.0 ? -*longer : 0.0, side > 0.0 ? *longer : 0.0, shape, extent);
  }
}

bool mayStandOn(const Detection& plane, double reach, const Extent& extent) {
  constexpr double kLeastCosine = 0.94;  // 20 deg
  constexpr double kMostOfLength = 0.25;
  const Vec3 axis = extent.rotation.col(2);
  const std::optional<double> along = alongToFace(plane, extent, kLeastCosine);
  if (!along || !holds(plane, extent.origin + *along * axis, reach)) return false;
  const double length = extent.size.z();
  return std::abs(std::abs(*along) - 0.5 * length) < kMostOfLength * length + reach;
}

void nameEndFaces(const PointNoise& sigma, std::vector<Detection>& items) {
  for (Detection& item : items) {
    if (!hasAxis(kindOf(item.shape))) continue;
    const double reach = kReachOfFaces * sigma(item.extent.origin);
    Extent& extent = item.extent;
    extent.face_at_minus_z = faceOn(-1.0, reach, extent, items);
    extent.face_at_plus_z = faceOn(1.0, reach, extent, items);
    if (extent.face_at_minus_z != kNoFace) extent.unseen_ends &= static_cast<std::uint8_t>(~kEndAtMinusZ);
    if (extent.face_at_plus_z != kNoFace) extent.unseen_ends &= static_cast<std::uint8_t>(~kEndAtPlusZ);
  }
}

}  // namespace primitect
