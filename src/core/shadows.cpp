// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// A plane, a map of where it is seen, and a search for the lamp; see shadows.h.
#include "core/shadows.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include "core/random.h"
#include "primitect/primitives.h"

namespace primitect {
namespace {

using Point = Eigen::Vector3f;

constexpr float kNearGround = 0.012f;   // m; points within are the plane's
constexpr float kAboveGround = 0.024f;  // m; points beyond stand on it
constexpr std::size_t kMostStanding = 16384;

std::vector<Point> pointsOf(const Cloud& cloud) {
  std::vector<Point> points;
  points.reserve(cloud.valid_count);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud.valid(i)) points.emplace_back(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  return points;
}

/// The plane n.p = offset.
struct Ground {
  Point normal;
  float offset;
  float height(const Point& point) const { return normal.dot(point) - offset; }
};

std::size_t countNear(const Ground& ground, const std::vector<Point>& points) {
  return std::count_if(points.begin(), points.end(),
                       [&](const Point& point) { return std::abs(ground.height(point)) < kNearGround; });
}

/// Least squares to the points near it.
void refit(const std::vector<Point>& points, Ground& ground) {
  Point sum = Point::Zero();
  float count = 0.0f;
  const auto isNear = [&ground](const Point& point) { return std::abs(ground.height(point)) < kNearGround; };
  for (const Point& point : points) {
    if (isNear(point)) sum += point, count += 1.0f;
  }
  if (!(count > 0.0f)) return;
  const Point mean = sum / count;
  Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
  for (const Point& point : points) {
    if (isNear(point)) spread += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen(spread);
  ground.normal = eigen.eigenvectors().col(0);
  ground.offset = ground.normal.dot(mean);
}

/// The plane through most of the points (RANSAC, Fischler and Bolles 1981), with its normal to the side on which more
/// of the others lie.
std::optional<Ground> findGround(const std::vector<Point>& points) {
  constexpr int kTries = 200, kSome = 1000;
  constexpr double kLeastShare = 0.33;
  Random random(1);
  std::vector<Point> some;
  for (int k = 0; k < kSome; ++k) some.push_back(points[random.below(points.size())]);
  std::optional<Ground> best;
  std::size_t most = 0;
  for (int k = 0; k < kTries; ++k) {
    const Point a = some[random.below(kSome)], b = some[random.below(kSome)], c = some[random.below(kSome)];
    const Point across = (b - a).cross(c - a);
    if (!(across.norm() > 1e-6f)) continue;
    const Point normal = across.normalized();
    const Ground ground{normal, normal.dot(a)};
    const std::size_t count = countNear(ground, some);
    if (count > most) most = count, best = ground;
  }
  if (static_cast<double>(most) < kLeastShare * kSome) return std::nullopt;
  for (int k = 0; k < 2; ++k) refit(some, *best);
  std::size_t above = 0, below = 0;
  for (const Point& point : some) {
    const float height = best->height(point);
    above += height > kAboveGround ? 1 : 0;
    below += height < -kAboveGround ? 1 : 0;
  }
  if (below > above) *best = {-best->normal, -best->offset};
  return best;
}

/// The plane in cells of which each is seen, or not though others around it are; and what stands on it. In the frame of
/// the plane, z up.
class Shadows {
 public:
  Shadows(const Ground& ground, const std::vector<Point>& points);

  bool isWorthASearch() const {
    constexpr int kFewestHoles = 50;
    constexpr std::size_t kFewestStanding = 100;
    return holes_ >= kFewestHoles && standing_.size() >= kFewestStanding;
  }

  /// What is wrong with a lamp there: holes that are lit, and cells in the shadow that are seen, over the holes. Of
  /// about so many of the points that stand.
  float misfit(const Point& lamp, std::size_t points);

  Point middleOfGround() const { return middle_of_ground_; }
  Point middleOfStanding() const { return middle_of_standing_; }
  Point inFrameOfGround(const Point& point) const { return axes_ * point - Point(0.0f, 0.0f, offset_); }
  Point inFrameOfCloud(const Point& point) const { return axes_.transpose() * (point + Point(0.0f, 0.0f, offset_)); }

 private:
  /// The lower two bits of a cell; above them the number of the lamp whose shadow fell there last.
  enum State : std::uint32_t { kOutside = 0, kSeen = 1, kHole = 2, kEither = 3 };
  static constexpr std::uint32_t kStateBits = 2, kStates = (1u << kStateBits) - 1;
  /// Over what is seen of the plane, not a wall behind it, whose shadow nobody sees.
  bool isOver(const Point& point) const {
    const float u = (point.x() - left_) * per_cell_, v = (point.y() - bottom_) * per_cell_;
    return u >= 0.0f && v >= 0.0f && u < static_cast<float>(columns_) && v < static_cast<float>(rows_) &&
           cells_[at(static_cast<int>(u), static_cast<int>(v))] != kOutside;
  }
  void draw(const std::vector<Point>& near);
  void findHoles(const std::vector<std::uint8_t>& seen);
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  Eigen::Matrix3f axes_;  // rows: x and y along the plane, z up
  float offset_;
  std::vector<Point> standing_;
  Point middle_of_ground_ = Point::Zero(), middle_of_standing_ = Point::Zero();
  float left_ = 0.0f, bottom_ = 0.0f, per_cell_ = 0.0f;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> cells_;
  std::uint32_t lamp_ = 0;
  int holes_ = 0;
};

Shadows::Shadows(const Ground& ground, const std::vector<Point>& points) : offset_(ground.offset) {
  axes_.row(2) = ground.normal;
  axes_.row(0) = ground.normal.unitOrthogonal();
  axes_.row(1) = ground.normal.cross(axes_.row(0).transpose());
  std::vector<Point> near, above, standing;
  for (const Point& point : points) {
    const Point moved = inFrameOfGround(point);
    if (std::abs(moved.z()) < kNearGround) near.push_back(moved);
    if (moved.z() > kAboveGround) above.push_back(moved);
  }
  if (near.empty()) return;
  draw(near);
  std::copy_if(above.begin(), above.end(), std::back_inserter(standing), [this](const Point& p) { return isOver(p); });
  const std::size_t step = standing.size() / kMostStanding + 1;
  for (std::size_t k = 0; k < standing.size(); k += step) standing_.push_back(standing[k]);
  for (const Point& point : near) middle_of_ground_ += point / static_cast<float>(near.size());
  for (const Point& point : standing_) middle_of_standing_ += point / static_cast<float>(standing_.size());
}

/// In cells so large that two points and more lie in those that are seen.
void Shadows::draw(const std::vector<Point>& near) {
  constexpr float kSmallest = 0.01f, kLarger = 1.4f;  // m
  constexpr int kSizes = 5;
  constexpr float kMostCells = 1e6f;
  Point low = near.front(), high = near.front();
  for (const Point& point : near) low = low.cwiseMin(point), high = high.cwiseMax(point);
  left_ = low.x(), bottom_ = low.y();
  float cell = kSmallest;
  std::vector<std::uint8_t> seen;
  for (int k = 0; k < kSizes; ++k, cell *= kLarger) {
    per_cell_ = 1.0f / cell;
    const float wide = (high.x() - left_) * per_cell_, deep = (high.y() - bottom_) * per_cell_;
    if (!((wide + 1.0f) * (deep + 1.0f) < kMostCells)) continue;
    columns_ = static_cast<int>(wide) + 1;
    rows_ = static_cast<int>(deep) + 1;
    seen.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    std::size_t filled = 0;
    for (const Point& point : near) {
      const std::size_t c =
          at(static_cast<int>((point.x() - left_) * per_cell_), static_cast<int>((point.y() - bottom_) * per_cell_));
      filled += 1 - seen[c];
      seen[c] = 1;
    }
    if (near.size() >= 2 * filled) break;
  }
  findHoles(seen);
}

/// Holes lie between cells that are seen, along the rows as along the columns. The border of what is seen may be
/// either.
void Shadows::findHoles(const std::vector<std::uint8_t>& seen) {
  struct Range {
    int first = -1, last = -1;
    void add(int k) {
      if (first < 0) first = k;
      last = k;
    }
    bool holds(int k) const { return first < k && k < last; }
  };
  std::vector<Range> along_row(rows_), along_column(columns_);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (seen[at(column, row)]) along_row[row].add(column), along_column[column].add(row);
    }
  }
  cells_.assign(seen.size(), kOutside);
  for (int row = 1; row + 1 < rows_; ++row) {
    for (int column = 1; column + 1 < columns_; ++column) {
      const std::size_t c = at(column, row);
      if (!along_row[row].holds(column) || !along_column[column].holds(row)) continue;
      bool inside = true;
      for (const std::size_t begin : {c - columns_ - 1, c - 1, c + columns_ - 1})
        inside = inside && seen[begin] && seen[begin + 1] && seen[begin + 2];
      cells_[c] = inside ? kSeen : seen[c] ? kEither : kHole;
      holes_ += cells_[c] == kHole ? 1 : 0;
    }
  }
}

float Shadows::misfit(const Point& lamp, std::size_t points) {
  static constexpr std::array<int, kStates + 1> kMoreWrong = {0, 1, -1, 0};  // with a shadow on it, by state
  ++lamp_;
  int wrong = holes_;
  const std::size_t step = standing_.size() / points + 1;
  for (std::size_t k = 0; k < standing_.size(); k += step) {
    const Point& point = standing_[k];
    const float above = lamp.z() - point.z();
    if (!(above > 0.0f)) continue;  // its shadow falls nowhere
    const float stretch = point.z() / above;
    const float u = (point.x() + stretch * (point.x() - lamp.x()) - left_) * per_cell_ - 0.5f;
    const float v = (point.y() + stretch * (point.y() - lamp.y()) - bottom_) * per_cell_ - 0.5f;
    if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(columns_ - 1) && v < static_cast<float>(rows_ - 1)))
      continue;
    // On the four cells around it: between the points there is no light.
    const std::size_t first = at(static_cast<int>(u), static_cast<int>(v));
    for (const std::size_t c : {first, first + 1, first + columns_, first + columns_ + 1}) {
      const std::uint32_t state = cells_[c] & kStates;
      // No branch: it would be guessed wrong half of the time.
      wrong += kMoreWrong[state] & -static_cast<int>(cells_[c] >> kStateBits != lamp_);
      cells_[c] = lamp_ << kStateBits | state;
    }
  }
  return static_cast<float>(wrong) / static_cast<float>(holes_);
}

