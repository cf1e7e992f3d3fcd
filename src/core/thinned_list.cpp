// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Copies the runs that are left; see thinned_list.h.
#include "core/thinned_list.h"

#include <algorithm>

namespace primitect {
namespace {

using kernels::kPointsPerRun;

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

void ThinnedList::copyRuns(const Cloud& whole) {
  const auto endOf = [&whole](std::uint32_t run) {
    return std::min(whole.size(), (run + std::size_t{1}) * kPointsPerRun);
  };
  std::size_t count = 0;
  for (const std::uint32_t run : left_) count += endOf(run) - run * kPointsPerRun;
  part_.prepare(static_cast<std::uint32_t>(count), 1, whole.hasNormals());
  forCoordinates(whole, part_, [&](const std::vector<float>& from, std::vector<float>& to) {
    float* next = to.data();
    for (const std::uint32_t run : left_)
      next = std::copy(from.data() + run * kPointsPerRun, from.data() + endOf(run), next);
  });
}

void ThinnedList::keep(const Cloud& cloud) {
  cloud_ = &cloud;
  each_ = 1.0;
}

/// Copies what is left; returns how many points of the whole there are to one of these, if none were missing.
double ThinnedList::copy(const Cloud& whole, const PointRuns& some) {
  // The paper's scenes have 160,000 points: these stay whole.
  constexpr std::size_t kFewestPoints = 131072;
  const std::size_t every = std::max<std::size_t>(1, measuredIn(some) / kFewestPoints);
  left_.clear();
  for (std::size_t first = 0; first < some.size(); first += every) {
    const std::size_t k = first + placeInGroup(first, every);
    if (k < some.size()) left_.push_back(some.number[k]);
  }
  const std::size_t runs = numberOfRuns(whole);
  if (left_.empty() || left_.size() == runs) return 1.0;
  copyRuns(whole);
  return static_cast<double>(runs) / static_cast<double>(left_.size());
}

void ThinnedList::begin(const Cloud& cloud, const PointRuns& some) {
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
