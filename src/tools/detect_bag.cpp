// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// detect_bag BAG...: finds primitives in the clouds of a recording; see --help.
#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "io/picture.h"
#include "io/report.h"
#include "tools/bag_text.h"
#include "tools/detect_bag_options.h"
#include "tools/format.h"
#include "tools/standard_output.h"

namespace {

namespace fs = std::filesystem;
namespace tools = primitect::tools;
using primitect::io::FrameReport;

enum ExitCode : int { kOk = 0, kBadFile = 1, kBadUsage = 2 };

/// A line for each cloud, in a file or on standard output; or nowhere.
class JsonLines {
 public:
  explicit JsonLines(const std::string& path) : path_(path) {}

  bool toStdout() const { return path_ == "-"; }

  void write(const FrameReport& frame) {
    if (path_.empty()) return;
    if (!toStdout() && !file_.is_open()) file_.open(path_);  // an older one stays until there is something new
    std::ostream& out = toStdout() ? std::cout : file_;
    out << primitect::io::frameJson(frame);
    if (!toStdout()) check();
  }

  void finish() {
    if (path_.empty() || toStdout()) return;
    file_.close();
    check();
  }

 private:
  void check() const {
    if (!file_) throw std::runtime_error(path_ + ": cannot be written");
  }

  std::string path_;
  std::ofstream file_;
};

/// Of clouds, in a folder that is made.
class Pictures {
 public:
  explicit Pictures(const std::string& folder) : folder_(folder) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw std::runtime_error(folder + ": cannot be made: " + error.message());
  }

  /// place: among all clouds, from 1 on.
  void write(int place, const FrameReport& frame, const primitect::io::LabelledPoints& points) const {
    const std::string title = tools::format("%d, %.3f s", place, frame.recorded);
    const fs::path path = folder_ / tools::format("%06d.png", place);
    primitect::io::writePicture(path, primitect::io::drawPicture(points, std::nullopt, title));
  }

 private:
  fs::path folder_;
};

volatile std::sig_atomic_t interrupted = 0;

int run(const tools::DetectBagOptions& options) {
  JsonLines json(options.json);
  tools::BagSummary summary;
  bool damaged = false;
  int clouds = 0;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGPIPE, SIG_IGN);  // whoever read the output has enough: an error as any other
  const auto use = [&](const FrameReport& frame) {
    if (interrupted) throw std::runtime_error("interrupted; no bag is left");
    ++clouds;
    json.write(frame);
    summary.add(frame);
    damaged = damaged || frame.damaged;
    if (!json.toStdout()) std::cout << tools::frameLine(frame);
    tools::flushOutput();
  };
  primitect::ros_layer::ShowPoints draw;
  if (!options.pictures.empty()) {
    const Pictures pictures(options.pictures);
    draw = [&clouds, pictures](const FrameReport& frame, const primitect::io::LabelledPoints& points) {
      pictures.write(clouds, frame, points);
    };
  }
  const primitect::ros_layer::BagOutcome outcome = primitect::ros_layer::detectInBags(options.job, use, draw);
  json.finish();
  if (!json.toStdout()) std::cout << summary.text(outcome.topic, options.job.params);
  if (!summary.warning().empty()) std::cerr << "detect_bag: " << summary.warning() << "\n";
  for (const std::string& note : summary.notes()) std::cerr << "detect_bag: note: " << note << "\n";
  if (outcome.unusable_transforms > 0) {
    std::cerr << "detect_bag: " << outcome.unusable_transforms << " transforms could not be used\n";
  }
  if (outcome.unpaired_images > 0) {
    std::cerr
        << "detect_bag: note: no camera_info has the stamp of " << outcome.unpaired_images
        << " images; they took the last one before them, and nodes, which wait for their own, hear none of them\n";
  }
  return damaged || !summary.anySearched() ? kBadFile : kOk;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto options = tools::parseDetectBagOptions(argc, argv);
    const int exit_code = options ? run(*options) : kOk;
    tools::flushOutput();
    return exit_code;
  } catch (const std::invalid_argument& error) {
    std::cerr << "detect_bag: " << error.what() << "\n";
    return kBadUsage;
  } catch (const std::exception& error) {
    std::cerr << "detect_bag: " << error.what() << "\n";
    return kBadFile;
  }
}
