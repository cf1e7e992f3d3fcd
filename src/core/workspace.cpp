// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From a cloud to shapes on its samples: begin, vote, segment, look closer; see workspace.h.
#include "core/workspace.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/clustering.h"
#include "core/extent.h"
#include "core/image_noise.h"
#include "core/residuals.h"

namespace primitect {
namespace {

Status statusOf(const Cloud& cloud) {
  if (cloud.valid_count == 0) return Status::empty_input;
  return cloud.valid_count < kFewestPoints ? Status::too_few_points : Status::ok;
}

/// last: nothing will be measured on the points of the cloud. outline: whose memory its own is to have.
Detection describe(const Segment& segment, const Samples& samples, bool last, std::vector<Vec3> outline) {
  SeenPoints inliers;
  inliers.gather(samples, segment.inliers);
  Detection detection;
  detection.shape = canonical(segment.candidate.shape);
  detection.concave = segment.candidate.concave;
  detection.extent = measureExtent(detection.shape, inliers, std::move(outline));
  detection.votes = static_cast<float>(segment.candidate.votes);
  detection.inlier_count = static_cast<std::uint32_t>(inliers.size());
  if (last) detection.rms_error = rmsDistance(detection.shape, inliers);
  detection.confidence = static_cast<float>(segment.confidence);
  detection.evidence = segment.evidence;
  detection.rival = segment.rival;
  return detection;
}

/// How large what the first samples show is, and how far away (m).
struct SeenSize {
  explicit SeenSize(const Samples& samples)
      : diagonal(boundingBoxDiagonal(samples)),
        depth(std::accumulate(samples.z.begin(), samples.z.end(), 0.0) / static_cast<double>(samples.size())) {}

