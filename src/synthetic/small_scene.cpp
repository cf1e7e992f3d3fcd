// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Objects are drawn without a size first; then the size is found at which they own the wanted number of points.
#include "synthetic/small_scene.h"

#include <array>
#include <cmath>
#include <functional>

#include "core/random.h"
#include "synthetic/paper_objects.h"
#include "synthetic/paper_rendering.h"
#include "synthetic/poses.h"

namespace primitect::synthetic {
namespace {

/// An object of which everything but its size (m) is known.
using Family = std::function<PaperObject(double size)>;

/// Well within the field, 0.1 to 1 m above the background.
Vec3 drawMiddle(Random& random) {
  constexpr double kReach = 1.75;
  const double x = random.uniform(-kReach, kReach), y = random.uniform(-kReach, kReach);
  return {x, y, 0.1 * x + random.uniform(0.1, 1.0)};
}

Family drawSphereFamily(Random& random) {
  const Vec3 center = drawMiddle(random);
  return [center](double size) { return objectOf(Sphere{center, size}); };
}

/// 1 to 3 times as long as wide, |axis_z| <= 0.7.
Family drawCylinderFamily(Random& random) {
  constexpr double kSteepest = 0.7;
  const Vec3 middle = drawMiddle(random);
  Vec3 axis;
  do {
    axis = drawDirection(random, 1.0);
  } while (std::abs(axis.z()) > kSteepest);
  const double half_length_per_radius = random.uniform(1.0, 3.0);
  return [=](double size) {
    const Cylinder cylinder{middle, axis, size};
    const double half_length = half_length_per_radius * size;
    return PaperObject{cylinder, [cylinder, half_length](double x, double y) {
                         const double z = cylinderHeight(cylinder, x, y);
                         const double along = (Vec3(x, y, z) - cylinder.point).dot(cylinder.axis);
                         return std::abs(along) <= half_length ? z : kNothing;
                       }};
  };
}

/// Half angle and axis as the paper's.
Family drawConeFamily(Random& random) {
  Cone cone = std::get<Cone>(drawCone(random).shape);
  const Vec3 middle = drawMiddle(random);
  return [cone, middle](double size) {
    Cone sized = cone;
    sized.apex = middle - 0.5 * size * cone.axis;
    return PaperObject{sized, [sized, size](double x, double y) { return coneHeight(sized, size, x, y); }};
  };
}

/// Corners around the middle, 25 to 60 deg from the background, no corner sharper than 30 deg.
Family drawTriangleFamily(Random& random) {
  const Vec3 middle = drawMiddle(random);
  const double tilt = random.uniform(25.0, 60.0) * kDegree, heading = random.uniform(0.0, 360.0) * kDegree;
  const Vec3 across(std::cos(heading), std::sin(heading), 0.0);
  // Quaternion's FromTwoVectors would compile a singular value decomposition: ten seconds.
  const Vec3 up = normalAt(background().shape, Vec3::Zero());
  const Eigen::AngleAxisd onto_background(std::acos(up.z()), Vec3::UnitZ().cross(up).normalized());
  const Eigen::Matrix3d turn = (onto_background * Eigen::AngleAxisd(tilt, across)).matrix();
  std::array<Vec3, 3> offsets;
  for (int k = 0; k < 3; ++k) {
    const double angle = (120.0 * k + random.uniform(-30.0, 30.0)) * kDegree;
    offsets[k] = turn * Vec3(std::cos(angle), std::sin(angle), 0.0);
  }
  return [middle, offsets](double size) {
    return triangleObject({middle + size * offsets[0], middle + size * offsets[1], middle + size * offsets[2]});
  };
}

constexpr std::array<Family (*)(Random&), kKindCount> kDraw = {drawTriangleFamily, drawSphereFamily, drawCylinderFamily,
                                                               drawConeFamily};

/// Share of the points that the object owns when only the background is behind it.
double shareAlone(const PaperObject& object) {
  const PaperRendering seen = renderFromAbove({background(), object});
  return static_cast<double>(seen.owned[1]) / static_cast<double>(seen.owner.size());
}

/// Draws until an object has about the wanted share.
PaperObject drawOfShare(std::size_t kind, double share, Random& random) {
  constexpr double kFirstSize = 0.25, kNear = 1.1;
  while (true) {
    const Family family = kDraw[kind](random);
    double size = kFirstSize;
    for (int step = 0; step < 4; ++step) {
      const PaperObject object = family(size);
      const double reached = shareAlone(object);
      if (reached <= 0.0) break;
      const bool is_small = kSmallestShare <= reached && reached <= kSmallShareLimit;
      if (is_small && reached < kNear * share && share < kNear * reached) return object;
      size *= std::sqrt(share / reached);
    }
  }
}

}  // namespace

PaperScene makeSmallScene(std::uint64_t seed, double sigma, double outlier_share) {
  checkNoise(sigma, outlier_share);
  // Other numbers than those of the paper's scenes.
  Random random(seed ^ 0x736d616c6cU);
  const std::size_t count = 6 + random.below(5), first_kind = random.below(kKindCount);
  std::vector<PaperObject> objects = {background()};
  for (std::size_t k = 0; k < count; ++k) {
    const double share = kSmallestShare * std::pow(kSmallShareLimit / kSmallestShare, random.uniform());
    objects.push_back(drawOfShare((first_kind + k) % kKindCount, share, random));
  }
  return sceneOf(objects, renderFromAbove(objects), sigma, outlier_share, random);
}

}  // namespace primitect::synthetic
