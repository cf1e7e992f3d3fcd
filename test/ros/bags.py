#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""bag.launch: a looped bag of clouds (time jumps back at its end), and a recorded depth camera."""
import io
import math
import os
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import rosbag
import rospkg
import rospy
import rostest
from primitect.msg import Primitive, PrimitiveArray
from ros_helpers import Collector, cloud_message, wait_for, wall_and_ball
from rosgraph_msgs.msg import Log
from sensor_msgs.msg import CameraInfo, CompressedImage
from visualization_msgs.msg import Marker, MarkerArray

FIRST_STAMP = 1000
DETECT_BAG = os.path.join(os.environ["CMAKE_PREFIX_PATH"].split(":")[0], "lib", "primitect", "detect_bag")
# In the folder "shared" beside the project.
RECORDED = os.path.join(os.path.dirname(os.path.realpath(rospkg.RosPack().get_path("primitect"))), "shared", "bags",
                        "sphere406_kinect2.bag")


def write_bag(path, frames=8):
    points = wall_and_ball()
    with rosbag.Bag(path, "w") as bag:
        for frame in range(frames):
            stamp = rospy.Time(FIRST_STAMP, 250000000 * (frame % 4)) + rospy.Duration(frame // 4)
            bag.write("/sensor/points", cloud_message(*points, stamp=stamp), stamp)


def png(values, width):
    """Of one channel of 16 bits."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    rows = [b"\0" + struct.pack(">%dH" % width, *values[k:k + width]) for k in range(0, len(values), width)]
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 16, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"".join(rows))) + chunk(b"IEND", b""))


def write_packed_bag(path, frames=8):
    """The same wall and ball as compressed depth images; their camera_info is not beside them."""
    points, width, height = wall_and_ball()
    image = CompressedImage(format="16UC1; compressedDepth png")
    image.data = bytes(12) + png([round(1000 * z) for _, _, z in points], width)
    info = CameraInfo(width=width, height=height)
    info.K = [140, 0, (width - 1) / 2, 0, 140, (height - 1) / 2, 0, 0, 1]
    info.P = info.K[:3] + [0] + info.K[3:6] + [0] + info.K[6:] + [0]
    with rosbag.Bag(path, "w") as bag:
        for frame in range(frames):
            for message in image, info:
                message.header.stamp = rospy.Time(FIRST_STAMP, 100000000 * frame)
                message.header.frame_id = "camera"
            bag.write("/lens/depth/compressedDepth", image, image.header.stamp)
            bag.write("/elsewhere/info", info, info.header.stamp)


def bytes_of(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


class Launched:
    """A launch file that runs while the with block does, started in a folder as a shell does it."""

    def __init__(self, *arguments, folder="/"):
        self._arguments = arguments
        self._folder = folder

    def __enter__(self):
        self._process = subprocess.Popen(["roslaunch", "--wait", "primitect", *self._arguments], cwd=self._folder,
                                         env=dict(os.environ, PWD=self._folder))

    def __exit__(self, *_):
        self._process.send_signal(signal.SIGINT)
        self._process.wait()


class Bags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def collect(self, name, message_type):
        collector = Collector(name, message_type)
        self.addCleanup(collector.stop)
        return collector

    def test_of_clouds_are_processed_and_started_anew_when_time_jumps_back(self):
        folder = os.path.join(self.folder, "two words, an owner's")
        os.mkdir(folder)
        write_bag(os.path.join(folder, "clouds.bag"))
        primitives = self.collect("/looped/primitives", PrimitiveArray)
        markers = self.collect("/looped/markers", MarkerArray)

        def jumps():
            stamps = [m.header.stamp for m in primitives.all()]
            return [i for i in range(1, len(stamps)) if stamps[i] < stamps[i - 1]]

        def cleared():
            return [a for a in markers.all() if a.markers[0].action == Marker.DELETEALL]
        with Launched("bag.launch", "bag:=clouds.bag", "input:=/sensor/points", "name:=looped", "loop:=true", "delay:=2",
                      folder=folder):
            self.assertTrue(wait_for(lambda: jumps() and len(cleared()) >= 2))
        for message in primitives.all():
            self.assertIn(message.header.stamp.secs, (FIRST_STAMP, FIRST_STAMP + 1))
            self.assertEqual(message.header.frame_id, "camera")
        # Everything is deleted once at the start and once a jump, not in every frame.
        self.assertLessEqual(len(cleared()), 1 + len(jumps()))

    def test_give_the_node_what_they_give_detect_bag_whatever_was_found_when_they_were_recorded(self):
        path, found = os.path.join(self.folder, "clouds.bag"), os.path.join(self.folder, "found.bag")
        write_bag(path, frames=4)
        with rosbag.Bag(path, "a") as bag:
            for frame in range(4):
                stamp = rospy.Time(FIRST_STAMP, 250000000 * frame + 1000)
                for topic in ("primitives", "points", "parameter_updates"):
                    bag.write("/compared/" + topic, PrimitiveArray(points_in=7), stamp)
        subprocess.run([DETECT_BAG, path, "--out", found], check=True, stdout=subprocess.DEVNULL)
        with rosbag.Bag(found) as bag:
            offline = [message for _, message, _ in bag.read_messages("/detector/primitives")]
        primitives = self.collect("/compared/primitives", PrimitiveArray)
        recorded = [self.collect("/recorded/compared/" + topic, PrimitiveArray)
                    for topic in ("primitives", "points", "parameter_updates")]
        with Launched("bag.launch", "bag:=" + path, "input:=/sensor/points", "name:=compared", "rate:=0.5", "delay:=3"):
            self.assertTrue(wait_for(lambda: len(primitives.all()) >= len(offline)
                                     and all(len(one.all()) >= 4 for one in recorded)))
        self.assertEqual([[m.points_in for m in one.all()] for one in recorded], [[7] * 4] * 3)
        online = primitives.all()
        self.assertEqual((len(offline), len(online)), (4, 4))
        for one, other in zip(online, offline):
            self.assertGreater(len(one.primitives), 1)
            one.header.seq = other.header.seq = 0
            one.processing_time = other.processing_time = 0.0
            self.assertEqual(bytes_of(one), bytes_of(other))

    def test_of_compressed_depths_are_unpacked_with_the_camera_info_that_is_named(self):
        write_packed_bag(os.path.join(self.folder, "packed.bag"))
        primitives = self.collect("/unpacked/primitives", PrimitiveArray)
        with Launched("bag.launch", "bag:=packed.bag", "depth:=/lens/depth/compressedDepth", "camera_info:=/elsewhere/info",
                      "name:=unpacked", "loop:=true", "delay:=2", folder=self.folder):
            self.assertTrue(wait_for(lambda: len(primitives.all()) >= 3))
        for message in primitives.all():
            radii = [p.radius for p in message.primitives if p.type == Primitive.SPHERE]
            self.assertEqual(len(radii), 1)
            self.assertAlmostEqual(radii[0], 0.1, delta=0.003)

    def test_whose_topic_is_misspelt_say_what_nobody_publishes(self):
        write_packed_bag(os.path.join(self.folder, "packed.bag"))
        log = self.collect("/rosout", Log)
        self.collect("/misspelt/primitives", PrimitiveArray)

        def told():
            return [entry.msg for entry in log.all() if entry.msg.startswith("/misspelt: no cloud on ")]
        with Launched("bag.launch", "bag:=packed.bag", "depth:=/lens/depth", "name:=misspelt", "loop:=true", "delay:=2",
                      folder=self.folder):
            sentence = "none sent any: /lens/depth is published compressed only (depth:=/lens/depth/compressedDepth)"
            self.assertTrue(wait_for(lambda: [line for line in told() if sentence in line]))
        with Launched("bag.launch", "bag:=packed.bag", "depth:=/lens/dept/compressedDepth", "name:=misspelt", "delay:=2",
                      folder=self.folder):
            sentence = ("none sent any: it waits for /lens/camera_info and /lens/dept/compressedDepth, "
                        "which nobody publishes")
            self.assertTrue(wait_for(lambda: [line for line in told() if sentence in line]))

    def test_of_a_depth_camera_show_the_ball(self):
        if not os.path.exists(RECORDED):
            print("SKIPPED: no recorded bag at " + RECORDED + " (beside the project)", file=sys.stderr, flush=True)
            self.skipTest("no recorded bag at " + RECORDED)
        config = os.path.join(self.folder, "far.yaml")
        with open(config, "w", encoding="utf-8") as file:
            file.write("preset: default\nmax_depth: 4.0\n")
        primitives = self.collect("/recorded/primitives", PrimitiveArray)

        def is_the_ball(p):  # its true radius is 0.203 m
            return p.type == Primitive.SPHERE and abs(p.radius - 0.203) < 0.03

        def with_ball():
            return [m for m in primitives.all() if any(is_the_ball(p) for p in m.primitives)]
        with Launched("bag.launch", "bag:=" + RECORDED, "depth:=/camera/depth_registered/image_raw", "name:=recorded",
                      "config:=" + config, "loop:=true", "delay:=2"):
            self.assertTrue(wait_for(lambda: len(primitives.all()) >= 10))
        print("ball in %d of %d frames" % (len(with_ball()), len(primitives.all())))
        self.assertEqual(len(with_ball()), len(primitives.all()))
        for ball in [p for m in with_ball() for p in m.primitives if is_the_ball(p)]:
            self.assertGreater(ball.confidence, 0.9)
            # Not certain, and better than one point (m); beyond 2 m neighbouring points err alike.
            self.assertTrue(all(1e-4 < math.sqrt(ball.pose.covariance[7 * i]) < 0.02 for i in range(3)))
            self.assertTrue(1e-4 < ball.radius_stddev < 0.02)


if __name__ == "__main__":
    rospy.init_node("bags_test")
    rostest.rosrun("primitect", "bags", Bags, sys.argv)
