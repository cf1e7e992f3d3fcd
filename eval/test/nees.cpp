// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Normalised errors: one standard deviation of error is 1, and what cannot be observed does not count.
#include "eval/nees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/random.h"

namespace nees_test {
namespace {

using namespace primitect;
using namespace primitect::eval;

constexpr double kShiftSigma = 0.002, kTurnSigma = 0.01;

/// Says that its origin is known to kShiftSigma and its turn to kTurnSigma, each in every direction.
Detection claiming(const Shape& shape, const Vec3& origin) {
  Detection detection;
  detection.shape = shape;
  detection.extent.origin = origin;
  detection.covariance.fill(0.0);
  for (int k = 0; k < 6; ++k) {
    const double sigma = k < 3 ? kShiftSigma : kTurnSigma;
    detection.covariance[7 * k] = sigma * sigma;
  }
  return detection;
}

/// Adds variance to the claim along one direction; part 0: shift, 3: turn.
void addVariance(Detection& detection, int part, const Vec3& direction, double variance) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      detection.covariance[6 * (part + row) + part + column] += variance * direction[row] * direction[column];
    }
  }
}

Vec3 leaning(const Vec3& axis, const Vec3& across, double angle) {
  return std::cos(angle) * axis + std::sin(angle) * across;
}

TEST(NormalisedErrors, OfAPlaneAreItsShiftAlongTheNormalAndTwoTurns) {
  const Plane found{Vec3(0, 0, 1), Vec3::UnitZ()};
  const Detection detection = claiming(found, Vec3(5, 3, 1));
  const NormalisedErrors moved = normalisedErrors(Plane{Vec3(7, 7, 1.002), -Vec3::UnitZ()}, detection);
  EXPECT_NEAR(moved.origin->value, 1.0, 1e-9);
  EXPECT_EQ(moved.origin->degrees, 1);
  EXPECT_NEAR(moved.axis->value, 0.0, 1e-9);
  EXPECT_EQ(moved.axis->degrees, 2);
  EXPECT_EQ(moved.total(Kind::plane)->degrees, 3);
  // Turned about the origin of the pose, so that this stays on the plane.
  const Plane turned{Vec3(5, 3, 1), leaning(Vec3::UnitZ(), Vec3::UnitX(), 2.0 * kTurnSigma)};
  EXPECT_NEAR(normalisedErrors(turned, detection).axis->value, 4.0, 1e-9);
  EXPECT_NEAR(normalisedErrors(turned, detection).origin->value, 0.0, 1e-9);
}

TEST(NormalisedErrors, OfASphereAreItsCentreAndRadius) {
  const Sphere found{Vec3(1, 2, 3), 0.1};
  Detection detection = claiming(found, found.center);
  detection.radius_stddev = 0.001f;
  const NormalisedErrors errors = normalisedErrors(Sphere{Vec3(1.002, 2.002, 3.004), 0.103}, detection);
  EXPECT_NEAR(errors.origin->value, 1.0 + 1.0 + 4.0, 1e-6);
  EXPECT_EQ(errors.origin->degrees, 3);
  EXPECT_FALSE(errors.axis);
  EXPECT_NEAR(errors.radius->value, 9.0, 1e-4);  // float
  EXPECT_EQ(errors.total(Kind::sphere)->degrees, 4);
}

TEST(NormalisedErrors, OfACylinderDoNotDependOnWhereOnItsAxisItsPointIs) {
  const Cylinder found{Vec3(0, 0, 1), Vec3::UnitX(), 0.05};
  Detection detection = claiming(found, Vec3(0.3, 0, 1));
  detection.radius_stddev = 0.001f;
  const Vec3 axis = leaning(Vec3::UnitX(), Vec3::UnitY(), kTurnSigma);
  const Vec3 beside(0.3, 0.002, 1.0);
  for (const double along : {-1.0, 0.0, 2.0}) {
    for (const double sign : {-1.0, 1.0}) {
      const Cylinder truth{beside + along * axis, sign * axis, 0.05};
      const NormalisedErrors errors = normalisedErrors(truth, detection);
      EXPECT_NEAR(errors.origin->value, 1.0, 1e-6);
      EXPECT_NEAR(errors.axis->value, 1.0, 1e-6);
      EXPECT_EQ(errors.pose->degrees, 4);
      EXPECT_EQ(errors.total(Kind::cylinder)->degrees, 5);
    }
  }
}

