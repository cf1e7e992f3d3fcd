// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Poses from text and to text.
#include "io/sensor_pose.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "primitect/cloud.h"

namespace primitect::io {
namespace {

bool isRotation(const Eigen::Quaterniond& quaternion) {
  constexpr double kShortest = 1e-6, kLongest = 1e6;
  return kShortest <= quaternion.norm() && quaternion.norm() <= kLongest;
}

/// Nothing unless all words are finite numbers.
std::vector<double> numbersOf(std::string text) {
  const auto separates = [](char c) { return c == ',' || c == '[' || c == ']'; };
  std::replace_if(text.begin(), text.end(), separates, ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back())) return {};
  }
  return numbers;
}

}  // namespace

SensorPose parseSensorPose(const std::string& text) {
  const std::vector<double> n = numbersOf(text);
  SensorPose pose;
  if (n.size() == 7) {
    pose.position = {n[0], n[1], n[2]};
    pose.orientation = Eigen::Quaterniond(n[6], n[3], n[4], n[5]);
  }
  if (n.size() != 7 || !isRotation(pose.orientation) || !(pose.position.norm() <= Cloud::kFarthest)) {
    throw std::invalid_argument("sensor: '" + text +
                                "' is not X Y Z QX QY QZ QW: seven numbers, a position in m and a quaternion other "
                                "than 0");
  }
  pose.orientation.normalize();
  return pose;
}

std::string sensorPoseText(const SensorPose& pose) {
  std::ostringstream text;
  text.precision(9);
  const auto& p = pose.position;
  const auto& q = pose.orientation;
  // Adding 0 turns -0 into 0.
  for (const double number : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) {
    text << (text.tellp() > 0 ? " " : "") << std::round(1e6 * number) / 1e6 + 0.0;
  }
  return text.str();
}

}  // namespace primitect::io
