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
  for (std::vector<float>* values : {&runs.x, &runs.y, &runs.z, &runs.radius}) values->resize(count);
}

}  // namespace

void findRuns(const Cloud& cloud, PointRuns& all) {
  resize(all, (cloud.size() + kRun - 1) / kRun);
  std::iota(all.number.begin(), all.number.end(), 0u);
  kernels::loops().balls(cloud.x.data(), cloud.y.data(), cloud.z.data(), cloud.size(), kRun,
                         {all.x.data(), all.y.data(), all.z.data(), all.radius.data()});
}

void chooseRuns(const Cloud& cloud, const PointRuns& all, PointRuns& some) {
  constexpr std::size_t kEnough = 262144, kFewest = 16;
  const std::size_t step = std::clamp<std::size_t>(cloud.size() / kEnough, 1, kFewest);
  resize(some, all.size());
  std::size_t count = 0, row = 0, column = 0;  // of the image, where the run begins
  for (std::size_t run = 0; run < all.size(); ++run, column += kRun) {
    for (; column >= cloud.width; column -= cloud.width) ++row;
    if ((row + column / kRun) % step != 0) continue;
    some.number[count] = all.number[run];
    some.x[count] = all.x[run], some.y[count] = all.y[run], some.z[count] = all.z[run];
    some.radius[count++] = all.radius[run];
  }
  resize(some, count);
}

}  // namespace primitect
