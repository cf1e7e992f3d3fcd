// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The direct linear transform and its parts; see moved_image.h.
#include "primitect/moved_image.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/image_rays.h"
#include "core/listed_image.h"
#include "core/lower_quartile.h"
#include "core/shadows.h"

namespace primitect {
namespace {

using Projection = Eigen::Matrix<double, 3, 4>;

constexpr std::size_t kFewest = 50;  // points

/// Some hundred from all over the image, every so many columns and rows.
std::vector<SeenPoint> someOf(const Cloud& cloud) {
  constexpr std::uint32_t kEnough = 1024;
  const auto step = std::max(1u, static_cast<std::uint32_t>(std::sqrt(cloud.valid_count / kEnough)));
  std::vector<SeenPoint> seen;
  for (std::uint32_t row = 0; row < cloud.height; row += step) {
    for (std::uint32_t column = 0; column < cloud.width; column += step) {
      const std::size_t i = std::size_t{row} * cloud.width + column;
      if (!cloud.valid(i)) continue;
      seen.push_back({Vec3(cloud.x[i], cloud.y[i], cloud.z[i]), Eigen::Vector2d(column, row)});
    }
  }
  return seen;
}

/// Moves the mean to 0 and the mean square of each coordinate to 1: the equations are then about as large.
template <int size, class Get>
Eigen::Matrix<double, size + 1, size + 1> normalizing(const std::vector<SeenPoint>& seen, const Get& get) {
  Eigen::Matrix<double, size, 1> mean = Eigen::Matrix<double, size, 1>::Zero();
  for (const SeenPoint& each : seen) mean += get(each) / static_cast<double>(seen.size());
  double square = 0.0;
  for (const SeenPoint& each : seen)
    square += (get(each) - mean).squaredNorm() / static_cast<double>(size * seen.size());
  const double scale = square > 0.0 ? 1.0 / std::sqrt(square) : 1.0;
  Eigen::Matrix<double, size + 1, size + 1> transform = Eigen::Matrix<double, size + 1, size + 1>::Identity();
  transform.template topLeftCorner<size, size>() *= scale;
  transform.template topRightCorner<size, 1>() = -scale * mean;
  return transform;
}

struct Fit {
  Projection projection;  ///< up to its scale, which may be negative
  double unknown;         ///< what is left, as a share of what tells the next worst known direction
};

std::optional<Fit> fitTo(const std::vector<SeenPoint>& seen) {
  const auto of_pixels = normalizing<2>(seen, [](const SeenPoint& each) { return each.pixel; });
  const auto of_points = normalizing<3>(seen, [](const SeenPoint& each) { return each.point; });
  Eigen::Matrix<double, 12, 12> sums = Eigen::Matrix<double, 12, 12>::Zero();
  for (const SeenPoint& each : seen) {
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
  if (!(eigen.eigenvalues()[1] > 0.0)) return std::nullopt;
  const Eigen::Matrix<double, 12, 1> least = eigen.eigenvectors().col(0);
  Projection normalized;
  for (int k = 0; k < 3; ++k) normalized.row(k) = least.segment<4>(4 * k);
  return Fit{of_pixels.inverse() * normalized * of_points, eigen.eigenvalues()[0] / eigen.eigenvalues()[1]};
}

/// How far a point is from where it would be seen (px); NaN where that is nowhere.
double errorOf(const Projection& projection, const SeenPoint& seen) {
  const Vec3 image = projection * seen.point.homogeneous();
  return (image.head<2>() / image.z() - seen.pixel).norm();
}

/// Those that a camera explains, and how far they are off.
struct Explained {
  std::vector<SeenPoint> seen;
  double misfit = 0.0;  ///< px, root mean square
};

Explained explainedBy(const Projection& projection, const std::vector<SeenPoint>& seen, double limit) {
  Explained explained;
  double sum = 0.0;
  for (const SeenPoint& each : seen) {
    const double error = errorOf(projection, each);
    if (!(error < limit)) continue;
    explained.seen.push_back(each);
    sum += error * error;
  }
  explained.misfit = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, explained.seen.size())));
  return explained;
}

/// Of more than half of them the error is no larger (px); those that are nowhere count as far off.
double medianError(const Projection& projection, const std::vector<SeenPoint>& seen) {
  List<double> errors;
  for (const SeenPoint& each : seen) {
    const double error = errorOf(projection, each);
    errors.push_back(std::isfinite(error) ? error : std::numeric_limits<double>::max());
  }
  return median(errors);
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

/// Those that a fit to themselves explains about as well as most: strays turn the first ones.
std::vector<SeenPoint> withoutStrays(const std::vector<SeenPoint>& seen) {
  constexpr int kTimes = 5;
  constexpr double kFar = 4.0, kLeastFar = 0.1;  // times the median error; px
  std::vector<SeenPoint> trusted = seen;
  for (int time = 0; time < kTimes && trusted.size() >= kFewest; ++time) {
    const std::optional<Fit> fit = fitTo(trusted);
    if (!fit) return {};
    const double far = std::max(kLeastFar, kFar * medianError(fit->projection, seen));
    const std::size_t before = trusted.size();
    trusted = explainedBy(fit->projection, seen, far).seen;
    if (trusted.size() == before) break;
  }
  return trusted;
}

/// Pixels are square; k(2, 2) is 1.
bool hasPixelsOfACamera(const Eigen::Matrix3d& k) {
  constexpr double kSkew = 0.02;
  return isOfPixels(k(0, 0) / k(1, 1)) && std::abs(k(0, 1)) < kSkew * k(0, 0);
}

/// The axis of the lens is not far from the image, of which a part may have been cut off. Of a list nobody knows what
/// was.
bool isCentral(const Eigen::Matrix3d& k, const Cloud& cloud) {
  constexpr double kBeside = 0.5;
  const auto central = [](double at, double size) { return -kBeside * size < at && at < (1.0 + kBeside) * size; };
  return !cloud.organized() || (central(k(0, 2), cloud.width) && central(k(1, 2), cloud.height));
}

/// Points that lie not where the camera is: there are those that it writes as (0, 0, 0) where it measures nothing.
std::ptrdiff_t countElsewhere(const Vec3& camera, const std::vector<SeenPoint>& seen) {
  constexpr double kThere = 0.001;  // m
  return std::count_if(seen.begin(), seen.end(),
                       [&camera](const SeenPoint& each) { return (each.point - camera).norm() > kThere; });
}

std::optional<CameraSearch> searchInOrder(const Cloud& cloud) {
  const std::optional<Eigen::Isometry3d> camera = findCamera(cloud);
  if (!camera) return std::nullopt;
  if (isAtOrigin(*camera, cloud)) return CameraSearch{true, std::nullopt};
  return CameraSearch{false, camera, cloud.organized() ? CameraClue::image : CameraClue::order};
}

CameraSearch searchInShadows(const Cloud& list) {
  const std::optional<Eigen::Isometry3d> camera = findCameraByShadows(list);
  return camera ? CameraSearch{false, camera, CameraClue::shadows} : CameraSearch();
}

}  // namespace

