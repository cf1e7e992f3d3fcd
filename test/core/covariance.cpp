// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Reported covariances against the errors that fits to noisy patches really have.
#include "core/covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "core/extent.h"
#include "core/fitting.h"
#include "test/support/fit_errors.h"
#include "test/support/scenes.h"

namespace primitect::covariance_test {
namespace {

using test::kKinds;
using test::NoisyFit;
using test::Patch;

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

Matrix6 poseOf(const Uncertainty& uncertainty) { return Eigen::Map<const Matrix6>(uncertainty.pose.data()); }

/// Mean over seeds of the normalised error, with the bias of the fit taken out.
double meanNormalisedError(Kind kind, int count, double noise, NoiseDirection direction, int seeds) {
  double sum = 0.0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const Patch patch = test::randomPatch(kind, count, random);
    const NoisyFit fit(patch, noise, direction, random);
    if (!fit.shape) return std::nan("");
    const Shape shape = fit.unbiased();
    sum += test::normalisedError(shape, patch.truth, measureCovariance(shape, fit.measured, fit.noise()));
  }
  return sum / seeds;
}

// The mean of 200 normalised errors strays by sqrt(2 / (200 K)), 6 % for a plane; 20 % is what is promised.

TEST(Covariance, IsThatOfTheErrorsForEveryKindAndNumberOfPoints) {
  for (const Kind kind : kKinds) {
    for (const int count : {60, 300, 2000}) {
      EXPECT_NEAR(meanNormalisedError(kind, count, 0.002, NoiseDirection::any, 200), 1.0, 0.2)
          << kindName(kind) << " " << count;
    }
  }
}

TEST(Covariance, IsThatOfTheErrorsForNoiseAlongTheRays) {
  for (const Kind kind : kKinds) {
    for (const int count : {60, 300, 2000}) {
      EXPECT_NEAR(meanNormalisedError(kind, count, 0.003, NoiseDirection::along_ray, 200), 1.0, 0.2)
          << kindName(kind) << " " << count;
    }
  }
}

TEST(Covariance, TakesTheScaleOfTheNoiseFromTheResiduals) {
  // A tolerance that holds all points makes the fit itself the same whatever sigma is said to be.
  for (const Kind kind : kKinds) {
    Random random(7);
    const Patch patch = test::randomPatch(kind, 1000, random);
    const NoisyFit fit(patch, 0.001, NoiseDirection::any, random);
    ASSERT_TRUE(fit.shape);
    const Hessian twice = measureCovariance(*fit.shape, fit.measured, fit.noise(2.0));
    const Hessian fourfold = measureCovariance(*fit.shape, fit.measured, fit.noise(4.0));
    // Both estimate the same from 1000 points, with different weights of the large residuals: a few percent each.
    for (int k = 0; k < parameterCount(kind); ++k) EXPECT_NEAR(twice(k, k) / fourfold(k, k), 1.0, 0.15);
  }
}

TEST(Covariance, GrowsWithTheNumberOfPointsThatShareTheirNoise) {
  Random random(8);
  const Patch patch = test::randomPatch(Kind::sphere, 100, random);
  const NoisyFit fit(patch, 0.001, NoiseDirection::any, random);
  const Hessian alone = measureCovariance(*fit.shape, fit.measured, fit.noise());
  const Hessian shared = measureCovariance(*fit.shape, fit.measured, fit.noise(), {{3.0, 3.0}, {}});
  EXPECT_LT((shared - 3.0 * alone).norm(), 1e-12 * shared.norm());
}

/// Of a fit to points whose noise is independent.
Uncertainties uncertaintiesOf(Kind kind, const SharedErrors& shared, const HeldAxis& axis = {}) {
  Random random(6);
  const Patch patch = test::randomPatch(kind, 200, random);
  const NoisyFit fit(patch, 0.001, NoiseDirection::any, random);
  const SeenPoints points(fit.measured);
  return measureUncertainty(*fit.shape, measureExtent(*fit.shape, points), points, fit.noise(), shared, axis);
}

TEST(Covariance, IsJudgedByWhatIsShownOfSharedNoiseAndPublishedWithAllOfIt) {
  const double alone = uncertaintiesOf(Kind::sphere, {}).by_all.radius_stddev;
  const auto [judged, published] = uncertaintiesOf(Kind::sphere, {{4.0, 9.0}, {}});
  EXPECT_NEAR(judged.radius_stddev, 2.0 * alone, 1e-6 * alone);
  EXPECT_NEAR(published.radius_stddev, 3.0 * alone, 1e-6 * alone);
}

TEST(Covariance, IsPublishedWithAllThatAHeldAxisIsOff) {
  const auto [judged, published] = uncertaintiesOf(Kind::cylinder, {}, {0.01, 0.02});
  EXPECT_NEAR(judged.axis_stddev, 0.01, 1e-6);
  EXPECT_NEAR(published.axis_stddev, 0.02, 1e-6);
}

/// Shift and turn that take the fit's pose to the truth's, of which directions that nobody can observe are left out.
Gradient poseError(const Shape& fit, const Shape& truth, const Vec3& origin) {
  Gradient error = Gradient::Zero();
  if (const Plane* plane = std::get_if<Plane>(&fit)) {
    const Plane& t = std::get<Plane>(truth);
    const double height = (t.point - origin).dot(t.normal) / plane->normal.dot(t.normal);
    error << height * plane->normal, plane->normal.cross(t.normal);
  } else if (const Sphere* sphere = std::get_if<Sphere>(&fit)) {
    error.head<3>() = std::get<Sphere>(truth).center - sphere->center;
  } else if (const Cylinder* cylinder = std::get_if<Cylinder>(&fit)) {
    const Cylinder& t = std::get<Cylinder>(truth);
    const Vec3 offset = t.point - origin;
    error << offset - offset.dot(cylinder->axis) / t.axis.dot(cylinder->axis) * t.axis, cylinder->axis.cross(t.axis);
  } else {
    const Cone& cone = std::get<Cone>(fit);
    const Cone& t = std::get<Cone>(truth);
    const double height = (origin - cone.apex).dot(cone.axis);
    error << t.apex + height * t.axis - origin, cone.axis.cross(t.axis);
  }
  return error;
}

TEST(PoseCovariance, IsThatOfTheErrorsInWhatCanBeObserved) {
  constexpr int kSeeds = 200, kObservable[] = {3, 3, 4, 5};
  for (const Kind kind : kKinds) {
    double sum = 0.0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const Patch patch = test::randomPatch(kind, 300, random);
      const NoisyFit fit(patch, 0.004, NoiseDirection::any, random);
      ASSERT_TRUE(fit.shape);
      const Shape shape = fit.unbiased();
      const Extent extent = measureExtent(shape, fit.measured);
      const Matrix6 covariance = poseOf(measureUncertainty(shape, extent, fit.measured, fit.noise()).by_all);
      const Gradient error = poseError(shape, patch.truth, extent.origin);
      sum += test::normalisedSquare(error, covariance) / kObservable[static_cast<int>(kind)];
    }
    EXPECT_NEAR(sum / kSeeds, 1.0, 0.2) << kindName(kind);
  }
}

