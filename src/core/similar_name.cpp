// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Names compared letter by letter.
#include "core/similar_name.h"

#include <algorithm>
#include <numeric>

namespace primitect {
namespace {

/// Letters to put in, take out, change or swap with the next until one word is the other (Damerau and Levenshtein).
std::size_t changesBetween(const std::string& one, const std::string& other) {
  std::vector<std::size_t> row(other.size() + 1), last(row), last_but_one(row);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= one.size(); ++i) {
    last_but_one = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const std::size_t changed = last[j - 1] + (one[i - 1] == other[j - 1] ? 0 : 1);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1];
      if (swapped) row[j] = std::min(row[j], last_but_one[j - 2] + 1);
    }
  }
  return row.back();
}

/// The name that is meant, or empty.
std::string similarName(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t kShort = 4;  // letters: of fewer nothing can be told
  if (name.size() < kShort) return "";
  std::string best;
  std::size_t fewest = std::max<std::size_t>(1, name.size() / 6) + 1;
  for (const std::string& other : names) {
    const std::size_t changes = changesBetween(name, other);
    if (changes < fewest) best = other, fewest = changes;
  }
  if (!best.empty()) return best;
  const auto longer =
      std::find_if(names.begin(), names.end(), [&](const std::string& other) { return other.rfind(name, 0) == 0; });
  return longer == names.end() ? "" : *longer;
}

}  // namespace

std::string similarNameHint(const std::string& name, const std::vector<std::string>& names) {
  const std::string similar = similarName(name, names);
  return similar.empty() ? "" : "; did you mean '" + similar + "'?";
}

}  // namespace primitect
