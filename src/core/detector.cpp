// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline: rounds of sample, normals, vote, segment; then a closer look, and measures on the points of the cloud.
#include "primitect/detector.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/far_sides.h"
#include "core/workspace.h"

namespace primitect {
namespace {

Params checked(const Params& params) {
  checkParams(params);
  return params;
}

const Effort& checked(const Effort& effort) {
  if (0.0 < effort.share && effort.share <= 1.0) return effort;
  throw std::invalid_argument("share of the effort is " + std::to_string(effort.share) + ", allowed: above 0, up to 1");
}

}  // namespace

double leastShare(const Params& params) {
  constexpr double kFewestSamples = 256.0;
  return std::min(1.0, kFewestSamples / params.samples);
}

Detector::Detector(const Params& params) : work_(std::make_unique<Workspace>(checked(params))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Params& Detector::params() const { return work_->params; }

const Detections& Detector::result() const { return work_->result; }

SampleView Detector::samples() const {
  const Samples& s = work_->allSamples();
  return {s.x.data(), s.y.data(), s.z.data(), s.nx.data(), s.ny.data(), s.nz.data(), s.size()};
}

void Detector::onStageDone(std::function<void(const char*)> callback) { work_->stage_done = std::move(callback); }

const Detections& Detector::detect(const Cloud& cloud, const Effort& effort) {
  Workspace& w = *work_;
  const FrameMemoryScope scope(&w.memory);
  const Cloud& seen = w.begin(cloud, checked(effort));
  for (int round = 0; round < w.params.rounds && w.result.status == Status::ok; ++round) {
    if (round > 0 && !w.askForTime()) break;
    if (!w.prepareRound(seen, round)) break;
    w.params.verify ? w.segmentVerified(seen, round) : w.segmentByVotes();
    w.done("segment");
  }
  if (w.params.verify && w.result.status == Status::ok) {
    if (w.askForTime()) w.lookCloser(seen);
    w.conclude(seen);
    w.done("look closer");
    w.measureOnCloud(seen);
    w.done("measure");
  }
  return w.result;
}

void Detector::label(const Cloud& cloud, std::vector<std::uint32_t>& labels) const {
  const FrameMemoryScope scope(&work_->memory);
  if (!cloud.isConsistent()) return labels.assign(cloud.size(), 0);
  labelPoints(cloud, work_->result.items, work_->tolerance, labels);
  const bool may_be_far = work_->tolerance.noise.ofDepthCamera() && work_->params.does(Step::far_sides);
  if (may_be_far) dropFarSides(cloud, work_->result.items, work_->tolerance, labels);
}

}  // namespace primitect
