// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Words and numbers of a scene; see scene_text.h.
#include "synthetic/scene_text.h"

#include <cmath>
#include <iterator>
#include <locale>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "synthetic/poses.h"
#include "synthetic/scene_layout.h"
#include "synthetic/tabletop.h"

namespace primitect::synthetic {
namespace {

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// Finite ones.
std::optional<double> numberIn(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  const bool whole = stream >> number && stream.peek() == std::char_traits<char>::eof();
  return whole && std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

/// As many as come next.
std::vector<double> numbersFrom(std::size_t& next, const std::vector<std::string>& words) {
  std::vector<double> numbers;
  for (; next < words.size(); ++next) {
    const std::optional<double> number = numberIn(words[next]);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

/// One thing, as it is told.
struct Told {
  std::string kind;
  std::vector<double> sizes;
  Vec3 place = Vec3::Zero();  ///< m, from the middle of the table
  double turn = 0.0;          ///< rad
  bool lying = false;
};

[[noreturn]] void refuse(const std::string& thing, const std::string& why) {
  throw std::invalid_argument("'" + thing + "': " + why + "; expected " + kSceneGrammar);
}

/// At least one word.
Told toldBy(const std::string& thing, const std::vector<std::string>& words) {
  Told told;
  told.kind = words.front();
  std::set<std::string> said;
  std::size_t next = 1;
  told.sizes = numbersFrom(next, words);
  while (next < words.size()) {
    const std::string& word = words[next++];
    const std::vector<double> numbers = numbersFrom(next, words);
    if (!said.insert(word).second) refuse(thing, "'" + word + "' is said twice");
    if (word == "at" && (numbers.size() == 2 || numbers.size() == 3)) {
      const bool beside = std::abs(numbers[0]) > kTableHalfX || std::abs(numbers[1]) > kTableHalfY;
      if (beside && numbers.size() == 2) refuse(thing, "X and Y are beside the table; Z is wanted there");
      told.place = Vec3(numbers[0], numbers[1], numbers.size() == 3 ? numbers[2] : 0.0);
    } else if (word == "turn" && numbers.size() == 1) {
      told.turn = numbers[0] * kDegree;
    } else if (word == "lying" && numbers.empty()) {
      told.lying = true;
    } else {
      refuse(thing, "'" + word + "' and what follows is not understood");
    }
  }
  return told;
}

/// As it stands or lies around (0, 0) on the table.
struct PlacedThing {
  Solid solid;
  Eigen::Isometry3d pose;
};

Eigen::Isometry3d raised(double height) { return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, height)); }

PlacedThing placed(const std::string& thing, const Told& told) {
  const auto hasSizes = [&](std::size_t count) {
    if (told.sizes.size() != count)
      refuse(thing, "it has " + std::to_string(told.sizes.size()) + " instead of " + std::to_string(count) + " sizes");
    return true;
  };
  const auto size = [&told](std::size_t k) { return told.sizes[k]; };
  constexpr double kLargest = 2.0;  // m
  for (std::size_t k = told.kind == "cone" ? 1 : 0; k < told.sizes.size(); ++k) {
    if (!(size(k) > 0.0 && size(k) <= kLargest)) refuse(thing, "sizes must be above 0 m, and at most 2 m");
  }
  const Eigen::AngleAxisd upside_down(kPi, Vec3::UnitX()), lying(0.5 * kPi, Vec3::UnitY());
  if (told.lying && told.kind != "can" && told.kind != "cone") refuse(thing, "only a can or a cone can be lying");
  if (told.kind == "ball" && hasSizes(1)) return {Ball{size(0)}, raised(size(0))};
  if (told.kind == "box" && hasSizes(3)) {
    return {Box{0.5 * size(0), 0.5 * size(1), 0.5 * size(2)}, raised(0.5 * size(2))};
  }
  if (told.kind == "can" && hasSizes(2)) {
    const Rod rod = {size(0), 0.5 * size(1)};
    return {rod, told.lying ? raised(rod.radius) * lying : raised(rod.half_length)};
  }
  if (told.kind == "cone" && hasSizes(2)) {
    const Frustum cone = {size(0) * kDegree, 0.0, size(1)};
    if (!told.lying) return {cone, raised(cone.end) * upside_down};
    // On its side, the axis as steep as the side is to it.
    const Eigen::AngleAxisd tilt(0.5 * kPi - cone.half_angle, Vec3::UnitY());
    const Eigen::Translation3d centred(-0.5 * cone.end * std::cos(cone.half_angle), 0.0, 0.0);
    return {cone, Eigen::Isometry3d(centred * tilt)};
  }
  refuse(thing, "'" + told.kind + "' is no kind of thing");
}

Vec3 pointOf(const std::string& text) {
  const std::vector<std::string> words = wordsOf(text);
  std::size_t next = 0;
  const std::vector<double> numbers = numbersFrom(next, words);
  if (numbers.size() != 3 || next != words.size()) {
    throw std::invalid_argument("'" + text + "' is no place; expected X Y Z in m");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

World tableWith(const std::string& things) {
  World world = emptyRoom();
  if (things == "none") return world;
  std::istringstream stream(things);
  for (std::string thing; std::getline(stream, thing, ';');) {
    const std::vector<std::string> words = wordsOf(thing);
    if (words.empty()) continue;  // as after the last ';'
    const Told told = toldBy(thing, words);
    const PlacedThing on_table = placed(thing, told);
    const Eigen::Isometry3d place = Eigen::Translation3d(told.place + Vec3(0.0, 0.0, kTableHeight)) *
                                    Eigen::Isometry3d(Eigen::AngleAxisd(told.turn, Vec3::UnitZ()));
    world.add(told.kind, on_table.solid, place * on_table.pose);
  }
  return world;
}

Eigen::Isometry3d poseOf(const std::string& eye, const std::string& target, double roll) {
  const Vec3 from = pointOf(eye), to = pointOf(target);
  if (from == to) throw std::invalid_argument("the camera at '" + eye + "' looks at itself");
  return lookAt(from, to) * Eigen::AngleAxisd(roll, Vec3::UnitZ());
}

}  // namespace primitect::synthetic
