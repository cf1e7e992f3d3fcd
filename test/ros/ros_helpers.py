# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""What several ROS tests need: made-up clouds, collected messages, patient waiting."""
import math
import struct
import threading
import time

import rospy
from geometry_msgs.msg import TransformStamped
from primitect.msg import PrimitiveArray
from sensor_msgs.msg import PointCloud2, PointField

PATIENCE = 60.0  # s; a loaded machine is slow, a broken node never answers


def wait_for(condition, seconds=PATIENCE):
    """True as soon as the condition holds; False when it did not within the time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and not rospy.is_shutdown():
        if condition():
            return True
        time.sleep(0.05)
    return bool(condition())


class Collector:
    """All messages of a topic, in order."""

    def __init__(self, topic, message_type):
        self._messages = []
        self._lock = threading.Lock()
        self._subscriber = rospy.Subscriber(topic, message_type, self._add, queue_size=100)

    def _add(self, message):
        with self._lock:
            self._messages.append(message)

    def all(self):
        with self._lock:
            return list(self._messages)

    def last(self):
        messages = self.all()
        return messages[-1] if messages else None

    def connected(self):
        return self._subscriber.get_num_connections() > 0

    def stop(self):
        self._subscriber.unregister()


def float_fields(names=("x", "y", "z")):
    return [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate(names)]


def cloud_message(points, width, height, frame="camera", stamp=None, names=("x", "y", "z")):
    """These values of each point as float32 without padding."""
    message = PointCloud2()
    message.header.frame_id = frame
    message.header.stamp = stamp if stamp is not None else rospy.Time.now()
    message.width, message.height = width, height
    message.fields = float_fields(names)
    message.point_step = 4 * len(names)
    message.row_step = message.point_step * width
    message.data = b"".join(struct.pack("<%df" % len(names), *point) for point in points)
    return message


def wall_and_ball(radius=0.1, center=(0.0, 0.0, 0.8), wall=1.2, width=160, height=120):
    """What an ideal camera sees of a ball before a wall (m)."""
    points = []
    focal = 140.0
    for row in range(height):
        for column in range(width):
            ray = ((column - (width - 1) / 2) / focal, (row - (height - 1) / 2) / focal, 1.0)
            along = sum(a * b for a, b in zip(ray, center))
            square = sum(a * a for a in ray)
            root = along * along - square * (sum(c * c for c in center) - radius * radius)
            depth = (along - math.sqrt(root)) / square if root > 0 else wall
            points.append(tuple(depth * a for a in ray))
    return points, width, height


def camera_looking_ahead(height):
    """At this height (m) above the base; its x, y, z axes (right, down, ahead) are the base's -y, -z, x axes."""
    transform = TransformStamped()
    transform.header.frame_id, transform.child_frame_id = "base", "camera"
    transform.transform.translation.z = height
    rotation = transform.transform.rotation
    rotation.x, rotation.y, rotation.z, rotation.w = -0.5, 0.5, -0.5, 0.5
    return transform


class Detector:
    """Sends clouds to a detector and waits for its answers."""

    def __init__(self, input_topic="/cloud", name="/detector"):
        self._publisher = rospy.Publisher(input_topic, PointCloud2, queue_size=1)
        self._answers = Collector(name + "/primitives", PrimitiveArray)

    def ready(self):
        return wait_for(lambda: self._publisher.get_num_connections() > 0 and self._answers.connected())

    def ask(self, message):
        """The answer with the stamp of this message; None when none came. Sent once."""
        self._publisher.publish(message)
        return self.answer(message.header.stamp)

    def answer(self, stamp):
        def found():
            return [a for a in self._answers.all() if a.header.stamp == stamp]
        return found()[-1] if wait_for(found) else None
