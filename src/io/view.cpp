// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The camera's view and the choice of an orthographic one.
#include "io/view.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace primitect::io {
namespace {

constexpr double kNear = 0.02;    // m
constexpr double kMargin = 0.06;  // of the picture, on each side

/// In front of the origin and within 63 deg of z, but for one point in a hundred.
bool liesInView(const Cloud& cloud) {
  std::size_t outside = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i) && !(std::hypot(cloud.x[i], cloud.y[i]) < 2.0f * cloud.z[i])) ++outside;
  }
  return outside * 100 <= cloud.valid_count;
}

/// Unit vector in which the points spread least.
Vec3 thinDirection(const Cloud& cloud) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) sum += cloud.point(i);
  }
  const Vec3 mean = sum / std::max<double>(1.0, cloud.valid_count);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Vec3 offset = cloud.point(i) - mean;
    spread += offset * offset.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

Vec3 sumOfNormals(const Cloud& cloud) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; cloud.hasNormals() && i < cloud.size(); ++i) {
    if (std::isfinite(cloud.nx[i])) sum += Vec3(cloud.nx[i], cloud.ny[i], cloud.nz[i]);
  }
  return sum;
}

void chooseDirection(const Cloud& cloud, View& view) {
  if (liesInView(cloud)) return;
  view.forward = thinDirection(cloud);
  const Vec3 towards_viewer = cloud.hasNormals() ? sumOfNormals(cloud) : Vec3(Vec3::UnitZ());
  if (view.forward.dot(towards_viewer) > 0.0) view.forward = -view.forward;
  const Vec3 up = std::abs(view.forward.z()) < 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
  view.down = (-up + up.dot(view.forward) * view.forward).normalized();
  view.right = view.down.cross(view.forward);
}

struct Span {
  double low = -0.5, high = 0.5;
};

/// All but one point in 200 at either end: a few strays must not shrink everything else.
Span spanAlong(const Cloud& cloud, const Vec3& direction) {
  std::vector<double> places;
  places.reserve(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) places.push_back(direction.dot(cloud.point(i)));
  }
  if (places.empty()) return {};
  std::sort(places.begin(), places.end());
  const std::size_t cut = places.size() / 200;
  return {places[cut], places[places.size() - 1 - cut]};
}

}  // namespace

std::optional<Eigen::Vector2d> View::project(const Vec3& p) const {
  const double z = perspective ? depth(p) : 1.0;
  if (perspective && !(z >= kNear)) return std::nullopt;
  return Eigen::Vector2d(lens.fx * right.dot(p) / z + lens.cx, lens.fy * down.dot(p) / z + lens.cy);
}

View cameraView(const Intrinsics& lens, std::uint32_t width, std::uint32_t height, int scale) {
  View view;
  view.perspective = true;
  view.width = static_cast<int>(width) * scale;
  view.height = static_cast<int>(height) * scale;
  // Pixel u becomes the pixels u * scale ... u * scale + scale - 1.
  const double shift = 0.5 * (scale - 1);
  view.lens = {lens.fx * scale, lens.fy * scale, lens.cx * scale + shift, lens.cy * scale + shift};
  return view;
}

View orthographicView(const Cloud& cloud, int width, int height) {
  View view;
  view.width = width;
  view.height = height;
  chooseDirection(cloud, view);
  const Span across = spanAlong(cloud, view.right), along = spanAlong(cloud, view.down);
  const double scale = (1.0 - 2.0 * kMargin) * std::min(width / std::max(1e-6, across.high - across.low),
                                                        height / std::max(1e-6, along.high - along.low));
  view.lens = {scale, scale, 0.5 * width - scale * 0.5 * (across.low + across.high),
               0.5 * height - scale * 0.5 * (along.low + along.high)};
  return view;
}

}  // namespace primitect::io