TEST(PoseCovariance, OfSlenderConesFarFromTheirApexIsThatOfTheErrors) {
  constexpr int kTimes = 200, kPoints = 500;
  constexpr double kNoise = 0.002, kFrom = 0.3, kTo = 0.38, kObservable = 5.0;
  const Cone truth = {Vec3(-0.34, 0.0, 1.2), Vec3::UnitX(), 0.19};
  Random random(11);
  double sum = 0.0;
  for (int time = 0; time < kTimes; ++time) {
    std::vector<Vec3> measured;
    for (int i = 0; i < kPoints; ++i) {
      const test::SurfacePoint p = test::pointOn(truth, {random.uniform(kFrom, kTo), random.uniform(-1.3, 1.3)});
      measured.push_back(p.point + kNoise * random.gaussian() * p.normal);
    }
    FitPoints points;
    points.gather(SeenPoints(measured), NoiseModel{kNoise});
    const auto fit = refine(truth, points);
    ASSERT_TRUE(fit) << time;
    const Extent extent = measureExtent(*fit, measured);
    const Matrix6 covariance = poseOf(measureUncertainty(*fit, extent, measured, NoiseModel{kNoise}).by_all);
    const double square = test::normalisedSquare(poseError(*fit, truth, extent.origin), covariance) / kObservable;
    sum += square;
  }
  EXPECT_NEAR(sum / kTimes, 1.0, 0.2);
}

double trueRadius(const Shape& truth, const Extent& extent) {
  if (const Sphere* sphere = std::get_if<Sphere>(&truth)) return sphere->radius;
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&truth)) return cylinder->radius;
  const Cone& cone = std::get<Cone>(truth);
  const Vec3 wide_end = extent.origin + 0.5 * extent.size.z() * extent.rotation.col(2);
  return (wide_end - cone.apex).dot(cone.axis) * std::tan(cone.half_angle);
}

