// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a world to a labelled frame; see depth_frames.h.
#include "eval/depth_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "eval/measured_normals.h"
#include "primitect/transforms.h"
#include "synthetic/clutter.h"
#include "synthetic/frame.h"
#include "synthetic/hall.h"
#include "synthetic/heap.h"
#include "synthetic/sensors.h"

namespace primitect::eval {
namespace {

using synthetic::Frame;
using synthetic::kNoSurface;
using synthetic::PinholeCamera;
using synthetic::World;

/// A view of a world.
struct View {
  World world;
  PinholeCamera camera;
  Eigen::Isometry3d world_from_camera;
};

std::uint32_t leastPixels(const Recipe& recipe) {
  const double finer = recipe.width / static_cast<double>(PinholeCamera().width);
  return static_cast<std::uint32_t>(std::lround(kLeastPixels * finer * finer));
}

/// Shapes are scored as if they had no end. Two faces in one plane, like the tops of two boxes of the same height, are
/// therefore one true shape. One detection of each, where they can be told apart, counts like one of both (faces.h).
/// Index of the plane that the item lies in, or the number of shapes.
std::size_t indexOfSamePlane(const Detection& item, const std::vector<TrueShape>& truth) {
  constexpr double kApart = 0.004;               // m, twice the noise of the depth at 1 m
  constexpr double kLeastCosine = 1.0 - 1.5e-4;  // 1 deg
  const Plane* plane = std::get_if<Plane>(&item.shape);
  const auto same = [&](const TrueShape& shape) {
    const Plane* other = std::get_if<Plane>(&shape.shape);
    return plane && other && plane->normal.dot(other->normal) > kLeastCosine &&
           std::abs(distance(*other, item.extent.origin)) < kApart;
  };
  return std::find_if(truth.begin(), truth.end(), same) - truth.begin();
}

/// A tenth of the error that thousands of points leave, over the face.
bool isSame(const Detection& item, const Shape& shape) {
  constexpr double kFarther = 1e-5;  // m
  const Extent& extent = item.extent;
  return std::all_of(extent.hull.begin(), extent.hull.end(),
                     [&](const Vec3& corner) { return std::abs(distance(shape, corner)) < kFarther; });
}

void labelFaces(const Frame& frame, LabelledCloud& result) {
  result.face.assign(frame.surface.size(), kNoShape);
  for (std::size_t i = 0; i < frame.surface.size(); ++i) {
    const int t = result.surface[i];
    if (t >= 0 && !result.truth[t].exact) result.face[i] = frame.surface[i];
  }
}

Detections itemsIn(const View& view, const synthetic::Rendering& rendering, std::vector<int>& surface_of_item) {
  constexpr std::uint32_t kFewestPixels = 20;  // fewer hardly have an extent, and are clutter
  synthetic::TruthParams params;
  params.min_pixels = kFewestPixels;
  return truthOf(view.world, view.camera, view.world_from_camera, rendering, params, &surface_of_item);
}

/// What is seen of each surface of the world, without the noise, which would make it longer.
std::vector<std::optional<Extent>> seenExtents(const View& view, const synthetic::Rendering& exact) {
  std::vector<int> surface_of_item;
  const Detections items = itemsIn(view, exact, surface_of_item);
  std::vector<std::optional<Extent>> extents(view.world.surfaces().size());
  for (std::size_t k = 0; k < items.items.size(); ++k) extents[surface_of_item[k]] = items.items[k].extent;
  return extents;
}

/// The truth in order of its surfaces, also of those that need not be found; surfaces get its index as label.
void labelSurfaces(const View& view, const Frame& frame, const synthetic::Rendering& exact, LabelledCloud& result) {
  std::vector<int> surface_of_item;
  const Detections items = itemsIn(view, {frame.depth, frame.surface}, surface_of_item);
  std::vector<int> label(view.world.surfaces().size(), kClutter);
  std::vector<std::uint32_t> pixels;  // of each true shape
  const std::vector<std::optional<Extent>> seen = seenExtents(view, exact);
  for (std::size_t k = 0; k < items.items.size(); ++k) {
    const Detection& item = items.items[k];
    std::size_t t = indexOfSamePlane(item, result.truth);
    if (t == result.truth.size()) {
      result.truth.push_back({item.shape, item.concave});
      result.truth.back().seen = seen[surface_of_item[k]];
      pixels.push_back(0);
    } else {
      result.truth[t].seen.reset();
      if (!isSame(item, result.truth[t].shape)) result.truth[t].exact = false;
    }
    pixels[t] += item.inlier_count;
    result.truth[t].must = pixels[t] >= leastPixels(result.recipe) && !item.concave;
    label[surface_of_item[k]] = static_cast<int>(t);
  }
  result.surface.assign(frame.surface.size(), kNoShape);
  for (std::size_t i = 0; i < frame.surface.size(); ++i) {
    if (result.cloud.valid(i) && frame.surface[i] != kNoSurface) result.surface[i] = label[frame.surface[i]];
  }
  labelFaces(frame, result);
}

/// Of each true shape the share of its pixels whose neighbours two steps around are its own, too.
std::vector<double> insideShares(const LabelledCloud& frame, int width, int height) {
  constexpr int kSteps = 2;
  std::vector<double> inside(frame.truth.size(), 0.0), all(frame.truth.size(), 0.0);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int own = frame.surface[static_cast<std::size_t>(row) * width + column];
      if (own < 0) continue;
      bool surrounded = true;
      for (int down = -kSteps; down <= kSteps; ++down) {
        const int across = kSteps - std::abs(down);
        for (int right = -across; right <= across; ++right) {
          const int r = row + down, c = column + right;
          const bool within = 0 <= r && r < height && 0 <= c && c < width;
          surrounded = surrounded && within && frame.surface[static_cast<std::size_t>(r) * width + c] == own;
        }
      }
      all[own] += 1.0;
      inside[own] += surrounded ? 1.0 : 0.0;
    }
  }
  for (std::size_t t = 0; t < inside.size(); ++t) inside[t] /= std::max(all[t], 1.0);
  return inside;
}

