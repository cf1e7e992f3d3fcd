// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Counting smooth ways from plane to plane; see facets.h.
#include "core/facets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/evidence.h"

namespace primitect {
namespace {

/// Numbers of smooth ways from one plane to another, from the lower number to the higher one.
class Ways {
 public:
  explicit Ways(std::uint32_t planes) : planes_(planes), count_(std::size_t{planes} * planes, 0) {}

  void add(std::uint32_t a, std::uint32_t b) { ++count_[std::size_t{std::min(a, b)} * planes_ + std::max(a, b)]; }
  std::uint32_t between(std::uint32_t a, std::uint32_t b) const { return count_[std::size_t{a} * planes_ + b]; }

 private:
  std::uint32_t planes_;
  List<std::uint32_t> count_;
};

/// What is nobody's between two facets, beyond the noise of both, goes to one that runs on there.
List<std::uint32_t> widened(const Samples& samples, const SampleGraph& graph, List<std::uint32_t> owner,
                            std::uint32_t planes) {
  for (std::uint32_t i = 0; i < owner.size(); ++i) {
    if (owner[i] != kNobody) continue;
    const auto runs_on = [&](std::uint32_t j) { return owner[j] < planes && continuous(samples, i, j); };
    const auto& near = graph.of(i);
    const auto found = std::find_if(near.begin(), near.end(), runs_on);
    if (found != near.end()) owner[i] = owner[*found];
  }
  return owner;
}

/// Ways, of the samples that a straight line through the middle of the smaller one passes. Borders of facets have one
/// to twenty times as many, but for some that touch in a corner. Along an edge of a box there are hardly any: on 20
/// tables 16 groups come of it, none of which is anything but planes.
constexpr double kLeastBorder = 0.15;

/// The lowest number of a plane that each plane is joined to.
List<std::uint32_t> joined(const Samples& samples, const SampleGraph& graph, const List<std::uint32_t>& owner,
                           std::uint32_t planes) {
  constexpr std::size_t kNearest = 4;  // neighbours of each are enough: with all .2 % of a frame's instructions more
  Ways ways(planes);
  List<std::uint32_t> size(planes, 0), group(planes);
  for (std::uint32_t i = 0; i < owner.size(); ++i) {
    if (owner[i] >= planes) continue;
    ++size[owner[i]];
    const auto& near = graph.of(i);
    for (std::size_t k = 0; k < kNearest; ++k) {
      const std::uint32_t j = near[k];
      if (owner[j] != owner[i] && owner[j] < planes && continuous(samples, i, j)) ways.add(owner[i], owner[j]);
    }
  }
  std::iota(group.begin(), group.end(), 0u);
  for (std::uint32_t a = 0; a < planes; ++a) {
    for (std::uint32_t b = a + 1; b < planes; ++b) {
      const double border = std::sqrt(static_cast<double>(std::min(size[a], size[b])));
      if (border == 0.0 || !(ways.between(a, b) >= kLeastBorder * border)) continue;
      const auto [low, high] = std::minmax({group[a], group[b]});
      std::replace(group.begin(), group.end(), high, low);
    }
  }
  return group;
}

}  // namespace

SampleParts facetGroups(const Samples& samples, const SampleGraph& graph, const List<std::uint32_t>& owner,
                        std::uint32_t planes) {
  if (planes < 2) return {};
  const List<std::uint32_t> group = joined(samples, graph, widened(samples, graph, owner, planes), planes);
  SampleParts groups;
  for (std::uint32_t g = 0; g < planes; ++g) {
    if (std::count(group.begin(), group.end(), g) < 2) continue;
    List<std::uint32_t> of_group;
    for (std::uint32_t i = 0; i < owner.size(); ++i) {
      if (owner[i] < planes && group[owner[i]] == g) of_group.push_back(i);
    }
    groups.push_back(std::move(of_group));
  }
  return groups;
}

}  // namespace primitect
