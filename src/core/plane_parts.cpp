// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Parts by touch and by height; see plane_parts.h.
#include "core/plane_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "core/fitting.h"

namespace primitect {
namespace {

struct Height {
  double height;  ///< m, along the mean normal
  std::uint32_t sample;
};

Vec3 meanNormal(const Samples& samples, const List<std::uint32_t>& indices) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t i : indices) sum += samples.normal(i);
  return sum.normalized();
}

/// How many of the lowest make the two classes whose means differ most against their sizes (Otsu 1979).
std::size_t bestCut(const List<Height>& heights, std::size_t least) {
  double total = 0.0;
  for (const Height& h : heights) total += h.height;
  const double count = static_cast<double>(heights.size());
  double below = 0.0, most = -1.0;
  std::size_t best = least;
  for (std::size_t k = 1; k + least <= heights.size(); ++k) {
    below += heights[k - 1].height;
    if (k < least) continue;
    const double low = static_cast<double>(k), high = count - low;
    const double difference = below / low - (total - below) / high;
    const double between = low * high * difference * difference;
    if (!(between > most)) continue;
    most = between;
    best = k;
  }
  return best;
}

/// Samples, and how badly the best plane fits them: the sum of what they are off in distance and normal, in standard
/// deviations, squared.
struct Group {
  List<std::uint32_t> samples;
  double misfit;
};

/// Of one sample. A plane that leads from one top to another hardly shows in the distances: it lies askew to both.
double misfitAt(const Plane& plane, const Samples& samples, std::uint32_t i) {
  constexpr double kMost = 9.0;  // at edges normals are worse than elsewhere
  const double away = distance(plane, samples.point(i)) / samples.sigma[i];
  if (!(samples.normal_sigma[i] > 0.0f)) return away * away;
  const double turn_sq = (plane.normal.cross(samples.normal(i)) / samples.normal_sigma[i]).squaredNorm();
  return away * away + std::min(turn_sq, kMost);
}

double misfitOf(const Plane& plane, const Samples& samples, const List<std::uint32_t>& part) {
  double sum = 0.0;
  for (const std::uint32_t i : part) sum += misfitAt(plane, samples, i);
  return sum;
}

/// Of the better of two planes: its points tell little about how a small part lies, its normals hardly about where.
double misfitOf(const Samples& samples, const List<std::uint32_t>& part) {
  FitPoints points;
  points.gather({samples, part});
  const Moments moments = momentsOf(points);
  const std::optional<Shape> start = fitFromMoments(Kind::plane, moments);
  if (!start) return 0.0;
  const Plane by_points = std::get<Plane>(refine(*start, points).value_or(*start));
  const Plane by_normals = {moments.mean_point, moments.mean_normal.normalized()};
  return std::min(misfitOf(by_points, samples, part), misfitOf(by_normals, samples, part));
}

Group together(const Samples& samples, const Group& a, const Group& b) {
  Group both;
  std::merge(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(), std::back_inserter(both.samples));
  both.misfit = misfitOf(samples, both.samples);
  return both;
}

/// What the waves of a depth camera add to the squares of a sample: shares of the variances of distance and normal.
double wavesAt(const Samples& samples, std::uint32_t i) {
  constexpr double kOfDistance = 0.15, kOfNormal = 0.45;
  return kOfDistance + (samples.normal_sigma[i] > 0.0f ? kOfNormal : 0.0);
}

/// What chance alone hardly reaches.
constexpr double kSure = 15.0;

/// How much worse one plane fits both than one for each does, as a share of what noise and the waves of a depth
/// camera explain; below 1: it is the same plane.
double disagreement(const Samples& samples, const Group& a, const Group& b, const Group& both) {
  double waves = 0.0;
  for (const std::uint32_t i : both.samples) waves += wavesAt(samples, i);
  return (both.misfit - a.misfit - b.misfit) / std::max(kSure, waves);
}

/// A group as a level top: through its mean point, with this normal.
struct LevelTop {
  Vec3 mean = Vec3::Zero();
  double sigma = 0.0;   ///< m, mean of the samples
  double misfit = 0.0;  ///< as of a group

  LevelTop(const Samples& samples, const Group& group, const Vec3& level) {
    const double share = 1.0 / static_cast<double>(group.samples.size());
    for (const std::uint32_t i : group.samples) mean += share * samples.point(i), sigma += share * samples.sigma[i];
    for (const std::uint32_t i : group.samples) misfit += misfitAt({mean, level}, samples, i);
  }
};

/// What two groups are if they are tops that lie level.
enum class Tops { not_level, one_height, two_heights };

