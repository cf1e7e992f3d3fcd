// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame and what they keep between frames; only for detector.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/arrangement.h"
#include "core/clear_points.h"
#include "core/clustering.h"
#include "core/dense_fit.h"
#include "core/extent.h"
#include "core/far_sides.h"
#include "core/frame_memory.h"
#include "core/labeling.h"
#include "core/level_top.h"
#include "core/measurement.h"
#include "core/neighbors.h"
#include "core/normals.h"
#include "core/pair_voting.h"
#include "core/plane_parts.h"
#include "core/sampling.h"
#include "core/search.h"
#include "core/segmentation.h"
#include "core/spare_outlines.h"
#include "core/strip.h"
#include "core/thinned_cloud.h"
#include "core/verification.h"
#include "primitect/detector.h"

namespace primitect {

inline Status statusOf(const Cloud& cloud) {
  if (cloud.valid_count == 0) return Status::empty_input;
  return cloud.valid_count < kFewestPoints ? Status::too_few_points : Status::ok;
}

inline bool isDescribed(const Segment& segment) { return !segment.inliers.empty(); }

/// last: nothing will be measured on the points of the cloud. outline: whose memory its own is to have.
inline Detection describe(const Segment& segment, const Samples& samples, bool last, std::vector<Vec3> outline) {
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

/// What a detector keeps between frames so that it need not be allocated anew.
struct Detector::Workspace {
  explicit Workspace(const Params& checked_params)
      : params(checked_params),
        voting(checked_params),
        verification(checked_params),
        search(voting, verification, [this](const char* stage) { done(stage); }) {}

  void done(const char* stage) const {
    if (!stage_done) return;
    const FrameMemoryScope others(nullptr);  // what a callback makes is not the frame's
    stage_done(stage);
  }

  /// Of all rounds of this frame.
  const Samples& allSamples() const { return params.verify ? verification.samples() : all_samples; }

  /// Forgets the last frame and looks whether this one can be used. Returns the cloud to work on.
  const Cloud& begin(const Cloud& cloud, const Effort& frame_effort) {
    effort = &frame_effort;
    out_of_time = false;
    samples.clear();
    all_samples.clear();
    segments.clear();
    verification.begin({});
    normal_source.reset();
    forgetResult();
    result.points_in = static_cast<std::uint32_t>(cloud.size());
    result.points_used = cloud.valid_count;
    result.status = statusOf(cloud);
    depth_camera = false;
    if (result.status != Status::ok) return cloud;
    brings_normals = bringsNormals(cloud);
    const Cloud& seen = arrangement.of(cloud, brings_normals);
    normal_source.rays = arrangement.rays();
    result.seen_from_origin = arrangement.seenFromOrigin();
    labeling.begin(seen);
    depth_camera = params.verify && params.inlier_depth_share > 0.0 && mayBeOfDepthCamera(seen);
    voting.setReferences(atThisEffort(params.references));
    verification.setMinInliers(inliersAtThisEffort());
    return seen;
  }

  /// Any that are wanted; fields that hold none are as good as none.
  bool bringsNormals(const Cloud& cloud) const {
    const auto measured = [](float nx) { return !std::isnan(nx); };
    return params.use_cloud_normals && cloud.hasNormals() && std::any_of(cloud.nx.begin(), cloud.nx.end(), measured);
  }

  /// All but the memory of its lists.
  void forgetResult() {
    spare_outlines.shorten(result.items, 0);
    std::vector<Detection> items = std::move(result.items);
    result = {};
    result.items = std::move(items);
  }

  /// How many of what there are at full effort. With depth cameras less will do: their noise is known, and large
  /// planes, which the closer look leaves out, hold most of their points. Measured on 240 tables: of what is found .4 %
  /// more is right, .2 % less is found, in a sixth less time.
  std::size_t atThisEffort(int count) const {
    constexpr double kOfDepthCameras = 0.75;
    const double share = std::max(effort->share * (depth_camera ? kOfDepthCameras : 1.0), leastShare(params));
    return static_cast<std::size_t>(std::ceil(share * count));
  }

  /// As few as the same surface gets at this effort: or small ones that are seen would be refused. Less than a dozen
  /// samples on one surface may be chance.
  int inliersAtThisEffort() const {
    constexpr int kFewest = 12;
    return std::min(params.min_inliers, std::max(kFewest, static_cast<int>(atThisEffort(params.min_inliers))));
  }

  /// True from the first time on that the effort's owner says so.
  bool outOfTime() {
    const FrameMemoryScope others(nullptr);
    out_of_time = out_of_time || (effort->out_of_time && effort->out_of_time());
    return out_of_time;
  }

  /// How many pixels of a depth image a sample needs for itself: where the windows that normals are fitted to overlap
  /// more, another sample tells nothing new. 0 where normals are not from windows.
  double pixelsOfSample(const Cloud& cloud) {
    constexpr double kOfUsualWindow = 24.0;
    if (!depth_camera || brings_normals) return 0.0;
    const double share = shareOfUsualWindows(raysOf(cloud, normal_source));
    return kOfUsualWindow * share * share;
  }

  /// In a small part of a depth image samples could lie side by side, and what errs in one would err in all: slivers of
  /// a flank pass for planes. Measured on 120 objects cut out of tables (compare --set objects, seeds 1, 2300, 7000):
  /// as many are found either way, precision is 96 to 99 % instead of 80 to 86 %, in a third of the time.
  std::size_t mostSamples(const Cloud& cloud) {
    constexpr double kFewest = 64.0;
    const double pixels = pixelsOfSample(cloud);
    if (pixels == 0.0) return cloud.size();
    return static_cast<std::size_t>(std::ceil(std::max(cloud.valid_count / std::max(pixels, 1.0), kFewest)));
  }

  /// Draws samples from the points that none of these explains.
  void draw(const Cloud& cloud, const std::vector<Detection>& explaining, int count, int round) {
    // Wider than what makes an inlier: the outskirts of a noisy surface are no new one.
    constexpr double kOutskirts = 2.0;
    const PointRuns& runs = labeling.someRuns();
    if (round == 0) {
      sampler.begin(cloud, runs);
    } else {
      labeling.findUnexplained(explaining, tolerance.scaled(kOutskirts), runs, unexplained);
      sampler.keepTo(unexplained);
    }
    sampler.draw(std::min(atThisEffort(count), mostSamples(cloud)), static_cast<std::uint64_t>(params.seed) + round,
                 samples);
  }

  /// d_s of the first samples; 0 when all are in one place. With a depth camera at least their mean depth, or what was
  /// cut out of its image, like one object, would be looked at with bins and pairs so small that they tell only noise,
  /// and for radii smaller than its own.
  double sceneDiameter() const {
    const double seen = boundingBoxDiagonal(samples);
    if (!depth_camera || !(seen > 0.0)) return seen;
    const double depth = std::accumulate(samples.z.begin(), samples.z.end(), 0.0) / static_cast<double>(samples.size());
    return std::max(seen, depth);
  }

  /// d_s, and what noise to expect, from the first samples.
  void measureScale() {
    result.scene_diameter = params.scene_diameter > 0.0 ? params.scene_diameter : sceneDiameter();
    // All points in one place have no scale and no normals.
    if (!(result.scene_diameter > 0.0)) result.status = Status::too_few_points;
    constexpr double kJustSo = 1.0;
    tolerance = {NoiseModel{params.inlier_distance * result.scene_diameter},
                 std::cos(params.inlier_angle_deg * M_PI / 180.0), kJustSo};
    // With noise that is the same everywhere, cones need their distant pairs.
    voting.pairWithAll(!depth_camera);
    verification.begin({result.scene_diameter, depth_camera});
  }

  /// The samples of a round, with normals; false when there is nothing left to vote.
  bool prepareRound(const Cloud& cloud, int round) {
    draw(cloud, result.items, params.samples, round);
    done("sample");
    if (round == 0) measureScale();
    if (result.status != Status::ok || samples.size() < kFewestPoints) return false;
    estimateNormals(cloud, params, normal_source, samples);
    done("normals");
    return true;
  }

  /// The paper's way: what most references agree on.
  void segmentByVotes() {
    voting.vote(samples, result.scene_diameter, candidates);
    done("vote");
    clusterCandidates(candidates, params, result.scene_diameter);
    selectSegments(samples, candidates, params, tolerance, segments);
    all_samples.append(samples);
    assignSamples(all_samples, params, tolerance, segments);
    describeSegments(segments, all_samples);
  }

  /// Normals that the cloud brings may be too poor for its noise: then they are measured anew.
  bool improveNormals(const Cloud& cloud) {
    constexpr double kPoor = 0.1, kWanted = 0.05;  // rad, about each axis
    const NoiseModel& noise = verification.noise();
    const bool own = params.use_cloud_normals && cloud.hasNormals() && !cloud.organized();
    // With all samples noise that could not be measured is strong; with less effort they may just be too few.
    const bool known = verification.noiseMeasured() || effort->share >= 1.0;
    const bool poor = known && noise.angle >= kPoor * kNormalDeviations;
    if (!params.improve_normals || !own || !poor) return false;
    normal_source.neighbor_count = neighborsFor(cloud, samples, noise.distance, kWanted, normal_source);
    estimateNormals(cloud, params, normal_source, samples);
    return true;
  }

  void measureNoise(const Cloud& cloud) {
    search.measureNoise(samples, result.scene_diameter);
    if (improveNormals(cloud)) search.measureNoise(samples, result.scene_diameter);
  }

  void segmentVerified(const Cloud& cloud, int round) {
    if (round == 0) measureNoise(cloud);
    const auto first = static_cast<std::uint32_t>(verification.samples().size());
    verification.addSamples(samples);
    const auto place = [first](std::uint32_t voter) { return first + voter; };
    round == 0 ? search.goOn(place) : search.run(samples, result.scene_diameter, place);
    verification.select();
    useVerified();
  }

  void useVerified() {
    tolerance.noise = verification.noise();
    tolerance.deviations = kInlierDeviations;
    describeSegments(verification.segments(), verification.samples());
  }

  /// More samples where the shapes are, without the points of large planes: these need no closer look.
  void lookCloser(const Cloud& cloud) {
    List<bool> large;
    for (const Segment& segment : verification.segments()) {
      if (isDescribed(segment)) large.push_back(verification.isLargePlane(segment));
    }
    spare_outlines.keep(result.items, [&large](std::size_t k) { return large[k]; });
    draw(cloud, result.items, params.closer_samples, params.rounds);
    done("sample");
    estimateNormals(cloud, params, normal_source, samples);
    done("normals");
    verification.addSamples(samples);
    voteAgain();
  }

  /// What is there, and how likely; refuses what is not likely enough.
  void conclude() {
    verification.conclude();
    useVerified();
    result.refusals = verification.refusals();
  }

  /// What is left of all samples votes once more: together, samples of a small surface are enough.
  void voteAgain() {
    const List<std::uint32_t> rest = verification.unexplained();
    const Samples voters = verification.samples().part(rest);
    if (voters.size() < kFewestPoints) return;
    search.run(voters, result.scene_diameter, [&rest](std::uint32_t voter) { return rest[voter]; });
  }

  /// What the measures are taken from: the cloud, or where it is large a part of it. An image that was made of a cloud
  /// stays whole: its pixels stand for different numbers of points.
  void thin(const Cloud& whole) {
    arrangement.projected() ? thinned.keep(whole) : thinned.begin(whole, labeling.someRuns());
    if (thinned.thinned()) labeling_of_thinned.begin(thinned.cloud());
  }

  void findPoints(Labeling& of_cloud) {
    of_cloud.label(result.items, tolerance, of_cloud.allRuns(), labels);
    far_sides.clear();
    if (depth_camera) far_sides = markFarSides(thinned.cloud(), result.items, labels);
    pointsOfLabels(labels, mostPoints(), points);
    if (arrangement.projected()) {  // a pixel may hold several points of the cloud
      const List<std::size_t> all = arrangement.projected()->pointsOfLabels(labels, points.size());
      for (std::size_t k = 0; k < points.size(); ++k) points[k].all = all[k];
      return;
    }
    for (LabelledPoints& of_item : points) {
      of_item.all = static_cast<std::size_t>(std::llround(thinned.each() * static_cast<double>(of_item.all)));
    }
  }

  /// Of a small plane over the tops of several things only one of them. Its other points would be planes of their own
  /// more often wrongly than rightly: the closer look had too few samples of them.
  void keepToTops() {
    if (!depth_camera) return;
    const PointNoise sigma(verification.noise());
    std::size_t k = 0;
    for (const Segment& segment : verification.segments()) {
      if (!isDescribed(segment)) continue;
      LabelledPoints& of_item = points[k++];
      const bool small = kindOf(segment.candidate.shape) == Kind::plane && !verification.isLargePlane(segment);
      const std::optional<Vec3> level = small ? verification.levelOf(segment) : std::nullopt;
      if (!level || of_item.index.empty()) continue;
      const Plane& plane = std::get<Plane>(segment.candidate.shape);
      const std::size_t before = of_item.index.size();
      of_item.index = levelTop(thinned.cloud(), plane, *level, sigma, of_item.index);
      of_item.all = of_item.all * of_item.index.size() / before;
    }
  }

  /// The final numbers come from the points of the cloud.
  void measureOnCloud(const Cloud& whole) {
    thin(whole);
    findPoints(thinned.thinned() ? labeling_of_thinned : labeling);
    keepToTops();
    const Cloud& cloud = thinned.cloud();
    const CloudNormals normals = {params.use_cloud_normals && normal_source.neighbor_count <= 0, params.orient_normals};
    const ClearPoints clear(cloud, normals, result.items, labels, far_sides, verification.noise(), rangeOf(params));
    // Pixels of a projected image are not where a camera's were.
    const ImageRays rays =
        arrangement.projected() ? ImageRays() : everySoMany(thinned.step(), raysOf(whole, normal_source));
    Measurement measurement(cloud, rays, params, verification.noise(), verification.limits());
    const auto enough = [&](std::size_t k) {
      return points[k].all >= fewestPoints(kindOf(result.items[k].shape), whole);
    };
    const auto within = [this](std::size_t k) { return !isLine(result.items[k], verification.noise()); };
    const auto likely = [this](std::size_t k) { return result.items[k].confidence >= params.min_confidence; };
    for (std::size_t k = 0; k < result.items.size(); ++k) {
      if (!enough(k)) {
        ++result.refusals[Refusal::few_inliers];
        continue;
      }
      measurement.measure(points[k], clear.of(k, points[k].index), result.items[k]);
      if (!within(k)) {
        ++result.refusals[Refusal::limits];
      } else if (!likely(k)) {
        ++result.refusals[Refusal::unlikely];
      }
    }
    spare_outlines.keep(result.items, [&](std::size_t k) { return enough(k) && within(k) && likely(k); });
  }

  /// How many points the measures of each detection are taken from. 4096 instead of 2048: on the paper's scenes DOD is
  /// 0.04 sigma instead of 0.05 for 7 % more time, and planes of depth frames would take 3 % more of the frame's time;
  /// but errors of half angles in depth frames are 0.24 deg instead of 0.35 for 2 %.
  List<std::size_t> mostPoints() const {
    constexpr std::size_t kMost = 2048, kMostOfCurvedInDepth = 4096;
    List<std::size_t> most;
    for (const Detection& item : result.items) {
      most.push_back(depth_camera && kindOf(item.shape) != Kind::plane ? kMostOfCurvedInDepth : kMost);
    }
    return most;
  }

  /// The closer look may take every point of what is left: a shape has more of them than just those. Slivers that the
  /// flank of a tube leaves over, and crumbs of clutter, pass for planes: these need more, and in an image, where every
  /// sample stands for as many pixels, twice as much. There, with normals from windows, samples that are closer to each
  /// other than they are to tell something new count for fewer; of curved shapes, which chance makes less often, not by
  /// so much. Measured on 220 tables, 60 shuffled ones and 150 objects cut out of tables (seeds 2300 and following): as
  /// many are found, and .3, 1.1 and 2.5 % more of that is right.
  std::size_t fewestPoints(Kind kind, const Cloud& cloud) {
    constexpr double kOfCurved = 2.0 / 3.0;
    const bool curved = kind != Kind::plane, in_image = depth_camera && !arrangement.projected();
    // Of the points that as many samples stand for on average.
    const double least_share = curved ? 0.05 : in_image ? 0.3 : 0.15;
    // Without the closer look each of the few samples stands for no more than it would with it.
    const std::size_t drawn =
        out_of_time ? atThisEffort(params.rounds * params.samples + params.closer_samples) : result.samples;
    const double each = static_cast<double>(result.points_used) / static_cast<double>(std::max<std::size_t>(drawn, 1));
    const double least_pixels = (curved ? kOfCurved : 1.0) * pixelsOfSample(cloud);
    // As many as inliers were looked at; each of these stands for some of a large cloud.
    return static_cast<std::size_t>(inliersAtThisEffort() *
                                    std::max({thinned.each(), least_share * each, least_pixels}));
  }

  void describeSegments(const List<Segment>& described, const Samples& of) {
    spare_outlines.shorten(result.items, 0);
    for (const Segment& segment : described) {
      if (!isDescribed(segment)) continue;
      auto outline = spare_outlines.take(kindOf(segment.candidate.shape));
      result.items.push_back(describe(segment, of, !params.verify, std::move(outline)));
    }
    result.samples = static_cast<std::uint32_t>(of.size());
  }

  FrameMemory memory;  ///< of all lists of this detector: it outlives them
  Params params;
  std::function<void(const char*)> stage_done;
  const Effort* effort = nullptr;  ///< only while a frame runs
  bool out_of_time = false;        ///< in this frame
  bool brings_normals = false;     ///< the cloud of this frame, ones that are wanted
  bool depth_camera = false;       ///< took this frame, and shapes are verified with its noise, which is known
  Arrangement arrangement;
  PairVoting voting;
  Verification verification;
  Search search;
  Sampler sampler;
  Samples samples;             ///< of this round
  Samples all_samples;         ///< of all rounds of this frame, by votes alone
  Tolerance tolerance;         ///< of what belongs to a shape
  List<Candidate> candidates;  ///< by votes alone
  List<Segment> segments;      ///< by votes alone
  Labeling labeling;
  List<std::uint64_t> unexplained;  ///< bits of the points that samples are drawn from
  ThinnedCloud thinned;
  Labeling labeling_of_thinned;
  std::vector<std::uint32_t> labels;  ///< of the points of the thinned cloud
  List<bool> far_sides;               ///< which detections have points there
  List<LabelledPoints> points;        ///< of the detections
  NormalSource normal_source;         ///< of this frame
  SpareOutlines spare_outlines;
  Detections result;
};

}  // namespace primitect
