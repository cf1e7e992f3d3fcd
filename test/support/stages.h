// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages that a detector goes through in a frame.
#pragma once

#include <string>

#include "primitect/detector.h"

namespace primitect::test {

/// Votes and what is made of them, or of new samples before, take turns: each run of turns becomes one.
std::string turnsAsOne(const std::string& stages);

/// Names of the stages in their order, turns as one.
inline std::string stagesOf(Detector& detector, const Cloud& cloud, const Effort& effort = {}) {
  std::string stages;
  detector.onStageDone([&stages](const char* stage) { stages += std::string(stage) + " "; });
  detector.detect(cloud, effort);
  detector.onStageDone(nullptr);
  return turnsAsOne(stages);
}

}  // namespace primitect::test
