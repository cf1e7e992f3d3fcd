# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""A master of its own with nodes and nodelets, which are all gone when it ends; and what /proc says of them."""
import os
import re
import signal
import socket
import subprocess
import tempfile
import time
import xmlrpc.client

# What roscpp says where a subscriber's queue was full: of several discarded in a row, once.
DISCARD = re.compile(r"\[(\d+\.\d+)\] Incoming queue (?:was )?full for topic \"([^\"]+)\"")
# It is said at a level that is not usual; not what is said of every message.
LEVELS = "log4j.logger.ros=INFO\nlog4j.logger.ros.roscpp=DEBUG\nlog4j.logger.ros.roscpp.superdebug=WARN\n"
FORMAT = "[${severity}] [${time}] ${message}"
PATIENCE = 60.0  # s; a busy machine is slow
CALLER = "/eval"


class Failed(Exception):
    """Something did not start or ended on its own."""


def environment_of(setup):
    """The environment that a setup.bash makes, with Debian's own python in front."""
    if not os.path.isfile(setup):
        raise Failed("%s is missing: these programs were not built with ROS" % setup)
    own = dict(os.environ, PATH="/usr/bin:/bin:" + os.environ.get("PATH", ""))
    text = subprocess.run(["bash", "-c", 'source "$1" >/dev/null && env -0', "bash", setup], env=own, check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    return dict(entry.split("=", 1) for entry in text.split("\0") if "=" in entry)


def free_port():
    with socket.socket() as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


class Session:
    """with Session(setup) as session: ... All that was started is ended on the way out, last first."""

    def __init__(self, setup):
        self.folder = tempfile.TemporaryDirectory()
        self.port = free_port()
        self.uri = "http://localhost:%d" % self.port
        self.environment = dict(environment_of(setup), ROS_MASTER_URI=self.uri, ROS_HOSTNAME="localhost",
                                ROS_HOME=self.folder.name, ROS_LOG_DIR=self.folder.name,
                                ROSCONSOLE_STDOUT_LINE_BUFFERED="1")
        levels = os.path.join(self.folder.name, "rosconsole.config")
        with open(levels, "w", encoding="utf-8") as file:
            file.write(LEVELS)
        # Of nodes, which tell what their queues discard.
        self.telling = dict(self.environment, ROSCONSOLE_CONFIG_FILE=levels, ROSCONSOLE_FORMAT=FORMAT)
        self.started = []

    def __enter__(self):
        try:
            self.start(["roscore", "-p", str(self.port)])
            self.wait_for(lambda: self.master().getPid(CALLER), "the master")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in self.started[::-1]:
            end(process)
        self.folder.cleanup()

    def master(self):
        return xmlrpc.client.ServerProxy(self.uri)

    def start(self, command, **options):
        """Starts a program in a group of its own, so that it ends with all that it started."""
        log = open(os.path.join(self.folder.name, "output.log"), "ab")
        with log:
            process = subprocess.Popen(command, start_new_session=True,
                                       **dict({"stdout": log, "stderr": log, "env": self.environment}, **options))
        self.started.append(process)
        return process

    def node(self, name, *command):
        """Starts a node under an absolute name and waits for it; returns its process number."""
        namespace, _, base = name.rpartition("/")
        self.start([*command, "__name:=" + base] + (["__ns:=" + namespace] if namespace else []),
                   env=self.telling)
        return self.wait_for(lambda: self.pid_of(name), name)

    def discards(self, topic):
        """When queues of this topic were full, s since 1970. Raises Failed where nodes do not tell."""
        said = self.said()
        if "[DEBUG] [" not in said:
            raise Failed("roscpp does not tell what its queues discard")
        return discards_in(said, topic)

    def manager(self, name, threads):
        """An empty nodelet manager; returns its process number."""
        return self.node(name, "rosrun", "nodelet", "nodelet", "manager", "_num_worker_threads:=%d" % threads)

    def pid_of(self, name):
        code, _, uri = self.master().lookupNode(CALLER, name)
        return xmlrpc.client.ServerProxy(uri).getPid(CALLER)[2] if code == 1 else None

    def wait_for(self, condition, what):
        """The first value that is something; raises Failed, with what was said so far, when none comes."""
        end_time = time.monotonic() + PATIENCE
        while time.monotonic() < end_time:
            try:
                value = condition()
                if value:
                    return value
            except (OSError, xmlrpc.client.Error):
                pass
            time.sleep(0.1)
        raise Failed("%s did not start. %s" % (what, self.last_words()))

    def said(self):
        with open(os.path.join(self.folder.name, "output.log"), encoding="utf-8", errors="replace") as file:
            return file.read()

    def last_words(self):
        return self.said()[-1500:]


def discards_in(said, topic):
    return [float(moment) for moment, of in DISCARD.findall(said) if of == topic]


def end(process):
    """Interrupts a process and its group as Ctrl-C does, then more firmly."""
    for number, seconds in ((signal.SIGINT, 10), (signal.SIGTERM, 5), (signal.SIGKILL, 5)):
        try:
            os.killpg(process.pid, number)
        except ProcessLookupError:
            break
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            continue
    process.wait()


def cpu_ticks(pid):
    """User and system time of a process so far, in clock ticks."""
    with open("/proc/%d/stat" % pid, encoding="utf-8") as file:
        fields = file.read().rpartition(")")[2].split()
    return int(fields[11]) + int(fields[12])


def peak_megabytes(pid):
    """The largest resident memory of a process so far."""
    with open("/proc/%d/status" % pid, encoding="utf-8") as file:
        return next(int(line.split()[1]) for line in file if line.startswith("VmHWM:")) / 1024
