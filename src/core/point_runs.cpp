// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Every run, or a diagonal pattern of them; see point_runs.h.
#include "core/point_runs.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace primitect {
namespace {

using kernels::kPointsPerRun;
constexpr std::size_t kAhead = 6;  // runs

void resize(PointRuns& runs, std::size_t count) {
  runs.number.resize(count);
  runs.measured.resize(count);
  for (List<float>* values : {&runs.x, &runs.y, &runs.z, &runs.radius}) values->resize(count);
}

/// Asks for a run before it is looked at.
void prefetch(const Cloud& cloud, const RunLayout& layout, std::size_t run) {
  for (std::size_t place = 0; place < kPointsPerRun; place += kernels::kPointsPerRow) {  // a line of the cache each
    const std::size_t k = layout.point(run, place);
    if (k >= cloud.size()) return;
    for (const std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z}) __builtin_prefetch(values->data() + k);
  }
}

/// Looks at the k-th of these runs.
void look(const Cloud& cloud, std::size_t k, PointRuns& runs) {
  const std::size_t begin = runs.layout.firstPointOf(runs.number[k]);
  const kernels::RunOfPoints points = {cloud.x.data() + begin, cloud.y.data() + begin, cloud.z.data() + begin,
                                       runs.layout.stride()};
  const bool whole = cloud.size() - begin >= kPointsPerRun;  // only the last one of runs in a row is not
  const kernels::RunBall ball =
      kernels::loops().ballOfRun(whole ? points : LastRun(points, cloud.size() - begin).points());
  runs.x[k] = ball.x, runs.y[k] = ball.y, runs.z[k] = ball.z, runs.radius[k] = ball.radius;
  runs.measured[k] = ball.measured;
}

}  // namespace

LastRun::LastRun(const kernels::RunOfPoints& some, std::size_t count) {
  const auto fill = [count](const float* from, float* to) {
    std::fill(std::copy_n(from, count, to), to + kPointsPerRun, std::numeric_limits<float>::quiet_NaN());
  };
  fill(some.x, x), fill(some.y, y), fill(some.z, z);
}

void findRuns(const Cloud& cloud, PointRuns& all) {
  resize(all, numberOfRuns(cloud));
  all.layout = RunLayout(cloud);
  std::iota(all.number.begin(), all.number.end(), 0u);
  for (std::size_t k = 0; k < all.size(); ++k) look(cloud, k, all);
}

void findSomeRuns(const Cloud& cloud, PointRuns& some) {
  // Fewer would part what is small: at 1280 x 720 every third run is left, at 640 x 480 all of them are.
  constexpr std::size_t kEnough = 262144, kLargestStep = 64;
  const std::size_t step = std::clamp<std::size_t>(cloud.valid_count / kEnough, 1, kLargestStep);
  if (step == 1) return findRuns(cloud, some);
  const std::size_t all = numberOfRuns(cloud);
  resize(some, all);
  some.layout = RunLayout(cloud);
  std::size_t count = 0;
  for (std::size_t first = 0; first < all; first += step) {
    const std::size_t run = first + placeInGroup(first, step);
    if (run >= all) continue;
    some.number[count++] = static_cast<std::uint32_t>(run);
  }
  resize(some, count);
  for (std::size_t k = 0; k < count; ++k) {
    // No stride that a processor would foresee. Without this 1280 x 720 takes 0.6 ms more.
    if (k + kAhead < count) prefetch(cloud, some.layout, some.number[k + kAhead]);
    look(cloud, k, some);
  }
}

}  // namespace primitect
