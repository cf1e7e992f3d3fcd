// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The kd-tree behind NeighborSearch.
#include "core/neighbors.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace primitect {

struct NeighborSearch::Tree {
  pcl::KdTreeFLANN<pcl::PointXYZ> search{false};
  List<std::uint32_t> cloud_index;
  pcl::Indices found;
  std::vector<float> distances_sq;
};

NeighborSearch::NeighborSearch(const Cloud& cloud) : tree_(std::make_unique<Tree>()) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  points->reserve(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i)) continue;
    points->emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
    tree_->cloud_index.push_back(static_cast<std::uint32_t>(i));
  }
  if (!points->empty()) tree_->search.setInputCloud(points);
}

NeighborSearch::~NeighborSearch() = default;

void NeighborSearch::nearest(const Cloud& cloud, std::uint32_t point, int count, List<std::uint32_t>& neighbors) {
  neighbors.clear();
  if (tree_->cloud_index.empty()) return;
  const pcl::PointXYZ query(cloud.x[point], cloud.y[point], cloud.z[point]);
  tree_->search.nearestKSearch(query, count, tree_->found, tree_->distances_sq);
  for (const auto k : tree_->found) neighbors.push_back(tree_->cloud_index[k]);
}

}  // namespace primitect
