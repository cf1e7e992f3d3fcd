// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// JSON lines to a file or to standard output.
#pragma once

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace primitect::eval {

/// Where the JSON lines go; a line is flushed as soon as it is there, so that nothing is lost when the run is ended.
class LineWriter {
 public:
  explicit LineWriter(const std::string& path) : wanted_(!path.empty()), path_(path) {
    if (!wanted_ || path == "-") return;
    file_.open(path, std::ios::app);
    if (!file_) throw std::runtime_error("--json " + path + ": cannot be opened");
  }

  void write(const std::string& line) {
    if (!wanted_) return;
    std::ostream& out = file_.is_open() ? file_ : std::cout;
    out << line << std::endl;
    if (!out) throw std::runtime_error("--json " + path_ + ": cannot be written");
  }

  bool toStandardOutput() const { return wanted_ && !file_.is_open(); }

 private:
  bool wanted_;
  std::string path_;
  std::ofstream file_;
};

}  // namespace primitect::eval
