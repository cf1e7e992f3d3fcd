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

NoiseParams ofBentStructuredLight() {
  NoiseParams params;
  params.waves = 0.0025;
  params.wave_length = 71;
  return params;
}

struct Sensor {
  const char* name;
  NoiseParams noise;
};

const std::vector<Sensor>& sensors() {
  static const std::vector<Sensor> all = {{"structured_light", {}},
                                          {"bent_structured_light", ofBentStructuredLight()},
                                          {"stereo", ofStereo()},
                                          {"time_of_flight", ofTimeOfFlight()}};
  return all;
}

std::vector<std::string> namesOf(const std::vector<Sensor>& some) {
  std::vector<std::string> names;
  for (const Sensor& sensor : some) names.emplace_back(sensor.name);
  return names;
}

}  // namespace

const std::vector<std::string>& sensorNames() {
  static const std::vector<std::string> names = namesOf(sensors());
  return names;
}

NoiseParams noiseOf(const std::string& sensor) {
  std::string known;
  for (const Sensor& one : sensors()) {
    if (sensor == one.name) return one.noise;
    known += (known.empty() ? "" : ", ") + std::string(one.name);
  }
  throw std::invalid_argument("sensor " + sensor + ": must be one of " + known);
}

}  // namespace primitect::synthetic
