#!/usr/bin/env python3
"""A node of demo.launch: simulates a scene into a bag, then replays it with its clock as rosbag play does."""
import argparse
import os
import subprocess
import sys
import tempfile

import roslib.packages
import rospy


def main():
    options = parse_options()
    with tempfile.TemporaryDirectory(prefix="stillmap_demo_") as folder:
        bag = os.path.join(folder, options.scene + ".bag")
        simulate = [stillmap_command(), "simulate", options.scene, bag, "--scans", str(options.scans)]
        subprocess.run(simulate + (["--sensor", options.sensor] if options.sensor else []), check=True)
        play = ["rosbag", "play", "--clock", "--quiet", f"--rate={options.rate}", f"--delay={options.delay}", bag]
        subprocess.run(play, check=True)
    print("The recording has ended; the map stays until Ctrl-C.")


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene")
    parser.add_argument("--sensor", default="", help="the scene's own when empty")
    parser.add_argument("--scans", type=int, default=100)
    parser.add_argument("--rate", type=float, default=1.0)
    parser.add_argument("--delay", type=float, default=2.0, help="seconds given to the subscribers")
    return parser.parse_args(rospy.myargv()[1:])


def stillmap_command():
    found = roslib.packages.find_node("stillmap", "stillmap")
    if not found:
        raise SystemExit("play_simulation.py: the program stillmap is not built, or no workspace is sourced")
    return found[0]


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit(0)
    except subprocess.CalledProcessError as error:
        sys.exit(f"play_simulation.py: {error}")
