// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes of organized clouds by connected components; see pcl_planes.h.
#include "eval/peers/pcl_planes.h"

#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <optional>

#include "eval/peers/answers.h"
#include "eval/peers/pcl_clouds.h"
#include "eval/peers/peer_cloud.h"
#include "eval/peers/sides.h"
#include "io/quiet_pcl.h"

namespace primitect::eval {
namespace {

using Segmentation = pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label>;
using Regions =
    std::vector<pcl::PlanarRegion<pcl::PointXYZ>, Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>;

constexpr double kAngleStep = 3.0 * M_PI / 180.0;
constexpr double kDistanceStep = 0.02;                  // m
constexpr double kFewestPixels = 1000.0 / (640 * 480);  // share of the image

struct Image {
  PclPoints::Ptr points{new PclPoints};
  PclNormals::Ptr normals{new PclNormals};
};

Image imageOf(const Cloud& cloud) {
  Image image;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    image.points->push_back(pclPoint(cloud, i));
    image.normals->push_back(pclNormal(cloud, i));
  }
  image.points->width = image.normals->width = cloud.width;
  image.points->height = image.normals->height = cloud.height;
  image.points->is_dense = image.normals->is_dense = false;
  return image;
}

/// Nothing for a region that spans no plane, a single row of pixels: PCL gives it a normal of NaN.
std::optional<Plane> planeOf(const pcl::PlanarRegion<pcl::PointXYZ>& region) {
  const Vec3 centroid = region.getCentroid().cast<double>();
  const Vec3 normal = region.getCoefficients().head<3>().cast<double>().normalized();
  if (!normal.allFinite()) return std::nullopt;
  return turnedTo({centroid, normal}, -centroid);
}

std::vector<Shape> findPlanes(const Image& image) {
  Segmentation segmentation;
  segmentation.setAngularThreshold(kAngleStep);
  segmentation.setDistanceThreshold(kDistanceStep);
  segmentation.setMinInliers(static_cast<unsigned>(kFewestPixels * static_cast<double>(image.points->size())));
  segmentation.setInputCloud(image.points);
  segmentation.setInputNormals(image.normals);
  Regions regions;
  segmentation.segmentAndRefine(regions);
  std::vector<Shape> planes;
  for (const auto& region : regions) {
    if (const std::optional<Plane> plane = planeOf(region)) planes.push_back(*plane);
  }
  return planes;
}

Answer runPclPlanes(const LabelledCloud& input, int repeat) {
  if (!input.cloud.organized()) return failureOf("needs an organized cloud");
  const Image image = imageOf(peerCloud(input));
  const io::QuietPcl quiet;
  return timedAnswer(repeat, [&image] { return findPlanes(image); });
}

}  // namespace

Method makePclPlanes() { return {"pcl-planes", runPclPlanes}; }

}  // namespace primitect::eval
