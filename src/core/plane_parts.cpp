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

#include "core/fit_points.h"
#include "core/fitting.h"
#include "core/flat.h"
#include "kernels/loops.h"

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

/// Some samples, gathered for planes through them.
class PlanePoints {
 public:
  PlanePoints(const Samples& samples, const List<std::uint32_t>& part) {
    points_.gather({samples, part});
    inverse_variance_.assign(points_.view().count, 0.0f);
    for (std::size_t k = 0; k < part.size(); ++k) {
      const float sigma = samples.normal_sigma[part[k]];
      if (sigma > 0.0f) inverse_variance_[k] = 1.0f / (sigma * sigma);
    }
  }

  const Vec3& middle() const { return points_.middle(); }
  double meanSigma() const { return points_.meanSigma(); }

  /// What they are off a plane in distance and normal, in standard deviations, squared. A plane that leads from one top
  /// to another hardly shows in the distances: it lies askew to both.
  double misfit(const Plane& plane) const {
    const kernels::OffPlane off = kernels::loops().offPlane(flattened(plane, points_.origin()), points_.view(),
                                                            points_.normals(inverse_variance_));
    return kInlierDeviations * kInlierDeviations * off.distances + off.turns;
  }

  /// Of the better of two planes: their points tell little about how a small part lies, their normals hardly about
  /// where.
  double misfit() const {
    const Moments moments = momentsOf(points_);
    const std::optional<Shape> start = fitFromMoments(Kind::plane, moments);
    if (!start) return 0.0;
    const Plane by_points = std::get<Plane>(refine(*start, points_).value_or(*start));
    return std::min(misfit(by_points), misfit(Plane{moments.mean_point, moments.mean_normal.normalized()}));
  }

 private:
  FitPoints points_;
  List<float> inverse_variance_;  ///< of normals (1/rad^2); 0: not known
};

/// What the waves of a depth camera add to the squares of a sample: shares of the variances of distance and normal.
double wavesAt(const Samples& samples, std::uint32_t i) {
  constexpr double kOfDistance = 0.15, kOfNormal = 0.45;
  return kOfDistance + (samples.normal_sigma[i] > 0.0f ? kOfNormal : 0.0);
}

double wavesOf(const Samples& samples, const List<std::uint32_t>& part) {
  double sum = 0.0;
  for (const std::uint32_t i : part) sum += wavesAt(samples, i);
  return sum;
}

/// Some samples as a level top: through their mean point, with this normal.
struct LevelTop {
  Vec3 mean;
  double sigma;   ///< m, mean of the samples
  double misfit;  ///< as of a group

  LevelTop(const PlanePoints& points, const Vec3& level)
      : mean(points.middle()), sigma(points.meanSigma()), misfit(points.misfit({mean, level})) {}
};

/// Samples, and how badly the best plane fits them. What pairs ask of each is found once.
struct Group {
  List<std::uint32_t> samples;
  double misfit;
  double waves;
  std::optional<LevelTop> top;  ///< where a level is known

  Group(const Samples& all, List<std::uint32_t> some, const std::optional<Vec3>& level)
      : samples(std::move(some)), waves(wavesOf(all, samples)) {
    const PlanePoints points(all, samples);
    misfit = points.misfit();
    if (level) top.emplace(points, *level);
  }
};

/// What chance alone hardly reaches.
constexpr double kSure = 15.0;

/// How much worse one plane fits both than one for each does, as a share of what noise and the waves of a depth
/// camera explain; below 1: it is the same plane. misfit: of one plane to both.
double disagreement(const Group& a, const Group& b, double misfit) {
  return (misfit - a.misfit - b.misfit) / std::max(kSure, a.waves + b.waves);
}

/// What two groups are if they are tops that lie level.
enum class Tops { not_level, one_height, two_heights };

Tops topsOf(const Group& a, const Group& b, double misfit_of_both, const Vec3& level) {
  constexpr double kAsWell = 0.1;      // more misfit for each sample; whole level planes differed by 0.02 at most
  constexpr double kDeviations = 1.5;  // of the noise of a point
  constexpr double kLevelOff = 0.002;  // rad, what the level may be off
  const LevelTop &first = *a.top, &second = *b.top;
  const double misfit = first.misfit + second.misfit;
  const double margin = std::max(kSure, kAsWell * static_cast<double>(a.samples.size() + b.samples.size()));
  if (misfit > a.misfit + b.misfit + margin) return Tops::not_level;
  const Vec3 way = second.mean - first.mean;
  const double least = kDeviations * 0.5 * (first.sigma + second.sigma) + kLevelOff * way.norm();
  if (std::abs(level.dot(way)) < least) return Tops::one_height;
  return misfit + margin < misfit_of_both ? Tops::two_heights : Tops::not_level;
}

/// In rising order.
List<std::uint32_t> together(const Group& a, const Group& b) {
  List<std::uint32_t> both;
  both.reserve(a.samples.size() + b.samples.size());
  std::merge(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(), std::back_inserter(both));
  return both;
}

/// How little one plane fits both; below 1: it is the same plane.
double apartness(const Samples& samples, const Group& a, const Group& b, const std::optional<Vec3>& level) {
  const double misfit = PlanePoints(samples, together(a, b)).misfit(), apart = disagreement(a, b, misfit);
  const Tops tops = level ? topsOf(a, b, misfit, *level) : Tops::not_level;
  if (tops == Tops::one_height) return std::min(apart, 0.0);
  return tops == Tops::two_heights ? std::max(apart, 1.0) : apart;
}

/// Groups that become fewer while one plane fits two of them.
class Grouping {
 public:
  Grouping(const Samples& samples, const SampleParts& parts, const std::optional<Vec3>& level)
      : samples_(samples), level_(level) {
    for (const List<std::uint32_t>& part : parts) add(part);
  }

  /// Joins the two that are most at one; false when no two are.
  bool join() {
    double least = 1.0;
    std::size_t first = 0, second = 0;
    for (std::size_t b = 1; b < groups_.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (!(apart_[b][a] < least)) continue;
        least = apart_[b][a];
        first = a;
        second = b;
      }
    }
    if (first == second) return false;
    List<std::uint32_t> joined = together(groups_[first], groups_[second]);
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
  void add(List<std::uint32_t> samples) {
    Group group(samples_, std::move(samples), level_);
    List<double> from_others;
    for (const Group& other : groups_) from_others.push_back(apartness(samples_, other, group, level_));
    apart_.push_back(std::move(from_others));
    groups_.push_back(std::move(group));
  }

  void leave(std::size_t k) {
    const auto at = static_cast<std::ptrdiff_t>(k);
    groups_.erase(groups_.begin() + at);
    apart_.erase(apart_.begin() + at);
    for (std::size_t b = k; b < apart_.size(); ++b) apart_[b].erase(apart_[b].begin() + at);
  }

  const Samples& samples_;
  std::optional<Vec3> level_;
  List<Group> groups_;
  List<List<double>> apart_;  ///< of each group from those before it
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
