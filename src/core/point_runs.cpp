// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Every run, or a diagonal pattern of them; see point_runs.h.
#include "core/point_runs.h"

#include <algorithm>
#include <numeric>

namespace primitect {
namespace {

constexpr std::size_t kRun = kernels::kPointsPerRun;

void resize(PointRuns& runs, std::size_t count) {
  runs.number.resize(count);
  runs.measured.resize(count);
  for (List<float>* values : {&runs.x, &runs.y, &runs.z, &runs.radius}) values->resize(count);
}

}  // namespace

void findRuns(const Cloud& cloud, PointRuns& all) {
  resize(all, (cloud.size() + kRun - 1) / kRun);
  std::iota(all.number.begin(), all.number.end(), 0u);
  kernels::loops().balls(cloud.x.data(), cloud.y.data(), cloud.z.data(), cloud.size(), kRun,
                         {all.x.data(), all.y.data(), all.z.data(), all.radius.data()});
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t begin = k * kRun;
    all.measured[k] = kernels::loops().measured(cloud.z.data() + begin, std::min(kRun, cloud.size() - begin));
  }
}

void chooseRuns(const Cloud& cloud, const PointRuns& all, PointRuns& some) {
  // Fewer would part what is small: at 1280 x 720 every third run is left, at 640 x 480 all of them are.
  constexpr std::size_t kEnough = 262144, kLargestStep = 16;
  const std::size_t step = std::clamp<std::size_t>(cloud.valid_count / kEnough, 1, kLargestStep);
  resize(some, all.size());
  std::size_t count = 0;
  for (std::size_t first = 0; first < all.size(); first += step) {
    // A fixed place in the group would be the same columns of every row where the step divides the runs of a row.
    // Multiplicative hash (Knuth, TAOCP 3, 6.4).
    const std::size_t run = first + (static_cast<std::uint32_t>(first) * 2654435761u >> 16) % step;
    if (run >= all.size()) continue;
    some.number[count] = all.number[run];
    some.x[count] = all.x[run], some.y[count] = all.y[run], some.z[count] = all.z[run];
    some.measured[count] = all.measured[run];
    some.radius[count++] = all.radius[run];
  }
  resize(some, count);
}

}  // namespace primitect
