// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces that lie in one plane, each a detection of its own; see workspace.h.
#include <algorithm>
#include <cmath>

#include "core/evidence.h"
#include "core/point_noise.h"
#include "core/workspace.h"

namespace primitect {
namespace {

/// Of the samples that spoke for all of a plane this share is the face's.
void takeShare(double share, Detection& face) {
  const double of_all = confidenceOf(Kind::plane, face.evidence);
  face.evidence.inliers *= static_cast<float>(share);
  face.confidence *= static_cast<float>(confidenceOf(Kind::plane, face.evidence) / of_all);
}

/// How far the points of a depth camera stray from a plane that was fitted to them: 1 is what noise makes of a face.
double unevenness(const Detection& face, const Cloud& cloud, const List<std::uint32_t>& points,
                  const PointNoise& sigma) {
  const Vec3& normal = std::get<Plane>(face.shape).normal;
  double by_noise = 0.0;
  for (const std::uint32_t i : points) {
    const Vec3 point(cloud.x[i], cloud.y[i], cloud.z[i]);
    const double across = sigma(point) * normal.dot(point) / point.z();
    by_noise += across * across;
  }
  return static_cast<double>(points.size()) * face.rms_error * face.rms_error / by_noise;
}

}  // namespace

/// Those of the planes (index of the detection) that are kept, in the image.
List<Detector::Workspace::PlaneInImage> Detector::Workspace::planesInImage(const List<LabelRun>& runs) const {
  constexpr std::size_t kNone = ~std::size_t{0};
  const std::uint32_t width = thinned.cloud().width;
  const List<PixelBox> boxes = boxesOfLabels(runs, result.items.size(), width);
  List<PlaneInImage> planes;
  List<std::size_t> plane_of(boxes.size(), kNone);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const bool seen = boxes[k].left <= boxes[k].right;
    if (!seen || !kept[k] || kindOf(result.items[k].shape) != Kind::plane) continue;
    plane_of[k] = planes.size();
    planes.push_back({k, FacesApart(boxes[k], width)});
  }
  for (const LabelRun& run : runs) {
    const std::size_t k = run.label - 1;
    if (k < plane_of.size() && plane_of[k] != kNone) planes[plane_of[k]].faces.add(run);
  }
  return planes;
}

/// The largest face keeps the label of the plane, each other one gets one of its own. What is left is no part of any.
void Detector::Workspace::giveToFaces(const PlaneInImage& plane, const List<LabelRun>& runs) {
  const auto before = static_cast<std::uint32_t>(plane.of + 1);
  const List<std::size_t>& faces = plane.faces.faces();
  List<std::uint32_t> label_of(1, before);
  while (label_of.size() < faces.size()) {
    label_of.push_back(addPart(std::get<Plane>(result.items[plane.of].shape), plane.of));
    beside.push_back({label_of.back() - 1, plane.of});
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    takeShare(static_cast<double>(faces[k]) / static_cast<double>(plane.faces.count()), result.items[label_of[k] - 1]);
  }
  for (const LabelRun& run : runs) {
    if (run.label != before) continue;
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const int face = plane.faces.faceAt(i);
      labels[i] = face == FacesApart::kNone ? 0u : label_of[face];
    }
  }
}

void Detector::Workspace::takeFacesApart(const Cloud& whole, List<LabelRun>& runs) {
  beside.clear();
  if (!depth_camera || !thinned.cloud().organized()) return;
  const double least = static_cast<double>(fewestPoints(Kind::plane, whole));
  List<PlaneInImage> planes = planesInImage(runs);
  for (PlaneInImage& plane : planes) {
    const double each = static_cast<double>(points[plane.of].all) / static_cast<double>(plane.faces.count());
    const Plane& shape = std::get<Plane>(result.items[plane.of].shape);
    plane.faces.find(thinned.cloud(), shape, verification.noise(), static_cast<std::size_t>(std::ceil(least / each)));
    if (plane.faces.faces().size() > 1) giveToFaces(plane, runs);
  }
  if (beside.empty()) return;
  runs = labelRuns(labels);
  gatherPoints(runs);
}

/// What a plane cuts off a thing with a round side, in passing, is no face: as for tops (level_top.cpp), it is the
/// one that strays more than noise does, and than the largest one.
void Detector::Workspace::distrustUnevenFaces(const List<bool>& measured) {
  constexpr double kAsEven = 1.6;
  const PointNoise sigma(verification.noise());
  const auto uneven = [&](std::size_t k) {
    return measured[k] ? unevenness(result.items[k], thinned.cloud(), points[k].index, sigma) : 0.0;
  };
  for (const FaceBeside& face : beside) {
    if (uneven(face.index) > kAsEven * std::max(1.0, uneven(face.largest))) result.items[face.index].confidence = 0.0f;
  }
}

}  // namespace primitect
