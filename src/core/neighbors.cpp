// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The kd-tree behind NeighborSearch, and which points it holds.
#include "core/neighbors.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstring>
#include <vector>

namespace primitect {
namespace {

/// Tells the first point of each place from those that lie exactly where it does. Open addressing; the table is at
/// most half full.
class Places {
 public:
  explicit Places(std::size_t most_points) {
    std::size_t slots = 16;
    while (slots < 2 * most_points) slots *= 2;
    first_in_slot_.assign(slots, kEmpty);
  }

  bool isNew(const Cloud& cloud, std::size_t i) {
    const std::size_t mask = first_in_slot_.size() - 1;
    std::size_t slot = hash(cloud, i) & mask;
    for (; first_in_slot_[slot] != kEmpty; slot = (slot + 1) & mask) {
      const std::uint32_t k = first_in_slot_[slot];
      if (cloud.x[k] == cloud.x[i] && cloud.y[k] == cloud.y[i] && cloud.z[k] == cloud.z[i]) return false;
    }
    first_in_slot_[slot] = static_cast<std::uint32_t>(i);
    return true;
  }

 private:
  static constexpr std::uint32_t kEmpty = ~std::uint32_t{0};

  /// Bits of neighbours in a grid differ in few places: multiplied by large odd numbers they spread over the upper half
  /// (Knuth, The Art of Computer Programming 3, 6.4).
  static std::size_t hash(const Cloud& cloud, std::size_t i) {
    std::uint64_t mixed = 0;
    for (const float value : {cloud.x[i] + 0.0f, cloud.y[i] + 0.0f, cloud.z[i] + 0.0f}) {  // -0 + 0 = 0
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      mixed = (mixed ^ bits) * 0x9E3779B97F4A7C15u;
      mixed ^= mixed >> 32;
    }
    return static_cast<std::size_t>(mixed);
  }

  List<std::uint32_t> first_in_slot_;
};

}  // namespace

struct NeighborSearch::Tree {
  pcl::KdTreeFLANN<pcl::PointXYZ> search{false};
  List<std::uint32_t> cloud_index;
  pcl::Indices found;
  std::vector<float> distances_sq;
};

NeighborSearch::NeighborSearch(const Cloud& cloud) : tree_(std::make_unique<Tree>()) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  points->reserve(cloud.valid_count);
  Places places(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.valid(i) || !places.isNew(cloud, i)) continue;
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
