// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Three tasks, each a summary and its numbers.
#include "detector_diagnostics.h"

#include <algorithm>

#include "primitect/kernel_choice.h"
#include "primitect/noisy_image.h"

namespace primitect::ros_layer {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

const char* yesOrNo(std::optional<bool> fact) { return !fact ? "unknown" : *fact ? "yes" : "no"; }

}  // namespace

void FrameCounters::count(const PrimitiveArray& message, const Refusals& refusals) {
  if (message.status < kStatusCount) ++by_status[message.status];
  last_status = message.status;
  last_points_in = message.points_in;
  last_points_used = message.points_used;
  last_by_kind = {};
  last_refused = refusals;
  for (const Primitive& primitive : message.primitives) {
    ++last_by_kind[primitive.type];
    ++by_kind[primitive.type];
  }
  for (std::size_t i = 0; i < kRefusalCount; ++i) refused[i] += refusals.counts[i];
}

DetectorDiagnostics::DetectorDiagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                                         const std::string& name)
    : updater_(handle, private_handle, name) {
  updater_.setHardwareID("none");
  updater_.add("input", [this](DiagnosticStatusWrapper& status) { fillInput(status); });
  updater_.add("detection", [this](DiagnosticStatusWrapper& status) { fillDetection(status); });
  updater_.add("timing", [this](DiagnosticStatusWrapper& status) { fillTiming(status); });
}

void DetectorDiagnostics::frameReceived(const ros::Time& stamp) {
  back_jumps_.cloud(stamp);
  ++counters_.frames_in;
  last_frame_ = SteadyClock::now();
}

void DetectorDiagnostics::frameDone(const PrimitiveArray& message, const Refusals& refusals, const FrameView& view,
                                    const std::string& error) {
  counters_.count(message, refusals);
  view_ = view;
  last_error_ = error;
  last_frame_ = SteadyClock::now();  // a frame that took long is no silence
}

void DetectorDiagnostics::frameFailed(const std::string& error) {
  ++counters_.failed;
  last_error_ = error;
}

void DetectorDiagnostics::publish(bool subscribed, const StageTimes& times, const LatencyGovernor* governor) {
  if (subscribed && !subscribed_) last_frame_ = SteadyClock::now();
  subscribed_ = subscribed;
  times_ = &times;
  governor_ = governor;
  updater_.force_update();
  times_ = nullptr;
  governor_ = nullptr;
}

bool DetectorDiagnostics::timeWentBack(const ros::Time& stamp) {
  const SteadyClock::time_point now = SteadyClock::now();
  back_jumps_.back(stamp, now);
  startAnew();
  return back_jumps_.often(now);
}

void DetectorDiagnostics::startAnew() {
  counters_ = FrameCounters();
  view_ = FrameView();
  last_error_.clear();
}

bool DetectorDiagnostics::silent() const { return subscribed_ && secondsSince(last_frame_) > kSilenceSeconds; }

