// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Gathering labelled points, and the last least squares; see dense_fit.h.
#include "core/dense_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/fitting.h"
#include "core/random.h"
#include "core/seen_side.h"
#include "core/segmentation.h"
#include "core/tapered.h"

namespace primitect {

namespace {

/// Takes one at random of every so many points of a label, the same every time. Always the same one of them would be
/// columns of images of many widths.
class Thinning {
 public:
  explicit Thinning(std::size_t every) : every_(every), random_(every), next_(draw()) {}

  void take(const LabelRun& run, List<std::uint32_t>& taken) {
    const std::size_t count = run.end - run.begin;
    for (; next_ < passed_ + count; next_ = ++parts_ * every_ + draw()) {
      taken.push_back(run.begin + static_cast<std::uint32_t>(next_ - passed_));
    }
    passed_ += count;
  }

  bool takesAll() const { return every_ == 1; }

 private:
  std::size_t draw() { return every_ > 1 ? random_.below(every_) : 0; }

  std::size_t every_;
  Random random_;
  std::size_t parts_ = 0;   ///< of `every_` points each, that one was taken of
  std::size_t next_;        ///< the number of the next point to be taken
  std::size_t passed_ = 0;  ///< points in the runs before
};

/// The outermost pixels of a label: the tip of a cone is one of them, whichever way it points.
class OutermostPixels {
 public:
  void see(const LabelRun& run, std::uint32_t width) {
    if (!any_) top_ = run.begin;
    bottom_ = run.end - 1;
    forRows(run, width, [&](std::uint32_t row, std::uint32_t begin, std::uint32_t end) {
      if (!any_ || begin < left_ % width) left_ = row * width + begin;
      if (!any_ || end - 1 > right_ % width) right_ = row * width + end - 1;
      any_ = true;
    });
  }

  /// Those that were not taken, of rising indices.
  void addTo(List<std::uint32_t>& taken) const {
    for (const std::uint32_t pixel : {top_, left_, right_, bottom_}) {
      const auto at = std::lower_bound(taken.begin(), taken.end(), pixel);
      if (any_ && (at == taken.end() || *at != pixel)) taken.insert(at, pixel);
    }
  }

