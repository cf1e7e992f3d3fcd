// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Greedy choice with removals and exchanges; see selection.h.
#include "core/selection.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace primitect {
namespace {

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
void addGreedily(Choice& choice, const List<Hypothesis>& pool, List<Offer> offers) {
  const auto dropHopeless = [&offers] {
    const auto hopeless = [](const Offer& offer) { return !(offer.most > 0.0); };
    offers.erase(std::remove_if(offers.begin(), offers.end(), hopeless), offers.end());
  };
  dropHopeless();
  std::sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
    return a.most != b.most ? a.most > b.most : a.hypothesis < b.hypothesis;
  });
  while (Offer* best = bestOf(offers, choice)) {
    const Hypothesis& added = pool[best->hypothesis];
    choice.add(best->hypothesis);
    offers.erase(offers.begin() + (best - offers.data()));
    for (Offer& offer : offers) offer.known = offer.known && !concerns(added, pool[offer.hypothesis]);
    dropHopeless();
  }
}

/// Of all that are not chosen.
List<Offer> allOffers(const Choice& choice, const List<Hypothesis>& pool) {
  List<Offer> offers;
  for (std::uint32_t h = 0; h < pool.size(); ++h) {
    if (!choice.holds(h)) offers.push_back({h, choice.mostOf(h, pool[h].gain_sum)});
  }
  return offers;
}

void dropWorthless(Choice& choice) {
  for (std::uint32_t h = choice.worthless(); h != kNobody; h = choice.worthless()) choice.remove(h);
}

bool among(std::uint32_t h, const List<std::uint32_t>& list) {
  return std::find(list.begin(), list.end(), h) != list.end();
}

/// Takes out one after the other of those chosen that have not been tried since something that may have samples in
/// common with them joined or left, and keeps the outcome when the rest then finds something better: two planes for one
/// cone.
class Exchanges {
 public:
  Exchanges(Choice& choice, const List<Hypothesis>& pool)
      : choice_(choice), pool_(pool), tried_(pool.size(), false), offers_(pool.size()) {}

  /// All of these have been tried, when they were what was chosen.
  void spare(const List<std::uint32_t>& before) {
    for (const std::uint32_t h : before) tried_[h] = true;
    noteChange(before);
  }

  void run() {
    constexpr int kExchanges = 20;
    for (int k = 0; k < kExchanges && exchange(); ++k) continue;
  }

 private:
  bool exchange() {
    const List<std::uint32_t> chosen = choice_.order();
    const double before = choice_.total();
    findOffers();
    for (const std::uint32_t h : chosen) {
      if (tried_[h]) continue;
      tried_[h] = true;
      if (!mayReplace(h)) continue;
      choice_.note();
      choice_.remove(h);
      addGreedily(choice_, pool_, std::move(offers_[h]));
      // Without anything in its place nothing is gained: what was worthless is gone already.
      if (choice_.order().size() >= chosen.size()) {
        dropWorthless(choice_);
        if (choice_.total() > before + 1e-6) {
          noteChange(chosen);
          return true;
        }
      }
      choice_.goBack();
    }
    return false;
  }

  /// For each of those chosen that is to be tried: what could take its place.
  void findOffers() {
    for (List<Offer>& offers : offers_) offers.clear();
    for (std::uint32_t h = 0; h < pool_.size(); ++h) {
      if (choice_.holds(h)) continue;
      choice_.worthsOfAdding(h, worths_);
      for (const auto& [gone, worth] : worths_) {
        if (tried_[gone]) continue;
        offers_[gone].push_back({h, choice_.mostOf(h, worth.gain), worth.total, true});
      }
    }
  }

  /// Whether what is offered could be worth what leaves for it: something else may become worthless, so half of it is
  /// asked for. Likenesses take nobody's place. To ask without taking it out saves a quarter to a third of the time
  /// that a selection takes.
  bool mayReplace(std::uint32_t h) {
    constexpr double kLeast = 0.5;
    const double needed = kLeast * choice_.worthOfKeeping(h);
    const auto sum = [](double so_far, const Offer& offer) { return so_far + std::max(0.0, offer.total); };
    List<Offer>& offers = offers_[h];
    if (!(std::accumulate(offers.begin(), offers.end(), 0.0, sum) > needed)) return false;
    const auto likeness = [&](const Offer& offer) { return alike(pool_[h], pool_[offer.hypothesis]); };
    offers.erase(std::remove_if(offers.begin(), offers.end(), likeness), offers.end());
    return std::accumulate(offers.begin(), offers.end(), 0.0, sum) > needed;
  }

  /// What was next to something that has joined or left since then is tried again.
  void noteChange(const List<std::uint32_t>& before) {
    for (const std::uint32_t h : before) {
      if (!choice_.holds(h)) tryAgainBeside(h);
    }
    for (const std::uint32_t h : choice_.order()) {
      if (!among(h, before)) tryAgainBeside(h);
    }
  }

  void tryAgainBeside(std::uint32_t changed) {
    for (std::uint32_t h = 0; h < pool_.size(); ++h) tried_[h] = tried_[h] && !mayOverlap(pool_[h], pool_[changed]);
  }

  Choice& choice_;
  const List<Hypothesis>& pool_;
  List<bool> tried_;
  List<List<Offer>> offers_;  ///< of each of those chosen
  List<WorthWithout> worths_;
};

}  // namespace

bool alike(const Hypothesis& a, const Hypothesis& b) {
  constexpr double kSame = 0.75;  // of the inliers of both together
  if (kindOf(a.shape) != kindOf(b.shape)) return false;
  const auto same = [&a, &b](std::size_t both) {
    return static_cast<double>(both) > kSame * static_cast<double>(a.inliers + b.inliers - both);
  };
  if (!same(std::min(a.inliers, b.inliers))) return false;
  return mayOverlap(a, b) && same(commonInliers(a, b));
}

bool isKnown(const Hypothesis& hypothesis, const List<Hypothesis>& pool) {
  return std::any_of(pool.begin(), pool.end(), [&hypothesis](const Hypothesis& other) {
    return hypothesis.gain_sum < kMore * other.gain_sum && alike(other, hypothesis);
  });
}

Selection selectHypotheses(const Samples& samples, const List<Hypothesis>& pool, std::size_t min_inliers) {
  Choice choice(samples.size(), pool, min_inliers);
  addGreedily(choice, pool, allOffers(choice, pool));
  dropWorthless(choice);
  Exchanges(choice, pool).run();
  return {choice.order(), choice.owners()};
}

Selection selectAgain(const Samples& samples, const List<Hypothesis>& pool, std::size_t min_inliers,
                      const List<std::uint32_t>& before) {
  Choice choice(samples.size(), pool, min_inliers);
  for (const std::uint32_t h : before) {
    if (!pool[h].support.empty()) choice.add(h);
  }
  addGreedily(choice, pool, allOffers(choice, pool));
  dropWorthless(choice);
  Exchanges exchanges(choice, pool);
  exchanges.spare(before);
  exchanges.run();
  return {choice.order(), choice.owners()};
}

}  // namespace primitect
