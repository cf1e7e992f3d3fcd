// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Plane, sphere, cylinder, cone by RANSAC, one after the other; see pcl_sac.h.
#include "eval/peers/pcl_sac.h"

#include <pcl/common/centroid.h>
#include <pcl/common/common.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <array>
#include <optional>

#include "eval/peers/answers.h"
#include "eval/peers/pcl_clouds.h"
#include "eval/peers/peer_cloud.h"
#include "eval/peers/points.h"
#include "eval/peers/sides.h"
#include "io/quiet_pcl.h"

namespace primitect::eval {
namespace {

constexpr std::size_t kPoints = 4096;
constexpr int kIterations = 1000;
constexpr int kMostRounds = 40;
constexpr double kSmallestShare = 0.01;       // of the points at the start
constexpr double kThresholdShare = 0.01;      // of the bounding box' diagonal
constexpr double kLargestRadiusShare = 0.25;  // of the bounding box' diagonal
constexpr double kNormalWeight = 0.1;
constexpr double kSmallestHalfAngle = 5.0 * M_PI / 180.0;
constexpr double kLargestHalfAngle = 60.0 * M_PI / 180.0;
constexpr double kGeneralKindGain = 1.05;  // more inliers than a simpler kind

// From the simplest to the most general.
constexpr std::array<pcl::SacModel, 4> kModels = {pcl::SACMODEL_NORMAL_PLANE, pcl::SACMODEL_NORMAL_SPHERE,
                                                  pcl::SACMODEL_CYLINDER, pcl::SACMODEL_CONE};

/// The points that no shape has taken yet.
struct Scene {
  PclPoints::Ptr points{new PclPoints};
  PclNormals::Ptr normals{new PclNormals};
};

struct Fit {
  pcl::SacModel model = pcl::SACMODEL_NORMAL_PLANE;
  std::vector<float> coefficients;
  pcl::PointIndices::Ptr inliers{new pcl::PointIndices};
};

Scene sceneOf(const LabelledCloud& input) {
  const Cloud& cloud = peerCloud(input);
  Scene scene;
  for (const std::uint32_t i : drawPoints(usablePoints(cloud), kPoints, input.recipe.seed)) {
    scene.points->push_back(pclPoint(cloud, i));
    scene.normals->push_back(pclNormal(cloud, i));
  }
  return scene;
}

double diagonalOf(const PclPoints& points) {
  pcl::PointXYZ low, high;
  pcl::getMinMax3D(points, low, high);
  return (high.getVector3fMap() - low.getVector3fMap()).norm();
}

/// Seeded with a constant by PCL unless told otherwise.
Fit fitModel(pcl::SacModel model, const Scene& scene, double diagonal) {
  pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> segmentation;
  segmentation.setModelType(model);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setOptimizeCoefficients(true);
  segmentation.setNormalDistanceWeight(kNormalWeight);
  segmentation.setMaxIterations(kIterations);
  segmentation.setDistanceThreshold(kThresholdShare * diagonal);
  segmentation.setRadiusLimits(0.0, kLargestRadiusShare * diagonal);
  segmentation.setMinMaxOpeningAngle(kSmallestHalfAngle, kLargestHalfAngle);
  segmentation.setInputCloud(scene.points);
  segmentation.setInputNormals(scene.normals);
  Fit fit;
  fit.model = model;
  pcl::ModelCoefficients coefficients;
  segmentation.segment(*fit.inliers, coefficients);
  fit.coefficients = coefficients.values;
  return fit;
}

Fit bestFit(const Scene& scene, double diagonal) {
  Fit best;
  for (const pcl::SacModel model : kModels) {
    Fit fit = fitModel(model, scene, diagonal);
    if (fit.inliers->indices.size() > kGeneralKindGain * best.inliers->indices.size()) best = std::move(fit);
  }
  return best;
}

Vec3 meanNormal(const PclNormals& normals, const pcl::PointIndices& inliers) {
  Vec3 sum = Vec3::Zero();
  for (const int i : inliers.indices) sum += normals[i].getNormalVector3fMap().cast<double>();
  return sum.normalized();
}

Vec3 meanPoint(const PclPoints& points, const pcl::PointIndices& inliers) {
  Eigen::Vector4d mean;
  pcl::compute3DCentroid(points, inliers, mean);
  return mean.head<3>();
}

Shape shapeOf(const Fit& fit, const Scene& scene) {
  const std::vector<float>& c = fit.coefficients;
  const Vec3 first(c.at(0), c.at(1), c.at(2));
  if (fit.model == pcl::SACMODEL_NORMAL_PLANE) {
    // a x + b y + c z + d = 0, not scaled.
    const Plane plane{-c.at(3) * first / first.squaredNorm(), first.normalized()};
    return turnedTo(plane, meanNormal(*scene.normals, *fit.inliers));
  }
  if (fit.model == pcl::SACMODEL_NORMAL_SPHERE) return Sphere{first, c.at(3)};
  const Vec3 axis = Vec3(c.at(3), c.at(4), c.at(5)).normalized();
  if (fit.model == pcl::SACMODEL_CYLINDER) return Cylinder{first, axis, c.at(6)};
  // What PCL calls the opening angle is the one between axis and surface.
  return openedTo(Cone{first, axis, c.at(6)}, meanPoint(*scene.points, *fit.inliers));
}

template <class Points>
typename Points::Ptr without(const typename Points::Ptr& points, const pcl::PointIndices::Ptr& taken) {
  pcl::ExtractIndices<typename Points::PointType> extract;
  extract.setInputCloud(points);
  extract.setIndices(taken);
  extract.setNegative(true);
  typename Points::Ptr rest(new Points);
  extract.filter(*rest);
  return rest;
}

std::vector<Shape> findShapes(Scene scene) {
  const double diagonal = diagonalOf(*scene.points);
  const double fewest = std::max(3.0, kSmallestShare * static_cast<double>(scene.points->size()));
  std::vector<Shape> shapes;
  for (int round = 0; round < kMostRounds && scene.points->size() >= fewest; ++round) {
    const Fit fit = bestFit(scene, diagonal);
    if (fit.inliers->indices.size() < fewest) break;
    shapes.push_back(shapeOf(fit, scene));
    scene = {without<PclPoints>(scene.points, fit.inliers), without<PclNormals>(scene.normals, fit.inliers)};
  }
  return shapes;
}

Answer runPclSac(const LabelledCloud& input, int repeat) {
  const Scene scene = sceneOf(input);
  if (scene.points->empty()) return failureOf("no point has a normal");
  const io::QuietPcl quiet;
  return timedAnswer(repeat, [&scene] { return findShapes(scene); });
}

}  // namespace

Method makePclSac() { return {"pcl-sac", runPclSac}; }

}  // namespace primitect::eval