std::optional<Eigen::Isometry3d> findCamera(const Cloud& cloud) {
  constexpr double kLargestMisfit = 1.0 / 3.0, kLargestOfLists = 0.1;  // px; of pixels found from an order .3 is chance
  // Noise leaves nothing beside what tells the next worst known direction; points exactly in a plane leave four unknown
  // ones.
  constexpr double kUnknown = 1e-3;
  constexpr double kNearlyAll = 0.9;
  if (cloud.valid_count < kFewest) return std::nullopt;
  const std::vector<SeenPoint> seen = cloud.organized() ? someOf(cloud) : findPixels(cloud);
  if (seen.size() < kFewest) return std::nullopt;
  const std::vector<SeenPoint> trusted = withoutStrays(seen);
  if (trusted.size() < kFewest) return std::nullopt;
  const std::optional<Fit> fit = fitTo(trusted);
  if (!fit || !(fit->unknown < kUnknown)) return std::nullopt;
  const Projection& found = fit->projection;
  const double largest_misfit = cloud.organized() ? kLargestMisfit : kLargestOfLists;
  const Explained explained = explainedBy(found, trusted, std::numeric_limits<double>::infinity());
  if (explained.seen.empty() || !(explained.misfit < largest_misfit)) return std::nullopt;
  // What it saw lies before the camera.
  const auto depthOf = [&found](const SeenPoint& each) { return (found * each.point.homogeneous()).z(); };
  const double side = depthOf(explained.seen.front()) < 0.0 ? -1.0 : 1.0;
  const auto behind = [&](const SeenPoint& each) { return !(side * depthOf(each) > 0.0); };
  if (std::any_of(explained.seen.begin(), explained.seen.end(), behind)) return std::nullopt;
  const Projection projection = side * found;
  const Eigen::Matrix3d turned = projection.leftCols<3>();
  Eigen::Matrix3d k, r;
  split(turned, k, r);
  k /= k(2, 2);
  if (!(r.determinant() > 0.0) || !hasPixelsOfACamera(k) || !isCentral(k, cloud)) return std::nullopt;  // NaN, mirrored
  Eigen::Isometry3d cloud_from_camera = Eigen::Isometry3d::Identity();
  cloud_from_camera.translation() = -turned.inverse() * projection.col(3);
  cloud_from_camera.linear() = r.transpose();
  const double most = kNearlyAll * static_cast<double>(countElsewhere(cloud_from_camera.translation(), seen));
  if (static_cast<double>(trusted.size()) < most) return std::nullopt;
  return cloud_from_camera;
}

double turnOf(const Eigen::Isometry3d& cloud_from_camera, bool of_list) {
  const Eigen::Matrix3d axes = cloud_from_camera.linear();
  return of_list ? std::acos(std::min(1.0, axes(2, 2))) : Eigen::AngleAxisd(axes).angle();
}

bool isAtOrigin(const Eigen::Isometry3d& cloud_from_camera, const Cloud& cloud) {
  const double most = cloud.organized() ? 0.003 : 0.01;  // m and rad
  return cloud_from_camera.translation().norm() <= most && turnOf(cloud_from_camera, !cloud.organized()) <= most;
}

CameraSearch searchForCamera(const Cloud& whole) {
  if (const std::optional<CameraSearch> found = searchInOrder(whole)) return *found;
  return mayTellByShadows(whole) ? searchInShadows(whole) : CameraSearch();
}

std::optional<CameraSearch> searchForCameraInCut(const Cloud& cut) {
  constexpr double kLeft = 0.5;
  if (cut.organized()) {
    const bool at_origin = !cut.liesBehind() && findRays(cut).known;
    return at_origin ? std::optional(CameraSearch{true, std::nullopt}) : std::nullopt;
  }
  if (cut.valid_count < kLeft * static_cast<double>(cut.size())) return std::nullopt;
  if (const std::optional<CameraSearch> found = searchInOrder(cut)) return found;
  if (!mayTellByShadows(cut)) return CameraSearch();
  // The plane that they fall on may have been cut off.
  return cut.valid_count == cut.size() ? std::optional(searchInShadows(cut)) : std::nullopt;
}

}  // namespace primitect
