// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Errors of the depth that change slowly over an image, as a camera's calibration leaves them.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/seen_points.h"

namespace primitect {

/// Random errors over the directions of sight, the same everywhere: a sum of independent fields, short and long waves.
struct DepthWaves {
  /// Of x / z and y / z: errors of a field so far from each other are half as much alike as neighbours'.
  static constexpr std::array<double, 4> kReaches = {0.045, 0.09, 0.18, 0.36};

  std::array<double, kReaches.size()> variances = {};  ///< of each field, of shares of the depth

  bool any() const { return share() > 0.0; }

  /// Of the depth, one standard deviation; 0: none are known.
  double share() const { return std::sqrt(covariance(0.0)); }

  /// Of shares at two places whose distance in these coordinates has this square. Each field is a mixture of Gaussians
  /// of many widths: covariances made of it are ones.
  double covariance(double apart_sq) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < kReaches.size(); ++k) sum += variances[k] * alike(kReaches[k], apart_sq);
    return sum;
  }

  /// The same of several, to seven digits: a third fewer instructions for all that waves take.
  void covariances(const float* apart_sq, std::size_t count, float* result) const {
    std::fill_n(result, count, 0.0f);
    for (std::size_t field = 0; field < kReaches.size(); ++field) {
      if (variances[field] == 0.0) continue;
      const auto variance = static_cast<float>(variances[field]);
      const auto per_reach_sq = static_cast<float>(1.0 / (kReaches[field] * kReaches[field]));
      for (std::size_t k = 0; k < count; ++k) result[k] += variance / (1.0f + apart_sq[k] * per_reach_sq);
    }
  }

  /// Correlation within a field.
  static double alike(double reach, double apart_sq) { return 1.0 / (1.0 + apart_sq / (reach * reach)); }
};

/// Finds them where they show: on large planes. How much a row of three cells of the image bends, in the mean of the
/// relative errors of their depths, hardly depends on where the plane is said to be, so that little of long waves is
/// lost in its fit; and it grows with the distance of the cells as waves become less alike.
class WaveFinder {
 public:
  /// Points that belong to one plane, in the frame of the depth camera that saw them. What has too few of them, or
  /// covers too little of the image, tells nothing.
  void see(const SeenPoints& plane);

  /// Whether any plane told something.
  bool hasSeen() const { return normal_(kUnknowns - 1, kUnknowns - 1) > 0.0; }

  /// From all planes that were seen; none where chance may have made it.
  DepthWaves waves() const;

 private:
  /// The variances of the fields, and of errors that only the points of one cell share.
  static constexpr std::size_t kUnknowns = DepthWaves::kReaches.size() + 1;
  using Numbers = Eigen::Matrix<double, kUnknowns, 1>;
  using Square = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  static Numbers bendsAt(double apart);
  bool isSure(std::size_t field) const;

  /// Equations of least squares for the unknowns, from the squares of bends without what the noise of points makes of
  /// them.
  Square normal_ = Square::Zero();
  Numbers right_ = Numbers::Zero();
  /// Covariance of right_ where there is only that noise, of bends as if they had no cells in common.
  Square chance_ = Square::Zero();
};

}  // namespace primitect
