// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The last numbers of each shape, from the points of the cloud; see workspace.h.
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/bent_part.h"
#include "core/clear_points.h"
#include "core/ends_on_faces.h"
#include "core/evidence.h"
#include "core/extent.h"
#include "core/far_sides.h"
#include "core/interleaved.h"
#include "core/strip.h"
#include "core/workspace.h"

namespace primitect {
namespace {

/// Times as long along the three axes of its frame, about its origin.
void stretch(const Vec3& factors, Extent& extent) {
  extent.size = extent.size.cwiseProduct(factors);
  for (Vec3& corner : extent.hull) {
    const Vec3 there = extent.rotation.transpose() * (corner - extent.origin);
    corner = extent.origin + extent.rotation * there.cwiseProduct(factors);
  }
}

/// Sizes and corners of all extents, to be had back.
class HeldExtents {
 public:
  explicit HeldExtents(const std::vector<Detection>& items) {
    for (const Detection& item : items) {
      sizes_.push_back(item.extent.size);
      corners_.insert(corners_.end(), item.extent.hull.begin(), item.extent.hull.end());
    }
  }
  void giveBack(std::vector<Detection>& items) const {
    auto corner = corners_.begin();
    for (std::size_t k = 0; k < items.size(); ++k) {
      items[k].extent.size = sizes_[k];
      for (Vec3& of_item : items[k].extent.hull) of_item = *corner++;
    }
  }

