// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What a large image is worked on as: every so many-th column and row of it.
#pragma once

#include "primitect/cloud.h"

namespace primitect {

/// Of one frame after the other; its buffers are kept.
class ThinnedImage {
 public:
  /// The part that image_step.h says, with its step; the image itself where that is all of it, and what is no image.
  /// Valid until the next call.
  const Cloud& of(const Cloud& image);

 private:
  void copy(const Cloud& image, std::uint32_t step);

  Cloud part_;
};

}  // namespace primitect
