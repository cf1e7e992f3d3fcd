// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// How much effort frames may be so that they keep to a time.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace primitect {

/// Learns from what frames took which share of the effort keeps 95 % of them within a bound. It has no clock: whoever
/// runs the detector tells it the times, and the same times give the same shares.
class LatencyGovernor {
 public:
  /// bound: what frames may take, in s, above 0. least_share: where it stops to save, in (0, 1]. It starts with all of
  /// the effort. Throws std::invalid_argument naming a value that is not allowed.
  LatencyGovernor(double bound, double least_share);

  double bound() const { return bound_; }

  /// Of the effort of the next frame.
  double share() const { return share_; }

  /// A frame begins; what was asked in one that never ended is forgotten.
  void beginFrame();

  /// Asked in the middle of a frame, for the first, second, ... time: so many seconds after its beginning, how large a
  /// share of the samples that the search draws next keeps the bound, to 95 % of it? 1: all of them; 0: none, also
  /// where not a tenth is. Judged by how frames before went on from there. A search that ends early is asked less
  /// often: then its last place is judged by what comes after an earlier one, which is longer.
  double shareInTime(double elapsed);

  /// The frame is done and took so many seconds.
  void endFrame(double seconds);

  std::uint64_t frames() const { return frames_; }
  std::uint64_t missed() const { return missed_; }  ///< frames that took longer than the bound

  /// The last frames, whatever their share: so many, 100 at most, and how many of them took longer than the bound.
  std::uint64_t framesLately() const { return std::min<std::uint64_t>(frames_, late_.size()); }
  std::uint64_t missedLately() const { return missed_lately_; }
  /// More of these than the 5 % that the share aims at, and more than two.
  bool missesBound() const;

  /// Even the least share misses the bound, more often than that.
  bool hopeless() const;

 private:
  /// A place in the frame where shareInTime() is asked.
  struct Place {
    double elapsed = 0.0;  ///< s, in this frame
    double rest = 0.0;     ///< s, from there to the end of frames before; 0: not known yet
    double part = 1.0;     ///< of that time, what this frame takes with fewer samples; 0: nothing more is searched
  };

  void learnRest(double seconds);
  std::size_t missesOfShare() const;
  double lastTwo() const;
  double secondLargest() const;
  void adapt();
  void scaleShare(double factor);

  double bound_, least_share_;
  double share_ = 1.0;
  std::vector<double> costs_;  ///< of the last frames with this share, s
  std::array<Place, 16> places_;
  std::size_t asked_ = 0;    ///< places in this frame
  double would_take_ = 0.0;  ///< s; this frame, if it had not been cut short; 0: it was not
  std::uint64_t frames_ = 0, missed_ = 0, missed_lately_ = 0;
  std::array<bool, 100> late_ = {};  ///< frames that took longer than the bound, each in the place of its number
};

}  // namespace primitect
