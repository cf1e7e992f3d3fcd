// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy choice with removals and exchanges; see selection.h.
#include "core/selection.h"

#include <algorithm>

namespace primitect {
namespace {

/// What a hypothesis would bring: at the samples that it explains, and after all that speaks against it.
struct Worth {
  double gain, total;
};

/// A choice and what it is worth. What is asked about one hypothesis takes the time of its own support.
class Choice {
 public:
  Choice(std::size_t samples, const List<Hypothesis>& pool, std::size_t min_inliers)
      : pool_(pool),
        min_inliers_(static_cast<double>(min_inliers)),
        chosen_(pool.size(), false),
        standings_(pool.size()),
        best_(samples),
        second_(samples),
        left_(samples, 0) {}

  const List<std::uint32_t>& order() const { return order_; }
  bool holds(std::uint32_t h) const { return chosen_[h]; }

  /// What the total gains when h joins, once `gone` has left.
  Worth worthOfAdding(std::uint32_t h, std::uint32_t gone = kNobody) const {
    double gain = 0.0, against = 0.0;
    std::size_t better = 0;
    for (const Support& support : pool_[h].support) {
      const Holder& best = best_[support.sample];
      const float held = best.hypothesis == gone ? second_[support.sample].gain : best.gain;
      if (held >= kWellExplained) continue;
      if (support.gain > held) {
        gain += support.gain - held;
        ++better;
      } else if (held <= 0.0f) {
        // Near it, but not on it: against it, unless somebody else explains that sample.
        against += support.gain;
      }
    }
    const double own = static_cast<double>(better);
    return {gain, own < least(h) ? -1.0 : gain + against - price(h, own)};
  }

  /// No more than that would h add to the total, whatever is chosen, where it gains so much at its samples.
  double mostOf(std::uint32_t h, double gain) const { return gain - price(h, least(h)); }

  void add(std::uint32_t h) {
    for (const std::uint32_t kept : order_) {
      if (mayOverlap(pool_[kept], pool_[h])) standings_[kept].known = false;
    }
    chosen_[h] = true;
    standings_[h].known = false;
    order_.push_back(h);
    for (const Support& support : pool_[h].support) enter(h, support);
  }

  /// Those chosen in another order.
  void putInOrder(const List<std::uint32_t>& order) { order_ = order; }

  void remove(std::uint32_t h) {
    chosen_[h] = false;
    order_.erase(std::find(order_.begin(), order_.end(), h));
    ++removal_;
    for (const Support& support : pool_[h].support) {
      Holder &best = best_[support.sample], &second = second_[support.sample];
      if (best.hypothesis != h && second.hypothesis != h) continue;
      best = second = Holder();
      left_[support.sample] = removal_;
    }
    for (const std::uint32_t kept : order_) {
      if (!mayOverlap(pool_[kept], pool_[h])) continue;
      standings_[kept].known = false;
      for (const Support& support : pool_[kept].support) {
        if (left_[support.sample] == removal_) enter(kept, support);
      }
    }
  }

  /// The chosen one that is worth least, if that is nothing.
  std::uint32_t worthless() {
    std::uint32_t weakest = kNobody;
    double least = 0.0;
    for (const std::uint32_t h : order_) {
      const double worth = standingOf(h).keeping;
      if (worth > least) continue;
      least = worth;
      weakest = h;
    }
    return weakest;
  }

  /// What the total loses when a chosen one leaves.
  double worthOfKeeping(std::uint32_t h) { return standingOf(h).keeping; }

  double total() {
    double sum = 0.0;
    for (const std::uint32_t h : order_) sum += standingOf(h).share;
    return sum;
  }

  List<std::uint32_t> owners() const {
    List<std::uint32_t> owner(best_.size());
    for (std::size_t i = 0; i < best_.size(); ++i) owner[i] = best_[i].hypothesis;
    return owner;
  }

 private:
  struct Holder {
    std::uint32_t hypothesis = kNobody;
    float gain = 0.0f;
  };

