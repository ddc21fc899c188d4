#!/usr/bin/env python3
"""Pictures of a labelled sequence: all its points as they came, and what is left when the moving ones are taken out.

Each picture shows both in perspective (--view perspective) or from above (--view top)."""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402
from labelled_sequence import DYNAMIC, STATIC, read_labelled  # noqa: E402
from point_picture import Camera, draw  # noqa: E402

RED, AMBER = (214, 30, 42), (240, 160, 0)
LOW_GREY, HIGH_GREY = (188, 192, 198), (120, 126, 136)
PANEL_PX = (820, 530)
POINT_SIZE_M = 0.08


def main():
    options = parse_options()
    points, classes, track = load(options)
    views = {"perspective": perspective, "top": from_above}
    camera = views[options.view](track, options)
    static = classes == STATIC
    panels = [
        ("All points of all scans", paint(points, classes, camera)),
        ("Static map", paint(points[static], classes[static], camera)),
    ]
    save(panels, options)
    print(options.picture)


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sequence", help="SemanticKITTI folder, or a bag that `stillmap` wrote")
    parser.add_argument("labels", help="OUT/final or OUT/online of `stillmap label SEQUENCE OUT`")
    parser.add_argument("picture", help="the .png to write")
    parser.add_argument("--title", default="", help="over the picture")
    parser.add_argument("--view", choices=("perspective", "top"), default="perspective")
    parser.add_argument("--span-m", type=float, default=60, help="width of what is seen [%(default)s]")
    parser.add_argument("--ahead-m", type=float, default=0, help="moves the view along the track [%(default)s]")
    parser.add_argument("--turn-deg", type=float, default=25, help="of the camera from the track [%(default)s]")
    parser.add_argument("--pitch-deg", type=float, default=28, help="of the camera downwards [%(default)s]")
    parser.add_argument("--below-m", type=float, default=np.inf, help="leaves out what is higher above the sensor")
    return parser.parse_args()


def load(options):
    scans = list(read_labelled(options.sequence, options.labels))
    points, classes = np.concatenate([s[0] for s in scans]), np.concatenate([s[1] for s in scans])
    track = np.array([s[2] for s in scans])
    kept = points[:, 2] < track[:, 2].mean() + options.below_m
    return points[kept], classes[kept], track


def heading_rad(track):
    way = track[-1] - track[0]
    return float(np.arctan2(way[1], way[0]))


def focus(track, options):
    middle, along = (track.min(axis=0) + track.max(axis=0)) / 2, heading_rad(track)
    return middle + options.ahead_m * np.array([np.cos(along), np.sin(along), 0])


def perspective(track, options):
    yaw, pitch = heading_rad(track) + np.radians(options.turn_deg), np.radians(options.pitch_deg)
    backwards = np.array([-np.cos(yaw) * np.cos(pitch), -np.sin(yaw) * np.cos(pitch), np.sin(pitch)])
    target = focus(track, options)
    return Camera(target + options.span_m * backwards, target)


def from_above(track, options):
    target = focus(track, options)
    return Camera(target + np.array([0, 0, 60.0]), target, width_m=options.span_m)


def paint(points, classes, camera):
    """Static points grey, the lighter the lower; moving ones red, undecided ones amber."""
    low, high = np.percentile(points[:, 2], (5, 95))
    height = np.clip((points[:, 2] - low) / max(high - low, 0.1), 0, 1)[:, None]
    colors = ((1 - height) * np.array(LOW_GREY) + height * np.array(HIGH_GREY)).astype(np.float32)
    colors[classes == DYNAMIC] = RED
    undecided = (classes != DYNAMIC) & (classes != STATIC)
    colors[undecided] = AMBER
    return draw(points, colors, POINT_SIZE_M, camera, *PANEL_PX)


def save(panels, options):
    """The panels side by side, each pixel as it was drawn."""
    margin_px, head_px, foot_px = 20, 90, 50
    width_px = len(panels) * (PANEL_PX[0] + margin_px) + margin_px
    height_px = PANEL_PX[1] + head_px + foot_px
    figure = plt.figure(figsize=(width_px / 100, height_px / 100), dpi=100)
    for index, (name, picture) in enumerate(panels):
        left_px = margin_px + index * (PANEL_PX[0] + margin_px)
        place = np.array([left_px, foot_px, *PANEL_PX]) / [width_px, height_px, width_px, height_px]
        axis = figure.add_axes(place)
        axis.imshow(picture)
        axis.set_title(name, fontsize=17)
        axis.set_axis_off()
    figure.suptitle(options.title, fontsize=21, fontweight="bold", y=1 - 12 / height_px, va="top")
    dots = [plt.Line2D([], [], ls="", marker="o", ms=10, color=np.array(color) / 255, label=name)
            for name, color in (("static", HIGH_GREY), ("dynamic", RED), ("uncertain", AMBER))]
    figure.legend(handles=dots, loc="lower center", ncols=3, frameon=False, fontsize=16)
    figure.canvas.draw()
    picture = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")
    picture.quantize(256, dither=Image.Dither.NONE).save(options.picture, optimize=True)


if __name__ == "__main__":
    main()
