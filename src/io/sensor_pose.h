// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the sensor was that saw the points of a file.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "primitect/primitives.h"

namespace primitect::io {

/// Of the sensor's optical frame (z ahead, x right, y down) in the frame of the points.
struct SensorPose {
  Vec3 position = Vec3::Zero();  ///< m
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  Eigen::Isometry3d pointsFromSensor() const { return Eigen::Translation3d(position) * orientation; }
  static SensorPose of(const Eigen::Isometry3d& points_from_sensor) {
    return {points_from_sensor.translation(), Eigen::Quaterniond(points_from_sensor.linear())};
  }
};

/// "X Y Z QX QY QZ QW", as tf2_tools echo.py prints them, with or without commas and brackets; the quaternion is scaled
/// to unit length. Throws std::invalid_argument naming value and range.
SensorPose parseSensorPose(const std::string& text);

/// What parseSensorPose() takes.
std::string sensorPoseText(const SensorPose& pose);

}  // namespace primitect::io
