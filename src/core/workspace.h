// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame and what they keep between frames; only for detector.cpp.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/arrangement.h"
#include "core/curved_patch.h"
#include "core/depth_waves.h"
#include "core/evidence.h"
#include "core/faces_apart.h"
#include "core/frame_memory.h"
#include "core/labeling.h"
#include "core/level_top.h"
#include "core/measurement.h"
#include "core/normals.h"
#include "core/pair_voting.h"
#include "core/plane_parts.h"
#include "core/sampling.h"
#include "core/search.h"
#include "core/segmentation.h"
#include "core/spare_outlines.h"
#include "core/thinned_image.h"
#include "core/thinned_list.h"
#include "core/tube_gaps.h"
#include "core/verification.h"
#include "primitect/detector.h"

namespace primitect {

inline bool isDescribed(const Segment& segment) { return !segment.inliers.empty(); }

/// What a detector keeps between frames so that it need not be allocated anew.
struct Detector::Workspace {
  explicit Workspace(const Params& checked_params)
      : params(checked_params),
        voting(limitsForSamples(checked_params)),
        verification(whileChoosing(checked_params)),
        search(voting, verification, [this](const char* stage) { done(stage); }) {}

  void done(const char* stage) const {
    if (!stage_done) return;
    const FrameMemoryScope others(nullptr);  // what a callback makes is not the frame's
    stage_done(stage);
  }

  /// Of all rounds of this frame.
  const Samples& allSamples() const { return params.verify ? verification.samples() : all_samples; }

  // The stages: workspace.cpp.

  /// Forgets the last frame and looks whether this one can be used. Returns the cloud to work on.
  const Cloud& begin(const Cloud& cloud, const Effort& frame_effort);

  /// The samples of a round, with normals; false when there is nothing left to vote.
  bool prepareRound(const Cloud& cloud, int round);

  /// The paper's way: what most references agree on.
  void segmentByVotes();
  void segmentVerified(const Cloud& cloud, int round);

  /// More samples where the shapes are, without the points of large planes: these need no closer look.
  void lookCloser(const Cloud& cloud);

  /// What is there, and how likely; refuses what is not likely enough.
  void conclude(const Cloud& cloud);

  // Between them, and what they draw: workspace_samples.cpp.

  /// Asks the effort's owner, and remembers how large a part of the next draw there is time for. False: for none of it,
  /// now and later in this frame.
  bool askForTime();
  std::size_t atThisEffort(int count) const;
  int inliersAtThisEffort(double of_samples = 1.0) const;
  double pixelsOfSample(const Cloud& cloud);
  std::size_t mostSamples(const Cloud& cloud);
  double shareOfSamples() const;
  Labeling::Rows rowsFor(const Cloud& cloud);
  void draw(const Cloud& cloud, const std::vector<Detection>& explaining, int count, int round);
  double weightOfCloserSamples(const Cloud& cloud);

  // The last one: workspace_measures.cpp.

  /// The final numbers come from the points of the cloud.
  void measureOnCloud(const Cloud& whole);

  // Between labels and measures: workspace_tops.cpp.

  /// A plane for every height, where one leads over several tops.
  void takeTopsApart(const Cloud& whole, List<LabelRun>& runs);

  // Then: workspace_faces.cpp.

  /// A detection for every face, where several lie in one plane and are seen to be apart.
  void takeFacesApart(const Cloud& whole, List<LabelRun>& runs);

  /// Of such faces that were measured.
  void distrustUnevenFaces(const List<bool>& measured);

  // Then: workspace_tubes.cpp.

  /// A detection for every thing of one radius on one axis, where they are seen to be apart.
  void takeTubesApart(const Cloud& whole, const ImageRays& rays, List<LabelRun>& runs);

  // What these are made of.

  bool bringsNormals(const Cloud& cloud) const;
  void forgetResult();
  void measureImageNoise(const Cloud& image);
  void distrustBentParts(const List<bool>& measured);
  void distrustInterleaved(const List<bool>& measured, const Cloud& cloud);
  void measureScale();
  bool improveNormals(const Cloud& cloud);
  void measureNoise(const Cloud& cloud);
  void useVerified();
  void voteAgain();
  Verification::ImageSays askImage(const Segment& segment, const Cloud& cloud);
  void describeSegments(const List<Segment>& described, const Samples& of);

  struct PlaneInImage {
    std::size_t of;  ///< detection
    FacesApart faces;
  };
  /// A face, and the largest of those in its plane: detections.
  struct FaceBeside {
    std::size_t index, largest;
  };

