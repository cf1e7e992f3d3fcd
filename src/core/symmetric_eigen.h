// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Eigenvectors of a matrix of a shape's parameters: compiled once, which takes seconds.
#pragma once

#include "core/residuals.h"

namespace primitect {

/// Eigenvalues and the directions that they belong to.
struct SymmetricEigen {
  Gradient values;  ///< rising
  Hessian vectors;  ///< unit columns, in that order
};

/// Of a symmetric matrix, whose lower half is read.
SymmetricEigen eigenOf(const Hessian& symmetric);

}  // namespace primitect
