#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""A camera that replays sends the same few clouds over and over, each with a stamp of its own."""
import sys
import unittest

import rospy
import rostest
from ros_helpers import Collector, wait_for
from sensor_msgs.msg import CameraInfo, PointCloud2

REPLAYED, FRAMES = 3, 7


class ReplayedCamera(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.infos = Collector("/camera/depth/camera_info", CameraInfo)
        cls.collector = Collector("/camera/depth/points", PointCloud2)
        wait_for(lambda: len(cls.collector.all()) >= FRAMES)
        cls.clouds = cls.collector.all()[:FRAMES]

    def test_clouds_come_back_after_their_number(self):
        self.assertEqual(len(self.clouds), FRAMES)
        for earlier, later in zip(self.clouds, self.clouds[REPLAYED:]):
            self.assertEqual(earlier.data, later.data)
        self.assertEqual(len({cloud.data for cloud in self.clouds}), REPLAYED)

    def test_every_cloud_has_its_own_stamp(self):
        stamps = [cloud.header.stamp for cloud in self.clouds]
        self.assertEqual(stamps, sorted(set(stamps)))

    def test_the_calibration_has_the_stamp_of_the_cloud(self):
        wanted = self.clouds[-1].header.stamp
        self.assertTrue(wait_for(lambda: wanted in {info.header.stamp for info in self.infos.all()}))


if __name__ == "__main__":
    rospy.init_node("replayed_camera_test")
    rostest.rosrun("primitect", "replayed_camera", ReplayedCamera, sys.argv)
