#!/usr/bin/env python3
"""Draws which functions the instructions of a scan go to: each bar is as wide as its share, and those that it calls
lie below it. Counted by callgrind, so that two pictures of one machine can be compared to the percent.

usage: flame_graph.py PROGRAM [PROGRAM_AFTER] PICTURE [--scene SCENE SENSOR] [--stage STAGE]

PROGRAM is a build of stage_instructions; with two, the second is drawn below the first, at the same scale.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

DEEPEST = 5
LEAST = 0.004  # of the whole width: narrower bars are left out
STAGE = re.compile(r"^desc: Trigger: Client Request: (\w+)$", re.M)
OF_THE_PACKAGE = re.compile(r"stillmap::(?:\(anonymous namespace\)::)?(?:Mapper::State::)?([A-Za-z_]\w*(?:::[A-Za-z_]\w*)?)")


def label(function):
    """The function's own name; of what a parallel loop was made into, the function that the loop stands in. None for
    what only hands on: the mapper's own functions, TBB."""
    function = re.sub(r"'\d+$", "", function)  # callgrind's mark of a function that calls itself
    if function == "main":
        return None
    inner = function[function.index("<"):] if function.startswith("tbb::") and "<" in function else function
    for name in OF_THE_PACKAGE.findall(inner):
        if not name.startswith(("for_rows", "find_rows")):
            return None if name.startswith("Mapper") else name
    if function.startswith("tbb::"):
        return None
    return re.sub(r"[<(].*", "", function).split("::")[-1] or function


class CallGraph:
    """Costs of one dump: of each function itself, and of what it calls."""

    def __init__(self, text):
        self.own, self.calls, names = {}, {}, {}
        function = called = None

        def named(compressed):
            number, name = re.match(r"\((\d+)\)(?: (.*))?", compressed).groups()
            return names.setdefault(number, name or "?")

        for line in text.splitlines():
            if line.startswith("fn="):
                function = named(line[3:])
            elif line.startswith("cfn="):
                called = named(line[4:])
            elif line and line[0] in "0123456789+-*" and function:
                cost = int(line.split()[1])
                if called:
                    edges = self.calls.setdefault(function, {})
                    edges[called] = edges.get(called, 0) + cost
                    called = None
                else:
                    self.own[function] = self.own.get(function, 0) + cost

    def roots(self):
        called = {to for edges in self.calls.values() for to in edges}
        return {function for function in {*self.own, *self.calls} if function not in called}

    def add_to(self, tree, function, cost, path=()):
        """Adds what the function costs when called along `path`, in proportion where it is called from elsewhere, too."""
        edges = {to: c for to, c in self.calls.get(function, {}).items() if to not in path and to != function}
        whole = max(1, self.own.get(function, 0) + sum(edges.values()))
        node, name = tree, label(function)
        if name is not None:
            node = tree.setdefault(name, {"cost": 0, "below": {}})
            node["cost"] += cost
            node = node["below"]
        if len(path) < 40:
            for to, edge in edges.items():
                self.add_to(node, to, cost * edge / whole, (*path, function))


def stages(program, scene):
    """{stage: {"cost": instructions for each scan, "below": functions}}"""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "dump"
        command = ["valgrind", "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={out}", program, *scene]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"flame_graph: {' '.join(command)} ended with {done.returncode}:\n{done.stderr[-2000:]}")
        scans, found = done.stdout.count("scan "), {}
        for dump in sorted(pathlib.Path(folder).glob("dump.*"), key=lambda path: int(path.suffix[1:])):
            text = dump.read_text()
            if stage := STAGE.search(text):
                graph = CallGraph(text)
                node = found.setdefault(stage.group(1), {"cost": 0, "below": {}})
                node["cost"] += sum(graph.own.values()) / scans
                for root in graph.roots():
                    cost = graph.own.get(root, 0) + sum(graph.calls.get(root, {}).values())
                    graph.add_to(node["below"], root, cost / scans)
    return found


def draw(axes, tree, left, depth, width, colour):
    for name, node in sorted(tree.items(), key=lambda item: -item[1]["cost"]):
        if node["cost"] < LEAST * width:
            continue
        axes.barh(depth, node["cost"] / 1e6, left=left / 1e6, height=0.94, color=colour, edgecolor="white",
                  linewidth=0.6, alpha=1 - 0.13 * depth)
        room = int(node["cost"] / width * 150)
        if room > 2:
            axes.text((left + node["cost"] / 2) / 1e6, depth, name[:room], ha="center", va="center", fontsize=5.5)
        if depth < DEEPEST:
            draw(axes, node["below"], left, depth + 1, width, colour)
        left += node["cost"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="PROGRAM", help="and PICTURE last")
    parser.add_argument("--scene", nargs=2, metavar=("SCENE", "SENSOR"), default=["street", "hdl64"])
    parser.add_argument("--stage", help="only this one")
    options = parser.parse_args()
    *programs, picture = options.programs
    if len(programs) not in (1, 2):
        parser.error("give one or two builds of stage_instructions, and the picture")
    counted = [stages(program, options.scene) for program in programs]
    if options.stage:
        counted = [{name: node for name, node in found.items() if name == options.stage} for found in counted]
    totals = [sum(node["cost"] for node in found.values()) for found in counted]
    if not all(totals):
        sys.exit(f"flame_graph: no stage {options.stage or ''} was measured")
    figure, all_axes = plt.subplots(len(programs), figsize=(11, 2.6 * len(programs)), sharex=True, squeeze=False)
    for axes, found, total, title in zip(all_axes[:, 0], counted, totals, ("before", "after")):
        left = 0
        for number, (name, node) in enumerate(found.items()):
            draw(axes, {name: node}, left, 0, max(totals), plt.get_cmap("Set2")(number))
            left += node["cost"]
        axes.set_title((f"{title}: " if len(programs) == 2 else "") + f"{total / 1e6:.0f} million instructions a scan",
                       fontsize=9, loc="left")
        axes.invert_yaxis()
        axes.axis("off")
    figure.tight_layout()
    figure.savefig(picture, dpi=150)


if __name__ == "__main__":
    main()
