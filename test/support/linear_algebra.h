// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Decompositions for the tests, compiled once: each takes the compiler many seconds, with sanitizers half a minute.
#pragma once

#include <Eigen/Core>

namespace primitect::test {

/// Of a symmetric matrix, whose lower triangle is read.
double leastEigenvalue(const Eigen::MatrixXd& symmetric);

/// error' covariance^-1 error: the squared error in units of its standard deviations.
double normalisedSquare(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance);

}  // namespace primitect::test