/// The rim of a box three pixels wide is no region, however long it is.
void excuseRims(const PinholeCamera& camera, LabelledCloud& frame) {
  constexpr double kLeastInside = 0.25;  // rims have less than 0.1, all else more than 0.5
  const std::vector<double> inside = insideShares(frame, camera.width, camera.height);
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] < kLeastInside) frame.truth[t].must = false;
  }
}

/// The surfaces themselves, where the cloud has a measured point.
synthetic::Rendering exactRendering(const View& view, const Cloud& cloud) {
  synthetic::Rendering exact;
  render(view.world, view.camera, view.world_from_camera, exact);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) exact.depth[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return exact;
}

/// Exact points and normals; of surfaces that are none of the four kinds the normals are measured.
Cloud scoredPoints(const View& view, const Frame& frame, const synthetic::Rendering& exact, const Cloud& cloud) {
  std::vector<Shape> shapes;
  for (const synthetic::Surface& surface : view.world.surfaces()) {
    shapes.push_back(transformed(view.world_from_camera.inverse(), surface.shape));
  }
  Cloud scored;
  cloudFromDepth(exact.depth, view.camera, DepthRange(), scored);
  clearNormals(scored);
  std::vector<std::uint32_t> without_shape;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i) || frame.surface[i] == kNoSurface) continue;
    if (!view.world.surfaces()[frame.surface[i]].primitive) {
      without_shape.push_back(i);
      continue;
    }
    const Vec3 point = scored.point(i);
    const Eigen::Vector3f normal = normalAt(shapes[frame.surface[i]], point).cast<float>();
    scored.setNormal(i, normal.x(), normal.y(), normal.z());
  }
  measureNormals(without_shape, scored);
  return scored;
}

View viewOf(const Recipe& recipe) {
  const PinholeCamera camera = PinholeCamera().scaledTo(recipe.width, recipe.width * 3 / 4);
  if (recipe.set == "hall") return {synthetic::hall(recipe.seed), camera, synthetic::hallPose(recipe.seed)};
  const Eigen::Isometry3d pose = synthetic::clutterPose(recipe.seed);
  if (recipe.set == "heap") return {synthetic::heap(recipe.seed), camera, pose};
  if (recipe.set == "household") return {synthetic::householdTable(recipe.seed), camera, pose};
  if (recipe.set == "clutter") return {synthetic::shapelessTable(recipe.seed), camera, pose};
  return {synthetic::clutteredTable(recipe.seed), camera, pose};
}

}  // namespace

LabelledCloud depthFrame(const Recipe& recipe) {
  constexpr double kMillimeter = 0.001;
  const View view = viewOf(recipe);
  synthetic::FrameParams params;
  params.noise = synthetic::noiseOf(recipe.sensor);
  params.noise.scale = recipe.noise_scale;
  params.noise.blots = recipe.blots;
  if (recipe.noise_grain > 1) params.noise.grain = recipe.noise_grain;
  const Frame frame = renderFrame(view.world, view.camera, view.world_from_camera, params, recipe.seed, 0);
  LabelledCloud result;
  result.recipe = recipe;
  result.from_sensor = true;
  result.unit = kMillimeter;
  result.rules.max_distance = 20.0 * kMillimeter;
  cloudFromDepth(frame.depth, view.camera, params.truth.range, result.cloud);
  const synthetic::Rendering exact = exactRendering(view, result.cloud);
  labelSurfaces(view, frame, exact, result);
  excuseRims(view.camera, result);
  result.scored = scoredPoints(view, frame, exact, result.cloud);
  return result;
}

void excuseThinned(LabelledCloud& frame) {
  std::vector<std::uint32_t> left(frame.truth.size(), 0);
  for (std::size_t i = 0; i < frame.surface.size(); ++i) {
    if (frame.surface[i] >= 0 && frame.cloud.valid(i)) ++left[frame.surface[i]];
  }
  for (std::size_t t = 0; t < left.size(); ++t) {
    if (left[t] < leastPixels(frame.recipe)) frame.truth[t].must = false;
  }
}

}  // namespace primitect::eval
