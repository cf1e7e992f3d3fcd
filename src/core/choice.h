// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Which hypotheses are chosen, who holds each sample, and what the choice is worth.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/frame_memory.h"
#include "core/hypothesis.h"

namespace primitect {

/// Which hypothesis a sample belongs to: index in the pool.
constexpr std::uint32_t kNobody = 0xffffffffu;

/// What a hypothesis would bring: at the samples that it explains, and after all that speaks against it.
struct Worth {
  double gain, total;
};

/// What a hypothesis would bring once one of those chosen has left.
struct WorthWithout {
  std::uint32_t gone;
  Worth worth;
};

/// A choice and what it is worth. What is asked about one hypothesis takes the time of its own support.
class Choice {
 public:
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

  struct Holders {
    Holder best, second;
  };

  Choice(std::size_t samples, const List<Hypothesis>& pool, std::size_t min_inliers);

  /// Those chosen, as they came.
  const List<std::uint32_t>& order() const { return chosen_.order; }
  bool holds(std::uint32_t h) const { return chosen_.holds[h]; }

  /// What the total gains when h joins.
  Worth worthOfAdding(std::uint32_t h) const;

  /// The same once another has left: for each of those chosen that hold samples near h. In one pass, where a pass for
  /// each took a tenth of the time of a cluttered frame.
  void worthsOfAdding(std::uint32_t h, List<WorthWithout>& worths);

  /// No more than that would h add to the total, whatever is chosen, where it gains so much at its samples.
  double mostOf(std::uint32_t h, double gain) const { return gain - price(h, least(h)); }

  void add(std::uint32_t h);
  void remove(std::uint32_t h);

  /// Notes what is to go back to. In place of a copy of all holders, those that change from here on: 3 % of a recorded
  /// frame's instructions less.
  void note();
  /// To what was noted last, any number of times.
  void goBack();

  /// The chosen one that is worth least, if that is nothing; else kNobody.
  std::uint32_t worthless();

  /// What the total loses when a chosen one leaves.
  double worthOfKeeping(std::uint32_t h) { return standingOf(h).keeping; }

  double total();

  /// Of each sample.
  List<std::uint32_t> owners() const;

 private:
  /// What a hypothesis brings at its samples.
  struct Tally {
    double gain = 0.0;
    double against = 0.0;
    double better = 0.0;  ///< samples that it explains better than those who hold them

    void add(float own, float held) {
      if (held >= kWellExplained) return;
      if (own > held) {
        gain += own - held;
        ++better;
      } else if (held <= 0.0f) {
        // Near it, but not on it: against it, unless somebody else explains that sample.
        against += own;
      }
    }
  };

  /// What a hypothesis brings at the samples of one that holds them, and once that has left.
  struct Inheritance {
    Tally held, left;
  };

  struct Chosen {
    List<bool> holds;           ///< of each in the pool
    List<std::uint32_t> order;  ///< as they came
    List<Standing> standings;   ///< of each in the pool
  };

  /// What a sample was held by before it changed.
  struct Change {
    std::uint32_t sample;
    Holders before;
  };

  Worth worthOf(std::uint32_t h, const Tally& tally) const;
  const Standing& standingOf(std::uint32_t h);
  double least(std::uint32_t h) const;
  double price(std::uint32_t h, double own) const;
  void enter(std::uint32_t h, const Support& support);
  void change(std::uint32_t sample, const Holders& now);

  const List<Hypothesis>& pool_;
  double min_inliers_;
  Chosen chosen_, noted_;
  List<Holders> holders_;           ///< of each sample
  bool noting_ = false;             ///< something is to go back to
  List<Change> changes_;            ///< since it was noted
  List<Inheritance> inheritances_;  ///< of those chosen, for worthsOfAdding()
  List<std::uint32_t> left_;        ///< of each sample: the last removal that it lost a holder by
  std::uint32_t removal_ = 0;
};

}  // namespace primitect
