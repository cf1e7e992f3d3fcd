// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The pipeline: rounds of sample, normals, vote, segment; then a closer look, and measures on the points of the cloud.
#include "primitect/detector.h"

#include <utility>

#include "core/workspace.h"

namespace primitect {
namespace {

Params checked(const Params& params) {
  checkParams(params);
  return params;
}

}  // namespace

Detector::Detector(const Params& params) : work_(std::make_unique<Workspace>(checked(params))) {}
Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;

const Params& Detector::params() const { return work_->params; }

SampleView Detector::samples() const {
  const Samples& s = work_->allSamples();
  return {s.x, s.y, s.z, s.nx, s.ny, s.nz};
}

void Detector::onStageDone(std::function<void(const char*)> callback) { work_->stage_done = std::move(callback); }

const Detections& Detector::detect(const Cloud& cloud) {
  Workspace& w = *work_;
  w.begin(cloud);
  for (int round = 0; round < w.params.rounds && w.result.status == Status::ok; ++round) {
    if (!w.prepareRound(cloud, round)) break;
    w.params.verify ? w.segmentVerified(cloud, round) : w.segmentByVotes();
    w.done("segment");
  }
  if (w.params.verify && w.result.status == Status::ok) {
    w.lookCloser(cloud);
    w.done("look closer");
    w.measureOnCloud(cloud);
    w.done("measure");
  }
  return w.result;
}

void Detector::label(const Cloud& cloud, std::vector<std::uint32_t>& labels) const {
  labelPoints(cloud, work_->result.items, work_->tolerance, labels);
}

}  // namespace primitect
