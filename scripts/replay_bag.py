#!/usr/bin/env python3
"""Replays a bag through launch/stillmap.launch and checks that every scan in it is answered.

Prints the progress with the time left, then how many scans were answered and how long each took. The exit code is 1 when
a scan went unanswered. Source the workspace first (. build/devel/setup.sh). The ROS master is an own one on a free port,
so a running one is left alone; all that is started here also ends here."""
import argparse
import os
import signal
import socket
import subprocess
import sys
import time

import rosbag
import rospy
from stillmap.msg import Status
from stillmap.srv import SaveMap
from std_srvs.srv import SetBool

SILENCE_S = 20.0  # wall time without an answer after which the replay counts as over
RVIZ_DRAWS_S = 8.0  # what rviz needs for a whole picture without a graphics card


def main():
    options = parse_options()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("replay_bag.py: terminated"))
    scans = count_scans(options.bag, options.launch_arguments)
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    command = ["roslaunch", "stillmap", "stillmap.launch", f"bag:={os.path.abspath(options.bag)}"]
    output = open(options.log, "w", encoding="utf-8") if options.log else None
    with subprocess.Popen(
        command + options.launch_arguments, stdout=output, stderr=output, start_new_session=True
    ) as roslaunch:
        try:
            answers = Answers(scans, roslaunch, port)
            if options.picture:
                answers.wait_for(options.at_scan or scans * 2 // 3)
                take_picture(options.picture)
            answers.wait_for(scans)
            for path in options.save_map:
                save_map(path)
        finally:
            roslaunch.send_signal(signal.SIGINT)  # it ends its nodes and its master
    return answers.report()


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag")
    parser.add_argument("launch_arguments", nargs="*", metavar="NAME:=VALUE", help="for stillmap.launch")
    parser.add_argument("--save-map", action="append", default=[], metavar="FILE", help="saved at the end; may repeat")
    parser.add_argument("--log", metavar="FILE", help="for what roslaunch and the nodes print [the terminal]")
    parser.add_argument("--picture", metavar="PNG", help="of the whole screen, with the replay paused; needs rviz:=true")
    parser.add_argument("--at-scan", type=int, metavar="N", help="when to take it [after two thirds]")
    return parser.parse_intermixed_args()


def count_scans(file, launch_arguments):
    arguments = dict(argument.split(":=", 1) for argument in launch_arguments)
    topic = arguments.get("cloud_topic", "/cloud_registered")
    with rosbag.Bag(file) as bag:
        scans = bag.get_message_count(topic_filters=[topic])
        if scans == 0:
            topics = ", ".join(sorted(bag.get_type_and_topic_info().topics))
            raise SystemExit(f"{file}: nothing on {topic}; give cloud_topic:=NAME. It has {topics}")
    return scans


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


class Answers:
    """The node's status messages, one for each scan that it answers."""

    def __init__(self, scans, roslaunch, port):
        self.scans, self.roslaunch = scans, roslaunch
        self.process_ms = {}  # by the scan's stamp
        self.first = self.last = None  # wall time of answers
        self.wait_for_master(port)
        rospy.init_node("replay_bag", anonymous=True, disable_signals=True)
        rospy.Subscriber("/stillmap/status", Status, self.on_status, queue_size=1000)

    def wait_for_master(self, port):
        while socket.socket().connect_ex(("localhost", port)) != 0:
            self.check_launch()
            time.sleep(0.1)
        self.last = time.monotonic()

    def on_status(self, status):
        self.last = time.monotonic()
        self.first = self.first or self.last
        self.process_ms[status.header.stamp] = status.process_ms

    def wait_for(self, scans):
        """Until so many are answered, or none has been for SILENCE_S."""
        step_s = 0.5 if sys.stdout.isatty() else 10.0
        shown = time.monotonic()
        while len(self.process_ms) < scans and time.monotonic() - self.last < SILENCE_S:
            self.check_launch()
            time.sleep(0.1)
            if len(self.process_ms) > 1 and time.monotonic() - shown > step_s:
                shown = time.monotonic()
                self.show_progress()

    def check_launch(self):
        if self.roslaunch.poll() is not None:
            raise SystemExit(f"replay_bag.py: roslaunch ended early, with exit code {self.roslaunch.returncode}")

    def show_progress(self):
        answered = len(self.process_ms)
        left_s = (self.last - self.first) / (answered - 1) * (self.scans - answered)
        line = f"replay: {answered} of {self.scans} scans, {left_s:.0f} s left"
        print(f"\r{line}  " if sys.stdout.isatty() else line, end="" if sys.stdout.isatty() else "\n", flush=True)

    def report(self):
        times_ms = list(self.process_ms.values()) or [float("nan")]
        print(f"\n{len(self.process_ms)} of {self.scans} scans answered, "
              f"{sum(times_ms) / len(times_ms):.0f} ms each (at most {max(times_ms):.0f} ms)")
        return 0 if len(self.process_ms) == self.scans else 1


def take_picture(path):
    """Still, so that all that rviz shows is of the same moment."""
    pause = rospy.ServiceProxy("/bag/pause_playback", SetBool)
    pause(True)
    time.sleep(RVIZ_DRAWS_S)
    subprocess.run(["import", "-window", "root", path], check=True)
    print(path)
    pause(False)


def save_map(path):
    answer = rospy.ServiceProxy("/stillmap/save_map", SaveMap)(os.path.abspath(path))
    print(answer.message)
    if not answer.success:
        raise SystemExit(1)


if __name__ == "__main__":
    sys.exit(main())