  double diagonal;  ///< 0 when all are in one place
  double depth;     ///< along z, in the mean
};

/// d_s of what a depth camera sees; 0 when all is in one place. At least its mean depth, or what was cut out of its
/// image, like one object, would be looked at with bins and pairs so small that they tell only noise, and for radii
/// smaller than its own.
double sceneDiameterOfDepth(const SeenSize& seen) {
  return seen.diagonal > 0.0 ? std::max(seen.diagonal, seen.depth) : 0.0;
}

/// A ball or a tube close up, alone in the image of a depth camera, may have a radius of six tenths of what is seen of
/// it: bins of radii, which reach to `largest` (m), reach that far. Usually they do: what is around a thing makes d_s
/// large, a wall 1.6 times its depth.
double radiusStretch(const SeenSize& seen, double largest) {
  constexpr double kAlone = 1.5, kOfSeen = 0.6;
  const bool alone = seen.diagonal > 0.0 && seen.diagonal <= kAlone * seen.depth;
  return alone ? std::max(1.0, kOfSeen * seen.diagonal / largest) : 1.0;
}

}  // namespace

const Cloud& Detector::Workspace::begin(const Cloud& cloud, const Effort& frame_effort) {
  effort = &frame_effort;
  share_in_time = 1.0;
  cut_short = false;
  wanted_samples = 0;
  samples.clear();
  all_samples.clear();
  segments.clear();
  verification.begin({});
  normal_source.reset();
  forgetResult();
  depth_camera = false;
  if (!cloud.isConsistent()) {
    result.status = Status::rejected_input;
    result.points_in = static_cast<std::uint32_t>(cloud.size());
    return cloud;
  }
  const Cloud& enough = thinned_image.of(cloud);
  result.points_in = static_cast<std::uint32_t>(cloud.size()) * cloud.step * cloud.step;
  const std::uint32_t each = enough.step * enough.step;
  each_pixel = each;
  // Of sides that the step does not divide some pixels are more than their share.
  result.points_used = std::min(enough.valid_count * each, result.points_in);
  result.status = statusOf(enough);
  if (result.status != Status::ok) return cloud;
  brings_normals = bringsNormals(enough);
  const Cloud& seen = arrangement.of(enough, brings_normals);
  normal_source.rays = arrangement.rays();
  result.seen_from_origin = arrangement.seenFromOrigin();
  // Of lists with normals only points behind the sensor would tell: too little to refuse anything for. The paper's way
  // is left as it is.
  normal_source.from_origin = params.verify && result.seen_from_origin && !brings_normals;
  labeling.begin(seen);
  depth_camera = params.verify && params.inlier_depth_share > 0.0 && mayBeOfDepthCamera(seen);
  voting.setReferences(atThisEffort(params.references));
  verification.setMinInliers(inliersAtThisEffort());
  return seen;
}

/// Any that are wanted; fields that hold none are as good as none.
bool Detector::Workspace::bringsNormals(const Cloud& cloud) const {
  const auto measured = [](float nx) { return !std::isnan(nx); };
  return params.use_cloud_normals && cloud.hasNormals() && std::any_of(cloud.nx.begin(), cloud.nx.end(), measured);
}

/// All but the memory of its lists.
void Detector::Workspace::forgetResult() {
  spare_outlines.shorten(result.items, 0);
  std::vector<Detection> items = std::move(result.items);
  result = {};
  result.items = std::move(items);
}

/// d_s, and what noise to expect, from the first samples.
void Detector::Workspace::measureScale() {
  const SeenSize view(samples);
  const double seen = depth_camera ? sceneDiameterOfDepth(view) : view.diagonal;
  result.scene_diameter = params.scene_diameter > 0.0 ? params.scene_diameter : seen;
  // All points in one place have no scale and no normals.
  if (!(view.diagonal > 0.0)) result.status = Status::too_few_points;
  constexpr double kJustSo = 1.0;
  tolerance = {NoiseModel{params.inlier_distance * result.scene_diameter},
               std::cos(params.inlier_angle_deg * M_PI / 180.0), kJustSo};
  // With noise that is the same everywhere, cones need their distant pairs.
  voting.pairWithAll(!depth_camera);
  const double largest = params.radius_bin * params.radius_bins * result.scene_diameter;
  const bool told = params.scene_diameter > 0.0;  // then lengths do not depend on what is in view
  const double stretch = depth_camera && !told ? radiusStretch(view, largest) : 1.0;
  voting.stretchRadii(stretch);
  // Of small batches more is explained before the next one votes: on 60 tables six tenths of the references find as
  // much. With 32, a sphere on the top of a paraboloid is believed (hard_scenes). Elsewhere, where noise is measured
  // and pairs are far apart, 1 % of small objects are lost with 64.
  constexpr std::size_t kBatchOfDepth = 64, kBatchOfOthers = 256;
  search.setBatch(depth_camera ? kBatchOfDepth : kBatchOfOthers);
  // Of a cylinder that lies across the short side of an image from so near that its radius is 1.5 times the diagonal 24
  // deg are in view: about as little as its curvature needs to be clear (curvature.cpp).
  constexpr double kOfView = 1.5;
  // A list may be one thing alone, which somebody has cut out: the radius of half a ball is a third of its diagonal,
  // that of half a short tube more. What brings normals and lies around the origin was seen from all sides, and is all
  // there.
  constexpr double kOfList = 0.4;
  const bool all_sides = brings_normals && !result.seen_from_origin;
  const double most = depth_camera ? kOfView : all_sides ? 0.0 : kOfList;
  const double view_radius = told ? 0.0 : most * view.diagonal;
  verification.begin({result.scene_diameter, depth_camera, result.image_noise, sample_noise, image_growth, stretch,
                      view_radius, !brings_normals, normal_source.from_origin});
}

void Detector::Workspace::measureImageNoise(const Cloud& image) {
  image_growth = 1.0, sample_noise = 0.0;
  if (!depth_camera || !isDepthImage(image) || !params.does(Step::image_noise)) return;
  const ImageNoise noise = primitect::measureImageNoise(image, normal_source, samples);
  result.image_noise = noise.scale;
  normal_source.noise_scale = toleratedScale(noise.scale);
  normal_source.grain = grainOf(noise);
  normal_source.usual_grain = usualGrainOf(noise);
  image_growth = growthOf(noise);
  // What brings normals has no windows that would move its samples.
  const bool steadies = params.does(Step::steady_points) && !brings_normals;
  normal_source.steadying = steadies ? steadyingOf(noise) : 0.0;
  sample_noise = noiseOfSteadied(noise, normal_source.steadying);
}

bool Detector::Workspace::prepareRound(const Cloud& cloud, int round) {
  draw(cloud, result.items, params.samples, round);
  done("sample");
  if (round == 0) measureImageNoise(cloud);
  if (round == 0) measureScale();
  if (result.status != Status::ok || samples.size() < kFewestPoints) return false;
  estimateNormals(cloud, params, normal_source, samples);
  const bool kept = brings_normals && !params.orient_normals;
  // Around a model at the origin all normals face away.
  if (round == 0) result.normals_face_away = kept && result.seen_from_origin && mostFaceAway(samples);
  done("normals");
  return true;
}

void Detector::Workspace::segmentByVotes() {
  voting.vote(samples, result.scene_diameter, candidates);
  done("vote");
  clusterCandidates(candidates, params, result.scene_diameter);
  selectSegments(samples, candidates, params, tolerance, segments);
  all_samples.append(samples);
  assignSamples(all_samples, params, tolerance, segments);
  describeSegments(segments, all_samples);
}

/// Normals that a list brings, or has from its nearest neighbours, may be too poor for its noise: then they are
/// measured anew.
bool Detector::Workspace::improveNormals(const Cloud& cloud) {
  constexpr double kPoor = 0.1, kWanted = 0.05;  // rad, about each axis
  if (!params.improve_normals || cloud.organized()) return false;
  const NoiseModel& noise = verification.noise();
  // With all samples noise that could not be measured is strong; where fewer are asked for, they may just be too few,
  // and a neighbour search would take several times what they save.
  const bool as_many_as_usual = atThisEffort(params.samples) >= static_cast<std::size_t>(Params().samples);
  const bool known = verification.noiseMeasured() || as_many_as_usual;
  const bool poor = known && noise.angle >= kPoor * kNormalDeviations;
  if (!poor) return false;
  normal_source.neighbor_count = neighborsFor(cloud, samples, noise.distance, kWanted, normal_source);
  estimateNormals(cloud, params, normal_source, samples);
  return true;
}

void Detector::Workspace::measureNoise(const Cloud& cloud) {
  search.measureNoise(samples, result.scene_diameter);
  if (improveNormals(cloud)) search.measureNoise(samples, result.scene_diameter);
}

void Detector::Workspace::segmentVerified(const Cloud& cloud, int round) {
  if (round == 0) measureNoise(cloud);
  const auto first = static_cast<std::uint32_t>(verification.samples().size());
  verification.addSamples(samples);
  const auto place = [first](std::uint32_t voter) { return first + voter; };
  round == 0 ? search.goOn(place) : search.run(samples, result.scene_diameter, place);
  verification.select();
  useVerified();
}

void Detector::Workspace::useVerified() {
  tolerance.noise = verification.noise();
  tolerance.deviations = kInlierDeviations;
  describeSegments(verification.segments(), verification.samples());
}

void Detector::Workspace::lookCloser(const Cloud& cloud) {
  List<bool> large;
  for (const Segment& segment : verification.segments()) {
    if (isDescribed(segment)) large.push_back(verification.isLargePlane(segment));
  }
  spare_outlines.keep(result.items, [&large](std::size_t k) { return large[k]; });
  draw(cloud, result.items, params.closer_samples, params.rounds);
  verification.weighLaterDraws(weightOfCloserSamples(cloud));
  done("sample");
  estimateNormals(cloud, params, normal_source, samples);
  done("normals");
  verification.addSamples(samples);
  voteAgain();
}

void Detector::Workspace::conclude(const Cloud& cloud) {
  verification.conclude([&](const Segment& segment) { return askImage(segment, cloud); });
  useVerified();
  result.refusals = verification.refusals();
}

/// What is left of all samples votes once more: together, samples of a small surface are enough.
void Detector::Workspace::voteAgain() {
  const List<std::uint32_t> rest = verification.unexplained();
  const Samples voters = verification.samples().part(rest);
  if (voters.size() < kFewestPoints) return;
  search.run(voters, result.scene_diameter, [&rest](std::uint32_t voter) { return rest[voter]; });
}

void Detector::Workspace::describeSegments(const List<Segment>& described, const Samples& of) {
  spare_outlines.shorten(result.items, 0);
  for (const Segment& segment : described) {
    if (!isDescribed(segment)) continue;
    auto outline = spare_outlines.take(kindOf(segment.candidate.shape));
    result.items.push_back(describe(segment, of, !params.verify, std::move(outline)));
  }
  result.samples = static_cast<std::uint32_t>(of.size());
}

}  // namespace primitect