  /// Of a chosen one, until something that may have samples in common with it joins or leaves.
  struct Standing {
    bool known = false;
    double share = 0.0;    ///< of the total
    double keeping = 0.0;  ///< what the total loses when it leaves
  };

  const Standing& standingOf(std::uint32_t h) {
    Standing& standing = standings_[h];
    if (standing.known) return standing;
    double gain = 0.0, lost = 0.0, against = 0.0;
    std::size_t all = 0, without_other = 0;
    for (const Support& support : pool_[h].support) {
      const Holder& best = best_[support.sample];
      if (best.hypothesis == h) {
        gain += best.gain;
        ++all;
        const float other = second_[support.sample].gain;
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
  double least(std::uint32_t h) const {
    constexpr double kOwnShare = 0.3;
    return std::max(min_inliers_, kOwnShare * static_cast<double>(pool_[h].inliers));
  }

  double price(std::uint32_t h, double own) const { return priceOf(kindOf(pool_[h].shape), own) + 0.25 * min_inliers_; }

  void enter(std::uint32_t h, const Support& support) {
    Holder& best = best_[support.sample];
    Holder& second = second_[support.sample];
    if (support.gain > best.gain) {
      second = best;
      best = {h, support.gain};
    } else if (support.gain > second.gain) {
      second = {h, support.gain};
    }
  }

  const List<Hypothesis>& pool_;
  double min_inliers_;
  List<bool> chosen_;
  List<std::uint32_t> order_;  ///< of those chosen
  List<Standing> standings_;   ///< of those chosen
  List<Holder> best_, second_;
  List<std::uint32_t> left_;  ///< of each sample: the last removal that it lost a holder by
  std::uint32_t removal_ = 0;
};

/// What a candidate may bring.
struct Offer {
  std::uint32_t hypothesis;
  double most;         ///< at most so much: with every one that joins it gains less
  double total = 0.0;  ///< what it would bring now, where that is known
  bool known = false;  ///< nothing that may have samples in common with it has joined since
};

/// The best of the offers, of two as good the one of lower index; null: none is worth anything. What is known is looked
/// at first, and then what promised most at first, so that few others need be asked.
Offer* bestOf(List<Offer>& offers, const Choice& choice) {
  Offer* best = nullptr;
  const auto compare = [&best](Offer& offer) {
    if (!(offer.total > 0.0)) return;
    const bool better = !best || offer.total > best->total;
    if (better || (offer.total == best->total && offer.hypothesis < best->hypothesis)) best = &offer;
  };
  for (Offer& offer : offers) {
    if (offer.known) compare(offer);
  }
  for (Offer& offer : offers) {
    if (offer.known || (best && offer.most < best->total)) continue;
    const Worth worth = choice.worthOfAdding(offer.hypothesis);
    offer.known = true;
    offer.total = worth.total;
    offer.most = choice.mostOf(offer.hypothesis, worth.gain);
    compare(offer);
  }
  return best;
}

/// Adds the most valuable of these until none is worth anything.
void addGreedily(Choice& choice, const List<Hypothesis>& pool, const List<std::uint32_t>& candidates) {
  List<Offer> offers;
  for (const std::uint32_t h : candidates) {
    const double most = choice.mostOf(h, pool[h].gain_sum);
    if (most > 0.0) offers.push_back({h, most});
  }
  std::sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
    return a.most != b.most ? a.most > b.most : a.hypothesis < b.hypothesis;
  });
  while (Offer* best = bestOf(offers, choice)) {
    const Hypothesis& added = pool[best->hypothesis];
    choice.add(best->hypothesis);
    offers.erase(offers.begin() + (best - offers.data()));
    for (Offer& offer : offers) offer.known = offer.known && !mayOverlap(pool[offer.hypothesis], added);
    const auto hopeless = [](const Offer& offer) { return !(offer.most > 0.0); };
    offers.erase(std::remove_if(offers.begin(), offers.end(), hopeless), offers.end());
  }
}

/// What could take the place of h once it is gone: not its likenesses, and nothing that has no sample of it.
List<std::uint32_t> substitutesOf(std::uint32_t h, const Choice& choice, const List<Hypothesis>& pool) {
  List<std::uint32_t> substitutes;
  for (std::uint32_t k = 0; k < pool.size(); ++k) {
    if (k == h || choice.holds(k) || !mayOverlap(pool[k], pool[h]) || alike(pool[h], pool[k])) continue;
    substitutes.push_back(k);
  }
  return substitutes;
}

void dropWorthless(Choice& choice) {
  for (std::uint32_t h = choice.worthless(); h != kNobody; h = choice.worthless()) choice.remove(h);
}

/// Back to what was chosen before.
void restore(const List<std::uint32_t>& chosen, Choice& choice) {
  const List<std::uint32_t> now = choice.order();
  const auto in = [](std::uint32_t h, const List<std::uint32_t>& list) {
    return std::find(list.begin(), list.end(), h) != list.end();
  };
  for (const std::uint32_t h : now) {
    if (!in(h, chosen)) choice.remove(h);
  }
  for (const std::uint32_t h : chosen) {
    if (!in(h, now)) choice.add(h);
  }
  choice.putInOrder(chosen);
}

/// Whether these could be worth what leaves for them: something else may become worthless, so half of it is asked for.
/// To ask without taking it out saves a quarter to a third of the time that a selection takes.
bool mayReplace(std::uint32_t h, const List<std::uint32_t>& substitutes, Choice& choice) {
  constexpr double kLeast = 0.5;
  const double needed = kLeast * choice.worthOfKeeping(h);
  double offered = 0.0;
  for (const std::uint32_t k : substitutes) {
    offered += std::max(0.0, choice.worthOfAdding(k, h).total);
    if (offered > needed) return true;
  }
  return false;
}

/// Leaves one out, and keeps the outcome when the rest then finds something better: two planes for one cone.
bool exchange(Choice& choice, const List<Hypothesis>& pool) {
  const List<std::uint32_t> chosen = choice.order();
  const double before = choice.total();
  for (const std::uint32_t h : chosen) {
    const List<std::uint32_t> substitutes = substitutesOf(h, choice, pool);
    if (!mayReplace(h, substitutes, choice)) continue;
    choice.remove(h);
    addGreedily(choice, pool, substitutes);
    // Without anything in its place nothing is gained: what was worthless is gone already.
    if (choice.order().size() >= chosen.size()) {
      dropWorthless(choice);
      if (choice.total() > before + 1e-6) return true;
    }
    restore(chosen, choice);
  }
  return false;
}

}  // namespace

bool alike(const Hypothesis& a, const Hypothesis& b) {
  constexpr double kSame = 0.75;  // of the inliers of both together
  if (kindOf(a.shape) != kindOf(b.shape)) return false;
  const auto same = [&a, &b](std::size_t both) {
    return static_cast<double>(both) > kSame * static_cast<double>(a.inliers + b.inliers - both);
  };
  if (!same(std::min(a.inliers, b.inliers))) return false;
  std::size_t both = 0;
  auto at = b.support.begin();
  for (const Support& support : a.support) {
    while (at != b.support.end() && at->sample < support.sample) ++at;
    if (at == b.support.end()) break;
    if (at->sample == support.sample && at->gain > 0.0f && support.gain > 0.0f) ++both;
  }
  return same(both);
}

Selection selectHypotheses(const Samples& samples, const List<Hypothesis>& pool, std::size_t min_inliers) {
  constexpr int kExchanges = 20;
  Choice choice(samples.size(), pool, min_inliers);
  List<std::uint32_t> all(pool.size());
  for (std::uint32_t h = 0; h < pool.size(); ++h) all[h] = h;
  addGreedily(choice, pool, all);
  dropWorthless(choice);
  for (int k = 0; k < kExchanges && exchange(choice, pool); ++k) continue;
  return {choice.order(), choice.owners()};
}

}  // namespace primitect