struct Lamp {
  Point place;
  float misfit;
  bool operator<(const Lamp& other) const { return misfit < other.misfit; }
};

/// Around what stands there, up to 2.5 m from it.
std::vector<Lamp> manyLamps(Shadows& shadows, std::size_t points) {
  constexpr std::array<float, 8> kHeights = {0.25f, 0.35f, 0.5f, 0.7f, 0.95f, 1.3f, 1.8f, 2.4f};  // m
  constexpr std::array<float, 6> kAside = {0.3f, 0.6f, 0.9f, 1.2f, 1.6f, 2.1f};                   // m
  constexpr int kTurns = 20;
  const Point middle = shadows.middleOfStanding();
  std::vector<Lamp> lamps;
  const auto add = [&](const Point& place) { lamps.push_back({place, shadows.misfit(place, points)}); };
  for (const float height : kHeights) {
    add({middle.x(), middle.y(), height});
    for (const float aside : kAside) {
      for (int k = 0; k < kTurns; ++k) {
        const float turn = static_cast<float>(2.0 * M_PI * k / kTurns);
        add({middle.x() + aside * std::cos(turn), middle.y() + aside * std::sin(turn), height});
      }
    }
  }
  std::sort(lamps.begin(), lamps.end());
  return lamps;
}

/// To and fro and to the sides, as long as that helps, by steps that are shares of the distance.
void improve(Shadows& shadows, std::size_t points, float step, float least_step, Lamp& lamp) {
  lamp.misfit = shadows.misfit(lamp.place, points);
  while (step > least_step) {
    const Point away = lamp.place - shadows.middleOfGround();
    const float size = step * away.norm();
    const Point ahead = away.normalized(), aside = ahead.unitOrthogonal(), up = ahead.cross(aside);
    Lamp best = lamp;
    for (int k = 0; k < 27; ++k) {
      const Point way(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 % 3 - 1), static_cast<float>(k / 9 - 1));
      const Point place = lamp.place + size * (way.x() * 2.0f * ahead + way.y() * aside + way.z() * up);
      const bool edge = way.cwiseAbs().sum() == 2.0f;
      if (k == 13 || edge || !(place.z() > kAboveGround)) continue;
      const float misfit = shadows.misfit(place, points);
      if (misfit < best.misfit) best = {place, misfit};
    }
    if (best.misfit < lamp.misfit) {
      lamp = best;
    } else {
      step *= 0.5f;
    }
  }
}

