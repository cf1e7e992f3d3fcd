// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Faces against detections; see faces.h.
#include "eval/faces.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "eval/segcomp.h"

namespace primitect::eval {
namespace {

/// Faces of merged shapes and detections under the points.
struct OnFaces {
  std::vector<int> face, found;
  int faces = 0;
  std::map<int, int> shape_of_face;
};

/// Shapes have no end: what a detection has on nothing that must be found does not count here.
OnFaces lookAt(const LabelledCloud& input, const std::vector<int>& labels) {
  OnFaces result;
  for (std::size_t i = 0; i < input.face.size(); ++i) {
    const int t = input.surface[i];
    const bool counts = t >= 0 && input.truth[t].must;
    result.face.push_back(counts ? input.face[i] : kNoShape);
    result.found.push_back(counts ? labels[i] : kNoShape);
    if (result.face.back() < 0) continue;
    result.faces = std::max(result.faces, input.face[i] + 1);
    result.shape_of_face[input.face[i]] = t;
  }
  return result;
}

}  // namespace

std::vector<int> joinedOnFaces(const LabelledCloud& input, const std::vector<Shape>& found,
                               const std::vector<int>& labels) {
  std::vector<int> with(found.size());
  std::iota(with.begin(), with.end(), 0);
  const OnFaces seen = lookAt(input, labels);
  const Overlaps overlaps = countOverlaps(seen.face, static_cast<std::size_t>(seen.faces), seen.found, found.size());
  std::map<int, int> first_on_shape;
  for (const auto& [face, d] : segment(overlaps, input.rules.overlap).correct) {
    if (kindOf(found[d]) != Kind::plane) continue;
    with[d] = first_on_shape.emplace(seen.shape_of_face.at(face), d).first->second;
  }
  return with;
}

}  // namespace primitect::eval
