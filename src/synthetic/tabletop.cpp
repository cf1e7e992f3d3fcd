// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Draws objects and places for them until all of them stand apart and can be seen.
#include "synthetic/tabletop.h"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/random.h"
#include "synthetic/camera.h"
#include "synthetic/poses.h"
#include "synthetic/raycast.h"
#include "synthetic/room.h"
#include "synthetic/scene_layout.h"
#include "synthetic/tabletop_objects.h"

namespace primitect::synthetic {
namespace {

Place drawPlace(Random& random) {
  // An ellipse that the camera sees as a whole: 0.8 m to the sides, 0.6 m in depth.
  const double angle = random.uniform(0.0, 2.0 * kPi);
  const double reach = std::sqrt(random.uniform());
  return {{0.30 * reach * std::cos(angle), 0.40 * reach * std::sin(angle)}, random.uniform(0.0, 2.0 * kPi)};
}

/// A place for objects[places.size()] apart from the ones placed before it, or none.
std::optional<Place> freePlace(const std::vector<Object>& objects, const std::vector<Place>& places, Random& random) {
  constexpr int kTries = 60;
  constexpr double kGap = 0.020;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const Place place = drawPlace(random);
    bool is_free = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      is_free = is_free && apart(objects[i], places[i], objects[places.size()], place, kGap);
    }
    if (is_free) return place;
  }
  return std::nullopt;
}

/// Places for all objects, or none when one of them did not fit in.
std::optional<std::vector<Place>> drawPlaces(const std::vector<Object>& objects, Random& random) {
  std::vector<Place> places;
  while (places.size() < objects.size()) {
    const std::optional<Place> place = freePlace(objects, places, random);
    if (!place) return std::nullopt;
    places.push_back(*place);
  }
  return places;
}

constexpr double kYawSwing = 20.0 * kDegree;
constexpr double kPitch = 38.0 * kDegree;
constexpr double kPitchSwing = 2.0 * kDegree;
constexpr double kDistance = 1.02;
constexpr double kDistanceSwing = 0.03;

/// The camera at a place of its swing; each share is in [-1, 1].
Eigen::Isometry3d orbitPose(double yaw_share, double pitch_share, double distance_share) {
  const double yaw = kYawSwing * yaw_share;
  const double pitch = kPitch + kPitchSwing * pitch_share;
  const Vec3 target(0.0, 0.0, kTableHeight + 0.04);
  const Vec3 backwards(-std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch));
  return lookAt(target + (kDistance + kDistanceSwing * distance_share) * backwards, target);
}

/// The default camera with a quarter of its resolution: a sixteenth of the pixels is enough to see what is hidden.
PinholeCamera coarseCamera() {
  const PinholeCamera fine;
  return {fine.width / 4, fine.height / 4, fine.fx / 4, fine.fy / 4, (fine.cx - 1.5) / 4, (fine.cy - 1.5) / 4};
}

/// True when no corner of the body's bounding box is near or beyond the image border.
bool inView(const Body& body, const PinholeCamera& camera, const Eigen::Isometry3d& camera_from_world) {
  const Vec3 corners[2] = {body.corner_min, body.corner_max};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corners[corner & 1].x(), corners[(corner >> 1) & 1].y(), corners[corner >> 2].z());
    const Eigen::Vector2d pixel = camera.project(camera_from_world * body.world_from_body * p);
    const bool inside = pixel.x() > 1 && pixel.x() < camera.width - 2 && pixel.y() > 1 && pixel.y() < camera.height - 2;
    if (!inside) return false;
  }
  return true;
}

/// Pixels of the mantle of curved bodies, of all sides of boxes.
int mainFacePixels(const Body& body, const Rendering& rendering) {
  const int last = std::holds_alternative<Box>(body.solid) ? body.first_surface + 5 : body.first_surface;
  int count = 0;
  for (const int surface : rendering.surface) count += surface >= body.first_surface && surface <= last;
  return count;
}

bool allVisible(const World& world, std::size_t first_body) {
  // 900 pixels of the full image, and a fifth more for what the noise model loses at the edges.
  constexpr int kLeast = 900 * 6 / 5 / 16;
  const PinholeCamera camera = coarseCamera();
  Rendering rendering;
  for (const double yaw_share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double pitch_share : {-1.0, 1.0}) {
      const Eigen::Isometry3d pose = orbitPose(yaw_share, pitch_share, pitch_share);
      render(world, camera, pose, rendering);
      for (std::size_t i = first_body; i < world.bodies().size(); ++i) {
        const Body& body = world.bodies()[i];
        if (!inView(body, camera, pose.inverse()) || mainFacePixels(body, rendering) < kLeast) return false;
      }
    }
  }
  return true;
}

}  // namespace

World emptyRoom() {
  World world;
  addFloor(world);
  addWall(2.4, 0.0, world);
  addTable(kTableHalfX, kTableHalfY, world);
  return world;
}

World tabletop(std::uint64_t seed) {
  constexpr int kTries = 10000;
  Random random(seed);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const std::vector<Object> objects = drawObjects(random);
    const std::optional<std::vector<Place>> places = drawPlaces(objects, random);
    if (!places) continue;
    World world = emptyRoom();
    const std::size_t first_object = world.bodies().size();
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Place& place = (*places)[i];
      const Eigen::Isometry3d stand(Eigen::Translation3d(place.center.x(), place.center.y(), kTableHeight) *
                                    Eigen::AngleAxisd(place.yaw, Vec3::UnitZ()));
      world.add(objects[i].name, objects[i].solid, stand * objects[i].pose);
    }
    if (allVisible(world, first_object)) return world;
  }
  throw std::runtime_error("tabletop: found no visible arrangement for seed " + std::to_string(seed));
}

Eigen::Isometry3d cameraPose(double seconds) {
  const auto swing = [seconds](double period) { return std::sin(2.0 * kPi * seconds / period); };
  return orbitPose(swing(24.0), swing(17.0), swing(31.0));
}

}  // namespace primitect::synthetic