TEST(RadiusAndAngle, StrayAsTheyAreSaidTo) {
  constexpr int kSeeds = 200;
  for (const Kind kind : {Kind::sphere, Kind::cylinder, Kind::cone}) {
    double radius = 0.0, angle = 0.0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      Random random(static_cast<std::uint64_t>(seed));
      const Patch patch = test::randomPatch(kind, 300, random);
      const NoisyFit fit(patch, 0.002, NoiseDirection::any, random);
      ASSERT_TRUE(fit.shape);
      const Shape shape = fit.unbiased();
      const Extent extent = measureExtent(shape, fit.measured);
      const Uncertainty said = measureUncertainty(shape, extent, fit.measured, fit.noise()).by_all;
      radius += std::pow((trueRadius(patch.truth, extent) - extent.radius) / said.radius_stddev, 2) / kSeeds;
      if (kind != Kind::cone) continue;
      const double off = std::get<Cone>(shape).half_angle - std::get<Cone>(patch.truth).half_angle;
      angle += std::pow(off / said.half_angle_stddev, 2) / kSeeds;
    }
    // The mean of 200 squares strays by 10 %.
    EXPECT_NEAR(radius, 1.0, 0.3) << kindName(kind);
    if (kind == Kind::cone) {
      EXPECT_NEAR(angle, 1.0, 0.3);
    }
  }
}

/// Of a fit to 300 points with 2 mm of noise; its pose's covariance in the frame of the extent.
struct PatchUncertainty {
  Uncertainty uncertainty;
  Eigen::Matrix3d shift, turn;
};

PatchUncertainty uncertaintyOfPatch(Kind kind, Random& random) {
  const Patch patch = test::randomPatch(kind, 300, random);
  const NoisyFit fit(patch, 0.002, NoiseDirection::any, random);
  const Extent extent = measureExtent(*fit.shape, fit.measured);
  const Uncertainty uncertainty = measureUncertainty(*fit.shape, extent, fit.measured, fit.noise()).by_all;
  const Matrix6 covariance = poseOf(uncertainty);
  const Eigen::Matrix3d& axes = extent.rotation;
  return {uncertainty, axes.transpose() * covariance.topLeftCorner<3, 3>() * axes,
          axes.transpose() * covariance.bottomRightCorner<3, 3>() * axes};
}

TEST(PoseCovariance, SaysWhatCannotBeObserved) {
  Random random(9);
  for (const Kind kind : kKinds) {
    const PatchUncertainty of_patch = uncertaintyOfPatch(kind, random);
    const Eigen::Matrix3d &shift = of_patch.shift, &turn = of_patch.turn;
    const bool plane = kind == Kind::plane, sphere = kind == Kind::sphere;
    // Patches of some centimetres, 300 points, 2 mm: a tenth of a metre or radian is far beyond any real error.
    for (int k = 0; k < 3; ++k) {
      const bool shift_unknown = (plane && k < 2) || (kind == Kind::cylinder && k == 2);
      const bool turn_unknown = sphere || k == 2;
      EXPECT_EQ(shift(k, k) > 0.99 * kUnobservable, shift_unknown) << kindName(kind) << " " << k;
      EXPECT_EQ(turn(k, k) > 0.99 * kUnobservable, turn_unknown) << kindName(kind) << " " << k;
      if (!shift_unknown) {
        EXPECT_LT(shift(k, k), 0.01) << kindName(kind) << " " << k;
      }
      if (!turn_unknown) {
        EXPECT_LT(turn(k, k), 0.01) << kindName(kind) << " " << k;
      }
    }
  }
}

/// Along the direction in which it is largest.
double worstOf(const Eigen::MatrixXd& covariance) { return std::sqrt(-test::leastEigenvalue(-covariance)); }

TEST(PoseCovariance, HasItsWorstObservedDeviationsAsOneNumberEach) {
  Random random(19);
  for (const Kind kind : kKinds) {
    const auto [uncertainty, shift, turn] = uncertaintyOfPatch(kind, random);
    const double position = kind == Kind::plane      ? std::sqrt(shift(2, 2))
                            : kind == Kind::cylinder ? worstOf(shift.topLeftCorner<2, 2>())
                                                     : worstOf(shift);
    // Beside 1e6 the covariance has 0.02 mm and 0.02 mrad more.
    EXPECT_NEAR(uncertainty.position_stddev, position, 2e-5 + 0.01 * position) << kindName(kind);
    const double axis = kind == Kind::sphere ? 0.0 : worstOf(turn.topLeftCorner<2, 2>());
    EXPECT_NEAR(uncertainty.axis_stddev, axis, 2e-5 + 0.01 * axis) << kindName(kind);
    EXPECT_GT(uncertainty.position_stddev, 1e-5) << kindName(kind);
  }
}