 private:
  bool any_ = false;
  std::uint32_t top_ = 0, left_ = 0, right_ = 0, bottom_ = 0;
};

/// Adds the ends of a run in every row of the image that it passes through.
void addRowEnds(const LabelRun& run, std::uint32_t width, List<std::uint32_t>& ends) {
  constexpr std::uint32_t kFewest = 4;  // pixels: fewer may be of something that the surface passes through
  for (std::uint32_t begin = run.begin, end = 0; begin < run.end; begin = end) {
    const std::uint32_t row = begin / width;
    end = std::min(run.end, (row + 1) * width);
    if (end - begin < kFewest) continue;
    if (!ends.empty() && ends.back() / width == row) {
      ends.back() = end - 1;
    } else {
      ends.push_back(begin), ends.push_back(end - 1);
    }
  }
}

}  // namespace

void pointsOfLabels(const List<LabelRun>& runs, std::uint32_t width, const List<WantedPoints>& wanted,
                    List<LabelledPoints>& points) {
  const std::size_t count = wanted.size();
  points.resize(count);
  for (LabelledPoints& of_label : points) of_label.index.clear(), of_label.row_ends.clear(), of_label.all = 0;
  for (const LabelRun& run : runs) {
    if (run.label <= count) points[run.label - 1].all += run.end - run.begin;
  }
  List<Thinning> thinnings;
  for (std::size_t k = 0; k < count; ++k) thinnings.emplace_back(points[k].all / wanted[k].most + 1);
  List<OutermostPixels> outermost(count);
  for (const LabelRun& run : runs) {
    if (run.label > count) continue;
    const std::size_t k = run.label - 1;
    thinnings[k].take(run, points[k].index);
    if (width == 0) continue;
    addRowEnds(run, width, points[k].row_ends);
    if (wanted[k].outermost && !thinnings[k].takesAll()) outermost[k].see(run, width);
  }
  for (std::size_t k = 0; k < count; ++k) outermost[k].addTo(points[k].index);
}

namespace {

/// Share of the points that a shape must explain beyond another for each parameter that it has more. A cone that
/// tapers this much (rad) pays less for its last one, the half angle: noise makes cones of 4 to 6 deg of cylinders,
/// hardly ever wider ones.
constexpr double kPrice = 0.002, kPriceOfWideAngle = 0.0007, kWideAngle = 8.0 * M_PI / 180.0;

/// What a shape pays in place of one that was found, in shares of the points. The points alone do not know how their
/// normals turn along a tube: of 36 half tubes 1 to 4 cm long, with 1 to 3 mm of noise, 23 became balls when these had
/// only their fewer parameters to pay for, and 3 with as much as this; bands of balls are told all the same.
double priceOf(const Shape& shape, const Shape& found) {
  constexpr int kBallForTube = 7;  // parameters
  const bool other_ball = kindOf(shape) == Kind::sphere && kindOf(found) != Kind::sphere;
  if (other_ball) return kPrice * kBallForTube;
  const Cone* cone = std::get_if<Cone>(&shape);
  const bool wide = cone && cone->half_angle > kWideAngle;
  return kPrice * (parameterCount(kindOf(shape)) - 1) + (wide ? kPriceOfWideAngle : kPrice);
}

/// The cylinder that touches a cone along the line that its points lie around.
Cylinder straightened(const Cone& cone, const SeenSide& side) {
  return {side.point - side.radius * side.outward, (side.point - cone.apex).normalized(), side.radius};
}

/// The ball around the axis of a cone that touches it all around, where the middle of its points is along the axis: of
/// a small ball, whose normals come from windows as wide as itself, most is like the cone.
std::optional<Sphere> ballWithin(const Cone& cone, const Vec3& middle) {
  const double along = (middle - cone.apex).dot(cone.axis);
  if (!(along > 0.0)) return std::nullopt;
  const double cosine = std::cos(cone.half_angle);
  return Sphere{cone.apex + along / (cosine * cosine) * cone.axis, along * std::tan(cone.half_angle) / cosine};
}

/// From less agreement than this share of another start's a fit hardly gets to more: this saves its time.
constexpr double kLeastAgreement = 0.75;

/// The shape and its neighbours: what points that were taken for it may be as well. One that agrees much worse with
/// them will not get there.
List<Shape> startsAround(const Shape& shape, const FitPoints& points) {
  const double needed = kLeastAgreement * agreement(shape, points, kEnoughToCompare);
  List<Shape> starts = {shape};
  const auto add = [&](const Shape& start) {
    if (agreement(start, points, kEnoughToCompare) >= needed) starts.push_back(start);
  };
  const auto addBall = [&add](const SeenSide& side) {
    add(Sphere{side.point - side.radius * side.outward, side.radius});
  };
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
    add(tapered(*cylinder, points));
    addBall(seenSide(*cylinder, points.middle()));
  }
  if (const Cone* cone = std::get_if<Cone>(&shape)) {
    if (const auto side = seenSide(*cone, points.middle())) {
      add(straightened(*cone, *side));
      addBall(*side);
    }
    if (const auto ball = ballWithin(*cone, points.middle())) add(*ball);
  }
  return starts;
}

/// A fit to so many points shows the way. Prime: seldom in time with the rows of an image.
constexpr std::size_t kFew = 509;

std::optional<Shape> refineOnce(const Shape& start, const FitPoints& points, PointErrors errors,
                                bool hold_axis = false) {
  // In tolerances, which are three deviations: of what few points leave open, 0.04, and all, 0.01, these are a part
  // that does not count; what is left after a step is a tenth of it.
  RefineRules rules;
  rules.small_step = 0.02;
  rules.hold_axis = hold_axis;
  return errors == PointErrors::along_rays ? refineAlongRays(start, points, rules) : refine(start, points, rules);
}

/// The cone that touches this one along the line that its points lie around, and is as round there, but narrower: where
/// a fit along the rays starts.
/// How wide a half-hidden cone opens about the line that it shows, its points hardly tell. From wider, where distances
/// alone lead to, a fit along the rays stops as soon as one of them would miss the surface, where its standard
/// deviations are too small: six of them from the truth. From narrower none misses, and it goes on to where it fits
/// best. NEES of 480 cones on 130 tables (seed 2000) is 0.99 instead of 1.26, for .4 % more instructions of a frame.
/// Where the narrower one agrees much worse, as beside a cone that is seen all around, the points tell how wide it
/// opens, and the fit starts at the cone itself: there is none.
std::optional<Cone> narrowed(const Shape& fit, const FitPoints& points) {
  constexpr double kNarrower = 0.8;
  const Cone* cone = std::get_if<Cone>(&fit);
  const auto side = cone ? seenSide(*cone, points.middle()) : std::nullopt;
  if (!side) return std::nullopt;
  const Cone narrow = coneAlong((side->point - cone->apex).normalized(), *side, kNarrower * cone->half_angle);
  const double needed = kLeastAgreement * agreement(fit, points, kEnoughToCompare);
  if (!(agreement(narrow, points, kEnoughToCompare) >= needed)) return std::nullopt;
  return narrow;
}

bool areMany(const FitPoints& points) { return points.size() >= 2 * kFew; }

}  // namespace

