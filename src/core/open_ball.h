// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Balls that the camera looks into: the tread of a tyre and the rim of a funnel lie on a sphere of which nothing else
// is there.
#pragma once

#include "core/image_sight.h"
#include "primitect/primitives.h"

namespace primitect {

/// What an image shows within the outline of a ball, as shares of the places there, [0, 1]; each 0 where there are too
/// few to tell. The rest of them shows its front, or something before it, or nothing is measured there.
struct SightsOfBall {
  double deep = 0.0;      ///< points deep in it
  double beyond = 0.0;    ///< what is clearly behind it, or farther than depths are used
  double far_side = 0.0;  ///< points about where its far side is, as the inside of a bowl
};

/// Of a sphere in front of the camera and outside of it. No sights where the rays of the image are not known.
SightsOfBall sightsOf(const Sphere& ball, const AskedImage& image);

/// Whether the camera looks into it, or through it, and sees no bowl. Of tyres and rings that another renderer, which
/// is not part of this, made, .18 and more of the places show what is deep in them and .05 at most the far side; of
/// bowls with things in them .3 and .27; of balls none do. A dome on a body that is narrower than its ball, as a
/// shallow lid on its pot, is refused, too: of one on a cylinder of its width, up to half angles of 45 deg.
bool isOpen(const Sphere& ball, const AskedImage& image);

}  // namespace primitect