TEST(Covariance, OfPointsThatDetermineNothingIsLargeButFinite) {
  const std::vector<Shape> shapes = {Plane{Vec3(0, 0, 1), -Vec3::UnitZ()}, Sphere{Vec3(0, 0, 1), 0.1},
                                     Cylinder{Vec3(0, 0, 1), Vec3::UnitX(), 0.1},
                                     Cone{Vec3(0, 0, 1), Vec3::UnitX(), 0.3}};
  const auto millimetre = [](const Vec3&) { return 0.001; };
  for (const Shape& shape : shapes) {
    const Vec3 p = project(shape, Vec3(0.1, 0.02, 0.8));
    for (const std::size_t count : {0, 1, 3, 100}) {
      const std::vector<Vec3> same(count, p);
      const Uncertainty uncertainty = measureUncertainty(shape, measureExtent(shape, same), same, millimetre).by_all;
      const Matrix6 covariance = poseOf(uncertainty);
      ASSERT_TRUE(covariance.allFinite()) << kindName(kindOf(shape)) << " " << count;
      EXPECT_GE(uncertainty.radius_stddev, 0.0);
      EXPECT_TRUE(std::isfinite(uncertainty.radius_stddev));
      EXPECT_TRUE(std::isfinite(uncertainty.half_angle_stddev));
      EXPECT_TRUE(std::isfinite(uncertainty.position_stddev));
      EXPECT_TRUE(std::isfinite(uncertainty.axis_stddev));
      EXPECT_LE(covariance.diagonal().maxCoeff(), 2.0 * kUnobservable);
      EXPECT_GT(test::leastEigenvalue(covariance), -1e-12 * kUnobservable) << kindName(kindOf(shape)) << " " << count;
    }
  }
}

TEST(Covariance, OfExactPointsIsSmallButNotSingular) {
  Random random(10);
  for (const Kind kind : kKinds) {
    const Patch patch = test::randomPatch(kind, 300, random);
    std::vector<Vec3> exact;
    for (const test::SurfacePoint& p : patch.points) exact.push_back(p.point);
    const Hessian covariance = measureCovariance(patch.truth, exact, [](const Vec3&) { return 0.002; });
    const int count = parameterCount(kind);
    EXPECT_GT(test::leastEigenvalue(covariance.topLeftCorner(count, count)), 0.0);
    EXPECT_LT(covariance.diagonal().head(count).maxCoeff(), 1e-8);
  }
}

/// All else goes with a held axis as the points say, and is known the better the less that is off.
TEST(PoseCovariance, IsThatOfAHeldAxis) {
  constexpr double kHeld = 0.01;
  Random random(13);
  for (const Kind kind : {Kind::cylinder, Kind::cone}) {
    const Patch patch = test::randomPatch(kind, 300, random);
    const NoisyFit fit(patch, 0.004, NoiseDirection::any, random);
    ASSERT_TRUE(fit.shape);
    const Extent extent = measureExtent(*fit.shape, fit.measured);
    const auto with = [&](double deviation) {
      return measureUncertainty(*fit.shape, extent, fit.measured, fit.noise(), {}, {deviation}).by_all;
    };
    const Uncertainty alone = measureUncertainty(*fit.shape, extent, fit.measured, fit.noise()).by_all;
    const Uncertainty held = with(kHeld), poorly = with(1.0), exactly = with(1e-6);
    EXPECT_NEAR(held.axis_stddev, kHeld, 1e-6) << kindName(kind);
    EXPECT_NEAR(poorly.axis_stddev, 1.0, 1e-6);
    EXPECT_LT(exactly.axis_stddev, 1e-4);
    EXPECT_LT(exactly.radius_stddev, 1.0001 * alone.radius_stddev);
    EXPECT_GT(poorly.radius_stddev, alone.radius_stddev);
    if (kind == Kind::cone) {
      EXPECT_LT(exactly.half_angle_stddev, 0.9 * alone.half_angle_stddev);
      EXPECT_GT(poorly.half_angle_stddev, 2.0 * alone.half_angle_stddev);
    }
    const Matrix6 pose = poseOf(held);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(pose).eigenvalues()[0], 0.0);
  }
}

}  // namespace
}  // namespace primitect::covariance_test