 private:
  List<Vec3> sizes_, corners_;
};

/// The order in which they are measured: faces that axes end on before these.
List<std::size_t> planesFirst(const std::vector<Detection>& items) {
  List<std::size_t> order;
  for (const bool planes : {true, false}) {
    for (std::size_t k = 0; k < items.size(); ++k) {
      if ((kindOf(items[k].shape) == Kind::plane) == planes) order.push_back(k);
    }
  }
  return order;
}

/// By what was seen of it: a cone has no radius of its own.
bool isTooWideCone(const Detection& detection, const Params& params) {
  return kindOf(detection.shape) == Kind::cone && params.max_radius > 0.0 &&
         detection.extent.radius > params.max_radius;
}

}  // namespace

/// What the measures are taken from: the cloud, or of a large list a part of it.
void Detector::Workspace::thin(const Cloud& whole) {
  whole.organized() ? thinned.keep(whole) : thinned.begin(whole, labeling.someRuns());
  if (thinned.thinned()) labeling_of_thinned.begin(thinned.cloud());
}

/// Labels, whose runs these become, in parts somewhat larger than the samples saw. What has too few points to be
/// reported gives them to others: strips of the flanks of a tube, as planes. Of two that halve one surface neither is
/// kept: not seen on 60 tables.
void Detector::Workspace::labelStretched(Labeling& of_cloud, const Cloud& whole, List<LabelRun>& runs) {
  const HeldExtents of_samples(result.items);
  for (Detection& item : result.items) stretch(stretchOf(item), item.extent);
  of_cloud.label(result.items, tolerance, of_cloud.allRuns(), labels);
  runs = labelRuns(labels);
  kept = areEnough(countPoints(runs), whole);
  if (std::find(kept.begin(), kept.end(), false) != kept.end()) {
    of_cloud.labelWithout(result.items, kept, tolerance, of_cloud.allRuns(), runs, labels);
    List<bool> dropped;
    for (const bool keep : kept) dropped.push_back(!keep);
    runs = labelRunsAgain(runs, dropped, labels);
  }
  of_samples.giveBack(result.items);
}

/// Points of each shape, within its part and around it.
void Detector::Workspace::findPoints(const Cloud& whole, const ImageRays& rays) {
  List<LabelRun> runs;
  labelStretched(thinned.thinned() ? labeling_of_thinned : labeling, whole, runs);
  const Cloud& cloud = thinned.cloud();
  far_sides.assign(depth_camera ? result.items.size() : 0, false);
  if (depth_camera && params.does(Step::far_sides)) {
    far_sides = markFarSides(cloud, result.items, kept, tolerance, runs, labels);
    List<bool> curved;
    for (const Detection& item : result.items) curved.push_back(kindOf(item.shape) != Kind::plane);
    // Only these have far sides: .4 % of a frame's instructions less than all labels anew.
    runs = labelRunsAgain(runs, curved, labels);
  }
  gatherPoints(runs);
  takeTopsApart(whole, runs);
  takeFacesApart(whole, runs);
  takeTubesApart(whole, rays, runs);
}

void Detector::Workspace::gatherPoints(const List<LabelRun>& runs) {
  const Cloud& cloud = thinned.cloud();
  pointsOfLabels(runs, cloud.organized() ? cloud.width : 0, wantedPoints(), points);
  const List<std::size_t> all = countPoints(runs);
  for (std::size_t k = 0; k < points.size(); ++k) points[k].all = all[k];
}

/// After labels have changed.
void Detector::Workspace::gatherAnew(List<LabelRun>& runs) {
  runs = labelRuns(labels);
  gatherPoints(runs);
}

/// A detection of a part that was taken from another one. Returns its label.
std::uint32_t Detector::Workspace::addPart(const Shape& shape, std::size_t of) {
  Detection& item = result.items[of];
  std::vector<Vec3> outline;
  std::swap(outline, item.extent.hull);  // a copy would not be the frame's
  Detection part = item;
  std::swap(outline, item.extent.hull);
  part.shape = shape;
  part.extent.hull = spare_outlines.take(kindOf(shape));
  result.items.push_back(std::move(part));
  kept.push_back(true);
  far_sides.push_back(false);
  return static_cast<std::uint32_t>(result.items.size());
}

/// How many points of the whole cloud each detection has, as far as was looked.
List<std::size_t> Detector::Workspace::countPoints(const List<LabelRun>& runs) const {
  const std::size_t most = result.items.size();
  List<std::size_t> all(most, 0);
  if (arrangement.projected() && !arrangement.holdsAllPoints()) {  // a pixel may hold several points of the cloud
    all = arrangement.projected()->pointsOfLabels(labels, most);
  } else {
    for (const LabelRun& run : runs) {
      if (run.label <= most) all[run.label - 1] += run.end - run.begin;
    }
  }
  const double each = each_pixel * thinned.each();
  for (std::size_t& count : all) count = static_cast<std::size_t>(std::llround(each * static_cast<double>(count)));
  return all;
}

/// Which detections these numbers of points are enough for.
List<bool> Detector::Workspace::areEnough(const List<std::size_t>& all, const Cloud& whole) {
  List<bool> enough;
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    enough.push_back(all[k] >= fewestPoints(kindOf(result.items[k].shape), whole));
  }
  return enough;
}

/// Samples end before the surface does, at the tip of a cone by a fifth of its length, at the corner of a plane by more
/// than they are apart: points are looked for beyond. But where that is much of a plane, of few samples or narrow, what
/// lies beside it would count as its own: .2 % less of what is found on 280 tables was right, and the front of a flat
/// box, 28 mm high, tilted by 3 deg towards the table. Nor are planes of lists longer than samples saw them: of 100
/// unevenly dense scenes and mechanical parts .1 to .2 % less of what is found was right.
Vec3 Detector::Workspace::stretchOf(const Detection& item) const {
  constexpr double kSpacings = 0.3;             // of samples, on each side of a plane
  constexpr double kMost = 0.2;                 // of a plane's width or length: with more it stays as it is
  constexpr std::uint32_t kEnoughSamples = 64;  // of a plane
  const Kind kind = kindOf(item.shape);
  Vec3 factors = Vec3::Ones();
  if (hasAxis(kind)) factors.z() = stretchOfAxis(item);
  if (!depth_camera || kind != Kind::plane || item.inlier_count < kEnoughSamples) return factors;
  const Eigen::Vector2d size = item.extent.size.head<2>();
  const double more = 2.0 * kSpacings * std::sqrt(size.prod() / item.inlier_count);
  for (int k = 0; k < 2; ++k) {
    if (more < kMost * size[k]) factors[k] += more / size[k];
  }
  return factors;
}

