// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Spheres around runs of samples; see sample_blocks.h.
#include "core/sample_blocks.h"

#include <cmath>

#include "core/samples.h"

namespace primitect {

void SampleBlocks::clear() {
  begin_.clear();
  end_.clear();
  for (List<float>* values : {&x_, &y_, &z_, &radius_, &tolerance_}) values->clear();
}

void SampleBlocks::append(const SampleBlocks& more, std::size_t offset) {
  for (std::size_t k = 0; k < more.size(); ++k) {
    begin_.push_back(offset + more.begin_[k]);
    end_.push_back(offset + more.end_[k]);
  }
  const auto add = [](List<float>& values, const List<float>& others) {
    values.insert(values.end(), others.begin(), others.end());
  };
  add(x_, more.x_), add(y_, more.y_), add(z_, more.z_);
  add(radius_, more.radius_), add(tolerance_, more.tolerance_);
}

void SampleBlocks::build(const Samples& samples) {
  const auto middleOf = [](const List<float>& values, std::size_t from, std::size_t to) {
    const auto range = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(from),
                                           values.begin() + static_cast<std::ptrdiff_t>(to));
    return 0.5f * (*range.first + *range.second);
  };
  clear();
  for (std::size_t begin = 0; begin < samples.size(); begin += kSize) {
    const std::size_t end = std::min(begin + kSize, samples.size());
    const float x = middleOf(samples.x, begin, end), y = middleOf(samples.y, begin, end),
                z = middleOf(samples.z, begin, end);
    float radius = 0.0f, tolerance = 0.0f;
    for (std::size_t i = begin; i < end; ++i) {
      radius = std::max(radius, std::hypot(samples.x[i] - x, samples.y[i] - y, samples.z[i] - z));
      tolerance = std::max(tolerance, 1.0f / samples.inverse_tolerance[i]);
    }
    begin_.push_back(begin);
    end_.push_back(end);
    x_.push_back(x), y_.push_back(y), z_.push_back(z);
    radius_.push_back(radius * 1.0001f);  // rounding
    tolerance_.push_back(tolerance);
  }
}

}  // namespace primitect
