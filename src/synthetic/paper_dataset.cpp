// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The synthetic data set of the paper: draw the shapes, render, drop the small ones, render again, add noise.
#include "synthetic/paper_dataset.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/random.h"
#include "synthetic/paper_objects.h"
#include "synthetic/pca_normals.h"

namespace primitect::synthetic {
namespace {

constexpr int kGridSize = 401;
constexpr double kGridStep = 0.01;  // m
constexpr double kMinShare = 0.02;  // an object that owns less of the points is dropped

/// How many of each kind are drawn, before small ones are dropped.
struct Counts {
  int spheres, cylinders, cones, triangles;
};
constexpr std::array<Counts, kSceneKindCount> kCounts = {
    {{30, 0, 0, 0}, {0, 20, 0, 0}, {0, 0, 30, 0}, {0, 0, 0, 20}, {20, 5, 10, 5}}};
constexpr std::array<const char*, kSceneKindCount> kNames = {"spheres", "cylinders", "cones", "planes", "mixed"};

std::vector<PaperObject> drawObjects(SceneKind kind, Random& random) {
  const Counts& counts = kCounts[static_cast<std::size_t>(kind)];
  std::vector<PaperObject> objects = {background()};
  for (int k = 0; k < counts.spheres; ++k) objects.push_back(drawSphere(random));
  for (int k = 0; k < counts.cylinders; ++k) objects.push_back(drawCylinder(random));
  for (int k = 0; k < counts.cones; ++k) objects.push_back(drawCone(random));
  for (int k = 0; k < counts.triangles; ++k) objects.push_back(drawTriangle(random));
  return objects;
}

/// What is seen at each grid point.
struct Rendering {
  std::vector<Vec3> points;
  std::vector<int> owner;  ///< index of the object
  std::vector<int> owned;  ///< points of each object
};

double gridCoordinate(int k) { return (k - kGridSize / 2) * kGridStep; }

Rendering render(const std::vector<PaperObject>& objects) {
  Rendering seen;
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

/// The background, the first object, stays whatever it owns: without it there would be holes.
std::vector<PaperObject> withEnoughPoints(const std::vector<PaperObject>& objects, const Rendering& seen) {
  std::vector<PaperObject> kept = {objects.front()};
  for (std::size_t k = 1; k < objects.size(); ++k) {
    if (seen.owned[k] >= kMinShare * seen.owner.size()) kept.push_back(objects[k]);
  }
  return kept;
}

/// Moves the points by noise, some of them anywhere into the bounding box; these lose their surface.
void disturb(Rendering& seen, std::vector<int>& surface, double sigma, double outlier_share, Random& random) {
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

Cloud toCloud(const Rendering& seen) {
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(seen.points.size()), 1, true);
  for (std::size_t i = 0; i < seen.points.size(); ++i) {
    // Not by setPoint(), which would take the background's noiseless point at the origin for a missing one.
    const Eigen::Vector3f point = seen.points[i].cast<float>();
    cloud.x[i] = point.x();
    cloud.y[i] = point.y();
    cloud.z[i] = point.z();
  }
  cloud.valid_count = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

/// Outward normals of the noiseless surfaces; all look up, as only upper surfaces are seen.
std::vector<Vec3> noiselessNormals(const std::vector<PaperObject>& objects, const Rendering& seen) {
  std::vector<Vec3> normals(seen.points.size());
  for (std::size_t i = 0; i < normals.size(); ++i) normals[i] = normalAt(objects[seen.owner[i]].shape, seen.points[i]);
  return normals;
}

}  // namespace

const char* sceneKindName(SceneKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

SceneKind sceneKindFromName(const std::string& name) {
  for (std::size_t k = 0; k < kSceneKindCount; ++k) {
    if (name == kNames[k]) return static_cast<SceneKind>(k);
  }
  throw std::invalid_argument("scene kind '" + name + "': must be spheres, cylinders, cones, planes or mixed");
}

PaperScene makePaperScene(SceneKind kind, std::uint64_t seed, double sigma, double outlier_share) {
  if (!(sigma >= 0.0 && sigma <= 1.0))
    throw std::invalid_argument("sigma = " + std::to_string(sigma) + ": must be in 0 to 1 m");
  if (!(outlier_share >= 0.0 && outlier_share < 1.0))
    throw std::invalid_argument("outlier_share = " + std::to_string(outlier_share) + ": must be in [0, 1)");
  Random random(seed * kSceneKindCount + static_cast<std::uint64_t>(kind));
  std::vector<PaperObject> objects = drawObjects(kind, random);
  objects = withEnoughPoints(objects, render(objects));
  Rendering seen = render(objects);
  const std::vector<Vec3> normals = noiselessNormals(objects, seen);

  PaperScene scene;
  // A background that is wholly hidden is no part of the truth.
  const int hidden = seen.owned.front() == 0 ? 1 : 0;
  for (std::size_t k = hidden; k < objects.size(); ++k) scene.truth.push_back(objects[k].shape);
  scene.surface = seen.owner;
  for (int& surface : scene.surface) surface -= hidden;
  disturb(seen, scene.surface, sigma, outlier_share, random);
  scene.cloud = toCloud(seen);
  estimateNormals(scene.cloud, kGridStep, normals);
  return scene;
}

}  // namespace primitect::synthetic
