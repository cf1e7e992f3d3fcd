// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Lists that stay in the first cache, for a kernel file that has included its lanes: what passes a condition is packed
// into one, so that the next step has all lanes full. Short steps over lists, one after the other, are what keeps the
// processor busy: in one long loop it waits for the results of divisions and look-ups.
#pragma once

namespace primitect::kernels {
namespace {

/// In the innermost loops, where a call would cost more than the work.
#define PRIMITECT_INLINE inline __attribute__((always_inline))

/// Entries that a list takes before it must be emptied.
constexpr int kEntries = 256;
constexpr int kRoom = kEntries + 2 * kLanes;

/// 0, 1, 2, ...
Ints laneNumbers() {
  Ints lanes;
  for (int k = 0; k < kLanes; ++k) lanes[k] = k;
  return lanes;
}

Ints all(bool fact) { return Ints{} - static_cast<int>(fact); }

/// Structure of arrays with kFields numbers an entry.
template <int kFields>
class LaneList {
 public:
  int count() const { return count_; }
  void clear() { count_ = 0; }

  PRIMITECT_INLINE void append(const Floats (&values)[kFields], const Packing& packing) {
    for (int k = 0; k < kFields; ++k) store(packing.packed(values[k]), values_[k] + count_);
    count_ += packing.count();
  }

  /// The lanes beyond the last entry become zeros.
  void pad() {
    for (auto& values : values_) store(Floats{}, values + count_);
  }

  Floats at(int field, int i) const { return load(values_[field] + i); }
  void set(int field, int i, Floats value) { store(value, values_[field] + i); }

  /// Which lanes from i on are entries.
  Ints valid(int i) const { return laneNumbers() < count_ - i; }

 private:
  int count_ = 0;
  alignas(64) float values_[kFields][kRoom];
};

}  // namespace
}  // namespace primitect::kernels
