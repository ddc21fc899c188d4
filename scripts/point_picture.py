"""Draws a point cloud as a surface would look: points with a size in metres, nearest on top, edges shaded by depth."""
import numpy as np

BACKGROUND = np.array([250, 250, 252], np.float32)
OVERSAMPLING = 2  # pixels are averaged at the end


class Camera:
    """Looks from `eye` to `target`; orthographic when `width_m` is given."""

    def __init__(self, eye, target, field_of_view_deg=50.0, width_m=None):
        self.eye = np.asarray(eye, np.float32)
        forward = np.asarray(target, np.float32) - self.eye
        self.forward = forward / np.linalg.norm(forward)
        up = np.array([0, 0, 1], np.float32) if abs(self.forward[2]) < 0.99 else np.array([0, 1, 0], np.float32)
        right = np.cross(self.forward, up)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.right, self.forward)
        self.field_of_view_deg, self.width_m = field_of_view_deg, width_m

    def project(self, points, width_px):
        """Returns x, y, depth and the pixels that one metre spans there; y downwards, (0, 0) is the middle."""
        relative = points - self.eye
        depth_m = relative @ self.forward
        if self.width_m is None:
            focal_px = width_px / 2 / np.tan(np.radians(self.field_of_view_deg) / 2)
            px_per_m = focal_px / np.maximum(depth_m, 0.1)
        else:
            px_per_m = np.full(len(points), width_px / self.width_m, np.float32)
        return relative @ self.right * px_per_m, -(relative @ self.up) * px_per_m, depth_m, px_per_m


def draw(points, colors, size_m, camera, width_px, height_px):
    """Returns a picture, uint8 (height, width, 3). The points are discs of diameter size_m."""
    width, height = width_px * OVERSAMPLING, height_px * OVERSAMPLING
    x, y, depth_m, px_per_m = camera.project(points, width)
    x, y = x + width / 2, y + height / 2
    seen = (depth_m > 0.5) & (x >= 0) & (x < width) & (y >= 0) & (y < height)
    order = np.flatnonzero(seen)[np.argsort(-depth_m[seen], kind="stable")]  # the nearest is painted last
    columns, rows, depth_m = x[order].astype(np.int32), y[order].astype(np.int32), depth_m[order]
    radius_px = np.clip(size_m * px_per_m[order] / 2, 0.5, 6.0)

    owner = _nearest_point(columns, rows, radius_px, depth_m, width, height)
    empty = owner < 0
    depth = np.where(empty, np.inf, depth_m[owner])
    picture = np.where(empty[..., None], BACKGROUND, colors[order][owner] * _edge_shade(depth)[..., None])
    blocks = picture.reshape(height_px, OVERSAMPLING, width_px, OVERSAMPLING, 3)
    return blocks.mean(axis=(1, 3)).clip(0, 255).astype(np.uint8)


def _nearest_point(columns, rows, radius_px, depth_m, width, height):
    """Index of the point seen in each pixel, or -1; the points come from far to near."""
    owner = np.full((height, width), -1, np.int64)
    depth = np.full((height, width), np.inf, np.float32)
    reach = int(np.ceil(radius_px.max())) if len(radius_px) else 0
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            c, r = columns + dx, rows + dy
            inside = (c >= 0) & (c < width) & (r >= 0) & (r < height)
            covers = np.flatnonzero(inside & (dx * dx + dy * dy <= radius_px**2))
            layer = np.full((height, width), -1, np.int64)
            layer[r[covers], c[covers]] = covers  # of equal pixels the last one, the nearest, stays
            layer_depth = np.where(layer < 0, np.inf, depth_m[layer])
            nearer = layer_depth < depth
            owner[nearer], depth[nearer] = layer[nearer], layer_depth[nearer]
    return owner


def _edge_shade(depth):
    """Eye-dome lighting (Boucheny 2009): a pixel darkens by how much nearer its neighbours are."""
    log_depth = np.log2(depth)
    step_px, strength = OVERSAMPLING, 6.0
    darkness = np.zeros(depth.shape, np.float32)
    with np.errstate(invalid="ignore"):  # infinity less infinity, where nothing is drawn
        for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            neighbour = np.roll(log_depth, (dy * step_px, dx * step_px), (0, 1))
            darkness += np.nan_to_num(np.clip(log_depth - neighbour, 0, 0.08), nan=0, posinf=0)
    return np.exp(-strength * darkness)
