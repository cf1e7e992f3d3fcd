// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Large images are worked on as images of every so many-th column and row of them: as much is found, and the time
// hardly grows with the resolution. Who reads an image need not read more of it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace primitect {

/// Every so many-th column and row, as long as 640 x 360 pixels, 240 columns and 240 rows are left; 1: all of them.
int largestImageStep(std::uint32_t width, std::uint32_t height);

/// step, if the image that it leaves holds enough measured points, 131072 of them; else a smaller one, that may leave
/// as many, or 1.
int imageStepFor(int step, std::size_t measured);

}  // namespace primitect
