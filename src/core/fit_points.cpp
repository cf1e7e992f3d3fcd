// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering samples into whole lanes; see fit_points.h.
#include "core/fit_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/point_noise.h"

namespace primitect {

namespace {

/// What fills up lanes.
constexpr float kNoWeight = std::numeric_limits<float>::infinity();

/// A point that is no number has no place.
bool usable(const Samples& s, std::uint32_t i) { return std::isfinite(s.x[i] + s.y[i] + s.z[i]); }

/// Mean of the usable points, in float itself, so that differences to it are exact.
std::array<float, 3> meanOf(const SampleSet& set) {
  const Samples& s = set.samples;
  double x = 0.0, y = 0.0, z = 0.0, count = 0.0;
  for (const std::uint32_t i : set.indices) {
    if (!usable(s, i)) continue;
    x += s.x[i], y += s.y[i], z += s.z[i];
    count += 1.0;
  }
  if (count == 0.0) return {0.0f, 0.0f, 0.0f};
  return {static_cast<float>(x / count), static_cast<float>(y / count), static_cast<float>(z / count)};
}

/// In lanes, to the digits that a mean needs.
double sumOf(const List<float>& values) {
  constexpr std::size_t kSums = 8;
  float sums[kSums] = {};
  std::size_t k = 0;
  for (; k + kSums <= values.size(); k += kSums) {
    for (std::size_t lane = 0; lane < kSums; ++lane) sums[lane] += values[k + lane];
  }
  for (; k < values.size(); ++k) sums[0] += values[k];
  return std::accumulate(sums, sums + kSums, 0.0);
}

}  // namespace

template <class ToleranceOf>
void FitPoints::gatherWith(const SampleSet& set, const ToleranceOf& tolerance) {
  const std::size_t most = wholeLanes(set.size());
  for (List<float>* values : {&x_, &y_, &z_, &nx_, &ny_, &nz_, &once_}) values->assign(most, 0.0f);
  inverse_tolerance_.assign(most, kNoWeight);
  const std::array<float, 3> origin = meanOf(set);
  origin_ = middle_ = Vec3(origin[0], origin[1], origin[2]);
  size_ = 0;
  double tolerances = 0.0;
  const Samples& s = set.samples;
  for (const std::uint32_t i : set.indices) {
    if (!usable(s, i)) continue;
    const std::size_t k = size_++;
    x_[k] = s.x[i] - origin[0], y_[k] = s.y[i] - origin[1], z_[k] = s.z[i] - origin[2];
    nx_[k] = s.nx[i], ny_[k] = s.ny[i], nz_[k] = s.nz[i];
    inverse_tolerance_[k] = tolerance(i);
    once_[k] = 1.0f;
    tolerances += 1.0 / inverse_tolerance_[k];
  }
  mean_sigma_ = tolerances / (kInlierDeviations * static_cast<double>(size_));
}

void FitPoints::gather(const SampleSet& set) {
  gatherWith(set, [&set](std::uint32_t i) { return set.samples.inverse_tolerance[i]; });
}

void FitPoints::gather(const SampleSet& set, const std::function<double(const Vec3&)>& tolerance) {
  gatherWith(set, [&](std::uint32_t i) { return static_cast<float>(1.0 / tolerance(set.samples.point(i))); });
}

void FitPoints::gather(const SeenPoints& seen, const NoiseModel& noise) {
  size_ = seen.size();
  origin_ = seen.origin;
  x_ = seen.x, y_ = seen.y, z_ = seen.z;
  const double count = static_cast<double>(size_);
  middle_ = origin_ + Vec3(sumOf(x_), sumOf(y_), sumOf(z_)) / count;
  for (List<float>* values : {&nx_, &ny_, &nz_, &once_}) values->clear();
  const kernels::FlatTolerance tolerance = flattened(noise, kInlierDeviations);
  const auto origin = static_cast<float>(origin_.z());
  inverse_tolerance_.resize(size_);
  for (float& z : z_) z += origin;
  kernels::loops().tolerances(tolerance, z_.data(), size_, inverse_tolerance_.data());
  z_ = seen.z;
  mean_sigma_ = sumOf(inverse_tolerance_) / (kInlierDeviations * count);
  for (float& value : inverse_tolerance_) value = 1.0f / value;
  const std::size_t filled = wholeLanes(size_);
  for (List<float>* values : {&x_, &y_, &z_}) values->resize(filled, 0.0f);
  inverse_tolerance_.resize(filled, kNoWeight);
}

double FitPoints::reach() const {
  constexpr std::size_t kAtOnce = kernels::kLanes;
  float farthest_sq[kAtOnce] = {};
  for (std::size_t start = 0; start < x_.size(); start += kAtOnce) {
    for (std::size_t lane = 0; lane < kAtOnce; ++lane) {
      const std::size_t k = start + lane;
      const float square = x_[k] * x_[k] + y_[k] * y_[k] + z_[k] * z_[k];
      farthest_sq[lane] = farthest_sq[lane] < square ? square : farthest_sq[lane];
    }
  }
  return std::sqrt(static_cast<double>(*std::max_element(farthest_sq, farthest_sq + kAtOnce)));
}

FitPoints FitPoints::thinned(std::size_t count) const {
  FitPoints some;
  some.size_ = count;
  some.origin_ = origin_, some.middle_ = middle_;
  some.mean_sigma_ = mean_sigma_;
  const std::size_t filled = wholeLanes(count);
  for (List<float>* values : {&some.x_, &some.y_, &some.z_}) values->assign(filled, 0.0f);
  some.inverse_tolerance_.assign(filled, kNoWeight);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t from = k * size_ / count;
    some.x_[k] = x_[from], some.y_[k] = y_[from], some.z_[k] = z_[from];
    some.inverse_tolerance_[k] = inverse_tolerance_[from];
  }
  return some;
}

kernels::MomentSums FitPoints::moments() const {
  const float* const fields[] = {x_.data(), y_.data(), z_.data(), nx_.data(), ny_.data(), nz_.data()};
  kernels::MomentSums sums;
  kernels::loops().moments(fields, once_.data(), x_.size(), sums);
  return sums;
}

}  // namespace primitect
