#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What launch files make of their arguments: parameters of the detector, and which of its two files RViz is given."""
import os
import shutil
import subprocess
import sys
import tempfile
import traceback
import unittest

import rosbag
import roslaunch
import rospy
import yaml
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def roslaunched(*arguments):
    """What the command roslaunch does with them, in a copy of this process, which has loaded it already."""
    with tempfile.TemporaryFile("w+") as output, tempfile.TemporaryFile("w+") as errors:
        sys.stdout.flush()
        sys.stderr.flush()
        copy = os.fork()
        if copy == 0:
            in_copy(arguments, output, errors)
        _, status = os.waitpid(copy, 0)
        for file in output, errors:
            file.seek(0)
        ended = os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)
        return subprocess.CompletedProcess(arguments, ended, output.read(), errors.read())


def in_copy(arguments, output, errors):
    """Runs it and ends the process, whatever happens."""
    ended = 1
    try:
        os.dup2(output.fileno(), 1)
        os.dup2(errors.fileno(), 2)
        sys.stdout, sys.stderr = output, errors
        try:
            sys.argv[:] = ["roslaunch", *arguments]  # this list, as the package reads it in other places, too
            roslaunch.main()
            ended = 0
        except SystemExit as end:
            ended = end.code if isinstance(end.code, int) else int(end.code is not None)
        except BaseException:
            traceback.print_exc()
        output.flush()
        errors.flush()
    finally:
        os._exit(ended)


def done(file, *arguments, node="/detector_rviz"):
    """Its words, and what it would start RViz, or another node, with; raises where it refuses."""
    run = roslaunched("--args", node, os.path.join(ROOT, "launch", file), "rviz:=true", *arguments)
    if run.returncode != 0:
        raise ValueError(run.stderr)
    return run


def started(file, *arguments):
    return done(file, *arguments).stdout


def words(file, *arguments):
    return done(file, *arguments).stderr


def checked(*arguments):
    """What is said about bags."""
    command = [os.path.join(ROOT, "scripts", "check_bag"), *arguments]
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True).stderr


def parameters(file, *arguments):
    """What it would set."""
    run = roslaunched("--dump-params", os.path.join(ROOT, "launch", file), *arguments)
    if run.returncode != 0 or not run.stdout:  # where it refuses a file, it ends with 0
        raise ValueError(run.stderr)
    return yaml.safe_load(run.stdout)


def config(name):
    with open(os.path.join(ROOT, "config", name), encoding="utf-8") as file:
        return yaml.safe_load(file)


FOLDER = tempfile.TemporaryDirectory()
BAG = os.path.join(FOLDER.name, "a.bag")
FILES = (("detector.launch",), ("depth_image.launch",), ("bag.launch", "bag:=" + BAG),
         ("bag.launch", "bag:=" + BAG, "depth:=/camera/depth/image_raw"))


def bag_of(name, topics):
    """The path of a bag with one empty message on each; topics: name -> type."""
    path = os.path.join(FOLDER.name, name)
    with rosbag.Bag(path, "w") as bag:
        for topic, kind in topics.items():
            bag.write(topic, kind(), rospy.Time(1))
    return path


def setUpModule():
    bag_of(os.path.basename(BAG), {"/lens/points": PointCloud2})


def tearDownModule():
    FOLDER.cleanup()


class LaunchParameters(unittest.TestCase):
    def test_reach_the_detector_from_every_file(self):
        for file in FILES:
            told = {"max_depth": 1.5, "target_frame": "map", "preset": "paper"}
            if "depth" not in " ".join(file):  # an image is in the camera's frame
                told["sensor_frame"] = "lens"
            found = parameters(*file, *("%s:=%s" % item for item in told.items()))
            for name, value in told.items():
                self.assertEqual(found["/detector/" + name], value, file)  # by default it is another one