/// Of the points, those that no camera at the place would have seen: others are before them, or they lie more than 60
/// deg aside of where it looks.
double hiddenShare(const std::vector<Point>& points, const Point& place, const Point& ahead) {
  constexpr std::size_t kMostLooked = 32768, kMostPixels = 4'000'000;
  constexpr float kLeastCosine = 0.5f;
  constexpr float kWide = 3.0f;   // pixels; times the distance of neighbours that fill a disc
  constexpr float kSteep = 4.0f;  // how much farther a surface may be one pixel further, in pixels
  constexpr float kFar = std::numeric_limits<float>::max();
  struct Ray {
    float u, v, distance;
  };
  std::vector<Ray> rays;
  const Point right = ahead.unitOrthogonal(), down = ahead.cross(right);
  const std::size_t step = points.size() / kMostLooked + 1;
  Ray low = {kFar, kFar, 0.0f}, high = {-kFar, -kFar, 0.0f};
  Point sum = Point::Zero();
  float square = 0.0f;
  std::size_t looked = 0;
  for (std::size_t k = 0; k < points.size(); k += step, ++looked) {
    const Point way = points[k] - place;
    const float depth = ahead.dot(way), distance = way.norm();
    sum += way;
    square += way.squaredNorm();
    if (!(depth > kLeastCosine * distance)) continue;
    rays.push_back({right.dot(way) / depth, down.dot(way) / depth, distance});
    low.u = std::min(low.u, rays.back().u), low.v = std::min(low.v, rays.back().v);
    high.u = std::max(high.u, rays.back().u), high.v = std::max(high.v, rays.back().v);
  }
  if (rays.empty()) return 1.0;
  const auto count = static_cast<float>(looked);
  const float away = sum.norm() / count, spread = std::sqrt(std::max(0.0f, square / count - away * away));
  const float pixel = kWide * spread / std::sqrt(count) / away;
  const float columns = (high.u - low.u) / pixel, rows = (high.v - low.v) / pixel;
  if (!(columns * rows < static_cast<float>(kMostPixels))) return 1.0;
  const auto width = static_cast<std::size_t>(columns) + 1;
  std::vector<float> nearest(width * (static_cast<std::size_t>(rows) + 1), kFar);
  const auto nearestOf = [&](const Ray& ray) -> float& {
    return nearest[static_cast<std::size_t>((ray.v - low.v) / pixel) * width +
                   static_cast<std::size_t>((ray.u - low.u) / pixel)];
  };
  for (const Ray& ray : rays) nearestOf(ray) = std::min(nearestOf(ray), ray.distance);
  const auto hidden = [&](const Ray& ray) { return ray.distance > (1.0f + kSteep * pixel) * nearestOf(ray); };
  const std::size_t aside = looked - rays.size();
  return static_cast<double>(aside + std::count_if(rays.begin(), rays.end(), hidden)) / static_cast<double>(looked);
}

