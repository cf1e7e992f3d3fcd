// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Points dropped or put in another order at random; see variants.h.
#include "eval/variants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "core/random.h"
#include "synthetic/poses.h"

namespace primitect::eval {
namespace {

/// The cloud's points with these indices, in this order.
void keepOnly(const std::vector<std::size_t>& kept, Cloud& cloud) {
  for (std::vector<float>* values : {&cloud.x, &cloud.y, &cloud.z, &cloud.nx, &cloud.ny, &cloud.nz}) {
    if (values->empty()) continue;
    std::vector<float> chosen;
    chosen.reserve(kept.size());
    for (const std::size_t i : kept) chosen.push_back((*values)[i]);
    *values = std::move(chosen);
  }
  cloud.width = static_cast<std::uint32_t>(kept.size());
  cloud.height = 1;
}

/// Indices of the points that are not missing.
std::vector<std::size_t> measured(const Cloud& cloud) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) order.push_back(i);
  }
  return order;
}

/// Where each point is between one side of the cloud (0) and the other (1), along a horizontal direction.
std::vector<double> placesAcross(const Cloud& cloud, double heading) {
  std::vector<double> places(cloud.size(), 0.0);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    places[i] = cloud.x[i] * std::cos(heading) + cloud.y[i] * std::sin(heading);
    least = std::min(least, places[i]);
    most = std::max(most, places[i]);
  }
  for (double& place : places) place = most > least ? (place - least) / (most - least) : 0.0;
  return places;
}

}  // namespace

void thinOut(Cloud& cloud, double keep, double uneven, std::uint64_t seed) {
  constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
  constexpr double kFullTurn = 6.283185307179586;
  // Other numbers than those that made the scene.
  Random random(seed ^ 0x7468696eU), heading(seed ^ 0x756e6576U);
  const std::vector<double> places = placesAcross(cloud, heading.uniform(0.0, kFullTurn));
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (random.uniform() < keep * std::pow(uneven, -places[i])) {
      kept.push_back(i);
      continue;
    }
    cloud.x[i] = cloud.y[i] = cloud.z[i] = kMissing;
  }
  if (!cloud.organized()) keepOnly(kept, cloud);
  cloud.countPoints();
}

void listPoints(Cloud& cloud) { keepOnly(measured(cloud), cloud); }

void shufflePoints(Cloud& cloud, std::uint64_t seed) {
  std::vector<std::size_t> order = measured(cloud);
  Random random(seed ^ 0x73687566U);
  for (std::size_t left = order.size(); left > 1; --left) std::swap(order[left - 1], order[random.below(left)]);
  keepOnly(order, cloud);
}

void averageInVoxels(Cloud& cloud, double side) {
  struct Sum {
    Eigen::Vector3d point = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    double points = 0.0;
  };
  std::map<std::array<double, 3>, Sum> voxels;
  const bool normals = cloud.hasNormals();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    const Eigen::Vector3d voxel = (cloud.point(i) / side).array().floor();
    Sum& sum = voxels[{voxel.z(), voxel.y(), voxel.x()}];
    sum.point += cloud.point(i);
    if (normals) sum.normal += cloud.normal(i);
    sum.points += 1.0;
  }
  cloud.reset(static_cast<std::uint32_t>(voxels.size()), 1, normals);
  std::size_t i = 0;
  for (const auto& [voxel, sum] : voxels) {
    const Eigen::Vector3f mean = (sum.point / sum.points).cast<float>(), normal = sum.normal.cast<float>();
    cloud.setPoint(i, mean.x(), mean.y(), mean.z(), DepthRange());
    if (normals) cloud.setNormal(i, normal.x(), normal.y(), normal.z());
    ++i;
  }
}

Eigen::Isometry3d robotFromSensor() {
  constexpr double kHeight = 1.3, kDown = 38.0 * synthetic::kPi / 180.0;  // m, rad
  return synthetic::robotFromCamera(kHeight, kDown);
}

}  // namespace primitect::eval