Tops topsOf(const Samples& samples, const Group& a, const Group& b, const Group& both, const Vec3& level) {
  constexpr double kAsWell = 0.1;      // more misfit for each sample; whole level planes differed by 0.02 at most
  constexpr double kDeviations = 1.5;  // of the noise of a point
  constexpr double kLevelOff = 0.002;  // rad, what the level may be off
  const LevelTop first(samples, a, level), second(samples, b, level);
  const double misfit = first.misfit + second.misfit;
  const double margin = std::max(kSure, kAsWell * static_cast<double>(both.samples.size()));
  if (misfit > a.misfit + b.misfit + margin) return Tops::not_level;
  const Vec3 way = second.mean - first.mean;
  const double least = kDeviations * 0.5 * (first.sigma + second.sigma) + kLevelOff * way.norm();
  if (std::abs(level.dot(way)) < least) return Tops::one_height;
  return misfit + margin < both.misfit ? Tops::two_heights : Tops::not_level;
}

/// Two groups as one, and how little that one plane fits both.
struct Pair {
  Group joined;
  double apart;
};

Pair pairOf(const Samples& samples, const Group& a, const Group& b, const std::optional<Vec3>& level) {
  Pair pair;
  pair.joined = together(samples, a, b);
  pair.apart = disagreement(samples, a, b, pair.joined);
  const Tops tops = level ? topsOf(samples, a, b, pair.joined, *level) : Tops::not_level;
  if (tops == Tops::one_height) pair.apart = std::min(pair.apart, 0.0);
  if (tops == Tops::two_heights) pair.apart = std::max(pair.apart, 1.0);
  return pair;
}

/// Groups that become fewer while one plane fits two of them.
class Grouping {
 public:
  Grouping(const Samples& samples, const SampleParts& parts, const std::optional<Vec3>& level)
      : samples_(samples), level_(level) {
    for (const List<std::uint32_t>& part : parts) add({part, misfitOf(samples, part)});
  }

  /// Joins the two that are most at one; false when no two are.
  bool join() {
    double least = 1.0;
    std::size_t first = 0, second = 0;
    for (std::size_t b = 1; b < groups_.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (!(pairs_[b][a].apart < least)) continue;
        least = pairs_[b][a].apart;
        first = a;
        second = b;
      }
    }
    if (first == second) return false;
    Group joined = std::move(pairs_[second][first].joined);
    leave(second);
    leave(first);
    add(std::move(joined));
    return true;
  }

  /// In the order of their first samples.
  SampleParts groups() const {
    SampleParts result;
    for (const Group& group : groups_) result.push_back(group.samples);
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  void add(Group group) {
    List<Pair> with_others;
    for (const Group& other : groups_) with_others.push_back(pairOf(samples_, other, group, level_));
    pairs_.push_back(std::move(with_others));
    groups_.push_back(std::move(group));
  }

  void leave(std::size_t k) {
    const auto at = static_cast<std::ptrdiff_t>(k);
    groups_.erase(groups_.begin() + at);
    pairs_.erase(pairs_.begin() + at);
    for (std::size_t b = k; b < pairs_.size(); ++b) pairs_[b].erase(pairs_[b].begin() + at);
  }

  const Samples& samples_;
  std::optional<Vec3> level_;
  List<Group> groups_;
  List<List<Pair>> pairs_;  ///< of each group with those before it
};

}  // namespace

SampleParts coplanarGroups(const Samples& samples, const SampleParts& parts, const std::optional<Vec3>& level) {
  Grouping grouping(samples, parts, level);
  while (grouping.join()) continue;
  return grouping.groups();
}

SampleParts separateParts(const List<std::uint32_t>& inliers, std::size_t least, SampleGraph& graph) {
  SampleParts parts = graph.parts(inliers, least);
  const bool all_touch = parts.size() == 1 && parts.front().size() == inliers.size();
  return all_touch ? SampleParts() : parts;
}

SampleParts stepParts(const Samples& samples, const Plane& plane, const List<std::uint32_t>& inliers,
                      std::size_t least) {
  constexpr double kLeastTilt = 0.02;  // rad: ten times what the noise of fifty normals leaves
  if (inliers.size() < 2 * least) return {};
  const Vec3 up = meanNormal(samples, inliers);
  if (!(up.cross(plane.normal).norm() > kLeastTilt)) return {};
  List<Height> heights;
  for (const std::uint32_t i : inliers) heights.push_back({up.dot(samples.point(i)), i});
  std::sort(heights.begin(), heights.end(), [](const Height& a, const Height& b) {
    return a.height != b.height ? a.height < b.height : a.sample < b.sample;
  });
  const std::size_t cut = bestCut(heights, least);
  SampleParts parts(2);
  for (std::size_t k = 0; k < heights.size(); ++k) parts[k < cut ? 0 : 1].push_back(heights[k].sample);
  for (List<std::uint32_t>& part : parts) std::sort(part.begin(), part.end());
  return parts;
}

}  // namespace primitect
