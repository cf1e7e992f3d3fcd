// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The detectors that are compared, ours and peers, behind one face.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "eval/labelled_cloud.h"
#include "primitect/primitives.h"

namespace primitect::eval {

/// What a method says about a cloud.
struct Answer {
  std::vector<Shape> shapes;
  std::vector<Detection> detections;  ///< ours: all that is said of each shape; peers: empty
  std::vector<std::uint32_t> labels;  ///< ours: of each point of the cloud, see Detector::label(); peers: empty
  double total_ms = 0.0;              ///< cloud in memory -> shapes; without reading files and without foreign normals
  double cpu_ms = -1.0;               ///< peers: processor time of it; -1: unknown
  double vote_ms = -1.0;              ///< ours: the voting stage alone; -1: has none
  double prepare_ms = 0.0;            ///< part of total_ms that builds search trees
  std::string failure;                ///< not empty: the method gave up on this cloud, and why
};

/// A detector under a name. `run` gets clouds one after the other and repeats itself `repeat` times on each: the
/// shortest time counts, the shapes are the last run's.
struct Method {
  std::string name;
  std::function<Answer(const LabelledCloud& input, int repeat)> run;
  bool ours = false;
  int algorithm_seed = 0;  ///< ours: see makeMethod()
};

/// Ours: "default", "paper", the ablations "b" to "e" of the paper, or NAME=preset:PRESET,parameter=value,..., with
/// without:STEP among them for each step of steps.def that is left out.
/// Peers: see eval/peers/peers.h.
/// algorithm_seed: of our random draw, whatever the text says; 0: that of the text. Peers and the truth ignore it.
/// Throws std::invalid_argument naming the text and what is allowed.
Method makeMethod(const std::string& text, int algorithm_seed = 0);

}  // namespace primitect::eval
