#!/usr/bin/env python3
"""Counts the instructions of each stage of a scan with callgrind, which do not drift as times do, and fails when a
stage takes more than its bound in instruction_bounds.txt.

usage: instruction_bounds.py PROGRAM [--scene SCENE SENSOR] [--write | --cache]

  --write   sets the bounds anew: what is measured now and 15 % more. Say in the commit why a stage may cost more.
  --cache   no bounds: prints a table, also with the bytes that come from beyond the first and the last cache.
"""
import argparse
import math
import pathlib
import re
import subprocess
import sys
import tempfile

BOUNDS = pathlib.Path(__file__).with_name("instruction_bounds.txt")
HEAD_ROOM = 1.15
LINE_BYTES = 64
SKIPPED = 77  # ctest's SKIP_RETURN_CODE
HEADING = """\
# Most instructions that a stage may take, in millions for each scan: plaza, VLP-16, one thread, Release, AVX2.
# Checked by instruction_bounds_test. To move a bound on purpose:
#   test/speed/instruction_bounds.py build/devel/lib/stillmap/stage_instructions --write
# and say in the commit what the instructions buy.
"""


def why_not_here():
    """Bounds hold for optimised code with AVX2 only; None when they can be checked."""
    flags = pathlib.Path("/proc/cpuinfo")
    if not flags.exists() or " avx2 " not in flags.read_text():
        return "this machine has no AVX2"
    return None


def counts(program, scene, cache):
    """{stage: {event: count for each scan}} in the order of the stages."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "dump"
        command = ["valgrind", "--tool=callgrind", "--instr-atstart=no", f"--cache-sim={'yes' if cache else 'no'}",
                   f"--callgrind-out-file={out}", str(program), *scene]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"instruction_bounds: {' '.join(command)} ended with {done.returncode}:\n{done.stderr[-2000:]}")
        scans = done.stdout.count("scan ")
        found = {}
        for dump in sorted(pathlib.Path(folder).glob("dump.*"), key=lambda path: int(path.suffix[1:])):
            text = dump.read_text()
            stage = re.search(r"^desc: Trigger: Client Request: (\w+)$", text, re.M)
            totals = re.search(r"^(?:totals|summary): ([\d ]+)$", text, re.M)
            if not stage or not totals:
                continue
            events = re.search(r"^events: (.+)$", text, re.M).group(1).split()
            numbers = [int(number) for number in totals.group(1).split()]
            sums = found.setdefault(stage.group(1), dict.fromkeys(events, 0))
            for event, number in zip(events, numbers):
                sums[event] += number / scans
    if not found:
        sys.exit("instruction_bounds: callgrind left no dump of a stage; does the program call stage_ended?")
    return found


def bounds():
    lines = [line.split() for line in BOUNDS.read_text().splitlines() if line and not line.startswith("#")]
    return {stage: float(millions) for stage, millions in lines}


def write(measured):
    lines = [f"{stage:12} {math.ceil(HEAD_ROOM * count['Ir'] / 1e4) / 100:6.2f}" for stage, count in measured.items()]
    BOUNDS.write_text(HEADING + "\n".join(lines) + "\n")
    print(BOUNDS.read_text(), end="")


def check(measured):
    allowed, passed = bounds(), True
    if set(allowed) != set(measured):
        sys.exit(f"{BOUNDS}: has {sorted(allowed)}, measured were {sorted(measured)}; write it anew with --write")
    for stage, count in measured.items():
        millions = count["Ir"] / 1e6
        passed &= millions <= allowed[stage]
        verdict = "" if millions <= allowed[stage] else "   TOO MANY: see the head of instruction_bounds.txt"
        print(f"{stage:12} {millions:8.2f} million instructions, bound {allowed[stage]:8.2f}{verdict}")
    return passed


def print_caches(measured):
    print(f"{'stage':12} {'Minstr':>8} {'Mreads':>8} {'Mwrites':>8} {'MB past L1':>11} {'MB past LL':>11}")
    for stage, count in measured.items():
        past_l1 = (count["D1mr"] + count["D1mw"]) * LINE_BYTES / 1e6
        past_ll = (count["DLmr"] + count["DLmw"]) * LINE_BYTES / 1e6
        print(f"{stage:12} {count['Ir'] / 1e6:8.2f} {count['Dr'] / 1e6:8.2f} {count['Dw'] / 1e6:8.2f} "
              f"{past_l1:11.2f} {past_ll:11.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--scene", nargs=2, metavar=("SCENE", "SENSOR"), default=[])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--cache", action="store_true")
    options = parser.parse_args()
    if reason := why_not_here():
        print(f"instruction_bounds: skipped, {reason}")
        sys.exit(SKIPPED)
    measured = counts(options.program, options.scene, options.cache)
    if options.cache:
        print_caches(measured)
    elif options.write:
        write(measured)
    elif not check(measured):
        sys.exit(1)


if __name__ == "__main__":
    main()