  void thin(const Cloud& whole);
  void findPoints(const Cloud& whole, const ImageRays& rays);
  void gatherPoints(const List<LabelRun>& runs);
  void gatherAnew(List<LabelRun>& runs);
  List<std::size_t> countPoints(const List<LabelRun>& runs) const;
  List<bool> areEnough(const List<std::size_t>& all, const Cloud& whole);
  Vec3 stretchOf(const Detection& item) const;
  double stretchOfAxis(const Detection& item) const;
  void labelStretched(Labeling& of_cloud, const Cloud& whole, List<LabelRun>& runs);
  void giveToTops(const LevelTops& tops, std::size_t of, const Cloud& whole, const List<LabelRun>& runs);
  template <class PartAt>
  void relabel(const List<LabelRun>& runs, std::uint32_t before, const List<std::uint32_t>& label_of,
               const PartAt& partAt);
  std::uint32_t addPart(const Shape& shape, std::size_t of);
  bool giveToParts(const List<AxisPart>& parts, std::size_t of, const Cloud& whole, const List<LabelRun>& runs);
  List<PlaneInImage> planesInImage(const List<LabelRun>& runs) const;
  bool endsBeforeTheBound(std::size_t plane) const;
  void findFaces(const List<LabelRun>& runs, std::size_t least, PlaneInImage& plane);
  std::optional<std::size_t> curvedUnder(const Labelled<Plane>& plane, const List<std::uint32_t>& pixels) const;
  List<List<std::uint32_t>> pixelsOfFaces(const PlaneInImage& plane, const List<LabelRun>& runs) const;
  bool giveToFaces(std::size_t least, const PlaneInImage& plane, const List<LabelRun>& runs);
  DepthWaves findWaves(const List<List<std::uint32_t>>& clear_points);
  List<WantedPoints> wantedPoints() const;
  std::size_t fewestPoints(Kind kind, const Cloud& cloud);

  FrameMemory memory;  ///< of all lists of this detector: it outlives them
  Params params;
  std::function<void(const char*)> stage_done;
  const Effort* effort = nullptr;  ///< only while a frame runs
  double share_in_time = 1.0;      ///< of the next draw's samples; 0: of no more
  bool cut_short = false;          ///< this frame's search, for want of time
  std::size_t wanted_samples = 0;  ///< drawn in this frame, and those that there was no time for
  bool brings_normals = false;     ///< the cloud of this frame, ones that are wanted
  bool depth_camera = false;       ///< took this frame, and shapes are verified with its noise, which is known
  double image_growth = 1.0;       ///< growthOf() the image
  double sample_noise = 0.0;       ///< of the image, noiseOfSteadied()
  ThinnedImage thinned_image;
  double each_pixel = 1.0;  ///< of this frame's thinned image: points of the cloud that it stands for
  Arrangement arrangement;
  PairVoting voting;
  Verification verification;
  Search search;
  Sampler sampler;
  Samples samples;             ///< of this round
  Samples all_samples;         ///< of all rounds of this frame, by votes alone
  Tolerance tolerance;         ///< of what belongs to a shape
  List<Candidate> candidates;  ///< by votes alone
  List<Segment> segments;      ///< by votes alone
  Labeling labeling;
  List<std::uint64_t> unexplained;  ///< bits of the points that samples are drawn from
  ThinnedList thinned;
  Labeling labeling_of_thinned;
  std::vector<std::uint32_t> labels;  ///< of the points of the thinned list
  List<bool> kept;                    ///< which detections have enough points
  List<bool> far_sides;               ///< which detections have points there
  List<LabelledPoints> points;        ///< of the detections
  List<FaceBeside> beside;            ///< of planes that were taken apart
  NormalSource normal_source;         ///< of this frame
  SpareOutlines spare_outlines;
  Detections result;
};

/// Points of a shape that was taken apart: those that partAt(index) says are of part k get label_of[k], others, for
/// which it is negative, none.
template <class PartAt>
void Detector::Workspace::relabel(const List<LabelRun>& runs, std::uint32_t before, const List<std::uint32_t>& label_of,
                                  const PartAt& partAt) {
  for (const LabelRun& run : runs) {
    if (run.label != before) continue;
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const int part = partAt(i);
      labels[i] = part < 0 ? 0u : label_of[part];
    }
  }
}

}  // namespace primitect
