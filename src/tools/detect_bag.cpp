// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// detect_bag BAG...: finds primitives in the clouds of a recording; see --help.
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "io/report.h"
#include "tools/bag_text.h"
#include "tools/detect_bag_options.h"

namespace {

namespace tools = primitect::tools;
using primitect::ros_layer::BagFrame;

enum ExitCode : int { kOk = 0, kBadFile = 1, kBadUsage = 2 };

/// A line for each cloud, in a file or on standard output; or nowhere.
class JsonLines {
 public:
  explicit JsonLines(const std::string& path) : path_(path) {
    if (path.empty() || toStdout()) return;
    file_.open(path);
    check();
  }

  bool toStdout() const { return path_ == "-"; }

  void write(const BagFrame& frame) {
    if (path_.empty()) return;
    std::ostream& out = toStdout() ? std::cout : file_;
    out << primitect::io::frameJson(
        {frame.secs, frame.nsecs, frame.frame_id, frame.problem, frame.found, frame.processing_ms});
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

int run(const tools::DetectBagOptions& options) {
  JsonLines json(options.json);
  tools::BagSummary summary;
  const std::string topic = primitect::ros_layer::detectInBags(options.job, [&](const BagFrame& frame) {
    json.write(frame);
    summary.add(frame);
    if (!json.toStdout()) std::cout << tools::frameLine(frame) << std::flush;
  });
  json.finish();
  if (!json.toStdout()) std::cout << summary.text(topic);
  return kOk;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto options = tools::parseDetectBagOptions(argc, argv);
    return options ? run(*options) : kOk;
  } catch (const std::invalid_argument& error) {
    std::cerr << "detect_bag: " << error.what() << "\n";
    return kBadUsage;
  } catch (const std::exception& error) {
    std::cerr << "detect_bag: " << error.what() << "\n";
    return kBadFile;
  }
}
