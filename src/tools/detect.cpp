// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// detect FILE...: finds primitives in point files; see --help.
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "io/label_file.h"
#include "io/picture.h"
#include "io/report.h"
#include "primitect/transforms.h"
#include "tools/detect_input.h"
#include "tools/detect_options.h"
#include "tools/notes.h"
#include "tools/output_target.h"
#include "tools/result_text.h"
#include "tools/stage_timing.h"
#include "tools/standard_output.h"
#include "tools/unlikely.h"

namespace {

namespace io = primitect::io;
namespace tools = primitect::tools;

enum ExitCode : int { kOk = 0, kBadFile = 1, kBadUsage = 2 };

struct Targets {
  tools::OutputTarget json, labels, picture;

  explicit Targets(const tools::DetectOptions& options)
      : json("--json", options.json, ".json", options.files, true),
        labels("--labels", options.labels, ".ply", options.files, false),
        picture("--picture", options.picture, ".png", options.files, false) {
    tools::refuseSharedFiles({&json, &labels, &picture}, options.files.size());
    tools::refuseUnwritable({&json, &labels, &picture}, options.files.size());
  }
};

/// All runs of one call are frames in a row, of one sensor and one machine.
using Governor = std::optional<primitect::LatencyGovernor>;

void runDetector(primitect::Detector& detector, const tools::DetectInput& input, int repeats, Governor& governor,
                 io::FileReport& report) {
  std::vector<io::Timing> runs;
  const std::uint64_t missed_before = governor ? governor->missed() : 0;
  for (int i = 0; i < repeats; ++i) {
    if (governor) report.effort = governor->share();
    const tools::TimedRun run = tools::timeDetection(detector, input.cloud, governor ? &*governor : nullptr);
    runs.push_back(run.timing_ms);
    if (i + 1 == repeats) report.detections = run.found;
  }
  if (governor) report.late_runs = static_cast<unsigned>(governor->missed() - missed_before);
  const tools::TimingSummary summary = tools::summarize(runs);
  report.timing_ms.insert(report.timing_ms.end(), summary.median_ms.begin(), summary.median_ms.end());
  report.repeats = repeats;
  report.min_ms = summary.min_ms;
  report.max_ms = summary.max_ms;
}

/// In the frame of the sensor: the picture is what it saw.
void writePointOutputs(const Targets& targets, std::size_t index, const std::vector<std::uint32_t>& labels,
                       const tools::DetectInput& input, const io::FileReport& report) {
  if (targets.labels.wanted()) {
    io::writeLabels(targets.labels.path(index), input.file.cloud, report.detections, labels);
  }
  if (!targets.picture.wanted()) return;
  const std::string title = std::filesystem::path(report.file).filename().string();
  const io::LabelledPoints points{input.seen(), input.range, labels, report.detections};
  io::writePicture(targets.picture.path(index), io::drawPicture(points, input.file.intrinsics, title));
}

void toFrameOfFile(const Eigen::Isometry3d& points_from_sensor, io::FileReport& report) {
  primitect::transformDetections(points_from_sensor, report.detections);
  for (auto* unreported : {&report.late, &report.unlikely, &report.few_inliers}) {
    if (*unreported) primitect::transformDetections(points_from_sensor, **unreported);
  }
}

io::FileReport processFile(const tools::DetectOptions& options, const Targets& targets, std::size_t index,
                           Governor& governor) {
  io::FileReport report;
  report.file = options.files[index];
  tools::Stopwatch reading;
  const tools::DetectInput input = tools::readInput(options, report.file);
  report.timing_ms.emplace_back("read", reading.lapMs());
  report.sensor = input.sensor;
  report.found_by = input.found_by;
  report.left_out = input.params.left_out;
  primitect::Detector detector(input.params);
  const double bound = input.params.max_latency;
  if (bound > 0.0 && !governor) governor.emplace(bound, primitect::leastShare(input.params));
  runDetector(detector, input, options.repeats, governor, report);
  std::vector<std::uint32_t> labels;
  if (targets.labels.wanted() || targets.picture.wanted() || options.unlikely) detector.label(input.cloud, labels);
  writePointOutputs(targets, index, labels, input, report);
  if (options.unlikely && report.detections.status == primitect::Status::ok) {
    tools::Unreported unreported = tools::searchUnreported(input, report.effort.has_value(), labels);
    report.late = std::move(unreported.late);
    report.unlikely = std::move(unreported.unlikely);
    report.few_inliers = std::move(unreported.few_inliers);
  }
  if (input.sensor) toFrameOfFile(input.sensor->pointsFromSensor(), report);
  if (targets.json.perInput()) tools::writeTextFile(targets.json.path(index), io::reportJson(report));
  if (!targets.json.toStdout()) std::cout << tools::resultText(report, input) << std::flush;
  return report;
}

void writeJson(const Targets& targets, const std::vector<io::FileReport>& reports) {
  if (!targets.json.wanted() || targets.json.perInput()) return;
  if (reports.size() == 1 && !reports[0].error.empty()) return;
  const std::string text = reports.size() == 1 ? io::reportJson(reports[0]) : io::reportsJson(reports);
  if (targets.json.toStdout()) {
    std::cout << text << std::flush;
  } else {
    tools::writeTextFile(targets.json.path(0), text);
  }
}

io::FileReport failure(const std::string& file, const std::string& cause) {
  std::cerr << "detect: " << cause << "\n";
  io::FileReport report;
  report.file = file;
  report.error = cause;
  return report;
}

int run(const tools::DetectOptions& options) {
  const Targets targets(options);
  std::cerr << tools::ignoredFramesText(options);
  int exit_code = kOk;
  std::vector<io::FileReport> reports;
  Governor governor;
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    try {
      reports.push_back(processFile(options, targets, i, governor));
    } catch (const std::invalid_argument&) {
      throw;  // parameters that contradict each other
    } catch (const std::runtime_error& error) {
      reports.push_back(failure(options.files[i], error.what()));
    } catch (const std::exception& error) {
      reports.push_back(failure(options.files[i], options.files[i] + ": " + error.what()));
    }
    if (reports.back().error.empty()) continue;
    exit_code = kBadFile;
    if (targets.json.perInput()) tools::writeTextFile(targets.json.path(i), io::reportJson(reports.back()));
  }
  writeJson(targets, reports);
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto options = tools::parseDetectOptions(argc, argv);
    const int exit_code = options ? run(*options) : kOk;
    tools::flushOutput();
    return exit_code;
  } catch (const std::invalid_argument& error) {
    std::cerr << "detect: " << error.what() << "\n";
    return kBadUsage;
  } catch (const std::exception& error) {
    std::cerr << "detect: " << error.what() << "\n";
    return kBadFile;
  }
}
