// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The data sets by name and the variants that they share; see data_sets.h.
#include "eval/data_sets.h"

#include <stdexcept>

#include "eval/cut_out.h"
#include "eval/depth_frames.h"
#include "eval/variants.h"
#include "primitect/transforms.h"
#include "synthetic/mechanical_part.h"
#include "synthetic/paper_dataset.h"
#include "synthetic/small_scene.h"
#include "synthetic/world.h"

namespace primitect::eval {
namespace {

using synthetic::kSceneKindCount;
using synthetic::SceneKind;

const std::string kPaper = "paper-", kConcave = "concave-";

Vec3 mirrored(const Vec3& v) { return {v.x(), v.y(), -v.z()}; }

Shape mirrored(const Plane& s) { return Plane{mirrored(s.point), -mirrored(s.normal)}; }
Shape mirrored(const Sphere& s) { return Sphere{mirrored(s.center), s.radius}; }
Shape mirrored(const Cylinder& s) { return Cylinder{mirrored(s.point), mirrored(s.axis), s.radius}; }
Shape mirrored(const Cone& s) { return Cone{mirrored(s.apex), mirrored(s.axis), s.half_angle}; }

/// Every hill becomes a hollow: z -> -z, and the normals look up again, out of the material.
void turnInsideOut(LabelledCloud& result) {
  for (std::size_t i = 0; i < result.cloud.size(); ++i) {
    result.cloud.z[i] = -result.cloud.z[i];
    result.cloud.nx[i] = -result.cloud.nx[i];
    result.cloud.ny[i] = -result.cloud.ny[i];
  }
  for (TrueShape& truth : result.truth) {
    truth.shape = std::visit([](const auto& shape) { return mirrored(shape); }, truth.shape);
    truth.concave = kindOf(truth.shape) != Kind::plane;
  }
}

LabelledCloud labelled(synthetic::PaperScene scene, const Recipe& recipe) {
  LabelledCloud result;
  for (const Shape& shape : scene.truth) result.truth.push_back({shape});
  result.cloud = std::move(scene.cloud);
  result.surface = std::move(scene.surface);
  if (recipe.sigma > 0.0) result.unit = recipe.sigma;
  return result;
}

LabelledCloud paperScene(const Recipe& recipe, SceneKind kind) {
  return labelled(makePaperScene(kind, recipe.seed, recipe.sigma, recipe.outliers), recipe);
}

/// What hides much of an object leaves too little of it.
LabelledCloud smallScene(const Recipe& recipe) {
  const synthetic::PaperScene scene = synthetic::makeSmallScene(recipe.seed, recipe.sigma, recipe.outliers);
  LabelledCloud result = labelled(scene, recipe);
  for (std::size_t t = 0; t < result.truth.size(); ++t) {
    result.truth[t].must = scene.owned[t] >= synthetic::kSmallestShare * static_cast<double>(scene.surface.size());
  }
  return result;
}

/// Points and normals of the true shapes: the noise is wider than some walls, and on a chamfer a few points wide the
/// normals of a neighbourhood are all wrong.
void takeNoiseAway(Cloud& scored, const std::vector<TrueShape>& truth, const std::vector<int>& surface) {
  for (std::size_t i = 0; i < scored.size(); ++i) {
    if (surface[i] < 0) continue;
    const Shape& shape = truth[surface[i]].shape;
    const Vec3 point = project(shape, scored.point(i));
    const Eigen::Vector3f p = point.cast<float>(), normal = normalAt(shape, point).cast<float>();
    scored.x[i] = p.x(), scored.y[i] = p.y(), scored.z[i] = p.z();
    scored.setNormal(i, normal.x(), normal.y(), normal.z());
  }
}

LabelledCloud mechanicalPart(const Recipe& recipe) {
  synthetic::MechanicalPart part = synthetic::makeMechanicalPart(recipe.seed, recipe.sigma);
  LabelledCloud result;
  for (std::size_t t = 0; t < part.truth.size(); ++t) result.truth.push_back({part.truth[t], part.concave[t]});
  result.cloud = std::move(part.cloud);
  result.surface = std::move(part.surface);
  result.scored = result.cloud;
  takeNoiseAway(result.scored, result.truth, result.surface);
  if (recipe.sigma > 0.0) result.unit = recipe.sigma;
  return result;
}

void moveToRobotFrame(LabelledCloud& result) {
  const Eigen::Isometry3d robot_from_sensor = robotFromSensor();
  result.cloud.move(robot_from_sensor, DepthRange());
  result.scored.move(robot_from_sensor, DepthRange());
  for (TrueShape& truth : result.truth) {
    Detections one;
    one.items.resize(1);
    one.items[0].shape = truth.shape;
    if (truth.seen) one.items[0].extent = *truth.seen;
    transformDetections(robot_from_sensor, one);
    truth.shape = one.items[0].shape;
    if (truth.seen) truth.seen = one.items[0].extent;
  }
}

LabelledCloud withoutVariants(const Recipe& recipe) {
  if (recipe.set == "small") return smallScene(recipe);
  if (isDepthFrame(recipe.set)) return depthFrame(recipe);
  if (recipe.set == "objects") {
    LabelledCloud result = depthFrame(recipe);
    cutOut(recipe.seed, result);
    excuseThinned(result);
    return result;
  }
  if (recipe.set == "parts") return mechanicalPart(recipe);
  for (std::size_t k = 0; k < kSceneKindCount; ++k) {
    const SceneKind kind = static_cast<SceneKind>(k);
    if (recipe.set == kPaper + synthetic::sceneKindName(kind)) return paperScene(recipe, kind);
    if (recipe.set != kConcave + synthetic::sceneKindName(kind)) continue;
    LabelledCloud result = paperScene(recipe, kind);
    turnInsideOut(result);
    return result;
  }
  std::string known;
  for (const std::string& name : dataSetNames()) known += " " + name;
  throw std::invalid_argument("data set '" + recipe.set + "': must be one of" + known);
}

}  // namespace

std::vector<std::string> dataSetNames() {
  std::vector<std::string> names;
  for (const std::string& family : {kPaper, kConcave}) {
    for (std::size_t k = 0; k < kSceneKindCount; ++k) {
      const SceneKind kind = static_cast<SceneKind>(k);
      // Planes have no inside.
      if (family == kPaper || kind != SceneKind::planes) names.push_back(family + synthetic::sceneKindName(kind));
    }
  }
  names.push_back("small");
  names.push_back("tabletop");
  names.push_back("clutter");
  names.push_back("household");
  names.push_back("heap");
  names.push_back("hall");
  names.push_back("objects");
  names.push_back("parts");
  return names;
}

LabelledCloud makeLabelledCloud(const Recipe& recipe) {
  checkRecipe(recipe);
  LabelledCloud result = withoutVariants(recipe);
  result.recipe = recipe;
  // Depth frames and parts bring their own.
  if (result.scored.size() == 0) result.scored = result.cloud;
  if (recipe.keep < 1.0 || recipe.uneven > 1.0) {
    thinOut(result.cloud, recipe.keep, recipe.uneven, recipe.seed);
    if (result.from_sensor) excuseThinned(result);
  }
  if (recipe.voxel > 0.0) averageInVoxels(result.cloud, recipe.voxel);
  if (recipe.listed) listPoints(result.cloud);
  if (recipe.shuffle) shufflePoints(result.cloud, recipe.seed);
  if (recipe.robot_frame) moveToRobotFrame(result);
  return result;
}

}  // namespace primitect::eval
