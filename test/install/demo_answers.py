#!/usr/bin/env python3
"""roslaunch stillmap demo.launch, wherever the package comes from: its node labels a simulated street and finds movers."""
import os
import signal
import socket
import subprocess
import sys
import time

import rospy
from stillmap.msg import Status

SCANS = 40
START_S, SILENCE_S = 90.0, 10.0  # patience for the first answer, and between answers


def main():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    os.environ["ROS_MASTER_URI"] = f"http://localhost:{port}"
    command = ["roslaunch", "-p", str(port), "stillmap", "demo.launch", f"scans:={SCANS}", "rviz:=false"]
    roslaunch = subprocess.Popen(command, start_new_session=True)
    try:
        while roslaunch.poll() is None and socket.socket().connect_ex(("localhost", port)) != 0:
            time.sleep(0.1)
        answers = collect(roslaunch)
    finally:
        roslaunch.send_signal(signal.SIGINT)
        roslaunch.wait(60)
    static, dynamic = (sum(getattr(a, f"{kind}_points") for a in answers) for kind in ("static", "dynamic"))
    print(f"{len(answers)} of {SCANS} scans answered: {static} points static, {dynamic} dynamic")
    # A loaded machine may lose the first ones, while the nodes find each other.
    return 0 if len(answers) >= SCANS * 3 // 4 and static > 100_000 and dynamic > 1000 else 1


def collect(roslaunch):
    answers = []
    rospy.init_node("demo_answers", disable_signals=True)
    rospy.Subscriber("/stillmap/status", Status, answers.append, queue_size=1000)
    seen, end = 0, time.monotonic() + START_S
    while len(answers) < SCANS and roslaunch.poll() is None and time.monotonic() < end:
        time.sleep(0.1)
        if len(answers) > seen:
            seen, end = len(answers), time.monotonic() + SILENCE_S
    return answers


if __name__ == "__main__":
    sys.exit(main())
