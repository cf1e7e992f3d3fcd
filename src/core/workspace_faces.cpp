// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie in one plane, each a detection of its own; see workspace.h.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/evidence.h"
#include "core/face_misfit.h"
#include "core/observed_part.h"
#include "core/point_noise.h"
#include "core/workspace.h"

namespace primitect {
namespace {

/// To be left over of a plane that is taken apart: a share of its pixels.
constexpr double kMuch = 0.1;

}  // namespace

/// Those of the planes (index of the detection) that are kept, in the image.
List<Detector::Workspace::PlaneInImage> Detector::Workspace::planesInImage(const List<LabelRun>& runs) const {
  constexpr std::size_t kNoPlane = ~std::size_t{0};
  const std::uint32_t width = thinned.cloud().width;
  const List<PixelBox> boxes = boxesOfLabels(runs, result.items.size(), width);
  List<PlaneInImage> planes;
  List<std::size_t> plane_of(boxes.size(), kNoPlane);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const bool seen = boxes[k].left <= boxes[k].right;
    if (!seen || !kept[k] || kindOf(result.items[k].shape) != Kind::plane) continue;
    plane_of[k] = planes.size();
    planes.push_back({k, FacesApart(boxes[k], width)});
  }
  for (const LabelRun& run : runs) {
    const std::size_t k = run.label - 1;
    if (k < plane_of.size() && plane_of[k] != kNoPlane) planes[plane_of[k]].faces.add(run);
  }
  return planes;
}

/// By so much that noise takes none of its points beyond.
bool Detector::Workspace::endsBeforeTheBound(std::size_t plane) const {
  constexpr double kDeviations = 2.0 * kInlierDeviations;
  const Cloud& cloud = thinned.cloud();
  const List<std::uint32_t>& index = points[plane].index;
  if (index.empty()) return true;
  const auto byDepth = [&cloud](std::uint32_t a, std::uint32_t b) { return cloud.z[a] < cloud.z[b]; };
  const auto reaches = [&](std::uint32_t i) {
    const Vec3 point = cloud.point(i);
    return depthRangeOf(params).endsWithin(kDeviations * verification.noise().at(point), point.z());
  };
  const auto [nearest, farthest] = std::minmax_element(index.begin(), index.end(), byDepth);
  return !reaches(*nearest) && !reaches(*farthest);
}

/// In cells half as wide, too, while much is left over: faces may be too narrow for those before. But smaller cells
/// also see a path where another surface passes through the plane, and find fewer faces then.
void Detector::Workspace::findFaces(const List<LabelRun>& runs, std::size_t least, PlaneInImage& plane) {
  constexpr double kStrips = 0.7;  // at the border of whole planes: of 5 x 5 cells .64
  const LabelledImage image = {thinned.cloud(), labels, verification.noise(), endsBeforeTheBound(plane.of)};
  const Plane& shape = std::get<Plane>(result.items[plane.of].shape);
  const auto tooWide = [](const FacesApart& faces) {
    return faces.left() > (faces.faces().size() > 1 ? kMuch : kStrips);
  };
  plane.faces.find(image, shape, least);
  while (tooWide(plane.faces) && !plane.faces.finest()) {
    FacesApart finer = plane.faces.finer();
    for (const LabelRun& run : runs) {
      if (run.label == plane.of + 1) finer.add(run);
    }
    finer.find(image, shape, least);
    if (finer.faces().size() < plane.faces.faces().size()) return;
    plane.faces = std::move(finer);
  }
}

/// The curved shape (index of the detection) on whose observed part nearly all of these pixels of a plane lie, if there
/// is one.
std::optional<std::size_t> Detector::Workspace::curvedUnder(const List<std::uint32_t>& pixels) const {
  constexpr double kMost = 0.9;
  constexpr std::size_t kAsked = 256;  // pixels, spread evenly
  const Cloud& cloud = thinned.cloud();
  const std::size_t step = pixels.size() / kAsked + 1, asked = (pixels.size() + step - 1) / step;
  const auto most_beside = static_cast<std::size_t>((1.0 - kMost) * static_cast<double>(asked));
  for (std::size_t k = 0; k < result.items.size() && asked > 0; ++k) {
    const Detection& item = result.items[k];
    if (!kept[k] || kindOf(item.shape) == Kind::plane) continue;
    const ObservedPart part(item.shape, item.extent);
    std::size_t beside = 0;
    for (std::size_t j = 0; j < pixels.size() && beside <= most_beside; j += step) {
      const Vec3 point = cloud.point(pixels[j]);
      const double near = kInlierDeviations * verification.noise().at(point);
      const auto margin = static_cast<float>(near);
      const bool on = std::abs(distance(item.shape, point)) < near &&
                      part.holds(cloud.x[pixels[j]], cloud.y[pixels[j]], cloud.z[pixels[j]], margin);
      beside += on ? 0 : 1;
    }
    if (beside <= most_beside) return k;
  }
  return std::nullopt;
}

