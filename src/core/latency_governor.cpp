// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Down at once when the load changes, up in steps that the times so far allow, and a band between where nothing
// changes.
#include "primitect/latency_governor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

namespace primitect {
namespace {

/// A new share aims at this part of the bound.
constexpr double kAim = 0.85;
/// Frames that the share is judged by, and how many of them may miss the bound: 5 %.
constexpr std::size_t kFrames = 40, kMissesAllowed = 2;
/// Frames with the same share before it may grow.
constexpr std::size_t kFramesToGrow = 16;
/// Less is not worth a change.
constexpr double kLeastGrowth = 1.05;

/// Of the time from the closer look to the end of a frame with all samples: the part that it takes with a share of
/// them. On 30 tables (compare --set tabletop --seeds 2300:30) the median was .50, .62, .80, .90 and .93 of it with .1,
/// .2, .4, .6 and .8 of the samples, .13 with none.
constexpr double kWithFew = 0.4;
double timeOfShare(double share) { return kWithFew + (1.0 - kWithFew) * std::sqrt(share); }

/// The share of the samples with which the rest of a frame takes that part of its time; 0 below a tenth of them: four
/// fifths of what is on a table are still found with these, a quarter with none.
double shareThatTakes(double part) {
  constexpr double kLeast = 0.1;
  const double root = (part - kWithFew) / (1.0 - kWithFew);
  const double share = root > 0.0 ? std::min(root * root, 1.0) : 0.0;
  return share < kLeast ? 0.0 : share;
}

}  // namespace

LatencyGovernor::LatencyGovernor(double bound, double least_share) : bound_(bound), least_share_(least_share) {
  if (!(bound > 0.0)) throw std::invalid_argument("bound is " + std::to_string(bound) + " s, allowed: above 0");
  if (!(0.0 < least_share && least_share <= 1.0)) {
    throw std::invalid_argument("least share is " + std::to_string(least_share) + ", allowed: above 0, up to 1");
  }
  costs_.reserve(kFrames + 1);
}

void LatencyGovernor::beginFrame() {
  asked_ = 0;
  would_take_ = 0.0;
}

double LatencyGovernor::shareInTime(double elapsed) {
  // A little less than the bound: of frames that aim at it half would miss it.
  constexpr double kAimOfCut = 0.95;
  constexpr double kFewFound = 0.3;  // with a fifth of the samples 5 % of what is on tables is missing
  if (asked_ == places_.size()) return elapsed > bound_ ? 0.0 : 1.0;
  Place& place = places_[asked_++];
  place.elapsed = elapsed;
  place.part = 1.0;
  if (elapsed + place.rest <= bound_) return 1.0;
  const double share = shareThatTakes((kAimOfCut * bound_ - elapsed) / place.rest);
  place.part = share > 0.0 ? timeOfShare(share) : 0.0;
  if (share < kFewFound) would_take_ = elapsed + place.rest;
  return share;
}

void LatencyGovernor::endFrame(double seconds) {
  bool& late = late_[frames_++ % late_.size()];
  missed_lately_ -= late ? 1 : 0;
  late = seconds > bound_;
  missed_lately_ += late ? 1 : 0;
  missed_ += late ? 1 : 0;
  learnRest(seconds);
  if (costs_.size() == kFrames) costs_.erase(costs_.begin());
  // A frame that kept the bound because the search was cut that short asks for fewer samples all the same.
  costs_.push_back(std::max(seconds, would_take_));
  beginFrame();
  adapt();
}

/// In seconds rather than in proportion: an interruption before the place says nothing about what comes after it. Where
/// fewer samples were drawn at the last place alone the time that they took tells what all would have.
void LatencyGovernor::learnRest(double seconds) {
  constexpr double kNew = 0.2, kMostSurprise = 1.5;
  // What was learned from a frame that was interrupted must not cut the search for ever.
  constexpr double kForget = 0.98;
  const auto begin = places_.begin(), end = begin + static_cast<std::ptrdiff_t>(asked_);
  const auto cuts = std::count_if(begin, end, [](const Place& place) { return place.part < 1.0; });
  const Place* last = asked_ > 0 ? &places_[asked_ - 1] : nullptr;
  if (cuts == 1 && 0.0 < last->part && last->part < 1.0) {
    seconds = last->elapsed + (seconds - last->elapsed) / last->part;
  } else if (cuts > 0) {
    std::for_each(begin, end, [](Place& place) { place.rest *= place.part < 1.0 ? kForget : 1.0; });
    return;
  }
  std::for_each(begin, end, [seconds](Place& place) {
    const double rest = seconds - place.elapsed;
    const bool first = place.rest == 0.0;
    place.rest = first ? rest : (1.0 - kNew) * place.rest + kNew * std::min(rest, kMostSurprise * place.rest);
  });
}

/// What both of the last two frames took at least; 0 before there are two.
double LatencyGovernor::lastTwo() const {
  return costs_.size() < 2 ? 0.0 : std::min(costs_[costs_.size() - 1], costs_[costs_.size() - 2]);
}

/// One frame in kFrames may be interrupted without saying anything about the others.
double LatencyGovernor::secondLargest() const {
  std::array<double, 2> largest;
  std::partial_sort_copy(costs_.begin(), costs_.end(), largest.begin(), largest.end(), std::greater<double>());
  return largest[1];
}

/// Of the last kFrames.
std::size_t LatencyGovernor::missesOfShare() const {
  const auto missed = [this](double cost) { return cost > bound_; };
  return static_cast<std::size_t>(std::count_if(costs_.begin(), costs_.end(), missed));
}

bool LatencyGovernor::hopeless() const { return share_ <= least_share_ && missesOfShare() > kMissesAllowed; }

bool LatencyGovernor::missesBound() const {
  return missed_lately_ > kMissesAllowed && missed_lately_ * kFrames > framesLately() * kMissesAllowed;
}

void LatencyGovernor::adapt() {
  constexpr double kMostDown = 0.25, kMostUp = 2.0;
  if (lastTwo() > bound_) return scaleShare(std::max(kMostDown, kAim * bound_ / lastTwo()));
  if (missesOfShare() > kMissesAllowed) return scaleShare(kAim);
  if (costs_.size() < kFramesToGrow) return;
  // Votes grow with the square of the share, samples times references, all else in proportion or less.
  const double room = kAim * bound_ / secondLargest();
  if (room > kLeastGrowth) scaleShare(std::min(kMostUp, std::sqrt(room)));
}

/// The times of another share say little about this one.
void LatencyGovernor::scaleShare(double factor) {
  const double share = std::clamp(share_ * factor, least_share_, 1.0);
  if (share == share_) return;
  for (Place& place : places_) place.rest *= share / share_;
  share_ = share;
  costs_.clear();
}

}  // namespace primitect