/// z to the point, y down.
Eigen::Isometry3d lookingAt(const Vec3& point, const Vec3& from, const Vec3& up) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Vec3 ahead = (point - from).normalized();
  const Vec3 across = ahead.cross(up);
  const Vec3 right = across.norm() > 1e-3 ? Vec3(across.normalized()) : ahead.unitOrthogonal();
  pose.linear().col(0) = right;
  pose.linear().col(1) = ahead.cross(right);
  pose.linear().col(2) = ahead;
  pose.translation() = from;
  return pose;
}

}  // namespace

std::optional<Eigen::Isometry3d> findCameraByShadows(const Cloud& list) {
  constexpr std::size_t kFewest = 500;
  constexpr std::size_t kRoughly = 700, kBetter = 1200, kWell = 4096, kAll = kMostStanding;  // points
  constexpr std::size_t kTaken = 4;
  constexpr float kMostMisfit = 0.25f, kAsGood = 0.15f;
  constexpr float kFarthest = 2.6f;     // m
  constexpr double kMostHidden = 0.03;  // behind edges, which noise and lenses blur
  const std::vector<Point> points = pointsOf(list);
  if (points.size() < kFewest || hiddenShare(points, Point::Zero(), Point::UnitZ()) <= kMostHidden) return std::nullopt;
  const std::optional<Ground> ground = findGround(points);
  if (!ground) return std::nullopt;
  Shadows shadows(*ground, points);
  if (!shadows.isWorthASearch()) return std::nullopt;
  std::vector<Lamp> lamps = manyLamps(shadows, kRoughly);
  lamps.resize(kTaken);
  for (Lamp& lamp : lamps) improve(shadows, kBetter, 0.1f, 0.02f, lamp);
  Lamp best = *std::min_element(lamps.begin(), lamps.end());
  improve(shadows, kWell, 0.03f, 0.004f, best);
  improve(shadows, kAll, 0.01f, 0.006f, best);
  const Point origin = shadows.inFrameOfGround(Point::Zero());
  const bool origin_is_as_good = origin.z() > kAboveGround && shadows.misfit(origin, kAll) < best.misfit + kAsGood;
  if (!(best.misfit < kMostMisfit) || origin_is_as_good) return std::nullopt;
  const Point middle = shadows.inFrameOfCloud(shadows.middleOfGround()), place = shadows.inFrameOfCloud(best.place);
  const Point way = middle - place;
  if (!(way.norm() < kFarthest) || hiddenShare(points, place, way.normalized()) > kMostHidden) return std::nullopt;
  return lookingAt(middle.cast<double>(), place.cast<double>(), ground->normal.cast<double>());
}

}  // namespace primitect
