// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Eigen's solver; see symmetric_eigen.h.
#include "core/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace primitect {

SymmetricEigen eigenOf(const Hessian& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Hessian> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace primitect
