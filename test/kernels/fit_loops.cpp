// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gains, normal equations and moments of every instruction set, against the shapes themselves and in double.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "core/fit_points.h"
#include "core/flat.h"
#include "core/residuals.h"
#include "test/support/hypotheses.h"

namespace primitect::fit_loops_test {
namespace {

using kernels::kLanes;

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// All points are in front of the apex: behind it a cone has no normal.
const std::vector<Shape>& shapes() {
  static const std::vector<Shape> kShapes = {
      Plane{Vec3(0.01, -0.02, 0.03), Vec3(0.36, 0.48, -0.8)}, Sphere{Vec3(0.02, 0.01, 0.1), 0.12},
      Cylinder{Vec3(0.0, 0.02, 0.08), Vec3(0.6, 0.8, 0.0), 0.07}, Cone{Vec3(0.0, -0.3, -0.4), Vec3(0, 0.6, 0.8), 0.3}};
  return kShapes;
}

/// Points and normals in a cube of 40 cm, with noise as of a sensor; the normals are those of places 1 cm beside them.
Samples randomSamples(std::size_t count, Random& random) {
  std::vector<test::SurfacePoint> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({0.2 * test::randomPoint(random), test::randomDirection(random)});
  Samples samples = test::samplesWith({0.02, 0.0, 0.5}, points);
  for (List<float>* places : {&samples.px, &samples.py, &samples.pz}) {
    for (float& value : *places) value += 0.01f * static_cast<float>(random.gaussian());
  }
  return samples;
}

/// What core/hypothesis.h says of gains.
double gainOf(const Shape& shape, double side, double widen, const Samples& samples, std::size_t i) {
  const double share = distance(shape, samples.point(i)) * samples.inverse_tolerance[i] / widen;
  const double turn = 1.0 - side * samples.normal(i).dot(normalAt(shape, samples.placeOfNormal(i)));
  if (!(std::abs(share) < samples.gain_reach && turn < samples.farthest_turn[i])) return kernels::kNoGain;
  return std::max(1.0 - share * share - samples.normal_loss[i] * turn, -1.2);
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(Gains, AreThoseOfTheShapeOnEveryInstructionSet) {
  Random random(81);
  for (const std::size_t count : {0u, 1u, 7u, 15u, 16u, 17u, 33u, 63u, 64u}) {
    Samples samples = randomSamples(count, random);
    samples.gain_reach = count % 2 == 0 ? 1.5f : 2.0f;  // as in depth frames and elsewhere
    if (count > 5) samples.x[5] = samples.y[5] = samples.z[5] = kMissing;
    if (count > 6) samples.nx[6] = samples.ny[6] = samples.nz[6] = kMissing;
    HeldGains held;
    for (std::size_t i = 0; i < count; ++i) held.push_back(i % 3 == 0 ? 0.5f : 0.05f);
    for (const Shape& shape : shapes()) {
      for (const float side : {1.0f, -1.0f}) {
        std::vector<float> first;
        for (const kernels::Loops* loops : kernels::allLoops()) {
          std::vector<float> gains(count, 7.0f);
          const kernels::GainSums sums =
              loops->gains(flattened(shape, Vec3::Zero()), side, 0.5f, samples.judged(held), 0, count, gains.data());
          std::size_t near = 0, inliers = 0;
          double positive = 0.0, counted = 0.0;
          for (std::size_t i = 0; i < count; ++i) {
            const double truth = gainOf(shape, side, 2.0, samples, i);
            // A sample within rounding of a bound may be on its other side: none is, with these seeds.
            ASSERT_NEAR(gains[i], truth, 2e-4) << loops->name << " " << kindName(kindOf(shape)) << " " << i;
            if (!(truth > kernels::kNoGain)) continue;
            ++near;
            inliers += truth > 0.0 ? 1 : 0;
            positive += std::max(truth, 0.0);
            counted += truth > 0.0 || i % 3 != 0 ? truth : 0.0;
          }
          EXPECT_EQ(sums.near, near);
          EXPECT_EQ(sums.inliers, inliers);
          EXPECT_NEAR(sums.positive, positive, 2e-4 * static_cast<double>(count));
          EXPECT_NEAR(sums.counted, counted, 2e-4 * static_cast<double>(count));
          gains.push_back(sums.positive), gains.push_back(sums.counted);
          if (first.empty()) first = gains;
          EXPECT_TRUE(sameBits(first, gains)) << loops->name;
        }
      }
    }
  }
}

TEST(Above, HasABitForEachValueAboveTheLimit) {
  Random random(82);
  for (std::size_t count = 0; count <= 64; ++count) {
    std::vector<float> values;
    for (std::size_t k = 0; k < count; ++k) values.push_back(static_cast<float>(random.uniform(-1.0, 1.0)));
    if (count > 3) values[1] = kMissing, values[2] = 0.0f, values[3] = -0.0f;
    for (const float limit : {0.0f, 0.3f, kernels::kNoGain}) {
      std::uint64_t truth = 0;
      for (std::size_t k = 0; k < count; ++k) {
        if (values[k] > limit) truth |= std::uint64_t{1} << k;
      }
      for (const kernels::Loops* loops : kernels::allLoops()) {
        EXPECT_EQ(loops->above(values.data(), count, limit), truth) << loops->name << " " << count;
      }
    }
  }
}

/// The same sums in double, point by point.
kernels::NormalEquations plainEquations(const Shape& shape, const Samples& samples, const Vec3& beside, double scale) {
  kernels::NormalEquations sums = {};
  const int count = parameterCount(kindOf(shape));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Residual r = residual(shape, samples.point(i));
    const double inverse = samples.inverse_tolerance[i] * scale, share = r.distance * inverse;
    if (!(std::abs(share) < 1.0)) continue;
    const double root = 1.0 - share * share, weight = std::pow(root * inverse, 2);
    sums.weight += root * root;
    // The derivative of share * root^2.
    sums.curvature += root * (1.0 - 5.0 * share * share);
    Gradient gradient = r.gradient;
    if (const Cone* cone = std::get_if<Cone>(&shape)) {
      // By what the parameters of its circle make of apex, axis and angle.
      const Turn turn(cone->axis);
      const double radius = circleBeside(beside, *cone).radius, height = (beside - cone->apex).dot(cone->axis);
      const Vec3 apex = r.gradient.head<3>();
      const double first = apex.dot(turn.first), second = apex.dot(turn.second), along = apex.dot(cone->axis);
      const double sine = std::sin(cone->half_angle);
      gradient << first, second, r.gradient[3] - height * first, r.gradient[4] - height * second,
          -along / std::tan(cone->half_angle), r.gradient[5] + radius / (sine * sine) * along;
    }
    for (int row = 0; row < count; ++row) {
      sums.right[row] -= weight * gradient[row] * r.distance;
      for (int column = 0; column <= row; ++column)
        sums.hessian[row][column] += weight * gradient[row] * gradient[column];
    }
  }
  return sums;
}

kernels::FlatTurn turnOf(const Shape& shape) {
  if (const Plane* plane = std::get_if<Plane>(&shape)) return flattened(Turn(plane->normal));
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) return flattened(Turn(cylinder->axis));
  const Cone* cone = std::get_if<Cone>(&shape);
  return cone ? flattened(Turn(cone->axis)) : kernels::FlatTurn();
}

TEST(NormalEquations, AreThoseOfTheResidualsOnEveryInstructionSet) {
  Random random(82);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 300u, 5000u}) {
    const Samples samples = randomSamples(count, random);
    const FitPoints points = test::fitPointsOf(samples);
    for (const Shape& shape : shapes()) {
      const kernels::NormalEquations truth = plainEquations(shape, samples, points.middle(), 0.5);
      const int rows = parameterCount(kindOf(shape));
      double largest = 1.0;
      for (int k = 0; k < rows; ++k) largest = std::max(largest, truth.hessian[k][k]);
      const kernels::FlatShape flat = flattenedBeside(points.middle(), shape, points.origin());
      kernels::NormalEquations first = {};
      for (const kernels::Loops* loops : kernels::allLoops()) {
        kernels::NormalEquations sums = {};
        loops->normalEquations(flat, turnOf(shape), points.view(), 0.5f, sums);
        // Single precision, and a point at the tolerance, whose weight is next to nothing, may fall either side.
        for (int row = 0; row < rows; ++row) {
          EXPECT_NEAR(sums.right[row], truth.right[row], 1e-4 * largest) << loops->name << " " << row;
          for (int column = 0; column <= row; ++column)
            EXPECT_NEAR(sums.hessian[row][column], truth.hessian[row][column], 1e-4 * largest) << loops->name;
        }
        const double rounding = 1e-4 * static_cast<double>(count);
        EXPECT_NEAR(sums.weight, truth.weight, rounding) << loops->name;
        EXPECT_NEAR(sums.curvature, truth.curvature, 5.0 * rounding) << loops->name;
        if (loops == *kernels::allLoops().begin()) first = sums;
        EXPECT_EQ(first.weight, sums.weight) << loops->name;
        EXPECT_EQ(first.curvature, sums.curvature) << loops->name;
        for (int row = 0; row < rows; ++row) {
          EXPECT_EQ(first.right[row], sums.right[row]) << loops->name;
          for (int column = 0; column <= row; ++column)
            EXPECT_EQ(first.hessian[row][column], sums.hessian[row][column]) << loops->name;
        }
      }
    }
  }
}

