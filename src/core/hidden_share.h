// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Could a camera at some place have seen these points?
#pragma once

#include <Eigen/Core>
#include <vector>

namespace primitect {

/// Share in [0, 1] of the points that no camera at the place would have seen: others are before them, or they lie more
/// than 60 deg aside of the direction `ahead` (unit). 1 where nothing can be said.
double hiddenShare(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& place,
                   const Eigen::Vector3f& ahead);

}  // namespace primitect
