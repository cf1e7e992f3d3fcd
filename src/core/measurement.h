// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// The final numbers of a detection, measured on the points of the cloud: fit, extent, covariance, what was not seen.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/competition.h"
#include "core/covariance.h"
#include "core/dense_fit.h"
#include "core/depth_waves.h"
#include "core/fit_points.h"
#include "core/frame_memory.h"
#include "core/noise.h"
#include "core/point_noise.h"
#include "core/seen_points.h"
#include "core/truncation.h"
#include "core/upright.h"
#include "primitect/cloud.h"
#include "primitect/params.h"
#include "primitect/primitives.h"

namespace primitect {

/// What tells which points count where a shape is looked for, and what they are fitted by; see toleratedScale().
struct MeasurementNoise {
  NoiseModel tolerated, full;
  DepthWaves waves = {};  ///< only covariances know of them: they are no reason to see less in an image
};

/// Of one frame.
class Measurement {
 public:
  Measurement(const Cloud& cloud, const ImageRays& rays, const Params& params, const MeasurementNoise& noise,
              const Limits& limits);

  /// Which of the clear points lie on the shape that was fitted to them.
  using OnSurface = std::function<List<std::uint32_t>(const Shape& fit)>;

  /// Fits the detection's shape to the clear ones of its points (clear_points.h), and measures all that follows from
  /// the fit. Ends of a list's tube with hardly any points are left out (thin_ends.h). Where the surface is not seen
  /// although it should be (seen_share.h), its size is left open (determination.h) or it is a strip of something else
  /// (strip.h, bent_strip.h), confidence goes down. An axis ends on a plane that was measured before, where it comes
  /// near to one (ends_on_faces.h); these must stay where they are.
  void measure(const LabelledPoints& labelled, const List<std::uint32_t>& clear, const OnSurface& on_surface,
               Detection& detection);

 private:
  struct Fit {
    Shape shape;
    double most_trust;  ///< in its size, see trustInSize()
    PointsChoice from;
  };

  struct Face {
    const Detection* plane;
    HeldAxis normal;
  };

  bool does(Step step) const { return limits_.params.does(step); }
  bool isFittedAlongRays(const Shape& shape) const;
  Shape unbiased(const Shape& fit) const;
  PointsChoice start(const Detection& found);
  void gatherClear(const List<std::uint32_t>& clear, const Detection& found);
  void gatherPart(const Detection& found);
  const Face* faceOf(const Detection& found) const;
  std::optional<PointsChoice> upright(const Face& face, PointsChoice choice, Leaning leaning) const;
  std::optional<PointsChoice> insteadOf(const Fit& doubtful, const Detection& found);
  Shape fittedToClear(const PointsChoice& from);
  Uncertainties uncertaintyOf(const Shape& fit, HeldAxis axis, const Extent& extent,
                              const DepthWaves* waves = nullptr) const;
  double leaveOutThinEnds(const Shape& shape);
  bool looksInto(const Detection& detection) const;
  double keepToSeen(Detection& detection, const List<std::uint32_t>& index, List<std::uint32_t>& kept);
  void endAtFacesOrTip(Detection& detection) const;
  Fit fitted(const List<std::uint32_t>& clear, const OnSurface& on_surface, const Detection& found,
             const PointsChoice& from);
  Fit fitted(const List<std::uint32_t>& clear, const OnSurface& on_surface, const Detection& found);
  double trustInSizeOf(const Fit& fit) const;

  const Cloud& cloud_;
  ImageRays rays_;
  NoiseModel tolerated_, noise_;
  Limits limits_;
  DepthRange range_;
  PointNoise sigma_;
  TruncationFinder truncation_;
  DepthWaves waves_;
  List<Face> faces_;  ///< likely planes measured so far
  // Of one detection; their memory serves the next.
  SeenPoints points_, outermost_, clear_;
  FitPoints fit_points_;
};

}  // namespace primitect
