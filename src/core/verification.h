// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Checking candidates on the samples, round by round: which shapes are there, and how sure that is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "core/candidate.h"
#include "core/frame_memory.h"
#include "core/hypothesis.h"
#include "core/proposal.h"
#include "core/sample_graph.h"
#include "core/segmentation.h"
#include "core/selection.h"
#include "primitect/params.h"

namespace primitect {

/// The scale of a frame.
struct FrameScale {
  double scene_diameter = 1.0;  ///< d_s, m
  bool depth_camera = false;    ///< depth along z: its noise grows with it
  double image_noise = 0.0;     ///< see Detections
  double sample_noise = 0.0;    ///< of its samples, noiseOfSteadied()
  double image_growth = 1.0;    ///< growthOf() the image
  double radius_stretch = 1.0;  ///< bins of radii are so many times as wide as params.radius_bin says
  double view_radius = 0.0;     ///< m; radii may be as large as this, even where the bins end before
  bool fitted_normals = false;  ///< the cloud brought none; false where its own are measured anew
  bool from_origin = false;     ///< seen by a sensor there
};

/// All hypotheses of a frame and the samples that they are checked on.
class Verification {
 public:
  explicit Verification(const Params& params) : params_(params) {}

  /// How many samples a shape needs at least, instead of the parameter's number.
  void setMinInliers(int count) { params_.min_inliers = count; }

  /// As how many samples each speaks for a shape that is not of the first of several draws; until the next frame
  /// begins.
  void weighLaterDraws(double weight) { weight_ = weight; }

  /// Forgets the last frame.
  void begin(const FrameScale& scale);

  /// The noise, from the first samples and what they voted for, strongest first.
  void measureNoise(Samples samples, const List<Candidate>& candidates);

  /// Samples of a round, with normals, and what is to be proposed from now on.
  void addSamples(Samples samples);

  /// Whether a candidate of this reference, any sample added so far, would be looked at.
  bool wants(std::uint32_t sample) const { return proposer_.wants(sample); }

  /// Candidates of such references, strongest first.
  void propose(const List<Candidate>& candidates);

  /// Selects from all that was proposed, as it was proposed: fits again have time until conclude().
  void select();

  /// Indices of the samples that nothing selected explains, where there are enough of them together for a shape.
  List<std::uint32_t> unexplained();

  /// What the image says of a cylinder, a cone or a ball of samples. bulges: it may be a slice of a ball.
  enum class ImageSays { nothing, not_seen, bulges };
  using AskImage = std::function<ImageSays(const Segment&)>;

  /// Selects anew, fits what was selected again, joins planes that are one, takes apart what leads over tops of nearly
  /// one height or tubes of several radii, and then refuses what is not likely enough, or not seen; its samples may
  /// serve others. No ask_image, or any confidence will do: the image is not asked. Then large planes of a depth camera
  /// that are less even than the rest are added (uneven_planes.h).
  void conclude(const AskImage& ask_image = nullptr);

  /// What points may stray; samples, which are steadied, less.
  const NoiseModel& noise() const { return point_noise_; }

  /// Of the points that shapes are fitted to in the end.
  NoiseModel fullNoise() const;
  /// False: nothing stood out clearly enough, and the noise is the largest that is possible.
  bool noiseMeasured() const { return noise_measured_; }
  const Samples& samples() const { return samples_; }
  /// What was selected, with the samples of each; every sample belongs to one at most. After conclude() those
  /// with the most samples come first.
  const List<Segment>& segments() const { return segments_; }
  const Refusals& refusals() const { return refusals_; }
  /// A plane with so much of the first draw, which was from all points, that it needs no closer look (plane_parts.h).
  bool isLargePlane(const Segment& segment) const;
  /// One with so much of it that things may stand on it.
  bool maySupport(const Segment& segment) const;
  /// The normal of that one which this plane is most parallel to: what it may stand on; nothing where there is
  /// none.
  std::optional<Vec3> levelOf(const Segment& plane) const;
  double radiusBin() const;      ///< m
  double largestRadius() const;  ///< m, of a shape

 private:
  /// A segment that is not of several things; a plane is none as far as this level tells.
  struct Whole {
    Kind kind;
    List<std::uint32_t> inliers;
    std::optional<Vec3> level;
  };

  /// Samples of a segment (rising indices) and the shape that they have alone.
  struct Part {
    List<std::uint32_t> samples;
    Hypothesis hypothesis;
    double worth;  ///< gains at these samples less the shape's price
  };

  /// How many samples a shape needs at least.
  std::size_t needed() const { return static_cast<std::size_t>(params_.min_inliers); }
  /// Inliers are in rising order, and those of the first draw before others.
  std::size_t inliersOfFirstDraw(const Segment& segment) const;
  bool isUnlikely(const Segment& segment) const { return segment.confidence < params_.min_confidence; }
  void setNoise(const NoiseModel& of_samples);
  Limits sampleLimits() const;
  ProposalRules rules() const;
  ProposalRules quickRules() const;
  void selectAgain();
  void segmentSelected();
  void dropLikenesses();
  void joinFacets();
  void refit();
  void refit(const Segment& segment, const HeldGains& held);
  void join(const Hypothesis& version);
  void split(const Segment& segment, const HeldGains& held);
  bool joinPlanes();
  std::size_t countBeside(const Segment& segment, const Segment& other) const;
  bool areNearlyOnePlane(const Segment& a, const Segment& b) const;
  bool areInterwoven(const Segment& few, const Segment& many) const;
  std::optional<Hypothesis> onePlaneFor(const Segment& few, const Segment& many, const HeldGains& held);
  void silenceWithLikes(std::uint32_t a, std::uint32_t b);
  void settle();
  bool separate();
  bool separateTops(const Segment& segment, const HeldGains& held);
  bool separateSteps(const Segment& segment, const HeldGains& held);
  std::optional<Part> partOf(List<std::uint32_t> samples, const Segment& segment, const HeldGains& held);
  List<Part> stepsOf(const Shape& shape, const List<std::uint32_t>& samples, int depth, const Segment& segment,
                     const HeldGains& held);
  void rejoin(const Segment& segment, const HeldGains& held, List<Part>& parts);
  bool mayBeLikely(const List<Part>& parts, const HeldGains& held) const;
  std::optional<Hypothesis> alone(const List<std::uint32_t>& part, const List<std::uint32_t>& others,
                                  const Segment& segment, const HeldGains& held);
  bool isWhole(const Segment& segment, const std::optional<Vec3>& level) const;
  double standingOf(const Segment& segment) const;
  void countDraws(Segment& segment) const;
  void judge(const Hypothesis& hypothesis, const List<std::uint32_t>& owner, std::uint32_t self, double stands,
             const HeldGains& held, Segment& segment) const;
  void assess(Segment& segment, const HeldGains& held);
  void assess();
  bool refuseUnlikely();
  bool offerBall(const Segment& segment);
  bool refuseByImage(const AskImage& ask_image);
  bool refuseTwins();
  void refuse(const Segment& segment, Refusal why);
  void addUnevenPlanes();
  HeldGains heldByChosen() const;

  Params params_;
  FrameScale scale_;
  NoiseModel noise_;        ///< of samples
  NoiseModel point_noise_;  ///< see noise()
  bool noise_measured_ = false;
  double weight_ = 1.0;  ///< of a sample of later draws
  Samples samples_;
  SampleGraph graph_;
  Proposer proposer_;
  List<Hypothesis> pool_;
  Selection selection_;
  List<Segment> segments_;
  List<Whole> wholes_;  ///< found while this frame is concluded; most are asked about several times
  Refusals refusals_;
};

}  // namespace primitect
