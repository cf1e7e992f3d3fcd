// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tubes, cones and balls in the image: whether it shows them, and things of one radius on one axis, each a detection of
// its own; see workspace.h.
#include <algorithm>
#include <optional>

#include "core/bulge.h"
#include "core/evidence.h"
#include "core/extent.h"
#include "core/far_sides.h"
#include "core/measurement.h"
#include "core/open_ball.h"
#include "core/seen_share.h"
#include "core/tube_gaps.h"
#include "core/workspace.h"

namespace primitect {
namespace {

using ImageSays = Verification::ImageSays;

/// What samples saw of it; nothing: they saw none of it.
std::optional<AxisPart> seenBySamples(const AxisPart& part, const Detection& tube) {
  const auto half = static_cast<float>(0.5 * tube.extent.size.z());
  const AxisPart seen = {std::max(part.low, -half), std::min(part.high, half)};
  return seen.low < seen.high ? std::optional<AxisPart>(seen) : std::nullopt;
}

/// With each of the pixels eight around it that are on the surface, too: samples are few.
List<std::uint32_t> around(const List<std::uint32_t>& pixels, const Detection& found, const AskedImage& image) {
  constexpr int kStep = 2;             // pixels next to each other err alike
  constexpr double kDeviations = 3.0;  // of what is on the surface
  const Cloud& cloud = image.cloud;
  const auto width = static_cast<int>(cloud.width), height = static_cast<int>(cloud.height);
  List<std::uint32_t> on_surface;
  for (const std::uint32_t pixel : pixels) {
    const int column = static_cast<int>(pixel) % width, row = static_cast<int>(pixel) / width;
    for (int k = 0; k < 9; ++k) {
      const int c = column + kStep * (k % 3 - 1), r = row + kStep * (k / 3 - 1);
      if (c < 0 || c >= width || r < 0 || r >= height) continue;
      const auto i = static_cast<std::uint32_t>(r * width + c);
      if (!cloud.valid(i)) continue;
      const Vec3 point = cloud.point(i);
      if (std::abs(distance(found.shape, point)) < kDeviations * image.sigma(point)) on_surface.push_back(i);
    }
  }
  return on_surface;
}

/// A part that is reported.
struct Thing {
  std::size_t part, count;  ///< number of the part; points in it
  AxisPart seen;
};

}  // namespace

/// Of a cylinder or a cone, whether the image shows too little of it, of every part along its axis, or that it bulges;
/// of a ball, whether the camera looks into it. What is refused for it is refused while others may still have its
/// samples: of 70 things that a simulated Kinect, which is not part of this, saw in 160 frames and that were missing, 5
/// lay in a tube or cone that was refused at the end.
Verification::ImageSays Detector::Workspace::askImage(const Segment& segment, const Cloud& cloud) {
  if (!depth_camera || !isDepthImage(cloud) || arrangement.isApproximate()) return ImageSays::nothing;
  const PointNoise sigma(verification.fullNoise());
  const AskedImage image{cloud, raysOf(cloud, normal_source), depthRangeOf(params), sigma};
  if (const Sphere* ball = std::get_if<Sphere>(&segment.candidate.shape)) {
    return segment.candidate.concave || !isOpen(*ball, image) ? ImageSays::nothing : ImageSays::not_seen;
  }
  Detection found;
  found.shape = segment.candidate.shape, found.concave = segment.candidate.concave;
  SeenPoints seen_points;
  seen_points.gather(verification.samples(), segment.inliers);
  found.extent = measureExtent(found.shape, seen_points, {});
  List<std::uint32_t> pixels;
  for (const std::uint32_t i : segment.inliers) pixels.push_back(verification.samples().index[i]);
  if (!isSeenSomewhere(found, pixels, image)) return ImageSays::not_seen;
  if (!params.does(Step::trust_in_evenness)) return ImageSays::nothing;
  seen_points.gather(cloud, around(pixels, found, image));
  const Bulge bulge = bulgeOf(found.shape, seen_points, found.extent, sigma);
  return mayBeSliceOfBall(bulge) ? ImageSays::bulges : ImageSays::nothing;
}

/// The first part that has enough points keeps the label, each other one gets one of its own. Parts with fewer are of
/// nothing. False: none has enough, and it stays as it is.
bool Detector::Workspace::giveToParts(const List<AxisPart>& parts, std::size_t of, const Cloud& whole,
                                      const List<LabelRun>& runs) {
  const Cloud& cloud = thinned.cloud();
  const Detection tube = result.items[of];  // has no outline
  const auto partAt = [&](std::uint32_t i) {
    const float height = heightOn(tube, cloud, i);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool below = k == 0 && height < parts[k].low, above = k + 1 == parts.size() && height > parts[k].high;
      if (parts[k].holds(height) || below || above) return static_cast<int>(k);
    }
    return -1;
  };
  List<std::size_t> counts(parts.size(), 0);
  for (const std::uint32_t i : points[of].index) {
    const int part = partAt(i);
    if (part >= 0) ++counts[static_cast<std::size_t>(part)];
  }
  const auto least = static_cast<double>(fewestPoints(kindOf(tube.shape), whole));
  const auto all = static_cast<double>(points[of].all), seen = static_cast<double>(points[of].index.size());
  List<Thing> things;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::optional<AxisPart> part_seen = seenBySamples(parts[k], tube);
    if (part_seen && all * static_cast<double>(counts[k]) >= least * seen) things.push_back({k, counts[k], *part_seen});
  }
  if (things.empty()) return false;
  const auto before = static_cast<std::uint32_t>(of + 1);
  List<std::uint32_t> label_of(parts.size(), 0);
  for (const Thing& thing : things) {
    const std::uint32_t label = &thing == &things.front() ? before : addPart(tube.shape, of);
    label_of[thing.part] = label;
    Detection& item = result.items[label - 1];
    item = tube;
    keepTo(thing.seen, item.shape, item.extent);
    far_sides[label - 1] = far_sides[of];
    // What speaks for the only one is not less for some crumbs beside it.
    if (things.size() > 1) takeShare(static_cast<double>(thing.count) / seen, item);
  }
  relabel(runs, before, label_of, partAt);
  for (std::uint32_t& label : label_of) label |= label > 0 ? kFarSide : 0u;
  relabel(runs, before | kFarSide, label_of, partAt);
  return true;
}

void Detector::Workspace::takeTubesApart(const Cloud& whole, const ImageRays& rays, List<LabelRun>& runs) {
  if (!depth_camera || !rays.known || !params.does(Step::tubes_apart)) return;
  const PointNoise sigma(verification.fullNoise());
  const DepthRange range = depthRangeOf(params);
  const AskedImage image{thinned.cloud(), rays, range, sigma};
  bool any = false;
  for (std::size_t k = 0, count = result.items.size(); k < count; ++k) {
    if (!kept[k] || !hasAxis(kindOf(result.items[k].shape))) continue;
    const List<AxisPart> parts = partsOfTube(result.items[k], points[k].index, image);
    if (parts.size() > 1 && giveToParts(parts, k, whole, runs)) any = true;
  }
  if (!any) return;
  gatherAnew(runs);
}

}  // namespace primitect