/// The share of its surface that an image shows tells what was taken from others (seen_share.h). In a list nothing
/// does: a can that lies on a table would go on along the line where they touch, by up to 40 % with half as much again.
double Detector::Workspace::stretchOfAxis(const Detection& item) const {
  constexpr double kInDepth = 1.5, kOfCones = 1.3, kSpacings = 1.5;  // of samples, at each end of a tube
  if (depth_camera) return kInDepth;
  if (kindOf(item.shape) == Kind::cone) return kOfCones;
  const double length = item.extent.size.z(), area = 2.0 * M_PI * item.extent.radius * length;
  return std::min(kInDepth, 1.0 + 2.0 * kSpacings * std::sqrt(area / item.inlier_count) / length);
}

/// Of the detections that were measured.
void Detector::Workspace::distrustBentParts(const List<bool>& measured) {
  if (!depth_camera || !params.does(Step::bent_parts)) return;
  const bool of_list = arrangement.projected() && !arrangement.isApproximate();
  const std::uint8_t cut_off = of_list ? kTruncatedByImage | kTruncationUnknown : kTruncatedByImage;
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    for (std::size_t other = 0; other < result.items.size(); ++other) {
      if (!measured[k] || !measured[other] || result.items[other].confidence < leastWhileChoosing(params)) continue;
      const bool bent = isBentPart(result.items[k], result.items[other], verification.noise(), cut_off);
      if (bent) result.items[k].confidence = 0.0f;
    }
  }
}

/// Of the detections that were measured, of which these are the points; the smaller one of two.
void Detector::Workspace::distrustInterleaved(const List<bool>& measured, const Cloud& cloud) {
  if (!depth_camera || !params.does(Step::interleaved)) return;
  const double least = leastWhileChoosing(params);
  const auto counts = [&](std::size_t k) { return measured[k] && result.items[k].confidence >= least; };
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    for (std::size_t other = 0; other < result.items.size(); ++other) {
      if (other == k || !counts(k) || !counts(other)) continue;
      const bool among =
          isAmong(result.items[k], result.items[other], points[other].index, cloud, verification.noise());
      if (among) result.items[k].confidence = 0.0f;
    }
  }
}

/// By the clear points of the large planes of a depth camera, which are likely.
DepthWaves Detector::Workspace::findWaves(const List<List<std::uint32_t>>& clear_points) {
  constexpr std::size_t kOneIn = 50;  // of all points
  if (!depth_camera || !params.does(Step::depth_waves)) return {};
  WaveFinder finder;
  SeenPoints seen;
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    const Detection& item = result.items[k];
    if (kindOf(item.shape) != Kind::plane || item.confidence < leastWhileChoosing(params)) continue;
    if (kOneIn * points[k].all < result.points_used) continue;
    seen.gather(thinned.cloud(), clear_points[k]);
    finder.see(seen);
  }
  const DepthWaves waves = finder.waves();
  if (finder.hasSeen()) result.depth_waves = waves.share();
  return waves;
}