void DetectorDiagnostics::fillInput(DiagnosticStatusWrapper& status) const {
  if (!subscribed_) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes to an output");
  } else if (silent()) {
    const std::string before = last_error_.empty() ? "" : "; the last one was refused: " + last_error_;
    status.summaryf(DiagnosticStatus::WARN, "no cloud for %.0f s%s", secondsSince(last_frame_), before.c_str());
  } else if (!last_error_.empty()) {
    status.summary(DiagnosticStatus::WARN, "last cloud refused: " + last_error_);
  } else if (back_jumps_.often(SteadyClock::now())) {
    status.summary(DiagnosticStatus::WARN,
                   "stamps go back again and again, and tracks begin anew each time: do two sources publish here?");
  } else if (view_.seen_from_origin == false) {
    status.summary(DiagnosticStatus::WARN,
                   "clouds are not seen from the origin of their frame: set sensor_frame, or is it the right one?");
  } else if (view_.normals_face_away) {
    status.summary(DiagnosticStatus::WARN, "most normals of the clouds face away from the sensor: set orient_normals");
  } else {
    status.summary(DiagnosticStatus::OK, counters_.frames_in == 0 ? "waiting for the first cloud" : "receiving");
    if (view_.image_noise >= kNoisyImage) {
      status.summaryf(DiagnosticStatus::OK, "receiving, with %.1f times the noise of structured light",
                      view_.image_noise);
    }
  }
  status.add("frames in", counters_.frames_in);
  status.add("times that stamps went back", back_jumps_.count());
  for (std::size_t i = 0; i < FrameCounters::kStatusCount; ++i) {
    const std::string name = statusName(static_cast<Status>(i));
    status.add(i == 0 ? "processed" : "rejected: " + name, counters_.by_status[i]);
  }
  status.add("failed", counters_.failed);
  status.add("points in last cloud", counters_.last_points_in);
  status.add("valid points in last cloud", counters_.last_points_used);
  status.add("seen from the origin", yesOrNo(view_.seen_from_origin));
  const char* const camera = "camera that the points tell, x y z (m) and x y z w";
  if (view_.found_camera) {
    const Eigen::Vector3d at = view_.found_camera->translation();
    const Eigen::Quaterniond turn(view_.found_camera->linear());
    status.addf(camera, "%.3f %.3f %.3f  %.4f %.4f %.4f %.4f", at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(),
                turn.w());
  } else {
    status.add(camera, "none");
  }
  const char* const noise = "noise, times structured light's";
  view_.image_noise > 0.0 ? status.addf(noise, "%.2f", view_.image_noise) : status.add(noise, "unknown");
  const char* const waves = "waves of the depth, percent of it";
  view_.depth_waves < 0.0 ? status.add(waves, "no plane tells") : status.addf(waves, "%.2f", 100.0 * view_.depth_waves);
}

void DetectorDiagnostics::fillDetection(DiagnosticStatusWrapper& status) const {
  std::string summary;
  for (std::size_t i = 0; i < kKindCount; ++i) {
    const std::string name = kindName(static_cast<Kind>(i));
    summary += (i == 0 ? "" : ", ") + name + " " + std::to_string(counters_.last_by_kind[i]);
    status.add(name + " in last frame", counters_.last_by_kind[i]);
    status.add(name + " in all frames", counters_.by_kind[i]);
  }
  status.summary(DiagnosticStatus::OK, summary);
  for (std::size_t i = 0; i < kRefusalCount; ++i) {
    const std::string reason = refusalName(static_cast<Refusal>(i));
    status.add("refused in last frame: " + reason, counters_.last_refused.counts[i]);
    status.add("refused: " + reason, counters_.refused[i]);
  }
  status.add("last status", statusName(static_cast<Status>(counters_.last_status)));
}

void DetectorDiagnostics::fillTiming(DiagnosticStatusWrapper& status) const {
  status.summary(DiagnosticStatus::OK, "no frame yet");
  status.add("voting kernel", kernelInUse());
  status.add("loops", loopsInUse());
  if (!times_) return;
  for (const StageSummary& s : times_->summaries()) {
    status.addf(s.stage + " ms p50 p95 max", "%.2f %.2f %.2f", s.median, s.p95, s.max);
    if (s.stage == "total") status.summaryf(DiagnosticStatus::OK, "%.1f ms a frame (median)", s.median);
  }
  fillLatency(status);
}

void DetectorDiagnostics::fillLatency(DiagnosticStatusWrapper& status) const {
  if (!governor_) return;
  status.addf("max_latency ms", "%g", 1e3 * governor_->bound());
  status.addf("share of the samples", "%.2f", governor_->share());
  status.add("frames under max_latency", governor_->frames() - governor_->missed());
  status.add("frames over max_latency", governor_->missed());
  if (governor_->hopeless()) {
    status.summary(DiagnosticStatus::WARN, "even with the fewest samples frames take longer than max_latency");
  } else if (governor_->missesBound()) {
    status.summary(DiagnosticStatus::WARN, std::to_string(governor_->missedLately()) + " of the last " +
                                               std::to_string(governor_->framesLately()) +
                                               " frames took longer than max_latency");
  }
}

}  // namespace primitect::ros_layer
