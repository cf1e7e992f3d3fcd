// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Copies the points that are left; see thinned_cloud.h.
#include "core/thinned_cloud.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

constexpr std::size_t kRun = kernels::kPointsPerRun;

/// Calls use(values of the whole, values of the part) for each coordinate that there is.
template <class Use>
void forCoordinates(const Cloud& whole, Cloud& part, const Use& use) {
  for (const auto values : {&Cloud::x, &Cloud::y, &Cloud::z, &Cloud::nx, &Cloud::ny, &Cloud::nz}) {
    if (!(part.*values).empty()) use(whole.*values, part.*values);
  }
}

std::size_t measuredIn(const PointRuns& runs) {
  std::size_t count = 0;
  for (const std::uint64_t bits : runs.measured) count += countOf(bits);
  return count;
}

}  // namespace

void ThinnedCloud::thinImage(const Cloud& whole) {
  const auto step = static_cast<std::uint32_t>(step_);
  part_.prepare((whole.width + step - 1) / step, (whole.height + step - 1) / step, whole.hasNormals());
  forCoordinates(whole, part_, [&](const std::vector<float>& from, std::vector<float>& to) {
    float* next = to.data();
    for (std::size_t row = 0; row < whole.height; row += step) {
      const float* const begin = from.data() + row * whole.width;
      for (std::size_t column = 0; column < whole.width; column += step) *next++ = begin[column];
    }
  });
}

void ThinnedCloud::thinRuns(const Cloud& whole) {
  const auto endOf = [&whole](std::uint32_t run) { return std::min(whole.size(), (run + std::size_t{1}) * kRun); };
  std::size_t count = 0;
  for (const std::uint32_t run : left_) count += endOf(run) - run * kRun;
  part_.prepare(static_cast<std::uint32_t>(count), 1, whole.hasNormals());
  forCoordinates(whole, part_, [&](const std::vector<float>& from, std::vector<float>& to) {
    float* next = to.data();
    for (const std::uint32_t run : left_) next = std::copy(from.data() + run * kRun, from.data() + endOf(run), next);
  });
}

void ThinnedCloud::keep(const Cloud& cloud) {
  cloud_ = &cloud;
  step_ = 1;
  each_ = 1.0;
}

/// Copies what is left; returns how many points of the whole there are to one of these, if none were missing.
double ThinnedCloud::copy(const Cloud& whole, const PointRuns& some) {
  constexpr double kFewestPixels = 640.0 * 360.0;
  // The paper's scenes have 160,000 points: these stay whole.
  constexpr std::size_t kFewestPoints = 131072;
  if (whole.organized()) {
    const double pixels = static_cast<double>(whole.size()) / kFewestPixels;
    const double points = static_cast<double>(whole.valid_count) / static_cast<double>(kFewestPoints);
    step_ = std::max(1, static_cast<int>(std::sqrt(std::min(pixels, points))));
    if (step_ > 1) thinImage(whole);
    return static_cast<double>(step_) * step_;
  }
  const std::size_t every = std::max<std::size_t>(1, measuredIn(some) / kFewestPoints);
  left_.clear();
  for (std::size_t first = 0; first < some.size(); first += every) {
    const std::size_t k = first + placeInGroup(first, every);
    if (k < some.size()) left_.push_back(some.number[k]);
  }
  const std::size_t runs = numberOfRuns(whole);
  if (left_.empty() || left_.size() == runs) return 1.0;
  thinRuns(whole);
  return static_cast<double>(runs) / static_cast<double>(left_.size());
}

void ThinnedCloud::begin(const Cloud& cloud, const PointRuns& some) {
  constexpr double kPattern = 2.0;
  keep(cloud);
  const double expected = copy(cloud, some);
  if (expected == 1.0) return;
  part_.countPoints();
  if (static_cast<double>(cloud.valid_count) > kPattern * expected * part_.valid_count) return keep(cloud);
  cloud_ = &part_;
  each_ = static_cast<double>(cloud.valid_count) / static_cast<double>(part_.valid_count);
}

}  // namespace primitect