void Detector::Workspace::measureOnCloud(const Cloud& whole) {
  thin(whole);
  // Pixels of an image that is only like the camera's are not where its were.
  ImageRays rays = arrangement.isApproximate() ? ImageRays() : raysOf(whole, normal_source);
  rays.border_known = !arrangement.projected();
  findPoints(whole, rays);
  const Cloud& cloud = thinned.cloud();
  const CloudNormals normals = {params.use_cloud_normals && normal_source.neighbor_count <= 0, params.orient_normals};
  const ClearPoints clear(cloud, normals, result.items, kept, labels, far_sides, verification.noise(),
                          depthRangeOf(params));
  List<std::size_t> left;
  for (const LabelledPoints& of_item : points) left.push_back(of_item.all);
  const List<bool> enough = areEnough(left, whole);  // and none of what was not kept
  List<List<std::uint32_t>> clear_points(result.items.size());
  const bool take_all = !params.does(Step::clear_points);
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    if (enough[k]) clear_points[k] = take_all ? points[k].index : clear.of(k, points[k].index);
  }
  const DepthWaves waves = findWaves(clear_points);
  const MeasurementNoise noise = {verification.noise(), verification.fullNoise(), waves};
  Measurement measurement(cloud, rays, params, noise, {params, verification.largestRadius()});
  const auto broken = [this](std::size_t k) -> std::optional<Refusal> {
    if (isLine(result.items[k], verification.noise())) return Refusal::too_small;
    return isTooWideCone(result.items[k], params) ? std::optional<Refusal>(Refusal::too_large) : std::nullopt;
  };
  const auto likely = [this](std::size_t k) { return result.items[k].confidence >= params.min_confidence; };
  for (const std::size_t k : planesFirst(result.items)) {
    if (!enough[k]) continue;
    ClearPoints::OnSurface on_surface(clear, k, clear_points[k]);
    measurement.measure(points[k], clear_points[k], std::ref(on_surface), result.items[k]);
    result.items[k].inlier_count = std::min(result.items[k].inlier_count, result.points_used);
  }
  distrustBentParts(enough);
  distrustInterleaved(enough, cloud);
  distrustUnevenFaces(enough);
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    if (!enough[k]) {
      ++result.refusals[Refusal::few_inliers];
    } else if (const auto refusal = broken(k)) {
      ++result.refusals[*refusal];
    } else if (!likely(k)) {
      ++result.refusals[Refusal::unlikely];
    }
  }
  spare_outlines.keep(result.items, [&](std::size_t k) { return enough[k] && !broken(k) && likely(k); });
  nameEndFaces(verification.fullNoise(), result.items);
}

/// How many points the measures of each detection are taken from. 4096 instead of 2048: on the paper's scenes DOD is
/// 0.04 sigma instead of 0.05 for 7 % more time, and planes of depth frames would take 3 % more of the frame's time;
/// but errors of half angles in depth frames are 0.24 deg instead of 0.35 for 2 %.
List<WantedPoints> Detector::Workspace::wantedPoints() const {
  constexpr std::size_t kMost = 2048, kMostOfCurvedInDepth = 4096;
  List<WantedPoints> wanted;
  for (const Detection& item : result.items) {
    const bool curved = kindOf(item.shape) != Kind::plane;
    wanted.push_back({depth_camera && curved ? kMostOfCurvedInDepth : kMost, curved});
  }
  return wanted;
}

/// The closer look may take every point of what is left: a shape has more of them than just those. Slivers that the
/// flank of a tube leaves over, and crumbs of clutter, pass for planes: these need more, and in an image, where every
/// sample stands for as many pixels, twice as much. There, with normals from windows, samples that are closer to each
/// other than they are to tell something new count for fewer; of curved shapes, which chance makes less often, not by
/// so much. Measured on 220 tables, 60 shuffled ones and 150 objects cut out of tables (seeds 2300 and following): as
/// many are found, and .3, 1.1 and 2.5 % more of that is right.
std::size_t Detector::Workspace::fewestPoints(Kind kind, const Cloud& cloud) {
  constexpr double kOfCurved = 2.0 / 3.0;
  const bool curved = kind != Kind::plane, in_image = depth_camera && !arrangement.isApproximate();
  // Of the points that as many samples stand for on average.
  const double least_share = curved ? 0.05 : in_image ? 0.3 : 0.15;
  // Without all of the closer look each of the few samples stands for no more than it would with it.
  const std::size_t drawn =
      cut_short ? atThisEffort(params.rounds * params.samples + params.closer_samples) : result.samples;
  const double each = static_cast<double>(result.points_used) / static_cast<double>(std::max<std::size_t>(drawn, 1));
  const double least_pixels = (curved ? kOfCurved : 1.0) * pixelsOfSample(cloud);
  // As many as inliers were looked at; each of these stands for some of a large cloud.
  const double least = std::max(each_pixel * std::max(thinned.each(), least_pixels), least_share * each);
  return static_cast<std::size_t>(inliersAtThisEffort() * least);
}

}  // namespace primitect