TEST(NormalisedErrors, OfAConeCompareTheRadiusAtItsWideEnd) {
  const Cone found{Vec3::Zero(), Vec3::UnitZ(), std::atan(0.5)};
  Detection detection = claiming(found, Vec3(0, 0, 0.2));
  detection.extent.radius = 0.15;  // 0.3 m below the apex
  detection.radius_stddev = 0.001f;
  detection.half_angle_stddev = 0.01f;
  const NormalisedErrors shifted = normalisedErrors(Cone{Vec3(0, 0, 0.002), Vec3::UnitZ(), std::atan(0.5)}, detection);
  EXPECT_NEAR(shifted.origin->value, 1.0, 1e-9);
  EXPECT_NEAR(shifted.radius->value, 1.0, 1e-4);  // the slope of 0.5 makes 1 mm of 2 mm
  EXPECT_NEAR(shifted.half_angle->value, 0.0, 1e-9);
  const NormalisedErrors wider = normalisedErrors(Cone{Vec3::Zero(), Vec3::UnitZ(), std::atan(0.5) + 0.02}, detection);
  EXPECT_NEAR(wider.half_angle->value, 4.0, 1e-4);
  EXPECT_EQ(wider.total(Kind::cone)->degrees, 6);
}

TEST(NormalisedErrors, LeaveOutWhatIsCalledUnobservable) {
  const Cylinder found{Vec3(0, 0, 1), Vec3::UnitX(), 0.05};
  Detection detection = claiming(found, Vec3(0, 0, 1));
  addVariance(detection, 0, Vec3::UnitY(), 1e6);
  addVariance(detection, 3, Vec3(0, 0.6, 0.8), 1e6);
  const NormalisedErrors errors = normalisedErrors(Cylinder{Vec3(0, 0.5, 1.002), Vec3::UnitX(), 0.05}, detection);
  EXPECT_NEAR(errors.origin->value, 1.0, 1e-6);
  EXPECT_EQ(errors.origin->degrees, 1);
  EXPECT_EQ(errors.axis->degrees, 1);
  EXPECT_FALSE(errors.radius) << "its spread is unknown";
  EXPECT_FALSE(errors.total(Kind::cylinder));
}

TEST(NormalisedErrors, OfADetectionWithoutCovarianceAreNone) {
  Detection detection;
  detection.shape = Sphere{Vec3::Zero(), 0.1};
  const NormalisedErrors errors = normalisedErrors(Sphere{Vec3::Zero(), 0.2}, detection);
  EXPECT_FALSE(errors.origin || errors.axis || errors.pose || errors.radius || errors.half_angle);
  EXPECT_THROW(normalisedErrors(Plane{}, detection), std::invalid_argument);
}

TEST(NormalisedErrors, AreAsManyAsTheirDegreesInTheMean) {
  Random random(3);
  double sum = 0.0;
  constexpr int kDraws = 4000;
  const Cylinder truth{Vec3(0.2, -0.1, 1.0), Vec3(0.6, 0.0, 0.8), 0.05};
  const Vec3 across_first = Vec3::UnitY(), across_second(-0.8, 0.0, 0.6);
  for (int draw = 0; draw < kDraws; ++draw) {
    Cylinder found = truth;
    const double shift_first = kShiftSigma * random.gaussian(), shift_second = kShiftSigma * random.gaussian();
    const double turn_first = kTurnSigma * random.gaussian(), turn_second = kTurnSigma * random.gaussian();
    found.point += shift_first * across_first + shift_second * across_second;
    found.axis = (truth.axis + turn_first * across_first + turn_second * across_second).normalized();
    sum += normalisedErrors(truth, claiming(found, found.point)).pose->value;
  }
  // Chi square of 4 degrees has variance 8: the mean of 4000 is known to 0.045.
  EXPECT_NEAR(sum / kDraws, 4.0, 0.15);
}

}  // namespace
}  // namespace nees_test
