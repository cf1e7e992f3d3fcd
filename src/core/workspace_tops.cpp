// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes that lead over the tops of several things, taken apart by the points of the cloud; see workspace.h.
#include <optional>
#include <utility>

#include "core/workspace.h"

namespace primitect {

/// The curved shape (index of the detection) that these pixels of a plane, with this label, are a patch of.
std::optional<std::size_t> Detector::Workspace::curvedUnder(const Labelled<Plane>& plane,
                                                            const List<std::uint32_t>& pixels) const {
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    const Detection& item = result.items[k];
    if (!kept[k] || kindOf(item.shape) == Kind::plane) continue;
    const Labelled<Detection> curved = {item, static_cast<std::uint32_t>(k + 1)};
    if (isPatchOf(curved, plane, pixels, thinned.cloud(), labels, verification.noise())) return k;
  }
  return std::nullopt;
}

/// Tops that are patches of curved shapes get the labels of these, the first other one keeps that of the plane that led
/// over all; another that has enough points gets one of its own. What is left near them is no part of anything.
void Detector::Workspace::giveToTops(const LevelTops& tops, std::size_t of, const Cloud& whole,
                                     const List<LabelRun>& runs) {
  const auto before = static_cast<std::uint32_t>(of + 1);
  const std::size_t least = fewestPoints(Kind::plane, whole), all = points[of].all, seen = points[of].index.size();
  const Cloud& cloud = thinned.cloud();
  List<List<std::uint32_t>> pixels(tops.tops().size());
  for (const std::uint32_t i : points[of].index) {
    const int top = tops.topAt(cloud.point(i));
    if (top != LevelTops::kNone) pixels[static_cast<std::size_t>(top)].push_back(i);
  }
  kept[of] = false;
  List<std::uint32_t> label_of;
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const LevelTops::Top& top = tops.tops()[k];
    if (const std::optional<std::size_t> curved = curvedUnder({top.plane, before}, pixels[k])) {
      label_of.push_back(static_cast<std::uint32_t>(*curved + 1));
    } else if (!kept[of]) {
      label_of.push_back(before);
      kept[of] = true;
    } else {
      label_of.push_back(all * top.count >= least * seen ? addPart(top.plane, of) : 0u);
    }
  }
  relabel(runs, before, label_of, [&](std::uint32_t i) { return tops.topAt(cloud.point(i)); });
}

/// Small planes that lead over the tops of several things. Where their heights differ by 1 or 2 mm, too little for the
/// samples to tell, all but one were not reported at all; the plane was tilted by up to 1.5 deg before they were told
/// apart.
void Detector::Workspace::takeTopsApart(const Cloud& whole, List<LabelRun>& runs) {
  if (!depth_camera || !params.does(Step::level_tops)) return;
  const PointNoise sigma(verification.noise());
  bool any = false;
  std::size_t next = 0;
  for (const Segment& segment : verification.segments()) {
    if (!isDescribed(segment)) continue;
    const std::size_t of = next++;
    const bool small = kindOf(segment.candidate.shape) == Kind::plane && !verification.maySupport(segment);
    const std::optional<Vec3> level = small ? verification.levelOf(segment) : std::nullopt;
    if (!level) continue;
    const Plane& plane = std::get<Plane>(segment.candidate.shape);
    const LevelTops tops(thinned.cloud(), plane, *level, sigma, points[of].index);
    if (tops.tops().empty()) continue;
    giveToTops(tops, of, whole, runs);
    any = true;
  }
  if (!any) return;
  gatherAnew(runs);
}

}  // namespace primitect
