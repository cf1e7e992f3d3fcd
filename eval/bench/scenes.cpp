// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws and renders; see scenes.h.
#include "eval/bench/scenes.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/random.h"
#include "synthetic/clutter.h"
#include "synthetic/frame.h"
#include "synthetic/paper_dataset.h"
#include "synthetic/poses.h"
#include "synthetic/scene_layout.h"

namespace primitect::bench {
namespace {

using synthetic::PaperScene;
using synthetic::PinholeCamera;
using synthetic::SceneKind;
using synthetic::World;

constexpr double kPaperNoise = 0.01;  // m

/// A point of the shape near the given one, at most half a step of the paper's grid away.
Vec3 movedAlong(const Shape& shape, const Vec3& point, Random& random) {
  constexpr double kHalfStep = 0.005;  // m
  const Vec3 normal = normalAt(shape, point);
  const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
  const double along_first = random.uniform(-kHalfStep, kHalfStep),
               along_second = random.uniform(-kHalfStep, kHalfStep);
  return project(shape, point + along_first * first + along_second * second);
}

Vec3 disturbed(const Vec3& v, double sigma, Random& random) {
  return v + sigma * Vec3{random.gaussian(), random.gaussian(), random.gaussian()};
}

/// With the noise of this seed, not cut at any depth.
Cloud render(const World& world, const Eigen::Isometry3d& world_from_camera, int width, int height,
             std::uint64_t seed) {
  const PinholeCamera camera = PinholeCamera().scaledTo(width, height);
  const synthetic::Frame frame = renderFrame(world, camera, world_from_camera, synthetic::FrameParams(), seed, 0);
  Cloud cloud;
  cloudFromDepth(frame.depth, camera, DepthRange(), cloud);
  return cloud;
}

/// 1.2 m before a wall, a little aside.
Cloud wallFrame(int width, int height, std::uint64_t seed) {
  constexpr double kAway = 1.2;                               // m
  const double aside = 0.05 * static_cast<double>(seed % 4);  // rad
  World wall;
  wall.add("wall", synthetic::Sheet{4.0, 4.0}, synthetic::tilted(-synthetic::kPi / 2));
  const Vec3 eye(-kAway * std::cos(aside), kAway * std::sin(aside), 0.0);
  return render(wall, synthetic::lookAt(eye, Vec3(0.0, 0.0, 0.0)), width, height, seed);
}

void addObject(int index, const Eigen::Isometry3d& place, World& world) {
  using synthetic::at;
  constexpr double kHeight = 0.10, kRadius = 0.035, kHalfAngle = 0.35;  // m, rad
  if (index % 4 == 0) world.add("ball", synthetic::Ball{kRadius}, place * at(0.0, kRadius));
  if (index % 4 == 1) world.add("rod", synthetic::Rod{kRadius, 0.5 * kHeight}, place * at(0.0, 0.5 * kHeight));
  if (index % 4 == 2) {
    const Eigen::Isometry3d apex_up = at(0.0, kHeight) * synthetic::tilted(synthetic::kPi);
    world.add("cone", synthetic::Frustum{kHalfAngle, 0.0, kHeight}, place * apex_up);
  }
  if (index % 4 == 3) world.add("box", synthetic::Box{kRadius, kRadius, kRadius}, place * at(0.0, kRadius));
}

}  // namespace

std::vector<Cloud> paperClouds(std::size_t count) {
  std::vector<Cloud> clouds;
  for (std::size_t k = 0; k < count; ++k) {
    clouds.push_back(makePaperScene(SceneKind::mixed, kFirstSeed + k, kPaperNoise).cloud);
  }
  return clouds;
}

Cloud paperCloudOf(std::size_t points) {
  constexpr double kNormalNoise = 0.09;  // rad about each axis: 6 deg in the median, as 41 neighbours give
  const PaperScene scene = makePaperScene(SceneKind::mixed, kFirstSeed, kPaperNoise);
  const std::size_t available = scene.cloud.size();
  Random random(kFirstSeed);
  Cloud cloud;
  cloud.reset(static_cast<std::uint32_t>(points), 1, true);
  for (std::size_t k = 0; k < points; ++k) {
    const std::size_t i = k * available / points;
    const Shape& shape = scene.truth[scene.surface[i]];
    const Vec3 noisy(scene.cloud.x[i], scene.cloud.y[i], scene.cloud.z[i]);
    const Vec3 exact = movedAlong(shape, project(shape, noisy), random);
    Vec3 normal = normalAt(shape, exact);
    if (normal.z() < 0.0) normal = -normal;  // all look up, as only upper surfaces are seen
    const Eigen::Vector3f p = disturbed(exact, kPaperNoise, random).cast<float>();
    const Eigen::Vector3f n = disturbed(normal, kNormalNoise, random).cast<float>();
    cloud.setPoint(k, p.x(), p.y(), p.z(), DepthRange());
    cloud.setNormal(k, n.x(), n.y(), n.z());
  }
  return cloud;
}

std::vector<Cloud> depthFrames(View view, int width, int height, std::size_t count) {
  std::vector<Cloud> frames;
  for (std::uint64_t seed = kFirstSeed; frames.size() < count; ++seed) {
    if (view == View::wall) {
      frames.push_back(wallFrame(width, height, seed));
      continue;
    }
    const World world = view == View::clutter ? synthetic::shapelessTable(seed) : synthetic::clutteredTable(seed);
    frames.push_back(render(world, synthetic::clutterPose(seed), width, height, seed));
  }
  return frames;
}

Cloud frameWithObjects(int objects) {
  constexpr int kColumns = 6, kRows = 4;
  constexpr double kStep = 0.14;  // m
  if (objects < 1 || objects > kColumns * kRows) {
    throw std::invalid_argument(std::to_string(objects) + " objects: must be 1 to 24");
  }
  World world;
  world.add("table", synthetic::Sheet{2.0, 2.0}, Eigen::Isometry3d::Identity());
  for (int k = 0; k < objects; ++k) {
    // 7 and 24 have no common divisor: one after the other all over the table, each place once.
    const int place = k * 7 % (kColumns * kRows);
    const Vec3 center((place / kColumns - 0.5 * (kRows - 1)) * kStep, (place % kColumns - 0.5 * (kColumns - 1)) * kStep,
                      0.0);
    addObject(k, Eigen::Isometry3d(Eigen::Translation3d(center)), world);
  }
  const Eigen::Isometry3d pose = synthetic::lookAt(Vec3(-0.6, 0.0, 0.9), Vec3(0.0, 0.0, 0.0));
  return render(world, pose, PinholeCamera().width, PinholeCamera().height, kFirstSeed);
}

}  // namespace primitect::bench
