#!/usr/bin/env python3
"""Replays a bag through launch/stillmap.launch and checks that every scan in it is answered.

Prints the progress with the time left, then how many scans were answered and how long each took. The exit code is 1
when a scan went unanswered. Source the workspace first (. build/devel/setup.sh). The ROS master is an own one on a free
port, so a running one is left alone; all that is started here also ends here."""
import argparse
import contextlib
import os
import signal
import socket
import subprocess
import sys
import time

import rosbag
import rospy
from geometry_msgs.msg import Point
from stillmap.msg import Status
from stillmap.srv import ExplainPoint, SaveMap
from std_srvs.srv import SetBool

SILENCE_S = 20.0  # wall time without an answer after which the replay counts as over
RVIZ_DRAWS_S = 8.0  # what rviz needs for a whole picture without a graphics card


def main():
    options = parse_options()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("replay_bag.py: terminated"))
    scans = count_scans(options.bag, options.launch_arguments)
    arguments = [f"bag:={os.path.abspath(options.bag)}"] + options.launch_arguments
    if options.save_map:
        folders = [os.path.dirname(os.path.abspath(path)) for path in options.save_map]
        arguments.append(f"map_directory:={os.path.commonpath(folders)}")
    with launched(arguments, options.log) as roslaunch:
        answers = Answers(scans, roslaunch)
        if options.picture:
            answers.wait_for(options.at_scan or scans * 2 // 3)
            take_picture(options.picture, options.explain)
        answers.wait_for(scans)
        for path in options.save_map:
            save_map(path)
    return answers.report()


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bag")
    parser.add_argument("launch_arguments", nargs="*", metavar="NAME:=VALUE", help="for stillmap.launch")
    parser.add_argument("--save-map", action="append", default=[], metavar="FILE", help="at the end; may repeat")
    parser.add_argument("--log", metavar="FILE", help="for what roslaunch and the nodes print [the terminal]")
    parser.add_argument("--picture", metavar="PNG", help="of the whole screen, with the replay paused; needs rviz:=true")
    parser.add_argument("--explain", metavar='"X Y Z"', help="a place of the map that the picture explains")
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


@contextlib.contextmanager
def launched(arguments, log_file):
    """stillmap.launch with a master of its own; both end when this is left."""
    port = free_port()
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    command = ["roslaunch", "stillmap", "stillmap.launch"] + arguments
    with contextlib.ExitStack() as stack:
        log = stack.enter_context(open(log_file, "w", encoding="utf-8")) if log_file else None
        roslaunch = stack.enter_context(subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True))
        stack.callback(roslaunch.send_signal, signal.SIGINT)
        while socket.socket().connect_ex(("localhost", port)) != 0:
            check_launch(roslaunch)
            time.sleep(0.1)
        yield roslaunch


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def check_launch(roslaunch):
    if roslaunch.poll() is not None:
        raise SystemExit(f"replay_bag.py: roslaunch ended early, with exit code {roslaunch.returncode}")


class Answers:
    """The node's status messages, one for each scan that it answers."""

    def __init__(self, scans, roslaunch):
        self.scans, self.roslaunch = scans, roslaunch
        self.process_ms = {}  # by the scan's stamp
        self.first, self.last = None, time.monotonic()  # wall time of answers
        rospy.init_node("replay_bag", anonymous=True, disable_signals=True)
        rospy.Subscriber("/stillmap/status", Status, self.on_status, queue_size=1000)

    def on_status(self, status):
        self.last = time.monotonic()
        self.first = self.first or self.last
        self.process_ms[status.header.stamp] = status.process_ms

    def wait_for(self, scans):
        """Until so many are answered, or none has been for SILENCE_S."""
        step_s = 0.5 if sys.stdout.isatty() else 10.0
        shown = time.monotonic()
        while len(self.process_ms) < scans and time.monotonic() - self.last < SILENCE_S:
            check_launch(self.roslaunch)
            time.sleep(0.1)
            if len(self.process_ms) > 1 and time.monotonic() - shown > step_s:
                shown = time.monotonic()
                self.show_progress()

    def show_progress(self):
        answered = len(self.process_ms)
        left_s = (self.last - self.first) / (answered - 1) * (self.scans - answered)
        line = f"replay: {answered} of {self.scans} scans, {left_s:.0f} s left"
        print(f"\r{line}  " if sys.stdout.isatty() else line, end="" if sys.stdout.isatty() else "\n", flush=True)

    def report(self):
        times_ms = list(self.process_ms.values())
        took = f", {sum(times_ms) / len(times_ms):.0f} ms each (at most {max(times_ms):.0f} ms)" if times_ms else ""
        print(f"\n{len(times_ms)} of {self.scans} scans answered{took}")
        if len(times_ms) == self.scans:
            return 0
        print("The warnings of /stillmap say why; a smaller rate:=0.5 tells whether the machine was too slow.")
        return 1


def take_picture(path, place):
    """Still, so that all that rviz shows is of the same moment."""
    pause = rospy.ServiceProxy("/bag/pause_playback", SetBool)
    pause(True)
    if place:
        print(rospy.ServiceProxy("/stillmap/explain_point", ExplainPoint)(Point(*map(float, place.split()))).message)
    time.sleep(RVIZ_DRAWS_S)
    subprocess.run(["import", "-window", "root", path], check=True)
    print(path)
    pause(False)


def save_map(path):
    answer = rospy.ServiceProxy("/stillmap/save_map", SaveMap)(path=os.path.abspath(path), overwrite=True)
    print(answer.message)
    if not answer.success:
        raise SystemExit(1)


if __name__ == "__main__":
    sys.exit(main())
