// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Adding votes to bins, vote by vote but for all rows of a vote at a time; for a kernel file that has included its
// lanes.
#pragma once

#include "kernels/kernels.h"
#include "kernels/vector_lists.h"
#include "kernels/vector_spread.h"

namespace primitect::kernels {
namespace {

/// The votes of two cells, each of them two neighbouring bins.
using Cells = float __attribute__((vector_size(16)));
using CellPair = double __attribute__((vector_size(16)));

using Places = int __attribute__((vector_size(16)));

/// The most votes seen, for each of the four bins of two cells, and where they were seen first.
class Record {
 public:
  explicit Record(float most = 0.0f) : most_(Cells{} + most) {}

  void see(Cells votes, Places where) {
    const Places more = votes > most_;
    most_ = more ? votes : most_;
    where_ = more ? where : where_;
  }

  /// To the bins, if it beats what they had. `where` is an index of the two cells in the list.
  void report(const int* cells, Bins& bins) const {
    int lane = 0;
    for (int k = 1; k < 4; ++k) {
      if (most_[k] > most_[lane] || (most_[k] == most_[lane] && where_[k] < where_[lane])) lane = k;
    }
    if (!(most_[lane] > bins.most)) return;
    bins.most = most_[lane];
    bins.strongest = cells[where_[lane] + lane / 2] + lane % 2;
  }

 private:
  Cells most_;
  Places where_ = {};
};

/// Adds to the bins of two cells, the second one last: they may be the same one if the first addend is 0.
Cells addTwo(float* bins, const int* cell, Cells addend) {
  double first, second;
  __builtin_memcpy(&first, bins + cell[0], sizeof first);
  __builtin_memcpy(&second, bins + cell[1], sizeof second);
  const Cells sum = (Cells)CellPair{first, second} + addend;
  first = ((CellPair)sum)[0];
  second = ((CellPair)sum)[1];
  __builtin_memcpy(bins + cell[0], &first, sizeof first);
  __builtin_memcpy(bins + cell[1], &second, sizeof second);
  return sum;
}

/// Votes for kShares rows each, about to be added to the bins: cells, and what is added to the two bins of each.
template <int kShares>
struct VoteList {
  int count = 0;
  alignas(64) int cells[4 * kRoom];
  alignas(64) float addends[kShares / 2][4 * kRoom];

  /// Sets votes i, i + 1, ...
  void set(int i, const ShareLanes (&shares)[kShares], const LayerLanes& layers, int radius_stride) {
    Floats columns[4] = {};
    for (int k = 0; k < kShares; ++k) columns[k] = (Floats)(shares[k].row * radius_stride + layers.lower);
    storeRows(columns, reinterpret_cast<float*>(cells) + 4 * i);
    for (int k = 0; k < kShares; k += 2) {
      const Floats first = shares[k].weight * layers.upper_weight, second = shares[k + 1].weight * layers.upper_weight;
      storeRows({shares[k].weight - first, first, shares[k + 1].weight - second, second}, addends[k / 2] + 4 * i);
    }
  }
};

/// Adds the votes of a list, one by one.
template <int kShares>
class Addition {
 public:
  Addition(const VoteList<kShares>& votes, Bins& bins) : votes_(votes), bins_(bins), all_(bins.votes) {
    for (Record& record : records_) record = Record(bins.most);
  }

  PRIMITECT_INLINE void add(int i) {
    if (i >= votes_.count) return;
    for (int k = 0; k < kShares / 2; ++k) {
      Cells addend;
      __builtin_memcpy(&addend, votes_.addends[k] + 4 * i, sizeof addend);
      records_[k].see(addTwo(all_, votes_.cells + 4 * i + 2 * k, addend), Places{} + 4 * i);
      total_ += addend;
    }
  }

  void finish() {
    bins_.total += (total_[0] + total_[1]) + (total_[2] + total_[3]);
    for (int k = 0; k < kShares / 2; ++k) records_[k].report(votes_.cells + 2 * k, bins_);
    if (!bins_.cells) return;
    int* cells = bins_.cells + bins_.cell_count;
    for (int i = 0; i < votes_.count; ++i) {
      __builtin_memcpy(cells + kShares * i, votes_.cells + 4 * i, kShares * sizeof(int));
    }
    bins_.cell_count += static_cast<std::size_t>(kShares) * votes_.count;
  }

 private:
  const VoteList<kShares>& votes_;
  Bins& bins_;
  float* all_;
  Record records_[kShares / 2];
  Cells total_ = {};
};

/// Votes for a single row.
struct RowVoteList {
  int count = 0;
  int cells[kRoom];
  float lower[kRoom], upper[kRoom];

  void set(int i, Floats weight, const LayerLanes& layers) {
    const Floats part = weight * layers.upper_weight;
    store(layers.lower, cells + i);
    store(weight - part, lower + i);
    store(part, upper + i);
  }
};

/// Adds them. Most of a sphere's votes fall into the same few bins, and each would wait for the sum of the one before:
/// neighbours in the list, and the two bins of a vote, go to different copies of the row.
class RowAddition {
 public:
  RowAddition(const RowVoteList& votes, Bins& bins, int row_size) : votes_(votes), bins_(bins), row_size_(row_size) {
    if (votes.count == 0) return;
    for (auto& copy : copies_) __builtin_memset(copy, 0, static_cast<std::size_t>(row_size) * sizeof(float));
  }

  PRIMITECT_INLINE void add(int i) {
    if (i >= votes_.count) return;
    const int copy = i % 2, cell = votes_.cells[i];
    copies_[copy][cell] += votes_.lower[i];
    copies_[2 + copy][cell + 1] += votes_.upper[i];
  }

  void finish() {
    if (votes_.count == 0) return;
    Floats most = {}, total = {};
    Ints strongest = {};
    for (int k = 0; k < row_size_; k += kLanes) {
      const Floats sum = load(bins_.votes + k) + ((load(copies_[0] + k) + load(copies_[1] + k)) +
                                                  (load(copies_[2] + k) + load(copies_[3] + k)));
      store(sum, bins_.votes + k);
      total += sum;
      const Ints more = sum > most;
      most = more ? sum : most;
      strongest = more ? laneNumbers() + k : strongest;
    }
    bins_.most = bins_.total = 0.0f;
    for (int k = 0; k < kLanes; ++k) {
      bins_.total += total[k];
      if (!(most[k] > bins_.most)) continue;
      bins_.most = most[k];
      bins_.strongest = strongest[k];
    }
  }

 private:
  const RowVoteList& votes_;
  Bins& bins_;
  int row_size_;
  float copies_[4][kMostRadiusStride];
};

}  // namespace
}  // namespace primitect::kernels
