// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The direct linear transform and its parts; see moved_image.h.
#include "primitect/moved_image.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/image_rays.h"

namespace primitect {
namespace {

using Projection = Eigen::Matrix<double, 3, 4>;

struct Seen {
  Vec3 point;             ///< m
  Eigen::Vector2d pixel;  ///< column and row
};

/// Some hundred from all over the image.
std::vector<Seen> someOf(const Cloud& cloud) {
  constexpr std::uint32_t kEnough = 1024;
  std::size_t step = std::max<std::size_t>(1, cloud.valid_count / kEnough);
  while (std::gcd(step, static_cast<std::size_t>(cloud.width)) > 1) ++step;  // then it visits all columns
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (!cloud.valid(i)) continue;
    seen.push_back({Vec3(cloud.x[i], cloud.y[i], cloud.z[i]),
                    Eigen::Vector2d(static_cast<double>(i % cloud.width), static_cast<double>(i / cloud.width))});
  }
  return seen;
}

/// Moves the mean to 0 and the mean square of each coordinate to 1: the equations are then about as large.
template <int size, class Get>
Eigen::Matrix<double, size + 1, size + 1> normalizing(const std::vector<Seen>& seen, const Get& get) {
  Eigen::Matrix<double, size, 1> mean = Eigen::Matrix<double, size, 1>::Zero();
  for (const Seen& each : seen) mean += get(each) / static_cast<double>(seen.size());
  double square = 0.0;
  for (const Seen& each : seen) square += (get(each) - mean).squaredNorm() / static_cast<double>(size * seen.size());
  const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 1.0;
  Eigen::Matrix<double, size + 1, size + 1> transform = Eigen::Matrix<double, size + 1, size + 1>::Identity();
  transform.template topLeftCorner<size, size>() *= scale;
  transform.template topRightCorner<size, 1>() = -scale * mean;
  return transform;
}

/// Up to its scale, which may be negative.
std::optional<Projection> projectionOf(const std::vector<Seen>& seen) {
  // Noise leaves nothing beside what tells the next worst known direction; points in a plane leave four unknown ones.
  constexpr double kUnknown = 1e-3;
  const auto of_pixels = normalizing<2>(seen, [](const Seen& each) { return each.pixel; });
  const auto of_points = normalizing<3>(seen, [](const Seen& each) { return each.point; });
  Eigen::Matrix<double, 12, 12> sums = Eigen::Matrix<double, 12, 12>::Zero();
  for (const Seen& each : seen) {
    const Eigen::Vector4d point = of_points * each.point.homogeneous();
    const Eigen::Vector3d pixel = of_pixels * each.pixel.homogeneous();
    for (int k = 0; k < 2; ++k) {
      Eigen::Matrix<double, 12, 1> row = Eigen::Matrix<double, 12, 1>::Zero();
      row.segment<4>(4 * k) = point;
      row.tail<4>() = -pixel[k] * point;
      sums += row * row.transpose();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> eigen(sums);
  if (!(eigen.eigenvalues()[0] < kUnknown * eigen.eigenvalues()[1])) return std::nullopt;
  const Eigen::Matrix<double, 12, 1> least = eigen.eigenvectors().col(0);
  Projection normalized;
  for (int k = 0; k < 3; ++k) normalized.row(k) = least.segment<4>(4 * k);
  return of_pixels.inverse() * normalized * of_points;
}

/// Root mean square (px).
double misfitOf(const Projection& projection, const std::vector<Seen>& seen) {
  double sum = 0.0;
  for (const Seen& each : seen) {
    const Vec3 image = projection * each.point.homogeneous();
    sum += (image.head<2>() / image.z() - each.pixel).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(seen.size()));
}

/// m = k r: k upper triangular with a positive diagonal, r orthogonal.
void split(const Eigen::Matrix3d& m, Eigen::Matrix3d& k, Eigen::Matrix3d& r) {
  r.row(2) = m.row(2).normalized();
  k.setZero();
  k(2, 2) = m.row(2).norm();
  k(1, 2) = m.row(1).dot(r.row(2));
  const Eigen::RowVector3d second = m.row(1) - k(1, 2) * r.row(2);
  k(1, 1) = second.norm();
  r.row(1) = second / k(1, 1);
  k(0, 2) = m.row(0).dot(r.row(2)), k(0, 1) = m.row(0).dot(r.row(1));
  const Eigen::RowVector3d first = m.row(0) - k(0, 2) * r.row(2) - k(0, 1) * r.row(1);
  k(0, 0) = first.norm();
  r.row(0) = first / k(0, 0);
}

/// Pixels are square, and the axis of the lens is not far from the middle; k(2, 2) is 1.
bool isOfACamera(const Eigen::Matrix3d& k, const Cloud& cloud) {
  constexpr double kLongest = 2.5, kSkew = 0.02, kBorder = 0.2;  // every other row may be missing
  const double longer = k(0, 0) / k(1, 1);
  const auto central = [](double at, double size) { return kBorder * size < at && at < (1.0 - kBorder) * size; };
  return longer < kLongest && longer > 1.0 / kLongest && std::abs(k(0, 1)) < kSkew * k(0, 0) &&
         central(k(0, 2), cloud.width) && central(k(1, 2), cloud.height);
}

}  // namespace

bool isMovedImage(const Cloud& cloud) {
  return cloud.organized() && (cloud.liesBehind() || !findRays(cloud).seen_from_origin);
}

std::optional<Eigen::Isometry3d> findCamera(const Cloud& cloud) {
  constexpr std::size_t kFewest = 50;
  constexpr double kLargestMisfit = 1.0 / 3.0;  // px
  if (!cloud.organized() || cloud.valid_count < kFewest) return std::nullopt;
  const std::vector<Seen> seen = someOf(cloud);
  if (seen.size() < kFewest) return std::nullopt;
  const std::optional<Projection> found = projectionOf(seen);
  if (!found || !(misfitOf(*found, seen) < kLargestMisfit)) return std::nullopt;
  // What it saw lies before the camera.
  const Projection projection = (*found * seen.front().point.homogeneous()).z() < 0.0 ? Projection(-*found) : *found;
  const auto behind = [&](const Seen& each) { return !((projection * each.point.homogeneous()).z() > 0.0); };
  if (std::any_of(seen.begin(), seen.end(), behind)) return std::nullopt;
  const Eigen::Matrix3d turned = projection.leftCols<3>();
  Eigen::Matrix3d k, r;
  split(turned, k, r);
  if (!(r.determinant() > 0.0) || !isOfACamera(k / k(2, 2), cloud)) return std::nullopt;  // NaN, or a mirrored image
  Eigen::Isometry3d cloud_from_camera = Eigen::Isometry3d::Identity();
  cloud_from_camera.translation() = -turned.inverse() * projection.col(3);
  cloud_from_camera.linear() = r.transpose();
  return cloud_from_camera;
}

}  // namespace primitect
