// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What `detect_bag` prints for people.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "io/report.h"
#include "primitect/params.h"

namespace primitect::tools {

/// One line: when it was recorded, how many of each kind were found, or why nothing was, and the time it took.
std::string frameLine(const io::FrameReport& frame);

/// Of all clouds of a recording.
class BagSummary {
 public:
  void add(const io::FrameReport& frame);

  /// "51 clouds on /camera/points, 51 searched. ..."; where none was, why. A second line counts what was refused, with
  /// the parameters that may be the reason.
  std::string text(const std::string& topic, const Params& params) const;

  /// What makes results doubtful, a line; empty: nothing does.
  std::string warning() const;

  /// What may surprise, a line each.
  std::vector<std::string> notes() const;

  bool anySearched() const { return searched_ > 0; }

 private:
  std::size_t clouds_ = 0, searched_ = 0, elsewhere_ = 0, assumed_ = 0, moved_ = 0;
  std::string problem_;                             ///< of the first that was not searched
  std::array<std::size_t, kKindCount> found_ = {};  ///< in all clouds together
  double beyond_ = 0.0;                             ///< shares beyond max_depth, their sum
  std::size_t tracks_ = 0;                          ///< that began
  Refusals refusals_;
  std::vector<double> milliseconds_;
};

}  // namespace primitect::tools
