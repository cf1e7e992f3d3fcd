// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Copies the pixels that are left; see thinned_image.h.
#include "core/thinned_image.h"

#include "primitect/image_step.h"

namespace primitect {

void ThinnedImage::copy(const Cloud& image, std::uint32_t step) {
  part_.prepare((image.width + step - 1) / step, (image.height + step - 1) / step, image.hasNormals());
  part_.step = image.step * step;
  for (const auto values : {&Cloud::x, &Cloud::y, &Cloud::z, &Cloud::nx, &Cloud::ny, &Cloud::nz}) {
    if ((part_.*values).empty()) continue;
    float* next = (part_.*values).data();
    for (std::size_t row = 0; row < image.height; row += step) {
      const float* const begin = (image.*values).data() + row * image.width;
      for (std::size_t column = 0; column < image.width; column += step) *next++ = begin[column];
    }
  }
  part_.countPoints();
}

const Cloud& ThinnedImage::of(const Cloud& image) {
  int step = image.organized() ? largestImageStep(image.width, image.height) : 1;
  while (step > 1) {
    copy(image, static_cast<std::uint32_t>(step));
    const int enough = imageStepFor(step, part_.valid_count);
    if (enough == step) return part_;
    step = enough;
  }
  return image;
}

}  // namespace primitect
