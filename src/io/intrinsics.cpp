// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Intrinsics from text and from the points of an organized cloud.
#include "io/intrinsics.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace primitect::io {
namespace {

constexpr std::size_t kMinPoints = 50;
constexpr double kMaxResidual = 3.0;  // px; a recorded and rectified image stays well below one

/// A straight line pixel = slope * t + offset through all pairs that were added.
class LineFit {
 public:
  void add(double t, double pixel) {
    ++count_;
    sum_t_ += t;
    sum_pixel_ += pixel;
    sum_tt_ += t * t;
    sum_tp_ += t * pixel;
    sum_pp_ += pixel * pixel;
  }

  /// False when the line is not determined or the pairs are not on it.
  bool solve(double& slope, double& offset) const {
    if (count_ < kMinPoints) return false;
    const double n = static_cast<double>(count_);
    const double variance = sum_tt_ / n - (sum_t_ / n) * (sum_t_ / n);
    const double covariance = sum_tp_ / n - (sum_t_ / n) * (sum_pixel_ / n);
    if (!(variance > 1e-12)) return false;
    slope = covariance / variance;
    offset = (sum_pixel_ - slope * sum_t_) / n;
    const double pixel_variance = sum_pp_ / n - (sum_pixel_ / n) * (sum_pixel_ / n);
    return slope > 0.0 && pixel_variance - slope * covariance < kMaxResidual * kMaxResidual;
  }

 private:
  std::size_t count_ = 0;
  double sum_t_ = 0.0, sum_pixel_ = 0.0, sum_tt_ = 0.0, sum_tp_ = 0.0, sum_pp_ = 0.0;
};

}  // namespace

Intrinsics parseIntrinsics(const std::string& text) {
  std::istringstream stream(text);
  double values[4];
  bool good = true;
  for (int i = 0; i < 4; ++i) {
    char comma = ',';
    if (i > 0) stream >> comma;
    good = good && static_cast<bool>(stream >> values[i]) && comma == ',' && std::isfinite(values[i]);
  }
  stream >> std::ws;
  if (!good || !stream.eof() || values[0] <= 0.0 || values[1] <= 0.0) {
    throw std::invalid_argument("intrinsics: '" + text +
                                "' is not fx,fy,cx,cy: four numbers in pixels, the first two above 0");
  }
  return {values[0], values[1], values[2], values[3]};
}

std::optional<Intrinsics> estimateIntrinsics(const Cloud& cloud) {
  if (!cloud.organized()) return std::nullopt;
  LineFit columns, rows;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i) || cloud.z[i] <= 0.0f) continue;
    columns.add(static_cast<double>(cloud.x[i]) / cloud.z[i], static_cast<double>(i % cloud.width));
    rows.add(static_cast<double>(cloud.y[i]) / cloud.z[i], static_cast<double>(i / cloud.width));
  }
  Intrinsics found;
  if (!columns.solve(found.fx, found.cx) || !rows.solve(found.fy, found.cy)) return std::nullopt;
  return found;
}

}  // namespace primitect::io
