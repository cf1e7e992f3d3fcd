// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Plane fits in the image window and in neighbourhoods; see normals.h.
#include "core/normals.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/neighbors.h"
#include "core/tolerance.h"

namespace primitect {
namespace {

/// The pixels of a window, clipped to the image.
struct Window {
  int left, right, top, bottom;
};

Window windowAround(const Cloud& cloud, std::uint32_t pixel, int half_width) {
  const int column = static_cast<int>(pixel % cloud.width);
  const int row = static_cast<int>(pixel / cloud.width);
  return {std::max(column - half_width, 0), std::min(column + half_width, static_cast<int>(cloud.width) - 1),
          std::max(row - half_width, 0), std::min(row + half_width, static_cast<int>(cloud.height) - 1)};
}

/// Plane a x + b y + c z = 1 as inverse depth over the ray: 1/z = a u + b v + c with u = x/z, v = y/z.
struct InverseDepthFit {
  Vec3 plane = Vec3::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  ///< inverse of the normal equations
  int used = 0;
};

/// One least-squares pass over the pixels that `belongs` accepts; used = 0 when they do not determine a plane.
template <class Belongs>
InverseDepthFit fitWindow(const Cloud& cloud, const Window& window, const Vec3& center, const Belongs& belongs) {
  const double center_u = center.x() / center.z();
  const double center_v = center.y() / center.z();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  InverseDepthFit fit;
  for (int row = window.top; row <= window.bottom; ++row) {
    for (int column = window.left; column <= window.right; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * cloud.width + column;
      if (!belongs(i)) continue;
      const double inverse_depth = 1.0 / cloud.z[i];
      const Vec3 ray(cloud.x[i] * inverse_depth - center_u, cloud.y[i] * inverse_depth - center_v, 1.0);
      moments.noalias() += ray * ray.transpose();
      right += inverse_depth * ray;
      ++fit.used;
    }
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(moments);
  const Vec3 pivots = solver.vectorD();
  if (fit.used < 3 || !(pivots.minCoeff() > 1e-12 * pivots.maxCoeff())) return {};
  fit.plane = solver.solve(right);
  fit.spread = solver.solve(Eigen::Matrix3d::Identity());
  fit.plane.z() -= fit.plane.x() * center_u + fit.plane.y() * center_v;
  return fit;
}

/// Standard deviation of the direction of (a, b, c) about each axis (rad), of this noise of the inverse depth.
double directionNoise(const InverseDepthFit& fit, double inverse_depth_noise) {
  // a and b turn the plane; c is known much better.
  const double variance = 0.5 * (fit.spread(0, 0) + fit.spread(1, 1));
  return inverse_depth_noise * std::sqrt(variance) / fit.plane.norm();
}

void orientTowardsSensor(const Vec3& point, Vec3& normal) {
  if (normal.dot(point) > 0.0) normal = -normal;
}

void store(const Vec3& normal, std::size_t i, Samples& samples) {
  samples.nx[i] = static_cast<float>(normal.x());
  samples.ny[i] = static_cast<float>(normal.y());
  samples.nz[i] = static_cast<float>(normal.z());
}

void takeCloudNormals(const Cloud& cloud, bool orient, Samples& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::uint32_t k = samples.index[i];
    Vec3 normal(cloud.nx[k], cloud.ny[k], cloud.nz[k]);
    if (orient) orientTowardsSensor(samples.point(i), normal);
    store(normal, i, samples);
  }
}

/// The image window needs depth along z, as in an optical frame.
bool allInFront(const Cloud& cloud) {
  return std::none_of(cloud.z.begin(), cloud.z.end(), [](float z) { return z <= 0.0f; });
}

bool anyNormal(const Samples& samples) {
  return std::any_of(samples.nx.begin(), samples.nx.end(), [](float nx) { return nx == nx; });
}

/// pixel: of every point of the cloud that the samples are from.
template <class PixelOf>
void fitWindows(const Cloud& image, const PixelOf& pixel, int window_at_one_meter, Samples& samples) {
  constexpr int kSmallestWindow = 3;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    // Never larger than 1.5 times the value at 1 m: nearer than that the noise no longer asks for it.
    const int largest = std::max(kSmallestWindow, window_at_one_meter * 3 / 2);
    const double wanted =
        std::clamp(static_cast<double>(window_at_one_meter) / samples.z[i],
                   static_cast<double>(std::min(kSmallestWindow, window_at_one_meter)), static_cast<double>(largest));
    const int half_width = static_cast<int>(std::lround(wanted));
    if (const std::optional<WindowNormal> normal =
            windowNormal(image, pixel(samples.index[i]), samples.point(i), half_width)) {
      store(normal->direction, i, samples);
      samples.normal_sigma[i] = static_cast<float>(normal->sigma);
    }
  }
}

/// To the side of the given normal, or where there is none (0) towards the sensor.
void orient(Vec3& normal, const Vec3& point, const Vec3& given) {
  if (given.isZero()) return orientTowardsSensor(point, normal);
  if (normal.dot(given) < 0.0) normal = -normal;
}

void fitNeighborhoods(const Cloud& cloud, int count, NeighborSearch& search, Samples& samples) {
  std::vector<std::uint32_t> neighbors;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    search.nearest(cloud, samples.index[i], count, neighbors);
    std::optional<Vec3> normal = planeNormal(cloud, neighbors);
    if (!normal) continue;
    orient(*normal, samples.point(i), samples.hasNormal(i) ? samples.normal(i) : Vec3(Vec3::Zero()));
    store(*normal, i, samples);
  }
}

}  // namespace

