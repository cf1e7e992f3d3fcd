// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lines and sums for a terminal.
#include "tools/bag_text.h"

#include "core/lower_quartile.h"
#include "io/shape_text.h"
#include "io/share_beyond.h"
#include "tools/format.h"

namespace primitect::tools {
namespace {

using Counts = std::array<std::size_t, kKindCount>;

Counts countsOf(const Detections& found) {
  Counts counts = {};
  for (const Detection& item : found.items) ++counts[static_cast<std::size_t>(kindOf(item.shape))];
  return counts;
}

/// "3 planes, 1 sphere".
std::string countsText(const Counts& counts) {
  std::string text;
  for (std::size_t kind = 0; kind < counts.size(); ++kind) {
    if (counts[kind] == 0) continue;
    const std::string name = kindName(static_cast<Kind>(kind));
    text += (text.empty() ? "" : ", ") + std::to_string(counts[kind]) + " " + name + (counts[kind] == 1 ? "" : "s");
  }
  return text;
}

}  // namespace

std::string frameLine(const io::FrameReport& frame) {
  std::string what = frame.problem;
  if (what.empty())
    what = frame.detections.items.empty() ? io::reasonText(frame.detections) : countsText(countsOf(frame.detections));
  return format("%9.3f s  %5.1f ms  ", frame.recorded, frame.processing_ms) + what + "\n";
}

void BagSummary::add(const io::FrameReport& frame) {
  ++clouds_;
  if (problem_.empty()) problem_ = frame.problem;
  if (frame.detections.status != Status::ok) return;
  ++searched_;
  beyond_ += frame.beyond;
  elsewhere_ += frame.detections.seen_from_origin ? 0 : 1;
  assumed_ += frame.origin_assumed ? 1 : 0;
  moved_ += frame.found_sensor ? 1 : 0;
  milliseconds_.push_back(frame.processing_ms);
  refusals_ += frame.detections.refusals;
  const Counts counts = countsOf(frame.detections);
  for (std::size_t kind = 0; kind < counts.size(); ++kind) found_[kind] += counts[kind];
  for (const Detection& item : frame.detections.items) {
    tracks_ += item.track_id != 0 && item.age == 0 ? 1 : 0;
  }
}

std::string BagSummary::warning() const {
  if (elsewhere_ == 0) return "";
  return std::to_string(elsewhere_) + " of " + std::to_string(clouds_) +
         " clouds are not seen from the origin of their frame along z: shapes are missed, normals turned; " +
         "--sensor_frame says where the camera was";
}

std::vector<std::string> BagSummary::notes() const {
  std::vector<std::string> notes;
  if (assumed_ > 0) {
    notes.push_back(std::to_string(assumed_) + " of " + std::to_string(clouds_) +
                    " clouds are lists without rows and columns, taken for seen from the origin of their frame along "
                    "z; --sensor_frame says where else the camera was");
  }
  if (moved_ > 0) {
    notes.push_back(std::to_string(moved_) + " of " + std::to_string(clouds_) +
                    " clouds were moved to another frame: searched from where their rows and columns, the order of "
                    "their points, or the shadows of things, tell that the camera was");
  }
  // Where nothing is nearer, that is the problem of those clouds.
  const double share = searched_ > 0 ? beyond_ / static_cast<double>(searched_) : 0.0;
  if (share >= io::kMuchBeyond) {
    notes.push_back(
        format("%.0f %% of what was measured lies beyond max_depth and is left out; --max_depth says how "
               "far to look",
               100.0 * share));
  }
  return notes;
}

std::string BagSummary::text(const std::string& topic, const Params& params) const {
  std::string text = std::to_string(clouds_) + (clouds_ == 1 ? " cloud on " : " clouds on ") + topic + ", " +
                     std::to_string(searched_) + " searched.";
  if (searched_ == 0) return text + " The first: " + problem_ + "\n";
  text += " In the mean";
  const auto clouds = static_cast<double>(searched_);
  for (std::size_t kind = 0; kind < found_.size(); ++kind) {
    const double mean = static_cast<double>(found_[kind]) / clouds;
    text += format("%s %.1f %ss", kind == 0 ? "" : ",", mean, kindName(static_cast<Kind>(kind)));
  }
  if (tracks_ > 0) text += "; " + std::to_string(tracks_) + (tracks_ == 1 ? " track" : " tracks");
  List<double> milliseconds(milliseconds_.begin(), milliseconds_.end());
  text += format("; median %.1f ms.\n", median(milliseconds));
  const std::string refused = io::refusalsText(refusals_, params);
  return text + (refused.empty() ? "" : "Tried and refused, in all of them: " + refused + "\n");
}

}  // namespace primitect::tools
