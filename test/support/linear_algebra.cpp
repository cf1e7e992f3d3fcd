// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Decompositions for the tests; see linear_algebra.h.
#include "test/support/linear_algebra.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace primitect::test {

double leastEigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

double normalisedSquare(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd solved = covariance.fullPivLu().solve(error);
  return error.dot(solved);
}

}  // namespace primitect::test
