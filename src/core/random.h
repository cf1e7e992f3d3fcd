// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Seeded random numbers that are the same on every machine (the distributions of <random> are not).
#pragma once

#include <cmath>
#include <cstdint>

namespace primitect {

/// xoshiro256++ (Blackman and Vigna 2019), seeded by splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15u;
      std::uint64_t mixed = seed;
      mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
      mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
      word = mixed ^ (mixed >> 31);
    }
  }

  std::uint64_t next() {
    const std::uint64_t result = rotateLeft(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotateLeft(state_[3], 45);
    return result;
  }

  /// In [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In [0, count), count > 0; the bias of at most count / 2^64 is of no matter here.
  std::uint64_t below(std::uint64_t count) { return next() % count; }

  /// Mean 0, standard deviation 1 (polar method of Marsaglia).
  double gaussian() {
    double u, v, square;
    do {
      u = uniform(-1.0, 1.0);
      v = uniform(-1.0, 1.0);
      square = u * u + v * v;
    } while (square >= 1.0 || square == 0.0);
    return u * std::sqrt(-2.0 * std::log(square) / square);
  }

 private:
  static std::uint64_t rotateLeft(std::uint64_t word, int bits) { return (word << bits) | (word >> (64 - bits)); }

  std::uint64_t state_[4];
};

}  // namespace primitect
