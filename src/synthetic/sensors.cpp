// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Figures of the cameras; see sensors.h.
#include "synthetic/sensors.h"

#include <stdexcept>

namespace primitect::synthetic {
namespace {

NoiseParams ofStereo() {
  NoiseParams params;
  params.footprint = 3;
  params.grain = 7;
  params.disparity_noise = 0.06;
  params.baseline = 0.05;
  params.shadows = true;
  params.disparity_step = 1.0 / 32.0;
  params.max_incidence_deg = 85.0;
  params.waves = 0.0015;
  return params;
}

NoiseParams ofTimeOfFlight() {
  NoiseParams params;
  params.footprint = 3;
  params.disparity_step = 0.0;
  params.max_incidence_deg = 90.0;
  params.waves = 0.0015;
  return params;
}

}  // namespace

const std::vector<std::string>& sensorNames() {
  static const std::vector<std::string> names = {"structured_light", "stereo", "time_of_flight"};
  return names;
}

NoiseParams noiseOf(const std::string& sensor) {
  if (sensor == "structured_light") return {};
  if (sensor == "stereo") return ofStereo();
  if (sensor == "time_of_flight") return ofTimeOfFlight();
  throw std::invalid_argument("sensor " + sensor + ": must be structured_light, stereo or time_of_flight");
}

}  // namespace primitect::synthetic
