// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie in one plane, each a detection of its own; see workspace.h.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/evidence.h"
#include "core/face_misfit.h"
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

/// Some of every face, in the order of the faces: of large planes not all, as that takes long.
List<List<std::uint32_t>> Detector::Workspace::pixelsOfFaces(const PlaneInImage& plane,
                                                             const List<LabelRun>& runs) const {
  constexpr std::size_t kMost = 16384;
  const auto step = static_cast<std::uint32_t>(plane.faces.count() / kMost + 1);
  List<List<std::uint32_t>> pixels(plane.faces.faces().size());
  std::uint32_t next = 0;
  for (const LabelRun& run : runs) {
    if (run.label != plane.of + 1) continue;
    for (next = std::max(next, run.begin); next < run.end; next += step) {
      const int face = plane.faces.faceAt(next);
      if (face != FacesApart::kNone) pixels[static_cast<std::size_t>(face)].push_back(next);
    }
  }
  return pixels;
}

/// Faces that are patches of curved shapes get the labels of these, the largest other one keeps that of the plane, each
/// other one gets one of its own, but for those with less than `least` pixels: they are too small to be reported, and
/// with the others the plane would span what lies between them. What is left is no part of any. False, and nothing is
/// changed, where that would be much, or all are too small: nothing is to be lost for faces that are too narrow.
bool Detector::Workspace::giveToFaces(std::size_t least, const PlaneInImage& plane, const List<LabelRun>& runs) {
  const List<std::size_t>& faces = plane.faces.faces();
  if (faces.size() < 2 || plane.faces.left() > kMuch) return false;
  const auto before = static_cast<std::uint32_t>(plane.of + 1);
  const Plane shape = std::get<Plane>(result.items[plane.of].shape);
  List<std::optional<std::size_t>> curved;
  bool any_large = false, any_small = false;
  for (const List<std::uint32_t>& pixels : pixelsOfFaces(plane, runs)) {
    curved.push_back(curvedUnder({shape, before}, pixels));
    if (!curved.back()) (faces[curved.size() - 1] < least ? any_small : any_large) = true;
  }
  if (any_small && !any_large) return false;
  kept[plane.of] = false;
  List<std::uint32_t> label_of;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (curved[k]) {
      label_of.push_back(static_cast<std::uint32_t>(*curved[k] + 1));
    } else if (faces[k] < least) {
      label_of.push_back(0);
    } else if (!kept[plane.of]) {
      label_of.push_back(before);
      kept[plane.of] = true;
    } else {
      label_of.push_back(addPart(shape, plane.of));
      beside.push_back({label_of.back() - 1, plane.of});
    }
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (curved[k] || label_of[k] == 0) continue;
    takeShare(static_cast<double>(faces[k]) / static_cast<double>(plane.faces.count()), result.items[label_of[k] - 1]);
  }
  relabel(runs, before, label_of, [&plane](std::uint32_t i) { return plane.faces.faceAt(i); });
  return true;
}

/// Where faces leave too much, smaller pieces are looked for, too: they may be strips of curved shapes.
void Detector::Workspace::takeFacesApart(const Cloud& whole, List<LabelRun>& runs) {
  constexpr std::size_t kStrip = 4;  // times smaller than a face
  beside.clear();
  if (!depth_camera || !params.does(Step::faces_apart)) return;
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
  gatherAnew(runs);
}

/// What a plane cuts off a thing with a round side, in passing, is no face: it strays more than noise does, and than
/// the largest face, which has the waves of the camera.
void Detector::Workspace::distrustUnevenFaces(const List<bool>& measured) {
  if (!params.does(Step::uneven_faces)) return;
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
