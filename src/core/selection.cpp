// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy choice with removals and exchanges; see selection.h.
#include "core/selection.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

/// A choice and what it is worth.
class Choice {
 public:
  Choice(std::size_t samples, const std::vector<Hypothesis>& pool, std::size_t min_inliers)
      : pool_(&pool), min_inliers_(static_cast<double>(min_inliers)), best_(samples), second_(samples) {}

  const std::vector<std::uint32_t>& chosen() const { return chosen_; }

  /// What the total gains when h joins.
  double worthOfAdding(std::uint32_t h) const {
    double sum = 0.0, own = 0.0;
    for (const Support& support : (*pool_)[h].support) {
      const float held = best_[support.sample].gain;
      if (support.gain > held && held < kWellExplained) sum += support.gain - held, own += 1.0;
      // Near it, but not on it: against it, unless somebody else explains that sample.
      if (support.gain < 0.0f && held <= 0.0f) sum += support.gain;
    }
    return own < least(h) ? -1.0 : sum - price(h, own);
  }

  /// What the total loses when h, which is chosen, leaves.
  double worthOfKeeping(std::uint32_t h) const {
    double sum = 0.0, own = 0.0;
    for (const Support& support : (*pool_)[h].support) {
      const Holder& best = best_[support.sample];
      const float other = second_[support.sample].gain;
      if (best.hypothesis == h && other < kWellExplained) sum += best.gain - other, own += 1.0;
      if (support.gain < 0.0f && best.gain <= 0.0f) sum += support.gain;
    }
    return own < least(h) ? -1.0 : sum - price(h, own);
  }

  void add(std::uint32_t h) {
    chosen_.push_back(h);
    for (const Support& support : (*pool_)[h].support) enter(h, support);
  }

  void remove(std::uint32_t h) {
    chosen_.erase(std::find(chosen_.begin(), chosen_.end(), h));
    std::fill(best_.begin(), best_.end(), Holder());
    std::fill(second_.begin(), second_.end(), Holder());
    for (const std::uint32_t kept : chosen_) {
      for (const Support& support : (*pool_)[kept].support) enter(kept, support);
    }
  }

  /// The chosen one that is worth least, if that is nothing.
  std::uint32_t worthless() const {
    std::uint32_t weakest = kNobody;
    double least = 0.0;
    for (const std::uint32_t h : chosen_) {
      const double worth = worthOfKeeping(h);
      if (worth > least) continue;
      least = worth;
      weakest = h;
    }
    return weakest;
  }

  bool holds(std::uint32_t h) const { return std::find(chosen_.begin(), chosen_.end(), h) != chosen_.end(); }

  double total() const {
    double sum = 0.0;
    std::vector<double> own(pool_->size(), 0.0);
    for (const Holder& best : best_) {
      sum += best.gain;
      if (best.hypothesis != kNobody) own[best.hypothesis] += 1.0;
    }
    for (const std::uint32_t h : chosen_) {
      sum -= price(h, own[h]);
      for (const Support& support : (*pool_)[h].support) {
        if (support.gain < 0.0f && best_[support.sample].gain <= 0.0f) sum += support.gain;
      }
    }
    return sum;
  }

  std::vector<std::uint32_t> owners() const {
    std::vector<std::uint32_t> owner(best_.size());
    for (std::size_t i = 0; i < best_.size(); ++i) owner[i] = best_[i].hypothesis;
    return owner;
  }

 private:
  struct Holder {
    std::uint32_t hypothesis = kNobody;
    float gain = 0.0f;
  };

  /// A shape that shares most of its inliers with others is one of them once more.
  double least(std::uint32_t h) const {
    constexpr double kOwnShare = 0.3;
    const auto& support = (*pool_)[h].support;
    const auto inliers = std::count_if(support.begin(), support.end(), [](const Support& s) { return s.gain > 0.0f; });
    return std::max(min_inliers_, kOwnShare * static_cast<double>(inliers));
  }

  double price(std::uint32_t h, double own) const {
    return priceOf(kindOf((*pool_)[h].shape), own) + 0.25 * min_inliers_;
  }

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

  const std::vector<Hypothesis>* pool_;
  double min_inliers_;
  std::vector<std::uint32_t> chosen_;
  std::vector<Holder> best_, second_;
};

/// Adds what is worth most until nothing is worth anything; never one that is barred.
void addGreedily(Choice& choice, const std::vector<bool>& barred) {
  while (true) {
    std::uint32_t best = kNobody;
    double most = 0.0;
    for (std::uint32_t h = 0; h < barred.size(); ++h) {
      if (barred[h] || choice.holds(h)) continue;
      const double worth = choice.worthOfAdding(h);
      if (!(worth > most)) continue;
      most = worth;
      best = h;
    }
    if (best == kNobody) return;
    choice.add(best);
  }
}

/// Hypotheses of the same kind that explain nearly the same samples as h, itself among them.
std::vector<bool> likenesses(const std::vector<Hypothesis>& pool, std::uint32_t h, std::size_t samples) {
  constexpr double kSame = 0.75;  // of the inliers of both together
  std::vector<bool> held(samples, false);
  double own = 0.0;
  for (const Support& support : pool[h].support) {
    held[support.sample] = support.gain > 0.0f;
    own += support.gain > 0.0f ? 1.0 : 0.0;
  }
  std::vector<bool> alike(pool.size(), false);
  for (std::size_t k = 0; k < pool.size(); ++k) {
    if (kindOf(pool[k].shape) != kindOf(pool[h].shape)) continue;
    double both = 0.0, others = 0.0;
    for (const Support& support : pool[k].support) {
      if (support.gain > 0.0f) (held[support.sample] ? both : others) += 1.0;
    }
    alike[k] = both > kSame * (own + others);
  }
  return alike;
}

void dropWorthless(Choice& choice) {
  for (std::uint32_t h = choice.worthless(); h != kNobody; h = choice.worthless()) choice.remove(h);
}

/// Leaves one out, and keeps the outcome when the rest then finds something better: two planes for one cone.
bool exchange(Choice& choice, const std::vector<Hypothesis>& pool, std::size_t samples) {
  const std::vector<std::uint32_t> chosen = choice.chosen();
  for (const std::uint32_t h : chosen) {
    Choice without = choice;
    without.remove(h);
    addGreedily(without, likenesses(pool, h, samples));
    dropWorthless(without);
    if (!(without.total() > choice.total() + 1e-6)) continue;
    choice = without;
    return true;
  }
  return false;
}

}  // namespace

Selection selectHypotheses(const Samples& samples, const std::vector<Hypothesis>& pool, std::size_t min_inliers) {
  constexpr int kExchanges = 20;
  Choice choice(samples.size(), pool, min_inliers);
  addGreedily(choice, std::vector<bool>(pool.size(), false));
  dropWorthless(choice);
  for (int k = 0; k < kExchanges && exchange(choice, pool, samples.size()); ++k) continue;
  return {choice.chosen(), choice.owners()};
}

}  // namespace primitect
