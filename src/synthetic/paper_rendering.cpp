// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Height fields over the grid, then noise and normals; see paper_rendering.h.
#include "synthetic/paper_rendering.h"

#include <Eigen/Geometry>
#include <stdexcept>
#include <string>

#include "synthetic/pca_normals.h"

namespace primitect::synthetic {
namespace {

constexpr int kGridSize = 401;
constexpr double kGridStep = 0.01;  // m

double gridCoordinate(int k) { return (k - kGridSize / 2) * kGridStep; }

/// Moves the points by noise, some of them anywhere into the bounding box; these lose their surface.
void disturb(PaperRendering& seen, std::vector<int>& surface, double sigma, double outlier_share, Random& random) {
  Eigen::AlignedBox3d box;
  for (Vec3& point : seen.points) {
    for (int axis = 0; axis < 3; ++axis) point[axis] += sigma * random.gaussian();
    box.extend(point);
  }
  if (outlier_share <= 0.0) return;
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    if (random.uniform() >= outlier_share) continue;
    for (int axis = 0; axis < 3; ++axis) seen.points[i][axis] = random.uniform(box.min()[axis], box.max()[axis]);
    surface[i] = -1;
  }
}

Cloud toCloud(const PaperRendering& seen) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(seen.points.size()), 1, true);
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    // Not by setPoint(), which would take the background's noiseless point at the origin for a missing one.
    const Eigen::Vector3f point = seen.points[i].cast<float>();
    cloud.x[i] = point.x();
    cloud.y[i] = point.y();
    cloud.z[i] = point.z();
  }
  cloud.countPoints();
  return cloud;
}

/// Outward normals of the noiseless surfaces; all look up, as only upper surfaces are seen.
std::vector<Vec3> noiselessNormals(const std::vector<PaperObject>& objects, const PaperRendering& seen) {
  std::vector<Vec3> normals(seen.points.size());
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = normalAt(objects[seen.owner[i]].shape, seen.points[i]);
  return normals;
}

}  // namespace

PaperRendering renderFromAbove(const std::vector<PaperObject>& objects) {
  PaperRendering seen;
  seen.owned.assign(objects.size(), 0);
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const double x = gridCoordinate(column), y = gridCoordinate(row);
      int owner = 0;
      double top = kNothing;
      for (std::size_t k = 0; k < objects.size(); ++k) {
        const double z = objects[k].height(x, y);
        if (z > top) owner = static_cast<int>(k), top = z;
      }
      seen.points.emplace_back(x, y, top);
      seen.owner.push_back(owner);
      ++seen.owned[owner];
    }
  }
  return seen;
}

PaperScene sceneOf(const std::vector<PaperObject>& objects, PaperRendering seen, double sigma, double outlier_share,
                   Random& random) {
  const std::vector<Vec3> normals = noiselessNormals(objects, seen);
  PaperScene scene;
  std::vector<int> label(objects.size(), -1);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (seen.owned[k] == 0) continue;
    label[k] = static_cast<int>(scene.truth.size());
    scene.truth.push_back(objects[k].shape);
    scene.owned.push_back(seen.owned[k]);
  }
  for (const int owner : seen.owner) scene.surface.push_back(label[owner]);
  disturb(seen, scene.surface, sigma, outlier_share, random);
  scene.cloud = toCloud(seen);
  estimateNormals(scene.cloud, kGridStep, normals);
  return scene;
}

void checkNoise(double sigma, double outlier_share) {
  if (!(sigma >= 0.0 && sigma <= 1.0))
    throw std::invalid_argument("sigma = " + std::to_string(sigma) + ": must be in 0 to 1 m");
  if (!(outlier_share >= 0.0 && outlier_share < 1.0))
    throw std::invalid_argument("outlier_share = " + std::to_string(outlier_share) + ": must be in [0, 1)");
}

}  // namespace primitect::synthetic
