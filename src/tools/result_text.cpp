// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Tables for a terminal.
#include "tools/result_text.h"

#include <cstdarg>
#include <cstdio>

#include "io/shape_text.h"

namespace primitect::tools {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof(text), pattern, arguments);
  va_end(arguments);
  return text;
}

/// Size with the length of what was seen.
std::string fullSize(const Detection& detection) {
  const Kind kind = kindOf(detection.shape);
  const bool long_one = kind == Kind::cylinder || kind == Kind::cone;
  const double length = detection.extent.size.z();
  return io::sizeText(detection) + (long_one && length > 0.0 ? ", length " + io::lengthText(length) : "");
}

std::string rowText(std::size_t number, const Detection& detection) {
  const Vec3& p = detection.extent.origin;
  const std::string rms = detection.rms_error < 0.0f ? "-" : format("%.1f mm", 1000.0 * detection.rms_error);
  return format("  %3zu  %-8s  %-36s  %8.3f %8.3f %8.3f  %7u  %7.0f  %s\n", number, kindName(kindOf(detection.shape)),
                fullSize(detection).c_str(), p.x(), p.y(), p.z(), detection.inlier_count, detection.votes, rms.c_str());
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

}  // namespace

std::string resultText(const io::FileReport& report, const std::string& size) {
  const Detections& found = report.detections;
  std::string text = report.file + ": " + size + ", " +
                     format("%u points used, %u samples, scene diameter %.3g m\n", found.points_used, found.samples,
                            found.scene_diameter);
  if (found.items.empty()) {
    text += "  nothing found: " + io::reasonText(found) + "\n";
  } else {
    text +=
        "    #  kind      size                                         position (m)         inliers    votes  rms\n";
  }
  for (std::size_t i = 0; i < found.items.size(); ++i) text += rowText(i + 1, found.items[i]);
  return text + (report.repeats > 1 ? repeatsText(report) : timesText(report));
}

}  // namespace primitect::tools
