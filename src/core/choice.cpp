// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Sums over supports, with the best and the second best holder of each sample; see choice.h.
#include "core/choice.h"

#include <algorithm>

namespace primitect {

Choice::Choice(std::size_t samples, const List<Hypothesis>& pool, std::size_t min_inliers)
    : pool_(pool),
      min_inliers_(static_cast<double>(min_inliers)),
      chosen_{List<bool>(pool.size(), false), {}, List<Standing>(pool.size())},
      holders_(samples),
      inheritances_(pool.size()),
      left_(samples, 0) {}

Worth Choice::worthOfAdding(std::uint32_t h) const {
  Tally tally;
  for (const Support& support : pool_[h].support) tally.add(support.gain, holders_[support.sample].best.gain);
  return worthOf(h, tally);
}

void Choice::worthsOfAdding(std::uint32_t h, List<WorthWithout>& worths) {
  for (const std::uint32_t kept : chosen_.order) inheritances_[kept] = Inheritance();
  Tally all;
  for (const Support& support : pool_[h].support) {
    const auto& [best, second] = holders_[support.sample];
    all.add(support.gain, best.gain);
    if (best.hypothesis == kNobody) continue;
    Inheritance& inheritance = inheritances_[best.hypothesis];
    inheritance.held.add(support.gain, best.gain);
    inheritance.left.add(support.gain, second.gain);
  }
  worths.clear();
  for (const std::uint32_t gone : chosen_.order) {
    const Tally &held = inheritances_[gone].held, &left = inheritances_[gone].left;
    if (!(left.better > 0.0)) continue;
    Tally tally;
    tally.gain = all.gain - held.gain + left.gain;
    tally.against = all.against - held.against + left.against;
    tally.better = all.better - held.better + left.better;
    worths.push_back({gone, worthOf(h, tally)});
  }
}

void Choice::add(std::uint32_t h) {
  for (const std::uint32_t kept : chosen_.order) {
    if (concerns(pool_[h], pool_[kept])) chosen_.standings[kept].known = false;
  }
  chosen_.holds[h] = true;
  chosen_.standings[h].known = false;
  chosen_.order.push_back(h);
  for (const Support& support : pool_[h].support) enter(h, support);
}

void Choice::remove(std::uint32_t h) {
  chosen_.holds[h] = false;
  chosen_.order.erase(std::find(chosen_.order.begin(), chosen_.order.end(), h));
  ++removal_;
  for (const Support& support : pool_[h].support) {
    const auto& [best, second] = holders_[support.sample];
    if (best.hypothesis != h && second.hypothesis != h) continue;
    change(support.sample, {});
    left_[support.sample] = removal_;
  }
  for (const std::uint32_t kept : chosen_.order) {
    if (!concerns(pool_[h], pool_[kept])) continue;
    chosen_.standings[kept].known = false;
    for (const Support& support : pool_[kept].support) {
      if (left_[support.sample] == removal_) enter(kept, support);
    }
  }
}

void Choice::note() {
  noted_ = chosen_;
  noting_ = true;
  changes_.clear();
}

void Choice::goBack() {
  for (auto change = changes_.rbegin(); change != changes_.rend(); ++change) holders_[change->sample] = change->before;
  changes_.clear();
  chosen_ = noted_;
}

std::uint32_t Choice::worthless() {
  std::uint32_t weakest = kNobody;
  double least = 0.0;
  for (const std::uint32_t h : chosen_.order) {
    const double worth = standingOf(h).keeping;
    if (worth > least) continue;
    least = worth;
    weakest = h;
  }
  return weakest;
}

double Choice::total() {
  double sum = 0.0;
  for (const std::uint32_t h : chosen_.order) sum += standingOf(h).share;
  return sum;
}

List<std::uint32_t> Choice::owners() const {
  List<std::uint32_t> owner(holders_.size());
  for (std::size_t i = 0; i < holders_.size(); ++i) owner[i] = holders_[i].best.hypothesis;
  return owner;
}

Worth Choice::worthOf(std::uint32_t h, const Tally& tally) const {
  if (tally.better < least(h)) return {tally.gain, -1.0};
  return {tally.gain, tally.gain + tally.against - price(h, tally.better)};
}

const Choice::Standing& Choice::standingOf(std::uint32_t h) {
  Standing& standing = chosen_.standings[h];
  if (standing.known) return standing;
  double gain = 0.0, lost = 0.0, against = 0.0;
  std::size_t all = 0, without_other = 0;
  for (const Support& support : pool_[h].support) {
    const auto& [best, second] = holders_[support.sample];
    if (best.hypothesis == h) {
      gain += best.gain;
      ++all;
      const float other = second.gain;
      if (other >= kWellExplained) continue;
      lost += best.gain - other;
      ++without_other;
    } else if (best.gain <= 0.0f) {
      against += support.gain;
    }
  }
  const double owned = static_cast<double>(all), missed = static_cast<double>(without_other);
  standing.known = true;
  standing.share = gain + against - price(h, owned);
  standing.keeping = missed < least(h) ? -1.0 : lost + against - price(h, missed);
  return standing;
}

/// A shape that shares most of its inliers with others is one of them once more.
double Choice::least(std::uint32_t h) const {
  constexpr double kOwnShare = 0.3;
  return std::max(min_inliers_, kOwnShare * static_cast<double>(pool_[h].inliers));
}

double Choice::price(std::uint32_t h, double own) const {
  return priceOf(kindOf(pool_[h].shape), own) + 0.25 * min_inliers_;
}

void Choice::change(std::uint32_t sample, const Holders& now) {
  if (noting_) changes_.push_back({sample, holders_[sample]});
  holders_[sample] = now;
}

void Choice::enter(std::uint32_t h, const Support& support) {
  const auto& [best, second] = holders_[support.sample];
  const Holder own = {h, support.gain};
  if (support.gain > best.gain) {
    change(support.sample, {own, best});
  } else if (support.gain > second.gain) {
    change(support.sample, {best, own});
  }
}

}  // namespace primitect
