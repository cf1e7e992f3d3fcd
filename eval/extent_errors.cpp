// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ends along the axis, outlines by the areas of polygons; see extent_errors.h.
#include "eval/extent_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#define BOOST_ALLOW_DEPRECATED_HEADERS  // it says so of its own headers
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace primitect::eval {
namespace {

namespace geometry = boost::geometry;

using Point = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<Point>;

/// The detection's ends may be the other way round than the true axis: only a cone's axis has a sense.
std::array<double, 2> beyondEnds(const Extent& seen, const Extent& found) {
  const Vec3 axis = seen.rotation.col(2), found_axis = found.rotation.col(2);
  const double middle = (found.origin - seen.origin).dot(axis), sense = found_axis.dot(axis);
  const double longer = 0.5 * (found.size.z() * std::abs(sense) - seen.size.z());
  const double shift = sense < 0.0 ? -middle : middle;
  return {longer - shift, longer + shift};
}

Polygon polygonOf(const std::vector<Vec3>& hull, const Extent& frame) {
  Polygon polygon;
  for (const Vec3& corner : hull) {
    const Vec3 offset = corner - frame.origin;
    geometry::append(polygon, Point(offset.dot(frame.rotation.col(0)), offset.dot(frame.rotation.col(1))));
  }
  geometry::correct(polygon);
  return polygon;
}

/// Nothing where there is no outline, or one without an area.
std::optional<double> outlineOverlap(const Extent& seen, const Extent& found) {
  const Polygon a = polygonOf(seen.hull, seen), b = polygonOf(found.hull, seen);
  if (!(geometry::area(a) > 0.0 && geometry::area(b) > 0.0)) return std::nullopt;
  std::vector<Polygon> shared;
  geometry::intersection(a, b, shared);
  double area = 0.0;
  for (const Polygon& part : shared) area += geometry::area(part);
  return area / (geometry::area(a) + geometry::area(b) - area);
}

}  // namespace

ExtentErrors extentErrors(const Shape& truth, const Extent& seen, const Detection& found) {
  const Kind kind = kindOf(truth);
  if (kindOf(found.shape) != kind) {
    throw std::invalid_argument(std::string("extent errors: a ") + kindName(kindOf(found.shape)) + " compared with a " +
                                kindName(kind));
  }
  ExtentErrors errors;
  if (kind == Kind::plane) errors.outline_overlap = outlineOverlap(seen, found.extent);
  if (kind == Kind::cylinder || kind == Kind::cone) errors.beyond_ends = beyondEnds(seen, found.extent);
  return errors;
}

}  // namespace primitect::eval
