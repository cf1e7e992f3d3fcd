// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What was found, as JSON for programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/sensor_pose.h"
#include "primitect/moved_image.h"
#include "primitect/primitives.h"
#include "primitect/steps.h"

namespace primitect::io {

/// Name and milliseconds, in the order of the pipeline.
using Timing = std::vector<std::pair<std::string, double>>;

/// All that the report of one file says.
struct FileReport {
  std::string file;
  std::string error;  ///< not empty: the file could not be read, nothing else holds
  Detections detections;
  std::optional<SensorPose> sensor;    ///< where it is not at the origin along z
  std::optional<CameraClue> found_by;  ///< what told it, where the points do
  std::optional<double> effort;        ///< with max_latency: the share of the samples that was drawn at each draw
  Timing timing_ms;                    ///< with several runs: the medians
  int repeats = 1;
  unsigned late_runs = 0;  ///< with max_latency: how many of them took longer
  Steps left_out;
  Timing min_ms, max_ms;  ///< with several runs only
  // Where it was asked for:
  std::optional<Detections> late;         ///< with max_latency: what there was no time for
  std::optional<Detections> unlikely;     ///< what was refused for its confidence
  std::optional<Detections> few_inliers;  ///< what has too few samples, or too few votes
};

/// One JSON object, ends with a newline:
/// {"file", "status", "points_in", "points_used", "samples", "scene_diameter", "image_noise", "depth_waves",
/// "seen_from_origin", "sensor": {"position", "orientation", "from"}, "refused": {reason: count}, "primitives": [...],
/// "timing_ms": {...}}. Metres, radians. What no stage has filled is null, as are the rival of a primitive that has
/// none and a sensor at the origin. With max_latency also "effort", the share of the samples. A file that could not be
/// read: {"file", "error", "primitives": []}. With several runs also "repeats", "timing_min_ms" and "timing_max_ms";
/// where it was asked for "late" (with max_latency), "unlikely" and "few_inliers", written as "primitives".
std::string reportJson(const FileReport& report);

/// A JSON array of such objects, in the order of the files.
std::string reportsJson(const std::vector<FileReport>& reports);

/// What a cloud of a recording gave.
struct FrameReport {
  double recorded = 0.0;              ///< s after the first one
  std::uint32_t secs = 0, nsecs = 0;  ///< stamp
  std::string frame_id;               ///< of the detections
  const Detections& detections;       ///< as the message has them, tracks included
  std::string problem;                ///< not empty: why there are none
  bool damaged = false;               ///< the recording cannot be read there
  double processing_ms = 0.0;
  double beyond = 0.0;  ///< share of what was measured that lies beyond max_depth
  /// Nothing tells that the sensor was at the origin of the frame, which is no optical one.
  bool origin_assumed = false;
  std::optional<SensorPose> found_sensor;  ///< in another frame than its own, where the points tell it
};

/// One JSON object in one line, which ends with a newline: {"stamp": {"secs", "nsecs"}, "frame_id", "status",
/// "problem", "points_in", "points_used", "samples", "depth_waves", "seen_from_origin", "sensor", "processing_ms",
/// "refused": {reason: count}, "primitives": [...]}; problem is null where there is none, sensor ({"position",
/// "orientation"}) where the points told none. Primitives as in reportJson(), those of a track also with "track_id" and
/// "age".
std::string frameJson(const FrameReport& report);

}  // namespace primitect::io
