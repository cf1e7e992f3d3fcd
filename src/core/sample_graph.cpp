// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Nearest neighbours by PCL's kd-tree, and a walk over them; see sample_graph.h.
#include "core/sample_graph.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace primitect {

void SampleGraph::build(const Samples& samples) {
  neighbors_.resize(samples.size());
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  for (std::size_t i = 0; i < samples.size(); ++i) points->emplace_back(samples.x[i], samples.y[i], samples.z[i]);
  if (points->empty()) return;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  pcl::Indices found;
  std::vector<float> distances_sq;
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    neighbors_[i].fill(i);
    tree.nearestKSearch((*points)[i], kNeighbors + 1, found, distances_sq);
    int filled = 0;
    for (const auto j : found) {
      if (static_cast<std::uint32_t>(j) != i && filled < kNeighbors) neighbors_[i][filled++] = j;
    }
  }
}

void SampleGraph::connected(const std::vector<std::uint32_t>& set, std::uint32_t start,
                            std::vector<std::uint32_t>& part) {
  constexpr std::uint8_t kOutside = 0, kWaiting = 1, kReached = 2;
  state_.assign(neighbors_.size(), kOutside);
  for (const std::uint32_t i : set) state_[i] = kWaiting;
  part.assign(1, start);
  const bool start_in_set = state_[start] == kWaiting;
  state_[start] = kReached;
  for (std::size_t k = 0; k < part.size(); ++k) {
    for (const std::uint32_t j : neighbors_[part[k]]) {
      if (state_[j] != kWaiting) continue;
      state_[j] = kReached;
      part.push_back(j);
    }
  }
  if (!start_in_set) part.erase(part.begin());
  std::sort(part.begin(), part.end());
}

}  // namespace primitect
