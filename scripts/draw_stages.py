#!/usr/bin/env python3
"""Draws the stages of the method from the tables of `stillmap stages`, as doc/method.md shows them.

Usage: stillmap simulate plaza plaza --sensor os1_64 --scans 41 && stillmap stages plaza stages --scan 40 &&
       scripts/draw_stages.py stages doc/images"""
import argparse
import os

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

EVIDENCE = [("unknown", "#c8c8c8"), ("occlusion", "#7aa6d8"), ("support", "#3d8f4d"), ("conflict", "#d62728")]
LABEL = [("uncertain", "#f0a800"), ("static", "#8a8f98"), ("dynamic", "#d62728")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stages", help="folder of `stillmap stages`")
    parser.add_argument("out", help="folder for the pictures")
    parser.add_argument("--span-m", type=float, default=36.0, help="of the plans [36]")
    options = parser.parse_args()
    voxels = np.genfromtxt(os.path.join(options.stages, "voxels.csv"), delimiter=",", names=True)
    points = np.genfromtxt(os.path.join(options.stages, "points.csv"), delimiter=",", names=True)
    os.makedirs(options.out, exist_ok=True)
    centre = np.array([np.median(points["x"]), np.median(points["y"])])
    draw_range_image(points, os.path.join(options.out, "stage_range_image.png"))
    plan = Plan(centre, options.span_m, options.out)
    plan.classes(voxels, voxels["evidence"], EVIDENCE, "stage_evidence.png", "What this scan says of each known voxel")
    plan.values(voxels, voxels["log_odds"], "stage_log_odds.png", "L, the log-odds of being static")
    plan.classes(points, points["label"], LABEL, "stage_decision.png", "The decision on each point")


def draw_range_image(points, path):
    figure, axes = plt.subplots(figsize=(9, 2.2), dpi=110, layout="constrained")
    order = np.argsort(-points["range_m"])
    dots = axes.scatter(points["azimuth_deg"][order], points["elevation_deg"][order], c=points["range_m"][order], s=0.6,
                        cmap="viridis_r", vmax=np.percentile(points["range_m"], 97), linewidths=0)
    figure.colorbar(dots, label="range, m", pad=0.01)
    axes.set(xlabel="azimuth, degrees", ylabel="elevation, degrees", xlim=(180, -180))
    save(figure, path)


class Plan:
    """Pictures from above, around the sensor."""

    def __init__(self, centre, span_m, folder):
        self.centre, self.span_m, self.folder = centre, span_m, folder

    def classes(self, table, value, classes, name, title):
        figure, axes = self.axes(title)
        for index, (label, color) in enumerate(classes):
            rows = value == index
            axes.scatter(table["x"][rows], table["y"][rows], c=color, s=1.2, linewidths=0, label=label)
        axes.legend(loc="upper right", markerscale=8, framealpha=0.95, fontsize=8)
        save(figure, os.path.join(self.folder, name))

    def values(self, table, value, name, title):
        figure, axes = self.axes(title)
        order = np.argsort(-value)
        dots = axes.scatter(table["x"][order], table["y"][order], c=value[order], s=1.2, cmap="RdYlGn", vmin=-4, vmax=4,
                            linewidths=0)
        figure.colorbar(dots, label="L", shrink=0.8, pad=0.02)
        save(figure, os.path.join(self.folder, name))

    def axes(self, title):
        figure, axes = plt.subplots(figsize=(5.4, 5.0), dpi=110, layout="constrained")
        axes.set(title=title, aspect="equal", xlabel="x, m", ylabel="y, m",
                 xlim=(self.centre[0] - self.span_m / 2, self.centre[0] + self.span_m / 2),
                 ylim=(self.centre[1] - self.span_m / 2, self.centre[1] + self.span_m / 2))
        return figure, axes


def save(figure, path):
    figure.savefig(path)
    plt.close(figure)
    print(path)


if __name__ == "__main__":
    main()
