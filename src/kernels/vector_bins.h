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
  explicit Record(float most) : most_(Cells{} + most) {}

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

/// Votes for kShares rows each, about to be added to the bins; a vote is four cells and four weights, of which the
/// first kShares count.
template <int kShares>
class VoteList {
 public:
  /// Sets votes i, i + 1, ...
  void set(int i, const ShareLanes (&shares)[kShares], const LayerLanes& layers, int radius_stride) {
    Floats cells[4] = {}, weights[4] = {};
    for (int k = 0; k < kShares; ++k) {
      cells[k] = (Floats)(shares[k].row * radius_stride + layers.lower);
      weights[k] = shares[k].weight;
    }
    storeRows(cells, reinterpret_cast<float*>(cells_) + 4 * i);
    storeRows(weights, weights_ + 4 * i);
    store(layers.upper_weight, upper_weights_ + i);
  }

  /// Adds the first `count` votes.
  void addTo(Bins& bins, int count) const {
    Record record(bins.most), second_record(bins.most);
    Cells total = {};
    Places vote = {};
    for (int i = 0; i < count; ++i) {
      const int* cell = cells_ + 4 * i;
      Cells weight, upper = Cells{} + upper_weights_[i];
      __builtin_memcpy(&weight, weights_ + 4 * i, sizeof weight);
      const Cells share = Cells{1.0f, 0.0f, 1.0f, 0.0f} + upper * Cells{-1.0f, 1.0f, -1.0f, 1.0f};
      total += weight;
      record.see(addTwo(bins.votes, cell, Cells{weight[0], weight[0], weight[1], weight[1]} * share), vote);
      if (kShares == 4) {
        const Cells addend = Cells{weight[2], weight[2], weight[3], weight[3]} * share;
        second_record.see(addTwo(bins.votes, cell + 2, addend), vote);
      }
      vote += 4;
    }
    bins.total += (total[0] + total[1]) + (total[2] + total[3]);
    record.report(cells_, bins);
    if (kShares == 4) second_record.report(cells_ + 2, bins);
    keepCells(bins, count);
  }

 private:
  void keepCells(Bins& bins, int count) const {
    int* cells = bins.cells + bins.cell_count;
    for (int i = 0; i < count; ++i) __builtin_memcpy(cells + kShares * i, cells_ + 4 * i, kShares * sizeof(int));
    bins.cell_count += static_cast<std::size_t>(kShares) * count;
  }

  alignas(64) int cells_[4 * kRoom];
  alignas(64) float weights_[4 * kRoom];
  float upper_weights_[kRoom];
};

}  // namespace
}  // namespace primitect::kernels
