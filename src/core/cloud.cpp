// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Storing points and normals; see cloud.h.
#include "primitect/cloud.h"

#include <algorithm>
#include <array>
#include <optional>

#include "kernels/loops.h"

namespace primitect {

void Cloud::reset(std::uint32_t new_width, std::uint32_t new_height, bool with_normals) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  prepare(new_width, new_height, with_normals);
  for (std::vector<float>* values : {&x, &y, &z, &nx, &ny, &nz}) std::fill(values->begin(), values->end(), kMissing);
}

void Cloud::prepare(std::uint32_t new_width, std::uint32_t new_height, bool with_normals) {
  const std::size_t count = static_cast<std::size_t>(new_width) * new_height;
  width = new_width;
  height = new_height;
  valid_count = behind_count = 0;
  step = 1;
  for (std::vector<float>* values : {&x, &y, &z}) values->resize(count);
  for (std::vector<float>* values : {&nx, &ny, &nz}) values->resize(with_normals ? count : 0);
}

void Cloud::countPoints() {
  const auto measured = [](float depth) { return !std::isnan(depth); };
  const auto behind = [](float depth) { return depth <= 0.0f; };
  valid_count = static_cast<std::uint32_t>(std::count_if(z.begin(), z.end(), measured));
  behind_count = static_cast<std::uint32_t>(std::count_if(z.begin(), z.end(), behind));
}

void Cloud::checkPoints(std::size_t begin, std::size_t end, const DepthRange& range) {
  constexpr float kAny = std::numeric_limits<float>::infinity();
  const kernels::PointBounds bounds = {kFarthest, range.min > 0.0f ? range.min : -kAny,
                                       range.max > 0.0f ? range.max : kAny};
  const kernels::MeasuredPoints measured =
      kernels::loops().dropUnmeasured(bounds, x.data() + begin, y.data() + begin, z.data() + begin, end - begin);
  valid_count += measured.count;
  behind_count += measured.behind;
}

void Cloud::setPoints(std::size_t begin, std::size_t count, const std::uint8_t* first, std::size_t step,
                      const DepthRange& range) {
  kernels::loops().takeApart(first, step, count, x.data() + begin, y.data() + begin, z.data() + begin);
  checkPoints(begin, begin + count, range);
}

namespace {

using Place = std::array<float, 3>;

/// One that three of 256 points share exactly, all over the cloud: of images in other columns each time.
std::optional<Place> sharedPlace(const Cloud& cloud) {
  constexpr std::size_t kLookedAt = 256;
  constexpr int kShare = 3;
  constexpr double kGolden = 0.618033988749895;
  if (cloud.size() < kLookedAt) return std::nullopt;
  std::array<Place, kLookedAt> places;
  std::size_t count = 0;
  for (std::size_t k = 0; k < kLookedAt; ++k) {
    const double part = std::fmod(kGolden * static_cast<double>(k), 1.0);
    const auto i =
        static_cast<std::size_t>((static_cast<double>(k) + part) / kLookedAt * static_cast<double>(cloud.size()));
    if (cloud.valid(i)) places[count++] = {cloud.x[i], cloud.y[i], cloud.z[i]};
  }
  std::sort(places.begin(), places.begin() + count);
  for (std::size_t k = kShare; k <= count; ++k) {
    if (places[k - kShare] == places[k - 1]) return places[k - 1];
  }
  return std::nullopt;
}

}  // namespace

void Cloud::dropFilledIn() {
  constexpr double kLeast = 0.01;
  const std::optional<Place> place = sharedPlace(*this);
  if (!place) return;
  const auto filled_in = [this, &place](std::size_t i) { return Place{x[i], y[i], z[i]} == *place; };
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < size(); ++i) count += filled_in(i) ? 1u : 0u;
  if (count < kLeast * valid_count || count == valid_count) return;
  for (std::size_t i = 0; i < size(); ++i) {
    if (filled_in(i)) x[i] = y[i] = z[i] = std::numeric_limits<float>::quiet_NaN();
  }
  valid_count -= count;
  if ((*place)[2] <= 0.0f) behind_count -= count;
}

void Cloud::move(const Eigen::Isometry3d& target_from_source, const DepthRange& range) {
  const Eigen::Matrix3f turn = target_from_source.linear().cast<float>();
  const Eigen::Vector3f shift = target_from_source.translation().cast<float>();
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector3f point = turn * Eigen::Vector3f(x[i], y[i], z[i]) + shift;
    x[i] = point.x(), y[i] = point.y(), z[i] = point.z();
  }
  valid_count = behind_count = 0;
  checkPoints(0, size(), range);
  if (!hasNormals()) return;
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector3f normal = turn * Eigen::Vector3f(nx[i], ny[i], nz[i]);
    nx[i] = normal.x(), ny[i] = normal.y(), nz[i] = normal.z();
  }
}

void Cloud::setNormal(std::size_t i, float px, float py, float pz) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  constexpr float kShortest = 1e-6f;
  const float length = std::sqrt(px * px + py * py + pz * pz);
  const bool measured = kShortest <= length && length <= std::numeric_limits<float>::max();
  nx[i] = measured ? px / length : kMissing;
  ny[i] = measured ? py / length : kMissing;
  nz[i] = measured ? pz / length : kMissing;
}

}  // namespace primitect