std::optional<Shape> refineDense(const Shape& start, const FitPoints& points, PointErrors errors, bool hold_axis) {
  const Shape few =
      areMany(points) ? refineOnce(start, points.thinned(kFew), errors, hold_axis).value_or(start) : start;
  // About a given axis it does not open of itself.
  const auto narrow = errors == PointErrors::along_rays && !hold_axis ? narrowed(few, points) : std::nullopt;
  const auto fit = narrow ? refineOnce(*narrow, points, errors) : std::nullopt;
  return fit ? fit : refineOnce(few, points, errors, hold_axis);
}

PointsChoice refineOnPoints(const Shape& shape, const FitPoints& points, const Limits& limits) {
  // What a fit to few points may lack of the agreement that one to all has is far less; others are not fitted to all:
  // .5 % fewer instructions of a tabletop, .8 % of a paper scene.
  constexpr double kFarBehind = 0.01, kClose = 0.005;  // of the points
  constexpr double kLeastTaperDeg = 4.0;               // of a cone that nobody would call a cylinder
  const double count = static_cast<double>(points.size());
  const FitPoints few = areMany(points) ? points.thinned(kFew) : FitPoints();
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  Shape best = shape;
  double most = kNone, most_of_cones = kNone, most_that_taper = kNone;
  const auto worthOf = [&](const Shape& fitted) { return agreement(fitted, points) - count * priceOf(fitted, shape); };
  for (Shape start : startsAround(shape, points)) {
    if (areMany(points)) {
      start = refineOnce(start, few, PointErrors::across).value_or(start);
      if (worthOf(start) < most - kFarBehind * count) continue;
    }
    const std::optional<Shape> fitted = refineOnce(start, points, PointErrors::across);
    if (!fitted) continue;
    const double worth = worthOf(*fitted);
    const bool holds = limits.hold(*fitted);
    if (holds && worth > most) most = worth, best = *fitted;
    // One that holds may come second by as little.
    const double allowed = holds ? kClose * count : 0.0;
    const bool wanted = holds || isSharper(*fitted, limits.params.min_half_angle_deg);
    if (kindOf(*fitted) != Kind::cone || !wanted) continue;
    most_of_cones = std::max(most_of_cones, worth + allowed);
    const bool tapers = holds && !isSharper(*fitted, kLeastTaperDeg);
    if (tapers) most_that_taper = std::max(most_that_taper, worth + allowed);
  }
  if (kindOf(best) != Kind::cylinder || !limits.params.detect_cones) return {best, false};
  const double needed = std::max(most, worthOf(best));
  return {best, most_of_cones > needed, most_that_taper > needed};
}

std::optional<Cylinder> asCylinder(const Shape& shape, const Vec3& middle) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) return *cylinder;
  const Cone* cone = std::get_if<Cone>(&shape);
  const auto side = cone ? seenSide(*cone, middle) : std::nullopt;
  return side ? std::optional<Cylinder>(straightened(*cone, *side)) : std::nullopt;
}

}  // namespace primitect
