// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Measuring the boxes; see sample_boxes.h.
#include "core/sample_boxes.h"

#include <algorithm>
#include <limits>

namespace primitect {
namespace {

/// Bounds of values[begin, end), NaN left out: it is never less nor more.
void bound(const List<float>& values, std::size_t begin, std::size_t end, float& low, float& high) {
  low = std::numeric_limits<float>::infinity();
  high = -low;
  for (std::size_t i = begin; i < end; ++i) {
    low = values[i] < low ? values[i] : low;
    high = values[i] > high ? values[i] : high;
  }
}

}  // namespace

void SampleBoxes::enclose(const Samples& samples) {
  constexpr std::size_t kRun = kernels::kBoxSamples;
  count_ = (samples.size() + kRun - 1) / kRun;
  const std::size_t padded = (count_ + kRun - 1) / kRun * kRun;
  for (List<float>* bounds : {&min_x_, &min_y_, &min_z_, &max_x_, &max_y_, &max_z_}) {
    bounds->assign(padded, std::numeric_limits<float>::quiet_NaN());
  }
  for (std::size_t k = 0; k < count_; ++k) {
    const std::size_t begin = k * kRun, end = std::min(begin + kRun, samples.size());
    bound(samples.x, begin, end, min_x_[k], max_x_[k]);
    bound(samples.y, begin, end, min_y_[k], max_y_[k]);
    bound(samples.z, begin, end, min_z_[k], max_z_[k]);
  }
}

kernels::Boxes SampleBoxes::view() const {
  return {min_x_.data(), min_y_.data(), min_z_.data(), max_x_.data(), max_y_.data(), max_z_.data(), count_};
}

}  // namespace primitect
