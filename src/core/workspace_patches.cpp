// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Planes, and parts of planes, that are patches of curved shapes; see workspace.h.
#include <cstdint>
#include <limits>
#include <optional>

#include "core/workspace.h"

namespace primitect {

/// The curved shape (index of the detection) that these pixels of a plane, with this label, are a patch of.
std::optional<std::size_t> Detector::Workspace::curvedUnder(const Labelled<Plane>& plane,
                                                            const List<std::uint32_t>& pixels,
                                                            double most_times) const {
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    const Detection& item = result.items[k];
    if (!kept[k] || kindOf(item.shape) == Kind::plane) continue;
    const Labelled<Detection> curved = {item, static_cast<std::uint32_t>(k + 1)};
    if (isPatchOf(curved, plane, pixels, thinned.cloud(), labels, verification.noise(), most_times)) return k;
  }
  return std::nullopt;
}

/// The waves of a real camera's noise make planes along the flanks of tubes. Where the tube is more likely these are
/// its points, and the plane is dropped.
void Detector::Workspace::giveFlanksToCurved(List<LabelRun>& runs) {
  constexpr double kUnlikely = 0.7;   // confidence; in recorded frames all planes along tubes have less
  constexpr double kMostTimes = 2.5;  // of more likely ones
  if (!depth_camera) return;
  bool any = false;
  for (std::size_t k = 0; k < result.items.size(); ++k) {
    const Plane* const plane = std::get_if<Plane>(&result.items[k].shape);
    if (!kept[k] || !plane) continue;
    const auto label = static_cast<std::uint32_t>(k + 1);
    const bool unlikely = result.items[k].confidence < kUnlikely;
    const double most_times = unlikely ? std::numeric_limits<double>::infinity() : kMostTimes;
    const std::optional<std::size_t> curved = curvedUnder({*plane, label}, points[k].index, most_times);
    if (!curved || result.items[*curved].confidence < result.items[k].confidence) continue;
    const List<std::uint32_t> label_of(1, static_cast<std::uint32_t>(*curved + 1));
    relabel(runs, label, label_of, [](std::uint32_t) { return 0; });
    kept[k] = false;
    any = true;
  }
  if (!any) return;
  gatherAnew(runs);
}

}  // namespace primitect