TEST(Agreement, IsThatOfTheDistancesOnEveryInstructionSet) {
  Random random(84);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 300u, 5000u}) {
    const Samples samples = randomSamples(count, random);
    const FitPoints points = test::fitPointsOf(samples);
    for (const Shape& shape : shapes()) {
      for (const std::size_t every : {1u, 3u}) {
        double truth = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
          if (i / kLanes % every != 0) continue;
          const double share = distance(shape, samples.point(i)) * samples.inverse_tolerance[i];
          truth += std::max(1.0 - share * share, 0.0);
        }
        const kernels::FlatShape flat = flattened(shape, points.origin());
        const double first = (*kernels::allLoops().begin())->agreement(flat, points.view(), every);
        EXPECT_NEAR(first, truth, 1e-4 * static_cast<double>(count)) << kindName(kindOf(shape));
        for (const kernels::Loops* loops : kernels::allLoops())
          EXPECT_EQ(loops->agreement(flat, points.view(), every), first) << loops->name;
      }
    }
  }
}

TEST(OffPlane, IsThatOfDistancesAndNormalsOnEveryInstructionSet) {
  Random random(85);
  const Plane plane = {Vec3(0.01, -0.02, 0.03), Vec3(0.36, 0.48, -0.8)};
  for (const std::size_t count : {1u, 15u, 16u, 17u, 300u}) {
    Samples samples = randomSamples(count, random);
    for (std::size_t i = 0; i < count; ++i) samples.normal_sigma[i] = i % 3 == 0 ? 0.0f : 0.3f;
    const FitPoints points = test::fitPointsOf(samples);
    List<float> inverse_variance(points.view().count, 0.0f);
    double distances = 0.0, turns = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = distance(plane, samples.point(i)) * samples.inverse_tolerance[i];
      distances += share * share;
      const double sigma = samples.normal_sigma[i];
      if (!(sigma > 0.0)) continue;
      inverse_variance[i] = static_cast<float>(1.0 / (sigma * sigma));
      turns += std::min((plane.normal.cross(samples.normal(i)) / sigma).squaredNorm(), 9.0);
    }
    const kernels::FlatShape flat = flattened(plane, points.origin());
    const auto off = [&](const kernels::Loops& loops) {
      return loops.offPlane(flat, points.view(), points.normals(inverse_variance));
    };
    const kernels::OffPlane first = off(**kernels::allLoops().begin());
    EXPECT_NEAR(first.distances, distances, 1e-4 * distances);
    EXPECT_NEAR(first.turns, turns, 1e-4 * static_cast<double>(count));
    for (const kernels::Loops* loops : kernels::allLoops()) {
      EXPECT_EQ(off(*loops).distances, first.distances) << loops->name;
      EXPECT_EQ(off(*loops).turns, first.turns) << loops->name;
    }
  }
}

