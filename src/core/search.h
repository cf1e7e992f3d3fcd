// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Votes and proposals in turns: references that are explained by now need not vote.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <utility>

#include "core/clustering.h"
#include "core/frame_memory.h"
#include "core/pair_voting.h"
#include "core/verification.h"

namespace primitect {

/// What looks for shapes among samples, with the verification that takes what is found.
class Search {
 public:
  /// done: called with the name of each stage that is over.
  Search(PairVoting& voting, Verification& verification, std::function<void(const char*)> done)
      : voting_(voting), verification_(verification), done_(std::move(done)) {}

  /// Batches have so many references.
  void setBatch(std::size_t references) { batch_ = references; }

  /// Noise from what the first batch of these samples votes for; d_s in m.
  void measureNoise(const Samples& samples, double scene_diameter) {
    begin(samples, scene_diameter);
    voteBatch(0, [](std::uint32_t) { return true; });
    done_("vote");
    sortByVotes(candidates_);
    verification_.measureNoise(samples, candidates_);
  }

  /// Among these voters, all batches. place: index of a voter among the samples of the verification.
  template <class Place>
  void run(const Samples& voters, double scene_diameter, const Place& place) {
    begin(voters, scene_diameter);
    runFrom(0, place);
  }

  /// The same with the voters of measureNoise(), whose first batch has voted.
  template <class Place>
  void goOn(const Place& place) {
    runFrom(1, place);
  }

 private:
  void begin(const Samples& voters, double scene_diameter) {
    voting_.begin(voters, scene_diameter);
    candidates_.clear();
  }

  std::size_t batches() const { return (voting_.references() + batch_ - 1) / batch_; }

  /// The wanted references of a batch, which are spread over all voters, vote.
  template <class Wanted>
  void voteBatch(std::size_t batch, const Wanted& wanted) {
    for (std::size_t k = batch; k < voting_.references(); k += batches()) {
      const std::uint32_t reference = voting_.reference(k);
      if (wanted(reference)) voting_.voteAt(reference, candidates_);
    }
  }

  template <class Place>
  void runFrom(std::size_t next, const Place& place) {
    done_("segment");
    for (std::size_t batch = 0; batch < batches(); ++batch) {
      const std::size_t pending = candidates_.size();
      if (batch >= next) voteBatch(batch, [&](std::uint32_t voter) { return verification_.wants(place(voter)); });
      done_("vote");
      for (std::size_t k = pending; k < candidates_.size(); ++k) candidates_[k].sample = place(candidates_[k].sample);
      sortByVotes(candidates_);
      proposeStrongest(batch + 1 == batches());
      done_("segment");
    }
  }

  /// Weak ones wait, until the last batch: a later one may know better.
  void proposeStrongest(bool all) {
    const auto taken = candidates_.begin() + static_cast<std::ptrdiff_t>(candidates_.size() / (all ? 1 : 2));
    strongest_.assign(candidates_.begin(), taken);
    candidates_.erase(candidates_.begin(), taken);
    verification_.propose(strongest_);
  }

  PairVoting& voting_;
  Verification& verification_;
  std::function<void(const char*)> done_;
  List<Candidate> candidates_, strongest_;
  std::size_t batch_ = 256;
};

}  // namespace primitect
