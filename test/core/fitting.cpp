// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits from moments and robust refinement, against exact and noisy geometry in random poses.
#include "core/fitting.h"

#include <gtest/gtest.h>

#include "test/support/exact_shapes.h"

namespace primitect::fitting_test {
namespace {

using test::kDegree;
using test::patchOf;
using test::SurfacePoint;

struct Scene {
  Shape truth;
  Samples samples;
  List<std::uint32_t> all;

  Scene(const Shape& shape, const std::vector<SurfacePoint>& points)
      : truth(shape), samples(test::samplesOf(points)), all(test::allOf(samples)) {}
  SampleSet set() const { return {samples, all}; }
  Moments moments() const {
    FitPoints points;
    points.gather(set());
    return momentsOf(points);
  }
};

/// One scene of each kind, about 1 m from the origin, with Gaussian noise along the normals (m).
std::vector<Scene> randomScenes(std::uint64_t seed, double noise) {
  Random random(seed);
  const auto noisy = [&](std::vector<SurfacePoint> points) {
    for (SurfacePoint& p : points) p.point += noise * random.gaussian() * p.normal;
    return points;
  };
  const Plane plane = {Vec3(0, 0, 1) + 0.2 * test::randomPoint(random), test::randomDirection(random)};
  const Sphere sphere = {Vec3(0, 0, 1) + 0.2 * test::randomPoint(random), random.uniform(0.05, 0.2)};
  const Cylinder cylinder = {Vec3(0, 0, 1), test::randomDirection(random), random.uniform(0.05, 0.2)};
  // The body points away from the sensor: towards it, a cone shows nothing but its base.
  Vec3 axis = test::randomDirection(random);
  if (axis.z() < 0.0) axis = -axis;
  const Cone cone = {Vec3(0, 0, 1), axis, random.uniform(12.0, 50.0) * kDegree};
  return {Scene(plane, noisy(patchOf(plane, 300, 0.2, random))), Scene(sphere, noisy(patchOf(sphere, 300, random))),
          Scene(cylinder, noisy(patchOf(cylinder, 300, -0.1, 0.1, random))),
          Scene(cone, noisy(patchOf(cone, 300, 0.05, 0.25, random)))};
}

/// Largest distance of the points from the shape.
double worst(const Shape& shape, const Scene& scene) {
  double result = 0.0;
  for (std::size_t k = 0; k < scene.all.size(); ++k) {
    result = std::max(result, std::abs(distance(shape, scene.set().point(k))));
  }
  return result;
}

/// Root mean square distance between the two surfaces at the points: what a fit gets wrong.
double surfaceError(const Shape& found, const Scene& scene) {
  double sum = 0.0;
  for (std::size_t k = 0; k < scene.all.size(); ++k) {
    const Vec3 on_truth = project(scene.truth, scene.set().point(k));
    sum += distance(found, on_truth) * distance(found, on_truth);
  }
  return std::sqrt(sum / static_cast<double>(scene.all.size()));
}

double generous(const Vec3&) { return 0.05; }

TEST(MomentFit, IsExactOnExactPoints) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const Scene& scene : randomScenes(seed, 0.0)) {
      const std::optional<Shape> found = fitFromMoments(kindOf(scene.truth), scene.moments());
      ASSERT_TRUE(found) << kindName(kindOf(scene.truth)) << " " << seed;
      EXPECT_LT(worst(*found, scene), 1e-4) << kindName(kindOf(scene.truth)) << " " << seed;
    }
  }
}

TEST(MomentFit, GivesNothingWhereTheKindIsNotDetermined) {
  Random random(61);
  const Plane plane = {Vec3(0, 0, 1), -Vec3::UnitZ()};
  const Scene flat(plane, patchOf(plane, 100, 0.2, random));
  EXPECT_FALSE(fitFromMoments(Kind::sphere, flat.moments()));
  EXPECT_FALSE(fitFromMoments(Kind::cylinder, flat.moments()));
  EXPECT_FALSE(fitFromMoments(Kind::cone, flat.moments()));
  const Scene two(plane, patchOf(plane, 2, 0.2, random));
  EXPECT_FALSE(fitFromMoments(Kind::plane, two.moments()));
}

TEST(Refinement, KeepsWhatIsExact) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Scene& scene : randomScenes(seed, 0.0)) {
      const std::optional<Shape> found = refine(scene.truth, scene.set(), generous);
      ASSERT_TRUE(found);
      EXPECT_LT(worst(*found, scene), 1e-6);
    }
  }
}

TEST(Refinement, BringsADisturbedShapeBack) {
  Random random(62);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Scene& scene : randomScenes(seed, 0.0)) {
      const Vec3 shift = 0.005 * test::randomDirection(random);
      const Vec3 tilt = 0.03 * test::randomDirection(random);
      Shape start = scene.truth;
      if (Plane* s = std::get_if<Plane>(&start)) *s = {s->point + shift, (s->normal + tilt).normalized()};
      if (Sphere* s = std::get_if<Sphere>(&start)) *s = {s->center + shift, 1.05 * s->radius};
      if (Cylinder* s = std::get_if<Cylinder>(&start))
        *s = {s->point + shift, (s->axis + tilt).normalized(), 1.05 * s->radius};
      if (Cone* s = std::get_if<Cone>(&start))
        *s = {s->apex + shift, (s->axis + tilt).normalized(), s->half_angle + 0.02};
      EXPECT_GT(worst(start, scene), 1e-3);
      const std::optional<Shape> found = refine(start, scene.set(), generous);
      ASSERT_TRUE(found);
      EXPECT_LT(worst(*found, scene), 1e-5) << kindName(kindOf(start)) << " " << seed;
    }
  }
}

