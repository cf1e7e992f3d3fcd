// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The synthetic data set of the paper: draw the shapes, render, drop the small ones, render again, add noise.
#include "synthetic/paper_dataset.h"

#include <array>
#include <stdexcept>

#include "core/random.h"
#include "synthetic/paper_objects.h"
#include "synthetic/paper_rendering.h"

namespace primitect::synthetic {
namespace {

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

/// The background, the first object, stays whatever it owns: without it there would be holes.
std::vector<PaperObject> withEnoughPoints(const std::vector<PaperObject>& objects, const PaperRendering& seen) {
  std::vector<PaperObject> kept = {objects.front()};
  for (std::size_t k = 1; k < objects.size(); ++k) {
    if (seen.owned[k] >= kMinShare * seen.owner.size()) kept.push_back(objects[k]);
  }
  return kept;
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
  checkNoise(sigma, outlier_share);
  Random random(seed * kSceneKindCount + static_cast<std::uint64_t>(kind));
  std::vector<PaperObject> objects = drawObjects(kind, random);
  objects = withEnoughPoints(objects, renderFromAbove(objects));
  return sceneOf(objects, renderFromAbove(objects), sigma, outlier_share, random);
}

}  // namespace primitect::synthetic