/// The waves of a real camera's noise make planes along the flanks of tubes. Where the tube is more likely these are
/// its points, and the plane is dropped.
void Detector::Workspace::giveFlanksToCurved(List<LabelRun>& runs) {
  if (!depth_camera) return;
  bool any = false;
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    if (!kept[k] || kindOf(result.items[k].shape) != Kind::plane) continue;
    const std::optional<std::size_t> curved = curvedUnder(points[k].index);
    if (!curved || result.items[*curved].confidence < result.items[k].confidence) continue;
    relabel(runs, static_cast<std::uint32_t>(k + 1), List<std::uint32_t>(1, static_cast<std::uint32_t>(*curved + 1)),
            [](std::uint32_t) { return 0; });
    kept[k] = false;
    any = true;
  }
  if (!any) return;
  runs = labelRuns(labels);
  gatherPoints(runs);
}

/// Of every face, in the order of the faces.
List<List<std::uint32_t>> Detector::Workspace::pixelsOfFaces(const PlaneInImage& plane,
                                                             const List<LabelRun>& runs) const {
  List<List<std::uint32_t>> pixels(plane.faces.faces().size());
  for (const LabelRun& run : runs) {
    if (run.label != plane.of + 1) continue;
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const int face = plane.faces.faceAt(i);
      if (face != FacesApart::kNone) pixels[static_cast<std::size_t>(face)].push_back(i);
    }
  }
  return pixels;
}

/// The largest face keeps the label of the plane, each other one gets one of its own, strips those of the curved shapes
/// that they lie on. What is left is no part of any. False, and nothing is changed, where that would be much: nothing
/// is to be lost for faces that are too narrow or too small.
bool Detector::Workspace::giveToFaces(std::size_t least, const PlaneInImage& plane, const List<LabelRun>& runs) {
  const List<std::size_t>& faces = plane.faces.faces();
  if (faces.size() < 2 || plane.faces.left() > kMuch) return false;
  List<std::optional<std::size_t>> curved;
  for (const List<std::uint32_t>& pixels : pixelsOfFaces(plane, runs)) {
    curved.push_back(curvedUnder(pixels));
    if (!curved.back() && pixels.size() < least) return false;
  }
  const auto largest = std::find(curved.begin(), curved.end(), std::nullopt) - curved.begin();
  if (largest == static_cast<std::ptrdiff_t>(faces.size())) return false;
  const auto before = static_cast<std::uint32_t>(plane.of + 1);
  List<std::uint32_t> label_of(faces.size(), before);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (curved[k]) {
      label_of[k] = static_cast<std::uint32_t>(*curved[k] + 1);
    } else if (k != static_cast<std::size_t>(largest)) {
      label_of[k] = addPart(std::get<Plane>(result.items[plane.of].shape), plane.of);
      beside.push_back({label_of[k] - 1, plane.of});
    }
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (curved[k]) continue;
    takeShare(static_cast<double>(faces[k]) / static_cast<double>(plane.faces.count()), result.items[label_of[k] - 1]);
  }
  relabel(runs, before, label_of, [&plane](std::uint32_t i) { return plane.faces.faceAt(i); });
  return true;
}

/// A second time with smaller ones, which are strips of curved shapes, where faces alone leave too much.
void Detector::Workspace::takeFacesApart(const Cloud& whole, List<LabelRun>& runs) {
  constexpr std::size_t kStrip = 4;  // times smaller than a face
  beside.clear();
  if (!depth_camera) return;
  const double fewest = static_cast<double>(fewestPoints(Kind::plane, whole));
  bool changed = false;
  for (PlaneInImage& plane : planesInImage(runs)) {
    const double each = static_cast<double>(points[plane.of].all) / static_cast<double>(plane.faces.count());
    const auto least = static_cast<std::size_t>(std::ceil(fewest / each));
    for (const std::size_t smallest : {least, least / kStrip}) {
      findFaces(runs, smallest, plane);
      if (!giveToFaces(least, plane, runs)) continue;
      changed = true;
      break;
    }
  }
  if (!changed) return;
  runs = labelRuns(labels);
  gatherPoints(runs);
}

/// What a plane cuts off a thing with a round side, in passing, is no face: it strays more than noise does, and than
/// the largest face, which has the waves of the camera.
void Detector::Workspace::distrustUnevenFaces(const List<bool>& measured) {
  const PointNoise sigma(verification.fullNoise());
  const auto uneven = [&](std::size_t k) {
    if (!measured[k]) return 0.0;
    return unevenness(thinned.cloud(), points[k].index, std::get<Plane>(result.items[k].shape), sigma);
  };
  std::size_t largest = result.items.size();  // those of one plane follow each other
  double most = 0.0;
  for (const FaceBeside& face : beside) {
    if (face.largest != largest) most = kAsEven * std::max(1.0, uneven(face.largest));
    largest = face.largest;
    if (uneven(face.index) > most) result.items[face.index].confidence = 0.0f;
  }
}

}  // namespace primitect
