// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Fits to the surfaces of simulated depth frames: noise along the rays, rounded disparities, lost pixels.
#include <gtest/gtest.h>

#include <array>

#include "primitect/transforms.h"
#include "synthetic/frame.h"
#include "synthetic/tabletop.h"
#include "test/support/fit_errors.h"

namespace primitect::rendered_fits_test {
namespace {

using test::normalisedError;

struct Means {
  double before = 0.0, after = 0.0;  ///< normalised errors of the fits, and with their bias taken out
  int count = 0;
};

/// At most `most` measured points of a surface, evenly taken.
std::vector<Vec3> pointsOn(const synthetic::Frame& frame, const Cloud& cloud, int surface, std::size_t most) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i) && frame.surface[i] == surface) pixels.push_back(i);
  }
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < pixels.size(); k += pixels.size() / most + 1) {
    points.emplace_back(cloud.x[pixels[k]], cloud.y[pixels[k]], cloud.z[pixels[k]]);
  }
  return points;
}

void addFit(const Shape& truth, const std::vector<Vec3>& points, std::array<Means, kKindCount>& means) {
  const auto noise = [](const Vec3& p) { return synthetic::axialSigma(p.z()); };
  std::vector<test::SurfacePoint> surface;
  for (const Vec3& p : points) surface.push_back({p, Vec3::UnitZ()});
  const auto fit = test::fitTo(surface, truth, noise);
  ASSERT_TRUE(fit);
  const Shape shape = withoutBias(*fit, points, noise, NoiseDirection::along_ray);
  const Hessian covariance = measureCovariance(shape, points, noise);
  Means& of_kind = means[static_cast<std::size_t>(kindOf(truth))];
  of_kind.before += normalisedError(*fit, truth, covariance);
  of_kind.after += normalisedError(shape, truth, covariance);
  ++of_kind.count;
}

/// Fits to all surfaces of a few frames that count, from their true shapes.
std::array<Means, kKindCount> fitFrames(std::size_t most_points) {
  const synthetic::PinholeCamera camera;
  const synthetic::FrameParams params;
  std::array<Means, kKindCount> means;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const synthetic::World world = synthetic::tabletop(seed);
    const Eigen::Isometry3d pose = synthetic::cameraPose(static_cast<double>(seed));
    const synthetic::Frame frame = synthetic::renderFrame(world, camera, pose, params, seed, 0);
    Cloud cloud;
    synthetic::cloudFromDepth(frame.depth, camera, params.truth.range, cloud);
    for (std::size_t surface = 0; surface < world.surfaces().size(); ++surface) {
      const std::vector<Vec3> points = pointsOn(frame, cloud, static_cast<int>(surface), most_points);
      if (points.size() < 100) continue;
      addFit(transformed(pose.inverse(), world.surfaces()[surface].shape), points, means);
    }
  }
  for (Means& m : means) {
    m.before /= m.count;
    m.after /= m.count;
  }
  return means;
}

// A dozen cones: their mean strays by sqrt(2 / (12 * 6)) = 17 %, and that of 20 spheres as much. Calibration to 20 % is
// shown by the covariance tests; here a model that misses what such a camera does would be off by a factor.
constexpr double kScatter = 0.45;

TEST(FitsToRenderedFrames, ErrAsTheirCovarianceSays) {
  for (const Means& m : fitFrames(300)) {
    EXPECT_GE(m.count, 10);
    EXPECT_NEAR(m.after, 1.0, kScatter);
  }
}

TEST(FitsToRenderedFrames, AreBetterOnceTheirBiasIsTakenOut) {
  for (const Means& m : fitFrames(8192)) {
    EXPECT_NEAR(m.after, 1.0, kScatter);
    EXPECT_GT(m.before, 1.5 * m.after);
  }
}

}  // namespace
}  // namespace primitect::rendered_fits_test
