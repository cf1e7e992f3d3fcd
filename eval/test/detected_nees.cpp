// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// End to end: detections in noisy scenes err as their covariances say.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "eval/nees.h"
#include "primitect/detector.h"
#include "test/support/fit_errors.h"
#include "test/support/noisy_points.h"

namespace primitect::eval::detected_nees_test {
namespace {

using test::kKinds;

Shape moved(Shape shape, const Vec3& by) {
  if (Plane* plane = std::get_if<Plane>(&shape)) plane->point += by;
  if (Sphere* sphere = std::get_if<Sphere>(&shape)) sphere->center += by;
  if (Cylinder* cylinder = std::get_if<Cylinder>(&shape)) cylinder->point += by;
  if (Cone* cone = std::get_if<Cone>(&shape)) cone->apex += by;
  return shape;
}

/// One random shape of each kind, 4 to 20 cm large and far enough from each other, measured with noise of all axes
/// alike (m).
struct Scene {
  std::array<Shape, kKindCount> truths;
  Cloud cloud;

  Scene(double noise, std::uint64_t seed) {
    constexpr int kPoints = 1500;
    Random random(seed);
    std::vector<test::SurfacePoint> points;
    for (const Kind kind : kKinds) {
      const auto k = static_cast<std::size_t>(kind);
      const Vec3 place(k % 2 ? 0.6 : -0.6, k / 2 ? 0.6 : -0.6, 0.5);
      test::Patch patch = test::randomPatch(kind, kPoints, random);
      truths[k] = moved(patch.truth, place);
      for (test::SurfacePoint& p : patch.points) points.push_back({p.point + place, p.normal});
    }
    cloud = test::cloudOf(test::measured(points, noise, 0.05, random));
  }
};

/// The detection of that kind whose seen part lies on the true surface.
const Detection* detectionOf(const Shape& truth, const Detections& detections) {
  for (const Detection& detection : detections.items) {
    if (detection.shape.index() != truth.index()) continue;
    const Extent& extent = detection.extent;
    const Vec3 seen = project(detection.shape, extent.origin + 0.01 * extent.rotation.col(0));
    if (std::abs(distance(truth, seen)) < 0.01) return &detection;
  }
  return nullptr;
}

struct Mean {
  double sum = 0.0;  ///< of normalised squared errors
  int degrees = 0;
  int found = 0;
  double value() const { return sum / degrees; }
  /// The sum of the squares of n normal numbers strays by sqrt(2 n).
  double spread() const { return std::sqrt(2.0 / degrees); }
};

/// One millimetre of noise and three in turn.
std::array<Mean, kKindCount> meansOver(int scenes) {
  Params params;
  params.max_depth = 0.0;
  params.orient_normals = false;  // they point out of the shapes
  Detector detector(params);
  std::array<Mean, kKindCount> means;
  for (int seed = 1; seed <= scenes; ++seed) {
    const Scene scene(seed % 2 ? 0.001 : 0.003, static_cast<std::uint64_t>(seed));
    const Detections& detections = detector.detect(scene.cloud);
    for (const Shape& truth : scene.truths) {
      const Detection* found = detectionOf(truth, detections);
      const auto error = found ? normalisedErrors(truth, *found).total(kindOf(truth)) : std::nullopt;
      if (!error) continue;
      Mean& mean = means[truth.index()];
      mean.sum += error->value;
      mean.degrees += error->degrees;
      ++mean.found;
    }
  }
  return means;
}

TEST(Detections, ErrAsTheirCovariancesSay) {
  constexpr int kScenes = 16;
  const std::array<Mean, kKindCount> means = meansOver(kScenes);
  Mean all;
  for (const Kind kind : kKinds) {
    const Mean& mean = means[static_cast<std::size_t>(kind)];
    ASSERT_GE(mean.found, kScenes - 2) << kindName(kind);
    // Calibrated to 20 % at the worst, and three times what chance does.
    EXPECT_NEAR(mean.value(), 1.0, 0.2 + 3.0 * mean.spread()) << kindName(kind);
    all.sum += mean.sum;
    all.degrees += mean.degrees;
  }
  // 288 degrees: chance makes 8 %. Over 150 scenes, all kinds were at 0.97 to 1.2.
  EXPECT_NEAR(all.value(), 1.0, 3.0 * all.spread());
}

}  // namespace
}  // namespace primitect::eval::detected_nees_test
