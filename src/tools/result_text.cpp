// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables for a terminal.
#include "tools/result_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/wanted_kinds.h"
#include "io/cut_away.h"
#include "io/depths_text.h"
#include "io/length_text.h"
#include "io/percent_text.h"
#include "io/point_files.h"
#include "io/shape_text.h"
#include "tools/format.h"
#include "tools/notes.h"
#include "tools/unlikely.h"

namespace primitect::tools {
namespace {

/// Size with the length of what was seen.
std::string fullSize(const Detection& detection) {
  const Kind kind = kindOf(detection.shape);
  const bool long_one = kind == Kind::cylinder || kind == Kind::cone;
  const double length = detection.extent.size.z();
  return io::sizeText(detection) + (long_one && length > 0.0 ? ", length " + io::lengthText(length) : "");
}

std::string orDash(const std::string& text) { return text.empty() ? "-" : text; }

/// What is worth a remark about few: "cut off by image, or a cone".
std::string remarkText(const Detection& detection) {
  std::string text = io::truncationText(detection.truncated);
  if (!text.empty()) text = "cut off by " + text;
  if (!detection.rival) return text;
  return text + (text.empty() ? "or a " : "; or a ") + kindName(*detection.rival);
}

/// To three decimals.
Vec3 rounded(const Vec3& v) {
  return v.unaryExpr([](double a) { return std::round(1000.0 * a) / 1000.0 + 0.0; });  // + 0: no "-0.000"
}

/// Where a plane faces, where the axis of a cylinder or cone points.
std::string directionText(const Detection& detection) {
  if (kindOf(detection.shape) == Kind::sphere) return "-";
  const Vec3 z = rounded(detection.extent.rotation.col(2));
  return format("%6.3f %6.3f %6.3f", z.x(), z.y(), z.z());
}

std::string headingText() {
  return format("  %3s  %-16s  %-34s  %8s  %8s %8s %8s  %20s  %6s  %8s  %8s  %7s  %6s\n", "#", "kind", "size", "stddev",
                "x (m)", "y", "z", "normal or axis x y z", "conf.", "coverage", "inliers", "votes", "rms");
}

std::string rowText(std::size_t number, const Detection& detection) {
  const Vec3 p = rounded(detection.extent.origin);
  const std::string rms = detection.rms_error < 0.0f ? "-" : format("%.1f mm", 1000.0 * detection.rms_error);
  std::string row =
      format("  %3zu  %-16s  %-34s  %8s  %8.3f %8.3f %8.3f  %20s", number, io::kindText(detection).c_str(),
             fullSize(detection).c_str(), orDash(io::deviationText(detection)).c_str(), p.x(), p.y(), p.z(),
             directionText(detection).c_str());
  row += format("  %6s  %8s", orDash(io::percentText(detection.confidence)).c_str(),
                orDash(io::percentText(detection.coverage)).c_str());
  row += format("  %8u  %7.0f  %6s", detection.inlier_count, detection.votes, rms.c_str());
  const std::string remark = remarkText(detection);
  return row + (remark.empty() ? "" : "  " + remark) + "\n";
}

std::string rowsText(const Detections& found) {
  std::string text;
  for (std::size_t i = 0; i < found.items.size(); ++i) text += rowText(i + 1, found.items[i]);
  return text;
}

/// What max_latency left of the samples; empty without it.
std::string effortText(const io::FileReport& report) {
  return report.effort ? format(" (max_latency leaves %.0f %%)", 100.0 * *report.effort) : "";
}

/// What was not reported, with the same columns.
std::string missingText(const std::string& what, const std::optional<Detections>& found) {
  if (!found) return "";
  return "  " + what + ", where nothing above is:" + (found->items.empty() ? " none\n" : "\n" + rowsText(*found));
}

/// "Why is my object missing?" in one line.
std::string refusedText(const io::FileReport& report, const Params& params) {
  const std::string counts = io::refusalsText(report.detections.refusals, params);
  const bool searched = report.unlikely || report.few_inliers;
  return counts.empty() ? ""
                        : "  tried and refused: " + counts + (searched ? "" : "; --unlikely looks for more") + "\n";
}

std::string timesText(const io::FileReport& report) {
  std::string text = "  ms:";
  for (const auto& [stage, time] : report.timing_ms) text += format(" %s %.2f", stage.c_str(), time);
  return text + "\n";
}

std::string repeatsText(const io::FileReport& report) {
  std::string text = format("  %d runs, ms       min    median       max\n", report.repeats);
  // "read" is measured once and has no row here.
  for (std::size_t i = 0; i < report.min_ms.size(); ++i) {
    const std::size_t median = report.timing_ms.size() - report.min_ms.size() + i;
    text += format("  %-12s %9.3f %9.3f %9.3f\n", report.min_ms[i].first.c_str(), report.min_ms[i].second,
                   report.timing_ms[median].second, report.max_ms[i].second);
  }
  return text;
}

std::string sizeText(const Cloud& cloud) {
  if (!cloud.organized()) return std::to_string(cloud.size()) + (cloud.size() == 1 ? " point" : " points");
  return std::to_string(cloud.width) + " x " + std::to_string(cloud.height) + " image";
}

/// The bounds that are on: "min_depth 0.1 m, max_depth 2 m".
std::string rangeText(const DepthRange& range) {
  std::string text = range.min > 0.0f ? format("min_depth %.4g m", range.min) : "";
  if (range.max > 0.0f) text += format("%smax_depth %.4g m", text.empty() ? "" : ", ", range.max);
  return text;
}

/// How many measured points lie on the other side of which bound: " (98832 beyond max_depth 2 m)".
std::string cutText(const Cloud& whole, const DepthRange& range) {
  const io::CutAway cut = io::cutAway(whole, range);
  std::string text = cut.nearer > 0 ? format("%zu nearer than min_depth %.4g m", cut.nearer, range.min) : "";
  if (cut.farther > 0) {
    text += format("%s%zu beyond max_depth %.4g m", text.empty() ? "" : ", ", cut.farther, range.max);
  }
  return text.empty() ? "" : " (" + text + ")";
}

std::string latencyText(const io::FileReport& report, const Params& params) {
  if (!(report.late_runs > 0)) return "";
  return format("  note: %u of %d runs took longer than max_latency (%.4g ms)\n", report.late_runs, report.repeats,
                1000.0 * params.max_latency);
}

bool anyKind(const Params& params) {
  const Kind kinds[] = {Kind::plane, Kind::sphere, Kind::cylinder, Kind::cone};
  return std::any_of(std::begin(kinds), std::end(kinds), [&](Kind kind) { return isWanted(kind, params); });
}

/// Unlike the detector, this knows whether points were not measured or cut away, and whether anything was looked for.
std::string emptyText(const io::FileReport& report, const DetectInput& input) {
  const Cloud& whole = input.seen();
  const DepthRange& range = input.range;
  const Detections& found = report.detections;
  if (found.status == Status::ok && !anyKind(input.params)) {
    return "all kinds are off (detect_planes, detect_spheres, detect_cylinders, detect_cones)";
  }
  const unsigned cut = whole.valid_count - found.points_used;
  if (whole.valid_count == 0) return format("none of the %zu points is measured", whole.size());
  if (cut == 0 || found.status == Status::ok) return io::reasonText(found);
  const std::string by = "cut away by the depth range (" + rangeText(range) + ")";
  if (found.points_used > 0) return io::reasonText(found) + format("; %u were ", cut) + by;
  const std::string scale = io::isDepthImage(report.file) ? "; is --depth-scale that of the image?" : "";
  return format("all %u measured points, %s, were ", cut, io::depthsText(whole).c_str()) + by + scale;
}

}  // namespace

std::string resultText(const io::FileReport& report, const DetectInput& input) {
  const Detections& found = report.detections;
  std::string text = report.file + ": " + sizeText(input.cloud) + ", " +
                     format("%u points used%s, %u samples%s, scene diameter %.3g m\n", found.points_used,
                            cutText(input.seen(), input.range).c_str(), found.samples, effortText(report).c_str(),
                            found.scene_diameter);
  text += notesText(found, input) + latencyText(report, input.params);
  if (found.items.empty()) {
    text += "  nothing found: " + emptyText(report, input) + "\n";
  } else {
    text += headingText();
  }
  text += rowsText(found) + missingText("would come out without max_latency", report.late);
  text += missingText("refused as too unlikely (min_confidence)", report.unlikely);
  const int fewest = fewestInliers(input.params);
  text += missingText(format("would come out with min_inliers %d and min_votes 0", fewest), report.few_inliers);
  text += refusedText(report, input.params);
  return text + (report.repeats > 1 ? repeatsText(report) : timesText(report));
}

}  // namespace primitect::tools
