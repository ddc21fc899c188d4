#!/usr/bin/env python3
"""A moving picture (GIF) of a labelled sequence: the static map grows in grey, what moves in each scan is red.

doc/images/street.gif is
  stillmap simulate street STREET --sensor os1_64 --scans 80; stillmap label STREET OUT --no-final
  scripts/moving_picture.py STREET OUT/online doc/images/street.gif --span-m 38"""
import argparse

import numpy as np
from PIL import Image
from labelled_sequence import DYNAMIC, STATIC, read_labelled
from point_picture import BACKGROUND, Camera, draw

RED, AMBER, GREY = (214, 30, 42), (240, 160, 0), (150, 156, 166)
SIZE_PX = (600, 360)
VOXEL_M = 0.1  # of the map that is drawn
LARGEST_BYTES = 2_000_000


def main():
    options = parse_options()
    scans = list(read_labelled(options.sequence, options.labels))[options.first:options.last]
    camera = overlooking(np.array([scan[2] for scan in scans]), options)
    standing, frames = {}, []
    for index, (points, classes, _) in enumerate(scans):
        static = classes == STATIC
        standing.update(zip(map(bytes, np.floor(points[static] / VOXEL_M).astype(np.int32)), points[static]))
        if index % options.stride == 0:
            frames.append(frame(np.array(list(standing.values())), points[~static], classes[~static], camera))
    save(frames, options)


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("sequence", help="SemanticKITTI folder, or a bag that `stillmap` wrote")
    parser.add_argument("labels", help="OUT/online of `stillmap label SEQUENCE OUT`")
    parser.add_argument("picture", help="the .gif to write")
    parser.add_argument("--first", type=int, default=0, help="scan [%(default)s]")
    parser.add_argument("--last", type=int, help="scan, not shown itself")
    parser.add_argument("--stride", type=int, default=3, help="scans from picture to picture [%(default)s]")
    parser.add_argument("--scan-ms", type=int, default=100, help="time between scans [%(default)s]")
    parser.add_argument("--span-m", type=float, default=45, help="distance of the camera [%(default)s]")
    parser.add_argument("--pitch-deg", type=float, default=32, help="of the camera downwards [%(default)s]")
    return parser.parse_args()


def overlooking(track, options):
    """A camera that stands still and looks along the way."""
    way, middle = track[-1] - track[0], (track[0] + track[-1]) / 2
    yaw, pitch = np.arctan2(way[1], way[0]), np.radians(options.pitch_deg)
    ahead = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), -np.sin(pitch)])
    return Camera(middle - options.span_m * ahead, middle)


def frame(standing, others, classes, camera):
    colors = np.where((classes == DYNAMIC)[:, None], RED, AMBER)
    points = np.concatenate([standing.reshape(-1, 3), others]).astype(np.float32)
    colors = np.concatenate([np.full((len(standing), 3), GREY), colors]).astype(np.float32)
    return Image.fromarray(draw(points, colors, 0.14, camera, *SIZE_PX))


def shades(*colors):
    """A palette: each colour from dark to full, and the background."""
    steps = [np.outer(np.linspace(0.3, 1, count), color) for color, count in colors]
    entries = np.concatenate(steps + [BACKGROUND[None]]).round().astype(np.uint8)
    palette = Image.new("P", (1, 1))
    palette.putpalette(entries.tobytes())
    return palette


def save(frames, options):
    palette = shades((GREY, 10), (RED, 5), (AMBER, 3))
    frames = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in frames]
    frames[0].save(options.picture, save_all=True, append_images=frames[1:], loop=0, optimize=True,
                   duration=options.stride * options.scan_ms)
    with open(options.picture, "rb") as written:
        size = len(written.read())
    print(f"{options.picture}: {len(frames)} pictures, {size / 1e6:.2f} MB")
    if size > LARGEST_BYTES:
        raise SystemExit("that is too large for a page: a larger --stride, or fewer scans")


if __name__ == "__main__":
    main()