class LaunchedBag(unittest.TestCase):
    def refused(self, bag):
        with self.assertRaises(ValueError) as refused:
            started("bag.launch", "bag:=" + bag)
        return str(refused.exception)

    def test_that_is_missing_or_none_is_refused_at_once(self):
        self.assertIn("No such file", self.refused("missing.bag"))
        self.assertIn("does not appear to be a bag", self.refused(os.path.join(ROOT, "README.md")))

    def test_that_was_cut_short_is_refused_with_what_mends_it(self):
        cut = os.path.join(FOLDER.name, "cut.bag")
        shutil.copy(BAG, cut)
        os.truncate(cut, os.path.getsize(cut) // 2)
        self.assertIn("cut.bag has no index", self.refused(cut))

    def test_may_be_larger_than_a_whole_number_of_the_parameter_server(self):
        large = os.path.join(FOLDER.name, "large.bag")
        shutil.copy(BAG, large)
        os.truncate(large, 3 << 30)  # sparse
        self.assertEqual(parameters("bag.launch", "bag:=" + large)["/bag_player/recorded_bytes"].strip(), str(3 << 30))

    def test_is_looked_for_in_the_folder_of_the_shell(self):
        before = os.environ.get("PWD", "/")
        self.addCleanup(os.environ.__setitem__, "PWD", before)
        os.environ["PWD"] = FOLDER.name
        started("bag.launch", "bag:=a.bag")
        os.environ["PWD"] = "/"
        self.assertIn("/a.bag: No such file", self.refused("a.bag"))

    def test_without_the_topic_tells_what_it_has(self):
        self.assertIn("bag.launch: no /wrong in the bag, which has /lens/points (sensor_msgs/PointCloud2) "
                      "(input:=/lens/points)", words("bag.launch", "bag:=" + BAG, "input:=wrong"))
        self.assertNotIn("in the bag", words("bag.launch", "bag:=" + BAG, "input:=/lens/points"))

    def test_has_topics_that_were_recorded_without_a_slash(self):
        bag = bag_of("names.bag", {"image": Image, "camera_info": CameraInfo})
        for topic in ("image", "/image"):
            self.assertEqual(checked("--depth", topic, bag), "")

    def test_of_images_tells_how_they_are_taken(self):
        bag = bag_of("images.bag", {"/lens/image": Image, "/lens/packed/compressedDepth": CompressedImage,
                                    "/lens/photo": CompressedImage})
        self.assertTrue(checked("/camera/depth/points", bag).endswith(
            " (depth:=/lens/image or depth:=/lens/packed/compressedDepth)\n"))
        self.assertTrue(checked("/wrong", bag_of("photo.bag", {"/lens/photo": CompressedImage})).endswith(
            "/lens/photo (sensor_msgs/CompressedImage)\n"))

    def test_without_the_calibration_of_its_images_tells_which_it_has(self):
        bag = bag_of("elsewhere.bag", {"/lens/image": Image, "/elsewhere/info": CameraInfo})
        told = "bag.launch: no calibration on %s in the bag, which has /elsewhere/info (sensor_msgs/CameraInfo)"
        self.assertIn(told % "/lens/camera_info", words("bag.launch", "bag:=" + bag, "depth:=lens/image"))
        self.assertNotIn("in the bag", words("bag.launch", "bag:=" + bag, "depth:=lens/image",
                                             "camera_info:=elsewhere/info"))
        self.assertIn(told % "/lens/image", checked("--depth", "--camera-info=/lens/image", "/lens/image", bag))
        bag = bag_of("none.bag", {"/lens/image": Image})
        self.assertTrue(checked("--depth", "/lens/image", bag).endswith("in the bag, which has none\n"))

    def test_with_something_else_on_the_topic_tells_what_it_is(self):
        bag = bag_of("image.bag", {"/lens/image": Image, "/lens/camera_info": CameraInfo})
        self.assertIn("bag.launch: /lens/image is a sensor_msgs/Image, not a sensor_msgs/PointCloud2 "
                      "(depth:=/lens/image); the bag has /lens/image (sensor_msgs/Image)", checked("/lens/image", bag))
        self.assertIn("/lens/points is a sensor_msgs/PointCloud2, not a sensor_msgs/Image (input:=/lens/points)",
                      checked("--depth", "/lens/points", BAG))
        self.assertIn("/lens/camera_info is a sensor_msgs/CameraInfo, not a sensor_msgs/Image; the bag has",
                      checked("--depth", "/lens/camera_info", bag))
        self.assertEqual(checked("--depth", "/lens/image", bag), "")

    def test_with_packed_images_has_their_calibration_beside_them(self):
        topic = "/lens/image/compressedDepth"
        bag = bag_of("packed.bag", {topic: CompressedImage, "/lens/camera_info": CameraInfo})
        self.assertEqual(checked("--depth", topic, bag), "")
        self.assertIn("not a sensor_msgs/PointCloud2 (depth:=%s)" % topic, checked(topic, bag))
        self.assertIn("not a sensor_msgs/CompressedImage; the bag has",
                      checked("--depth", topic, bag_of("raw.bag", {topic: Image})))


class LaunchCalibrations(unittest.TestCase):

    def test_are_looked_for_beside_the_image(self):
        for image, calibration in (("/lens/depth/image", "/lens/depth/camera_info"), ("lens/image", "lens/camera_info"),
                                   ("/image", "/camera_info"), ("image", "camera_info"),
                                   ("image/compressedDepth", "camera_info"), ("/lens/image/compressedDepth", "/lens/camera_info")):
            told = done("depth_image.launch", "depth:=" + image, node="/detector_points").stdout
            self.assertRegex(told, r"camera_info:=%s\s" % calibration, image)


class LaunchViews(unittest.TestCase):

    def test_the_first_primitives_tell_the_frame_where_nobody_does(self):
        for file in FILES:
            # The empty view is between two spaces.
            self.assertRegex(started(*file), r"rviz_in_frame \S+/config  detector/primitives .*:=", file)

    def test_the_camera_s_is_the_default(self):
        for file in FILES:
            self.assertIn("config/primitect.rviz", started(*file, "frame:=lens"), file)
        self.assertIn("config/primitect.rviz", started("demo.launch"))

    def test_the_robot_s_is_that_of_its_base_and_of_whoever_asks(self):
        for file in FILES:
            for arguments in (["frame:=base_link"], ["frame:=/base_footprint"], ["frame:=odom"], ["frame:=lens", "view:=robot"]):
                self.assertIn("config/robot.rviz", started(*file, *arguments), (file, arguments))
            self.assertIn("config/primitect.rviz", started(*file, "frame:=base_link", "view:=camera"), file)

    def test_another_one_is_refused(self):
        for file in FILES:
            with self.assertRaisesRegex(ValueError, "view must be camera or robot, not 'bogus'"):
                started(*file, "view:=bogus")

    def test_both_show_the_same(self):
        camera, robot = config("primitect.rviz"), config("robot.rviz")
        self.assertNotEqual(camera["Visualization Manager"].pop("Views"), robot["Visualization Manager"].pop("Views"))
        for shown in camera, robot:
            cloud = [d for d in shown["Visualization Manager"]["Displays"] if d["Name"] == "Cloud"][0]
            self.assertEqual(cloud.pop("Channel Name"), "z" if shown is camera else "x")
        self.assertEqual(camera, robot)


if __name__ == "__main__":
    unittest.main()
