#!/usr/bin/env python3
"""Draws what each stage of a scan costs before and after a change.

usage: plot_instructions.py BEFORE AFTER PICTURE.png

BEFORE and AFTER are tables of `test/speed/instruction_bounds.py PROGRAM --cache`; their second column, in millions of
instructions for each scan, is drawn. A stage that BEFORE does not have took nothing.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def instructions(path):
    """{stage: millions of instructions}"""
    rows = [line.split() for line in pathlib.Path(path).read_text().splitlines() if line.strip()]
    if not rows or rows[0][:2] != ["stage", "Minstr"]:
        sys.exit(f"{path}: its first line is not the heading of instruction_bounds.py --cache")
    return {row[0]: float(row[1]) for row in rows[1:]}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    before, after = instructions(sys.argv[1]), instructions(sys.argv[2])
    figure, axes = plt.subplots(figsize=(7, 3.2))
    for place, (name, counts, colour) in enumerate([("before", before, "0.65"), ("after", after, "tab:blue")]):
        at = [stage + 0.4 * place for stage in range(len(after))]
        widths = [counts.get(stage, 0) for stage in after]
        axes.barh(at, widths, height=0.38, color=colour, label=f"{name}: {sum(counts.values()):.0f}")
        for height, millions in zip(at, widths):
            axes.text(millions, height, f" {millions:.0f}", va="center", fontsize=8)
    axes.set_yticks([stage + 0.2 for stage in range(len(after))])
    axes.set_yticklabels(list(after))
    axes.invert_yaxis()
    axes.set_xlabel("million instructions for each scan")
    axes.legend(frameon=False)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(sys.argv[3], dpi=110)


if __name__ == "__main__":
    main()