std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, int half_width) {
  return windowNormal(cloud, pixel, Vec3(cloud.x[pixel], cloud.y[pixel], cloud.z[pixel]), half_width);
}

std::optional<WindowNormal> windowNormal(const Cloud& cloud, std::uint32_t pixel, const Vec3& center, int half_width) {
  constexpr double kLargestJump = 0.04;    // of the depth: more is another surface, at any slope that can be fitted
  constexpr double kSmallestShare = 0.25;  // of the window, on the centre's surface
  constexpr double kTolerance = 3.0;       // standard deviations
  constexpr int kRobustPasses = 2;
  const double depth = center.z();
  if (!(depth > 0.0)) return std::nullopt;
  const Window window = windowAround(cloud, pixel, half_width);
  const int needed = std::max(6, static_cast<int>(kSmallestShare * (2 * half_width + 1) * (2 * half_width + 1)));

  // The start comes from the inner window, where a step nearby has less of a say.
  InverseDepthFit fit = fitWindow(cloud, windowAround(cloud, pixel, (half_width + 1) / 2), center,
                                  [&](std::size_t i) { return std::abs(cloud.z[i] - depth) < kLargestJump * depth; });
  constexpr int kFewestAtStart = 6;
  if (fit.used < kFewestAtStart) return std::nullopt;
  const double tolerance = kTolerance * axialNoise(depth);
  for (int pass = 0; pass < kRobustPasses && fit.used > 0; ++pass) {
    const Vec3 plane = fit.plane;
    fit = fitWindow(cloud, window, center, [&](std::size_t i) {
      const double inverse_depth = plane.dot(Vec3(cloud.x[i], cloud.y[i], cloud.z[i])) / cloud.z[i];
      return std::abs(1.0 / inverse_depth - cloud.z[i]) < tolerance;
    });
  }
  const double center_error = 1.0 / (fit.plane.dot(center) / depth) - depth;
  if (fit.used < needed || !(std::abs(center_error) < tolerance)) return std::nullopt;
  const double noise = directionNoise(fit, axialNoise(depth) / (depth * depth));
  return WindowNormal{-fit.plane.normalized(), noise};
}

std::optional<Vec3> planeNormal(const Cloud& cloud, const std::vector<std::uint32_t>& points) {
  if (points.size() < 3) return std::nullopt;
  const auto at = [&cloud](std::uint32_t i) { return Vec3(cloud.x[i], cloud.y[i], cloud.z[i]); };
  const Vec3 origin = at(points.front());
  Vec3 sum = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : points) {
    const Vec3 offset = at(i) - origin;
    sum += offset;
    squares.noalias() += offset * offset.transpose();
  }
  const Eigen::Matrix3d scatter = squares - sum * sum.transpose() / static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  // Points on a line, or all the same, have no second direction.
  if (!(solver.eigenvalues()(1) > 1e-9 * solver.eigenvalues()(2)) || !(solver.eigenvalues()(2) > 0.0))
    return std::nullopt;
  return Vec3(solver.eigenvectors().col(0));
}

bool seenByDepthCamera(const Cloud& cloud, NormalSource& source) {
  const bool brings_normals = cloud.hasNormals();
  if (!cloud.organized() && !brings_normals && !source.image_tried) source.image = projectedImage(cloud);
  source.image_tried = true;
  return source.image.has_value() || (cloud.organized() && allInFront(cloud));
}

int neighborsFor(const Cloud& cloud, const Samples& samples, double sigma, double wanted, NormalSource& source) {
  constexpr std::size_t kLookedAt = 64;
  constexpr int kNearest = 11;
  constexpr double kFewest = 12.0, kMost = 300.0;
  if (!source.neighbors) source.neighbors = std::make_unique<NeighborSearch>(cloud);
  std::vector<double> radii;
  std::vector<std::uint32_t> nearest;
  for (std::size_t i = 0; i < samples.size(); i += samples.size() / kLookedAt + 1) {
    source.neighbors->nearest(cloud, samples.index[i], kNearest, nearest);
    double radius = 0.0;
    for (const std::uint32_t k : nearest) {
      radius = std::max(radius, (Vec3(cloud.x[k], cloud.y[k], cloud.z[k]) - samples.point(i)).norm());
    }
    radii.push_back(radius);
  }
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  const double spacing = *middle * std::sqrt(M_PI / kNearest);
  return static_cast<int>(std::clamp(2.0 * std::sqrt(M_PI) * sigma / (spacing * wanted), kFewest, kMost));
}

void estimateNormals(const Cloud& cloud, const Params& params, NormalSource& source, Samples& samples) {
  if (params.use_cloud_normals && cloud.hasNormals()) {
    takeCloudNormals(cloud, params.orient_normals, samples);
    // Fields that are there but hold zeros or NaN throughout are as good as none.
    if (anyNormal(samples) && source.neighbor_count <= 0) return;
  }
  const bool from_image = source.neighbor_count <= 0 && seenByDepthCamera(cloud, source);
  if (from_image && source.image) {
    const auto pixel = [&](std::uint32_t point) { return source.image->pixel[point]; };
    return fitWindows(source.image->image, pixel, params.normal_window, samples);
  }
  if (from_image)
    return fitWindows(
        cloud, [](std::uint32_t point) { return point; }, params.normal_window, samples);
  if (!source.neighbors) source.neighbors = std::make_unique<NeighborSearch>(cloud);
  const int count = source.neighbor_count > 0 ? source.neighbor_count : params.normal_neighbors;
  fitNeighborhoods(cloud, count, *source.neighbors, samples);
}

}  // namespace primitect