TEST(Refinement, AveragesNoiseAway) {
  constexpr double kNoise = 0.002;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const Scene& scene : randomScenes(seed, kNoise)) {
      const std::optional<Shape> found = refine(scene.truth, scene.set(), generous);
      ASSERT_TRUE(found);
      // At most six parameters from 300 points: sigma sqrt(6 / 300) = 0.14 sigma expected; three times that.
      EXPECT_LT(surfaceError(*found, scene), 0.42 * kNoise) << kindName(kindOf(scene.truth)) << " " << seed;
    }
  }
}

TEST(Refinement, IsNotMovedByOutliers) {
  Random random(63);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (Scene& scene : randomScenes(seed, 0.001)) {
      // A fifth of the points lies 2 to 5 cm off, all on the outer side.
      for (std::size_t i = 0; i < scene.samples.size(); i += 5) {
        const float away = static_cast<float>(random.uniform(0.02, 0.05));
        scene.samples.x[i] += away * scene.samples.nx[i];
        scene.samples.y[i] += away * scene.samples.ny[i];
        scene.samples.z[i] += away * scene.samples.nz[i];
      }
      const std::optional<Shape> found = refine(scene.truth, scene.set(), [](const Vec3&) { return 0.008; });
      ASSERT_TRUE(found);
      double error = 0.0;
      for (std::size_t i = 1; i < scene.samples.size(); i += 5) {
        error = std::max(error, std::abs(distance(*found, project(scene.truth, scene.samples.point(i)))));
      }
      EXPECT_LT(error, 0.001) << kindName(kindOf(scene.truth)) << " " << seed;
    }
  }
}

TEST(Refinement, GivesNothingRatherThanSomethingNotFinite) {
  Random random(64);
  const Sphere sphere = {Vec3(0, 0, 1), 0.1};
  Scene scene(sphere, patchOf(sphere, 50, random));
  scene.samples.x[3] = std::nanf("");  // not within any tolerance: no influence
  ASSERT_TRUE(refine(sphere, scene.set(), generous));
  const std::optional<Shape> far_start = refine(Sphere{Vec3(50, 0, 0), 1e-3}, scene.set(), generous);
  if (far_start) {
    EXPECT_TRUE(std::get<Sphere>(*far_start).center.allFinite());
    EXPECT_GT(std::get<Sphere>(*far_start).radius, 0.0);
  }
}

TEST(Refinement, FindsASlenderConeFromOneThatTapersLessOrMore) {
  // Both touch the same circle: only the angle is wrong, but the apex by half a metre.
  constexpr double kRadius = 0.05;
  const auto throughCircle = [](double half_angle) {
    return Cone{Vec3(0, -kRadius / std::tan(half_angle), 1), Vec3(0, 1, 0), half_angle};
  };
  for (const double half_angle : {0.07, 0.17, 0.26}) {
    Random random(79);
    const double middle = kRadius / std::tan(half_angle);
    const Samples samples =
        test::samplesOf(test::patchOf(throughCircle(half_angle), 500, middle - 0.05, middle + 0.05, random));
    const List<std::uint32_t> all = test::allOf(samples);
    for (const double start : {0.1, 0.2}) {
      const auto found = refine(throughCircle(start), {samples, all}, [](const Vec3&) { return 0.01; });
      ASSERT_TRUE(found) << half_angle << " from " << start;
      EXPECT_NEAR(std::get<Cone>(*found).half_angle, half_angle, 1e-4) << half_angle << " from " << start;
    }
  }
}

/// Of cylinders and cones whose axes are 3 deg beside the truth.
TEST(Refine, HoldsAnAxis) {
  RefineRules rules;
  rules.hold_axis = true;
  for (const Scene& scene : randomScenes(3, 0.001)) {
    const bool cylinder = kindOf(scene.truth) == Kind::cylinder;
    if (!cylinder && kindOf(scene.truth) != Kind::cone) continue;
    Shape start = scene.truth;
    Vec3& axis = cylinder ? std::get<Cylinder>(start).axis : std::get<Cone>(start).axis;
    axis = (axis + 0.05 * axis.unitOrthogonal()).normalized();
    const Vec3 held = axis;
    (cylinder ? std::get<Cylinder>(start).radius : std::get<Cone>(start).half_angle) += 0.02;
    const auto free = refine(start, scene.set(), generous), fit = refine(start, scene.set(), generous, rules);
    ASSERT_TRUE(free && fit);
    const auto axisOf = [&](const Shape& s) { return cylinder ? std::get<Cylinder>(s).axis : std::get<Cone>(s).axis; };
    EXPECT_LT(axisOf(*fit).cross(held).norm(), 1e-12);
    EXPECT_GT(axisOf(*free).cross(held).norm(), 0.02) << "without, it goes to the truth";
    EXPECT_LT(surfaceError(*fit, scene), 0.6 * surfaceError(start, scene)) << "all else moves";
  }
}

}  // namespace
}  // namespace primitect::fitting_test
