// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// From the shortest steps to differences over many; see lattice.h.
#include "core/lattice.h"

#include <algorithm>
#include <cmath>

namespace primitect {
namespace {

constexpr double kNearPlace = 0.1;  // spacings

/// What most of the values are off by, as an angle: those of one place point in one direction.
double offsetOf(const List<double>& values, double spacing) {
  const double turn = 2.0 * M_PI / spacing;
  double sine = 0.0, cosine = 0.0;
  for (const double value : values) sine += std::sin(turn * value), cosine += std::cos(turn * value);
  return std::atan2(sine, cosine) / turn;
}

}  // namespace

bool isWholeAndNotZero(double number, double near) {
  return std::abs(number - std::round(number)) < near && std::round(number) != 0.0;
}

double stepAt(double share, const List<double>& values, double least) {
  constexpr std::size_t kFewest = 25;
  List<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step > least) steps.push_back(step);
  }
  if (steps.size() < kFewest) return 0.0;
  const auto place = steps.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(steps.size()));
  std::nth_element(steps.begin(), place, steps.end());
  return *place;
}

Lattice latticeFrom(const List<double>& values, double about) {
  Lattice lattice = {0.0, about};
  for (const std::size_t apart : {1, 8, 64, 512}) {
    double products = 0.0, squares = 0.0;
    for (std::size_t i = apart; i < values.size(); ++i) {
      const double difference = values[i] - values[i - apart], number = difference / lattice.spacing;
      if (!isWholeAndNotZero(number, kNearPlace)) continue;
      products += std::round(number) * difference, squares += std::round(number) * std::round(number);
    }
    if (squares > 0.0) lattice.spacing = products / squares;
  }
  lattice.offset = offsetOf(values, lattice.spacing);
  return lattice;
}

std::optional<Lattice> findLattice(List<double> values) {
  constexpr double kNearlyAll = 0.95;
  constexpr double kLeast = 0.3;  // of what they would be apart if all were different: those of one place are not
  std::sort(values.begin(), values.end());
  if (values.empty()) return std::nullopt;
  const double least = kLeast * (values.back() - values.front()) / static_cast<double>(values.size());
  // Of many places some are empty, and steps longer; of few, shorter ones lie between values of one place.
  for (const double share : {0.75, 0.5, 0.25, 0.1}) {
    const double about = stepAt(share, values, least);
    if (!(about > 0.0)) return std::nullopt;
    const Lattice lattice = latticeFrom(values, about);
    const auto near = std::count_if(values.begin(), values.end(), [&lattice](double value) {
      const double place = lattice.place(value);
      return std::abs(place - std::round(place)) < kNearPlace;
    });
    if (static_cast<double>(near) > kNearlyAll * static_cast<double>(values.size())) return lattice;
  }
  return std::nullopt;
}

}  // namespace primitect
