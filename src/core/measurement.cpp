// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Putting the measures of a detection together; see measurement.h.
#include "core/measurement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/along_rays.h"
#include "core/axis_gap.h"
#include "core/bent_ends.h"
#include "core/bent_strip.h"
#include "core/bias.h"
#include "core/bulge.h"
#include "core/clear_points.h"
#include "core/cone_tip.h"
#include "core/coverage.h"
#include "core/determination.h"
#include "core/ends_on_faces.h"
#include "core/evidence.h"
#include "core/extent.h"
#include "core/misfit.h"
#include "core/observed_part.h"
#include "core/open_ball.h"
#include "core/seen_ends.h"
#include "core/seen_share.h"
#include "core/shared_noise.h"
#include "core/strip.h"
#include "core/thin_ends.h"
#include "core/tube_gaps.h"
#include "kernels/loops.h"

namespace primitect {

namespace {

/// Those of the points that lie on this part, or beside it by the noise.
SeenPoints within(const ObservedPart& part, SeenPoints points, const NoiseModel& noise) {
  const std::size_t count = points.size();
  const Eigen::Vector3f origin = points.origin.cast<float>();
  List<float> x(count), y(count), z(count), depth(count), allowed(count);
  for (std::size_t k = 0; k < count; ++k) {
    x[k] = origin.x() + points.x[k], y[k] = origin.y() + points.y[k], z[k] = origin.z() + points.z[k];
  }
  kernels::loops().depths(part.view(), x.data(), y.data(), z.data(), count, depth.data());
  kernels::loops().tolerances(flattened(noise, kInlierDeviations), z.data(), count, allowed.data());
  points.keep([&](std::size_t k) { return depth[k] >= -allowed[k]; });
  return points;
}

/// How far some of at least one point are off a shape: the mean of squared distances in three deviations of the noise,
/// none of which counts as more than one.
double misfitOf(const Shape& shape, const SeenPoints& seen, const PointNoise& sigma) {
  constexpr std::size_t kEnough = 509;
  const SomePoints<kEnough> points(seen);
  const Feet<SomePoints<kEnough>::kRoom> feet(shape, points);
  float one[SomePoints<kEnough>::kRoom];
  sigma.at(points, one);
  double sum = 0.0;
  for (std::size_t k = 0; k < points.count; ++k) {
    const float tolerances = feet.distance[k] / (static_cast<float>(kInlierDeviations) * one[k]);
    sum += std::min(tolerances * tolerances, 1.0f);
  }
  return sum / static_cast<double>(points.count);
}

}  // namespace

Measurement::Measurement(const Cloud& cloud, const ImageRays& rays, const Params& params, const MeasurementNoise& noise,
                         const Limits& limits)
    : cloud_(cloud),
      rays_(rays),
      tolerated_(noise.tolerated),
      noise_(noise.full),
      limits_(limits),
      range_(depthRangeOf(params)),
      sigma_(noise.full),
      truncation_(cloud, rays, range_, sigma_),
      waves_(noise.waves) {}

/// What a depth camera saw of curved shapes is fitted along its rays, and has no bias by the noise. Planes are not:
/// what turns them is small, and of narrow ones it is the smaller evil.
bool Measurement::isFittedAlongRays(const Shape& shape) const {
  return noise_.ofDepthCamera() && kindOf(shape) != Kind::plane && does(Step::along_rays);
}

/// Without the bias of the noise; as it is where that breaks the limits, and where a depth camera sees a face too
/// narrow for clear points: noise along the rays takes points of its border away, which turns the fit the other way.
/// With the bias taken out, faces 28 mm high were tilted by 3 deg instead of by 0.5.
Shape Measurement::unbiased(const Shape& fit) const {
  const bool narrow = kindOf(fit) == Kind::plane && clear_.size() == points_.size();
  if ((noise_.ofDepthCamera() && narrow) || !does(Step::bias)) return fit;
  const NoiseDirection direction = noise_.ofDepthCamera() ? NoiseDirection::along_ray : NoiseDirection::any;
  const Shape result = withoutBias(fit, clear_, sigma_, direction);
  return limits_.hold(result) ? result : fit;
}

/// What tells a cylinder from a cone grows with the length that was seen, of which clear points lack both ends. But
/// beyond what the samples saw of it, a bottle has its neck: points there would make a cone of it.
PointsChoice Measurement::start(const Detection& found) {
  const Shape& shape = found.shape;
  if (!hasAxis(kindOf(shape)) || !does(Step::last_fit)) return {shape, false};
  gatherPart(found);
  const PointsChoice choice = refineOnPoints(shape, fit_points_, limits_);
  const Face* face = faceOf(found);
  return face ? upright(*face, choice, Leaning::clear).value_or(choice) : choice;
}

/// Points to fit to: those of the part that samples saw.
void Measurement::gatherPart(const Detection& found) {
  fit_points_.gather(within(ObservedPart(found.shape, found.extent), points_, tolerated_), tolerated_);
}

/// The largest face that it may stand on; null where none is known well enough.
const Measurement::Face* Measurement::faceOf(const Detection& found) const {
  if (!noise_.ofDepthCamera() || !does(Step::upright)) return nullptr;
  const double reach = kReachOfFaces * sigma_(found.extent.origin);
  const Face* largest = nullptr;
  for (const Face& face : faces_) {
    if (!(face.normal.by_noise <= kUprightDeviation) || !mayStandOn(*face.plane, reach, found.extent)) continue;
    if (!largest || face.plane->inlier_count > largest->plane->inlier_count) largest = &face;
  }
  return largest;
}

/// The choice for the points of the part, made to stand upright where it may. Whether it is a cylinder or a cone is
/// clear only where it becomes a cone.
std::optional<PointsChoice> Measurement::upright(const Face& face, PointsChoice choice, Leaning leaning) const {
  const Vec3& normal = std::get<Plane>(face.plane->shape).normal;
  const std::optional<Shape> shape = uprightShape(choice.shape, normal, leaning, fit_points_, limits_);
  if (!shape) return std::nullopt;
  choice.shape = *shape;
  choice.axis = {std::hypot(kUprightDeviation, face.normal.by_noise),
                 std::hypot(kUprightDeviation, face.normal.by_all)};
  if (kindOf(*shape) == Kind::cone) choice.or_cone = choice.either = false;
  return choice;
}

/// Beyond what samples saw of an axis points of other surfaces are among them, which no image tells apart: of the
/// paper's scenes NEES of cones is 1.22 with them, 1.16 without. Nor are all that samples saw its own: one point of
/// another surface, taken for the tip of a cone, tells where the apex is (axis_gap.h).
void Measurement::gatherClear(const List<std::uint32_t>& clear, const Detection& found) {
  clear_.gather(cloud_, clear);
  if (!hasAxis(kindOf(found.shape)) || noise_.ofDepthCamera()) return;
  SeenPoints seen = within(ObservedPart(found.shape, found.extent), clear_, tolerated_);
  if (enoughClear(seen.size(), clear_.size())) clear_ = std::move(seen);
  clear_ = withoutFarEnds(found.extent.rotation.col(2), std::move(clear_));
}

Shape Measurement::fittedToClear(const PointsChoice& from) {
  const Shape& start = from.shape;
  fit_points_.gather(clear_, noise_);
  if (!does(Step::last_fit)) return start;
  const bool along_rays = isFittedAlongRays(start);
  const std::optional<Shape> refined =
      refineDense(start, fit_points_, along_rays ? PointErrors::along_rays : PointErrors::across, from.upright());
  const Shape fit = refined && limits_.hold(*refined) ? *refined : start;
  const Shape last = along_rays ? fit : unbiased(fit);
  // A few clear points may not hold a shape where all of its points are. But some of these may be of other surfaces,
  // and where those are is no matter, as long as most are held.
  constexpr double kWorse = 2.25, kMost = 0.4;
  const double before = misfitOf(start, points_, sigma_);
  return misfitOf(last, points_, sigma_) <= std::max(before, std::min(kWorse * before, kMost)) ? last : start;
}

/// Of a fit to the clear points; without waves only what decides, which then stands for both.
Uncertainties Measurement::uncertaintyOf(const Shape& fit, HeldAxis axis, const Extent& extent,
                                         const DepthWaves* waves) const {
  const auto from = [&](const SeenPoints& points) {
    SharedErrors shared;
    if (does(Step::shared_noise)) shared.noise = measureSharedNoise(fit, points, sigma_);
    if (waves) {
      shared.waves = *waves;
    } else {
      shared.noise.all = shared.noise.shown;
      axis.by_all = axis.by_noise;
    }
    return measureUncertainty(fit, extent, points, sigma_, shared, axis);
  };
  return isFittedAlongRays(fit) ? from(AlongRays(fit_points_).seenFor(fit)) : from(clear_);
}

/// What is no part of the surface stands out from a fit that it has bent only after some fits without the worst of it.
/// Among clutter any fit gets better by leaving out what contradicts it: it earns no more trust by that.
Measurement::Fit Measurement::fitted(const List<std::uint32_t>& clear, const OnSurface& on_surface,
                                     const Detection& found, const PointsChoice& from) {
  constexpr int kTimes = 3;
  gatherClear(clear, found);
  Fit fit = {fittedToClear(from), 1.0, from};
  if (!does(Step::false_border)) return fit;
  for (int time = 0; time < kTimes; ++time) {
    const List<std::uint32_t> rest = on_surface(fit.shape);
    if (rest.size() == clear.size()) break;
    if (time == 0) fit.most_trust = trustInSizeOf(fit);
    clear_.gather(cloud_, rest);
    fit.shape = fittedToClear(from);
  }
  return fit;
}

double Measurement::trustInSizeOf(const Fit& fit) const {
  const Extent extent = measureExtent(fit.shape, points_, {});
  return trustInSize(fit.shape, uncertaintyOf(fit.shape, fit.from.axis, extent).by_noise);
}

/// What is tried in place of a sharp cone that its points do not determine: upright, else the cylinder.
std::optional<PointsChoice> Measurement::insteadOf(const Fit& doubtful, const Detection& found) {
  const Vec3 middle = fit_points_.middle();
  const Face* face = doubtful.from.upright() ? nullptr : faceOf(found);
  if (face) {
    gatherPart(found);
    if (const auto choice = upright(*face, {doubtful.shape}, Leaning::any)) return choice;
  }
  const std::optional<Cylinder> cylinder = asCylinder(found.shape, middle);
  if (!cylinder || !limits_.hold(*cylinder)) return std::nullopt;
  return PointsChoice{*cylinder, true};
}

/// A sharp cone that its points do not determine is a cylinder: of cups of 5 to 7 deg, 24 mm thick and 1.3 m away, one
/// in six would be lost, and now and then a tin.
Measurement::Fit Measurement::fitted(const List<std::uint32_t>& clear, const OnSurface& on_surface,
                                     const Detection& found) {
  constexpr double kDoubtful = 0.5;
  const Fit fit = fitted(clear, on_surface, found, start(found));
  const Cone* cone = std::get_if<Cone>(&fit.shape);
  if (!cone || cone->half_angle > kSharpCone || !does(Step::undetermined_cones)) return fit;
  if (std::min(fit.most_trust, trustInSizeOf(fit)) > kDoubtful) return fit;
  if (const auto instead = insteadOf(fit, found)) return fitted(clear, on_surface, found, *instead);
  fit_points_.gather(clear_, noise_);  // uncertainty is measured on what it was fitted to
  return fit;
}

/// Without it cylinders and cones on tables are 2.6 mm too long in the median, with three times the noise 9.1.
void Measurement::endAtFacesOrTip(Detection& detection) const {
  const double sigma = sigma_(detection.extent.origin), narrow = detection.extent.radius_small;
  for (const Face& face : faces_) endOn(*face.plane, kReachOfFaces * sigma, detection.shape, detection.extent);
  // What ends on a face has no tip.
  if (detection.extent.radius_small == narrow) endAtTip(sigma, detection.shape, detection.extent);
}

/// Returns the share of the points that is left. In depth frames the share of the surface that the image shows tells
/// (seen_share.h).
double Measurement::leaveOutThinEnds(const Shape& shape) {
  const Cylinder* cylinder = std::get_if<Cylinder>(&shape);
  if (!cylinder || noise_.ofDepthCamera() || points_.empty() || !does(Step::thin_ends)) return 1.0;
  const auto before = static_cast<double>(points_.size());
  points_ = withoutThinEnds(*cylinder, std::move(points_));
  return static_cast<double>(points_.size()) / before;
}

/// Among the points of a tube or cone, index, are some of other things in its continuation: they would stretch it by
/// half or more, and what is not seen there would take its confidence. It is the part that is seen, where most of its
/// points are: kept becomes these. Returns the share of it that is seen.
double Measurement::keepToSeen(Detection& detection, const List<std::uint32_t>& index, List<std::uint32_t>& kept) {
  constexpr double kMost = 0.7;
  if (!does(Step::seen_share)) return 1.0;
  const AskedImage image{cloud_, rays_, range_, sigma_};
  SeenShare seen = seenShare(detection, index, image);
  if (!noise_.ofDepthCamera()) return seen.all;
  if (const Cylinder* tube = std::get_if<Cylinder>(&detection.shape); tube && !seen.part) {
    seen.part = seenEnds(*tube, detection.concave, detection.extent, image), seen.in_part = seen.all;
  }
  if (!seen.part) return seen.all;
  List<std::uint32_t> in_part;
  for (const std::uint32_t i : index) {
    if (seen.part->holds(heightOn(detection, cloud_, i))) in_part.push_back(i);
  }
  if (static_cast<double>(in_part.size()) < kMost * static_cast<double>(index.size())) return seen.all;
  std::swap(kept, in_part);
  points_.gather(cloud_, kept);
  detection.extent = measureExtent(detection.shape, points_, {});
  return seen.in_part;
}

/// What Verification asks of samples, while others may have them; but its rounds may be over before it has asked.
bool Measurement::looksInto(const Detection& detection) const {
  const Sphere* ball = std::get_if<Sphere>(&detection.shape);
  if (!ball || detection.concave || !noise_.ofDepthCamera() || !does(Step::seen_share)) return false;
  return isOpen(*ball, {cloud_, rays_, range_, sigma_});
}

void Measurement::measure(const LabelledPoints& labelled, const List<std::uint32_t>& clear, const OnSurface& on_surface,
                          Detection& detection) {
  points_.gather(cloud_, labelled.index);
  const Kind kind = kindOf(detection.shape);
  if (kind == Kind::plane) outermost_.gather(cloud_, labelled.row_ends);
  const Fit fit = fitted(clear, on_surface, detection);
  detection.shape = canonical(fit.shape);
  // What it was taken for is then its rival.
  if (detection.rival == kindOf(detection.shape)) detection.rival = kind;
  if (fit.from.upright() && kindOf(detection.shape) != kind) detection.rival = kind;
  if (fit.from.or_cone) detection.rival = Kind::cone;
  // Of 52 on simulated halls, heaps and tables a third were cylinders, of recorded ones all.
  constexpr float kTrustInEither = 0.7f;
  if (fit.from.either && kindOf(detection.shape) == Kind::cylinder) detection.confidence *= kTrustInEither;
  double share = leaveOutThinEnds(detection.shape);
  detection.extent = measureExtent(detection.shape, points_, outermost_, std::move(detection.extent.hull));
  List<std::uint32_t> kept;
  const double seen_share = keepToSeen(detection, labelled.index, kept);
  const List<std::uint32_t>& index = kept.empty() ? labelled.index : kept;
  if (!kept.empty()) share *= static_cast<double>(kept.size()) / static_cast<double>(labelled.index.size());
  detection.rms_error = rmsDistance(detection.shape, points_);
  const Density density = noise_.ofDepthCamera() ? Density::of_pixels : Density::of_surface;
  detection.coverage = measureCoverage(detection.shape, detection.extent, points_, density);
  detection.confidence *= static_cast<float>(trustInShare(seen_share));
  if (looksInto(detection)) detection.confidence = 0.0f;
  const Truncated truncated = truncation_.find(detection.shape, detection.extent, index);
  detection.truncated = truncated.by;
  // Where noise ends a surface, pixels tell little: neither what is seen of it nor why it ends is asked there.
  measureToTheEnds(detection.shape, points_, detection.extent);
  // What is measured above is with the points of a next part that goes on smoothly: clutter earns no more trust by
  // leaving out what contradicts it.
  share *= endWhereItBends(points_, sigma_, detection.shape, detection.extent);
  detection.inlier_count = static_cast<std::uint32_t>(std::lround(share * static_cast<double>(labelled.all)));
  if (does(Step::trust_in_evenness)) {
    const Bulge bulge = bulgeOf(detection.shape, points_, detection.extent, sigma_);
    detection.confidence *= static_cast<float>(trustInStraightSide(bulge));
  }
  endAtFacesOrTip(detection);
  detection.extent.unseen_ends = truncated.unseen_ends;
  // Where it was seen to its tip it does not go on.
  if (kindOf(detection.shape) == Kind::cone && detection.extent.radius_small == 0.0) {
    detection.extent.unseen_ends &= static_cast<std::uint8_t>(~kEndAtMinusZ);
  }
  const auto [by_noise, uncertainty] = uncertaintyOf(detection.shape, fit.from.axis, detection.extent, &waves_);
  if (does(Step::trust_in_size)) {
    detection.confidence *= static_cast<float>(std::min(fit.most_trust, trustInSize(detection.shape, by_noise)));
  }
  if (does(Step::trust_in_evenness)) {
    const bool in_depth = noise_.ofDepthCamera();
    detection.confidence *= static_cast<float>(trustInEvenness(detection.shape, points_, sigma_, in_depth));
  }
  if (noise_.ofDepthCamera() && does(Step::trust_in_fit)) {
    detection.confidence *= static_cast<float>(trustInFit(detection.shape, detection.rms_error, points_, sigma_));
  }
  if (kindOf(detection.shape) == Kind::plane && noise_.ofDepthCamera() && does(Step::trust_in_strips)) {
    detection.confidence *= static_cast<float>(trustInStrip(detection.extent, detection.evidence));
    const Plane& plane = std::get<Plane>(detection.shape);
    detection.confidence *= static_cast<float>(trustInFlat(plane, detection.extent, points_));
  }
  detection.covariance = uncertainty.pose;
  detection.radius_stddev = static_cast<float>(uncertainty.radius_stddev);
  detection.half_angle_stddev = static_cast<float>(uncertainty.half_angle_stddev);
  detection.position_stddev = static_cast<float>(uncertainty.position_stddev);
  detection.axis_stddev = static_cast<float>(uncertainty.axis_stddev);
  const bool likely = detection.confidence >= leastWhileChoosing(limits_.params);
  if (!likely || kindOf(detection.shape) != Kind::plane) return;
  faces_.push_back({&detection, {by_noise.axis_stddev, uncertainty.axis_stddev}});
}

}  // namespace primitect
