// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draw a part, sample its boundary, bring it to unit size, name its shapes, add noise, estimate normals.
#include "synthetic/mechanical_part.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "core/random.h"
#include "primitect/transforms.h"
#include "synthetic/csg.h"
#include "synthetic/part_designs.h"
#include "synthetic/pca_normals.h"

namespace primitect::synthetic {
namespace {

constexpr double kSame = 1e-9;  // m, and of unit vectors: shapes closer than this are one

bool sameDirection(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < kSame; }

bool same(const Plane& a, const Plane& b) {
  return sameDirection(a.normal, b.normal) && std::abs(distance(a, b.point)) < kSame;
}
bool same(const Sphere& a, const Sphere& b) {
  return (a.center - b.center).norm() < kSame && std::abs(a.radius - b.radius) < kSame;
}
bool same(const Cylinder& a, const Cylinder& b) {
  return sameDirection(a.axis, b.axis) && std::abs(a.radius - b.radius) < kSame &&
         std::abs(distance(a, b.point) + a.radius) < kSame;
}
bool same(const Cone& a, const Cone& b) {
  return (a.apex - b.apex).norm() < kSame && (a.axis - b.axis).norm() < kSame &&
         std::abs(a.half_angle - b.half_angle) < kSame;
}

bool same(const Shape& a, const Shape& b) {
  const auto compare = [&b](const auto& shape) { return same(shape, std::get<std::decay_t<decltype(shape)>>(b)); };
  return a.index() == b.index() && std::visit(compare, a);
}

/// From the frame in which the part was designed: moved, scaled, then turned.
struct Normalization {
  Vec3 center;
  double scale;
  Eigen::Isometry3d turn;

  Vec3 operator()(const Vec3& p) const { return turn * (scale * (p - center)); }

  Shape operator()(const Shape& shape) const {
    return transformed(turn, std::visit([this](auto s) { return Shape(scaled(s)); }, shape));
  }

 private:
  Vec3 scaledPoint(const Vec3& p) const { return scale * (p - center); }
  Plane scaled(const Plane& p) const { return {scaledPoint(p.point), p.normal}; }
  Sphere scaled(const Sphere& s) const { return {scaledPoint(s.center), scale * s.radius}; }
  Cylinder scaled(const Cylinder& c) const { return {scaledPoint(c.point), c.axis, scale * c.radius}; }
  Cone scaled(const Cone& c) const { return {scaledPoint(c.apex), c.axis, c.half_angle}; }
};

Normalization normalization(const std::vector<BoundaryPoint>& samples, Random& random) {
  Eigen::AlignedBox3d box;
  for (const BoundaryPoint& sample : samples) box.extend(sample.point);
  const double w = random.gaussian(), x = random.gaussian(), y = random.gaussian(), z = random.gaussian();
  return {box.center(), 1.0 / box.sizes().maxCoeff(), Eigen::Isometry3d(Eigen::Quaterniond(w, x, y, z).normalized())};
}

/// Of each face the first one with the same shape.
std::vector<std::size_t> firstAlike(const std::vector<Surface>& faces) {
  std::vector<std::size_t> first(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    while (first[i] < i &&
           !(faces[first[i]].concave == faces[i].concave && same(faces[first[i]].shape, faces[i].shape)))
      ++first[i];
  }
  return first;
}

/// Fills truth, concave and surface: faces with the same shape become one, rare ones are dropped.
void nameShapes(const std::vector<Surface>& faces, const std::vector<BoundaryPoint>& samples, MechanicalPart& part) {
  const std::vector<std::size_t> first = firstAlike(faces);
  std::vector<int> points_of_face(faces.size(), 0), points(faces.size(), 0), index(faces.size(), -1);
  for (const BoundaryPoint& sample : samples) ++points_of_face[sample.surface], ++points[first[sample.surface]];
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (first[i] != i || points[i] < kMinPartPoints) continue;
    // Where two steps meet, one's face may be hidden and look the other way: the shape is that of the seen one.
    std::size_t most_seen = i;
    for (std::size_t k = i; k < faces.size(); ++k) {
      if (first[k] == i && points_of_face[k] > points_of_face[most_seen]) most_seen = k;
    }
    index[i] = static_cast<int>(part.truth.size());
    part.truth.push_back(faces[most_seen].shape);
    part.concave.push_back(faces[most_seen].concave);
  }
  for (const BoundaryPoint& sample : samples) part.surface.push_back(index[first[sample.surface]]);
}

/// The points moved along their normals; not by Cloud::setPoint(), for which a point at the origin is missing.
Cloud noisyCloud(const std::vector<Vec3>& points, const std::vector<Vec3>& normals, double half_width, Random& random) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points.size()), 1, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f point = (points[i] + random.uniform(-half_width, half_width) * normals[i]).cast<float>();
    cloud.x[i] = point.x();
    cloud.y[i] = point.y();
    cloud.z[i] = point.z();
  }
  cloud.countPoints();
  return cloud;
}

}  // namespace

MechanicalPart makeMechanicalPart(std::uint64_t seed, double noise_half_width, std::size_t points) {
  if (!(noise_half_width >= 0.0 && noise_half_width <= 0.1)) {
    throw std::invalid_argument("noise_half_width = " + std::to_string(noise_half_width) + ": must be in 0 to 0.1");
  }
  if (points < 500 || points > 10'000'000) {
    throw std::invalid_argument("points = " + std::to_string(points) + ": must be in 500 to 10000000");
  }
  Random random(seed);
  const Csg solid = drawPart(random);
  const std::vector<BoundaryPoint> samples = solid.sampleBoundary(points, random);
  const Normalization normalized = normalization(samples, random);

  MechanicalPart part;
  nameShapes(solid.surfaces(), samples, part);
  for (Shape& shape : part.truth) shape = normalized(shape);
  std::vector<Vec3> exact_points;
  for (const BoundaryPoint& sample : samples) {
    exact_points.push_back(normalized(sample.point));
    part.normals.push_back(normalized.turn.linear() * sample.normal);
  }
  part.cloud = noisyCloud(exact_points, part.normals, noise_half_width, random);
  estimateNormals(part.cloud, std::sqrt(2.0 / static_cast<double>(points)), part.normals, kPartNeighbors);
  return part;
}

}  // namespace primitect::synthetic