TEST(Moments, AreSumsOverThePointsAlone) {
  Random random(83);
  for (const std::size_t count : {1u, 16u, 33u, 2000u}) {
    const Samples samples = randomSamples(count, random);
    const FitPoints points = test::fitPointsOf(samples);
    const kernels::MomentSums sums = points.moments();
    Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 6> product = Eigen::Matrix<double, 6, 6>::Zero();
    Vec3 tangent = Vec3::Zero();
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Matrix<double, 6, 1> field;
      field << samples.point(i) - points.origin(), samples.normal(i);
      sum += field;
      product += field * field.transpose();
      tangent += field.tail<3>() * field.tail<3>().dot(field.head<3>());
    }
    const double rounding = 1e-5 * static_cast<double>(count);
    for (int row = 0; row < 6; ++row) {
      EXPECT_NEAR(sums.sum[row], sum[row], rounding);
      for (int column = 0; column <= row; ++column)
        EXPECT_NEAR(sums.product[row][column], product(row, column), rounding);
    }
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(sums.tangent[axis], tangent[axis], rounding);
  }
}

TEST(AlongRays, AreTheSameOnEveryInstructionSet) {
  Random random(84);
  const kernels::FlatPlace origin = {0.1f, -0.2f, 1.0f};
  for (const std::size_t count : {1u, 16u, 1000u}) {
    const FitPoints points = test::fitPointsOf(randomSamples(count, random));
    const kernels::FitPoints view = points.view();
    for (const Shape& shape : shapes()) {
      std::vector<float> first;
      for (const kernels::Loops* loops : kernels::allLoops()) {
        std::vector<float> moved(3 * view.count);
        loops->alongRays(flattened(shape, points.origin()), origin, view, moved.data(), moved.data() + view.count,
                         moved.data() + 2 * view.count);
        // What fills up stays.
        for (std::size_t k = count; k < view.count; ++k) EXPECT_EQ(moved[k], view.x[k]) << loops->name;
        if (first.empty()) first = moved;
        EXPECT_TRUE(sameBits(first, moved)) << loops->name << " " << kindName(kindOf(shape));
      }
    }
  }
}

}  // namespace
}  // namespace primitect::fit_loops_test
