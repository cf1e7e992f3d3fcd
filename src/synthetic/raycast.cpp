// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Ray casting with a depth buffer: each body is tested only at the pixels that its bounding box covers.
#include "synthetic/raycast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthetic/intersections.h"
#include "synthetic/intersections_hollow.h"
#include "synthetic/intersections_traced.h"

namespace primitect::synthetic {
namespace {

/// Half-open ranges of columns and rows.
struct PixelBox {
  int u_begin, u_end, v_begin, v_end;
};

PixelBox wholeImage(const PinholeCamera& camera) { return {0, camera.width, 0, camera.height}; }

/// The pixels that can see the body: the projection of a body lies within that of its box's corners, provided that
/// all of them are in front of the camera.
PixelBox pixelBoxOf(const Body& body, const Eigen::Isometry3d& camera_from_body, const PinholeCamera& camera) {
  constexpr double kNear = 1e-3;
  Eigen::AlignedBox2d covered;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? body.corner_max.x() : body.corner_min.x(),
                 corner & 2 ? body.corner_max.y() : body.corner_min.y(),
                 corner & 4 ? body.corner_max.z() : body.corner_min.z());
    const Vec3 seen = camera_from_body * p;
    if (seen.z() < kNear) return wholeImage(camera);
    covered.extend(camera.project(seen));
  }
  const auto clamped = [](double value, int limit) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
  };
  return {clamped(std::floor(covered.min().x()), camera.width), clamped(covered.max().x() + 1.0, camera.width),
          clamped(std::floor(covered.min().y()), camera.height), clamped(covered.max().y() + 1.0, camera.height)};
}

/// Rays have z = 1 in the camera's frame, so the t of a hit is its depth there, whatever frame it is computed in.
template <class SolidType>
void draw(const SolidType& solid, const Body& body, const PinholeCamera& camera,
          const Eigen::Isometry3d& body_from_camera, Rendering& rendering) {
  const PixelBox box = pixelBoxOf(body, body_from_camera.inverse(), camera);
  const Vec3 origin = body_from_camera.translation();
  const Vec3 column_step = body_from_camera.linear().col(0) / camera.fx;
  for (int v = box.v_begin; v < box.v_end; ++v) {
    const Vec3 row_start = body_from_camera.linear() * camera.ray(0.0, v);
    const std::size_t row = static_cast<std::size_t>(v) * camera.width;
    for (int u = box.u_begin; u < box.u_end; ++u) {
      const Hit hit = intersect(solid, origin, row_start + u * column_step);
      const float depth = static_cast<float>(hit.t);
      if (!(hit.t > 0.0 && depth < rendering.depth[row + u])) continue;
      rendering.depth[row + u] = depth;
      rendering.surface[row + u] = body.first_surface + hit.face;
    }
  }
}

}  // namespace

void render(const World& world, const PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
            Rendering& rendering) {
  constexpr float kNothing = std::numeric_limits<float>::infinity();
  rendering.depth.assign(camera.pixelCount(), kNothing);
  rendering.surface.assign(camera.pixelCount(), kNoSurface);
  for (const Body& body : world.bodies()) {
    const Eigen::Isometry3d body_from_camera = body.world_from_body.inverse() * world_from_camera;
    std::visit([&](const auto& solid) { draw(solid, body, camera, body_from_camera, rendering); }, body.solid);
  }
  std::replace(rendering.depth.begin(), rendering.depth.end(), kNothing, kMissing);
}

}  // namespace primitect::synthetic
