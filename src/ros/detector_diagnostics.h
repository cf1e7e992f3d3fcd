// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// What the detector says about itself on /diagnostics: input, detection, timing.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <primitect/PrimitiveArray.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "back_jumps.h"
#include "primitect/latency_governor.h"
#include "primitect/primitives.h"
#include "steady_time.h"

namespace primitect::ros_layer {

/// Counters since the start or the last backward time jump.
struct FrameCounters {
  static constexpr std::size_t kStatusCount = 5;

  std::uint64_t frames_in = 0;
  std::uint64_t failed = 0;                                 ///< ended by an exception
  std::array<std::uint64_t, kStatusCount> by_status = {};   ///< frames of each PrimitiveArray.status
  std::array<std::uint64_t, kKindCount> by_kind = {};       ///< primitives reported
  std::array<std::uint64_t, kRefusalCount> refused = {};    ///< shapes that were tried and did not come out
  std::array<std::uint32_t, kKindCount> last_by_kind = {};  ///< primitives of the last frame
  Refusals last_refused;                                    ///< of the last frame
  std::uint32_t last_points_in = 0;
  std::uint32_t last_points_used = 0;
  std::uint8_t last_status = PrimitiveArray::OK;

  void count(const PrimitiveArray& message, const Refusals& refusals);
};

/// How the last cloud was seen.
struct FrameView {
  std::optional<bool> seen_from_origin;           ///< by a sensor there that looks along z; empty: unknown
  bool normals_face_away = false;                 ///< most of those that it brought, from that sensor
  double image_noise = 0.0;                       ///< times structured light's; 0: not measured
  double depth_waves = -1.0;                      ///< share of the depth; -1: no plane tells
  std::optional<Eigen::Isometry3d> found_camera;  ///< where the points tell that it is elsewhere: its optical frame, in
                                                  ///< that of the cloud
};

class DetectorDiagnostics {
 public:
  /// name: the node's or nodelet's full name.
  DetectorDiagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, const std::string& name);

  void frameReceived(const ros::Time& stamp);
  /// error: why the cloud was refused, or empty.
  void frameDone(const PrimitiveArray& message, const Refusals& refusals, const FrameView& view,
                 const std::string& error);
  void frameFailed(const std::string& error);

  /// Publishes now; for a wall timer, as the updater's own clock stalls when time jumps back.
  /// governor: null if max_latency is off.
  void publish(bool subscribed, const StageTimes& times, const LatencyGovernor* governor);
  /// The stamp of the next cloud is earlier than the one before: counts from here on. True: that happens again and
  /// again, see back_jumps.h.
  bool timeWentBack(const ros::Time& stamp);

  /// No cloud for longer than this (s), while subscribed, is silence.
  static constexpr double kSilenceSeconds = 5.0;

  /// As of the last publish().
  bool silent() const;
  /// Since the start, or since time went back.
  bool anyFrame() const { return counters_.frames_in > 0; }

 private:
  void startAnew();
  void fillInput(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void fillDetection(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void fillTiming(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void fillLatency(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  FrameCounters counters_;
  std::string last_error_;
  FrameView view_;
  BackJumps back_jumps_;
  bool subscribed_ = false;
  SteadyClock::time_point last_frame_ = SteadyClock::now();  ///< or when the input was subscribed
  const StageTimes* times_ = nullptr;                        ///< only while publish() runs
  const LatencyGovernor* governor_ = nullptr;                ///< the same
  diagnostic_updater::Updater updater_;
};

}  // namespace primitect::ros_layer
