// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// PCL's OrganizedMultiPlaneSegmentation.
#pragma once

#include "eval/methods.h"

namespace primitect::eval {

/// "pcl-planes": planes of organized clouds, refined; others fail with "needs an organized cloud". PCL's defaults: 3
/// deg and 2 cm between neighbours, largest curvature 0.001, at least 1000 pixels of 640 x 480 (scaled with the image).
/// The time does not contain the conversion.
Method makePclPlanes();

}  // namespace primitect::eval
