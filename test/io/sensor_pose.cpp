// SPDX-FileCopyrightText: 2026 The primitect developers
// SPDX-License-Identifier: BSD-3-Clause
// Poses of sensors as people write them.
#include "io/sensor_pose.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace primitect::io::sensor_pose_test {
namespace {

TEST(SensorPose, TakesWhatTfEchoPrints) {
  for (const char* text : {"0.1 -0.2 1.3 -0.5 0.5 -0.5 0.5", "[0.1, -0.2, 1.3] [-0.5, 0.5, -0.5, 0.5]",
                           " 0.1,-0.2,1.3,-0.5,0.5,-0.5,0.5 ", "1e-1 -0.2 1.3\n-5 5 -5 5"}) {
    const SensorPose pose = parseSensorPose(text);
    EXPECT_LT((pose.position - Vec3(0.1, -0.2, 1.3)).norm(), 1e-15) << text;
    // A camera that looks along x of a frame with z up.
    const Eigen::Isometry3d points_from_sensor = pose.pointsFromSensor();
    EXPECT_LT((points_from_sensor.linear().col(2) - Vec3::UnitX()).norm(), 1e-12) << text;
    EXPECT_LT((points_from_sensor.linear().col(1) + Vec3::UnitZ()).norm(), 1e-12) << text;
    EXPECT_LT((points_from_sensor.translation() - pose.position).norm(), 1e-15) << text;
  }
}

TEST(SensorPose, RefusesWhatIsNone) {
  for (const char* text :
       {"", "0 0 0", "0 0 0 0 0 0", "0 0 0 0 0 0 1 0", "0 0 0 0 0 0 0", "0 0 nan 0 0 0 1", "0 0 0 0 0 0 nan",
        "0 0 0 0 0 0 inf", "0 0 1x 0 0 0 1", "x y z 0 0 0 1", "0 0 2e6 0 0 0 1", "0 0 0 1e200 0 0 0"}) {
    try {
      parseSensorPose(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find("'" + std::string(text) + "' is not X Y Z QX QY QZ QW"), std::string::npos) << said;
    }
  }
}

TEST(SensorPose, IsWrittenAsItIsRead) {
  EXPECT_EQ(sensorPoseText(parseSensorPose("0.1 -0.2 1234.567 -0.5 0.5 -0.5 0.5")),
            "0.1 -0.2 1234.567 -0.5 0.5 -0.5 0.5");
  EXPECT_EQ(sensorPoseText(parseSensorPose("0 -0 0 0 0 -0 2")), "0 0 0 0 0 0 1");
}

}  // namespace
}  // namespace primitect::io::sensor_pose_test
