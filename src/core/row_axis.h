// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The axis through the centre of a camera along the rows of its image, from a list of the image's points.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "primitect/cloud.h"
#include "primitect/primitives.h"

namespace primitect {

/// Two points of a list, mostly of one row where they are near each other in it.
struct RowPair {
  Vec3 first, second;
};

/// Some hundred of the points of a list, at most, moved and scaled so that their mean is 0 and lengths are about 1.
class PointsOfList {
 public:
  explicit PointsOfList(const Cloud& list);

  /// Their indices, in order.
  const std::vector<std::size_t>& places() const { return places_; }
  Vec3 at(std::size_t place) const { return (list_.point(place) - middle_) / size_; }
  /// Each with the one that follows so many places later, where that is not missing.
  std::vector<RowPair> pairs(std::size_t apart) const;
  /// Of the first half of the list with one of the second half.
  std::vector<RowPair> farPairs() const;

 private:
  const Cloud& list_;
  std::vector<std::size_t> places_;
  Vec3 middle_ = Vec3::Zero();  // m
  double size_ = 1.0;           // m
};

/// Of a line along the rows, in the scale of PointsOfList.
struct RowAxis {
  Vec3 along, through;  ///< unit; of its points the nearest to the origin

  /// How far the second point is from the plane of the axis and the first one; infinite where there is none.
  double offPlane(const RowPair& pair) const;
};

constexpr std::size_t kFewestRowPairs = 50;

/// Those of one row: less off its plane than `near`.
std::vector<RowPair> inOneRow(const RowAxis& axis, const std::vector<RowPair>& pairs, double near);

/// Points of a row are in a plane with the axis: the line through two of them meets it, an equation linear in the axis'
/// Pluecker coordinates (Hartley and Zisserman, Multiple View Geometry, 2004, 3.2.2). Most points that are near each
/// other in the list of an image are of one row. So the axis is found from five such pairs, drawn again until nearly
/// all others agree, and by least squares from these. near: as of inOneRow(). Nothing where too few agree.
std::optional<RowAxis> findRowAxis(const PointsOfList& points, double near);

}  // namespace primitect
