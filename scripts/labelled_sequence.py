"""Reads a sequence (SemanticKITTI folder or bag) together with what `stillmap label` said of it."""
import os

import numpy as np

STATIC, DYNAMIC = 9, 251  # in NNNNNN.label; all else is uncertain
MIN_RANGE_M = 1.0  # nearer rows are no returns, or the carrier of the sensor


def read_labelled(sequence, labels_folder):
    """Yields (points in the map frame, their classes, position of the sensor) of each scan, in order of time."""
    read = _read_bag if sequence.endswith(".bag") else _read_folder
    for index, (points, position) in enumerate(read(sequence)):
        classes = _read_classes(os.path.join(labels_folder, f"{index:06d}.label"), len(points))
        usable = np.linalg.norm(points - position, axis=1) > MIN_RANGE_M  # NaN compares false
        yield points[usable], classes[usable], position


def _read_classes(file, count):
    if not os.path.exists(file):
        raise SystemExit(f"{file}: missing; run `stillmap label SEQUENCE OUT` and give OUT/final or OUT/online")
    classes = np.fromfile(file, np.uint32) & 0xFFFF
    if len(classes) != count:
        raise SystemExit(f"{file}: {len(classes)} labels for {count} points; they are of another sequence")
    return classes


def _read_folder(folder):
    velodyne = os.path.join(folder, "velodyne")
    T_camera_sensor = _calibration(os.path.join(folder, "calib.txt"))
    with open(os.path.join(folder, "poses.txt"), encoding="ascii") as lines:
        poses = [_matrix(line.split()) for line in lines if line.strip()]
    for name, T_world_camera in zip(sorted(os.listdir(velodyne)), poses):
        points = np.fromfile(os.path.join(velodyne, name), np.float32).reshape(-1, 4)[:, :3]
        T_map_sensor = np.linalg.inv(T_camera_sensor) @ T_world_camera @ T_camera_sensor
        rotation, position = T_map_sensor[:3, :3], T_map_sensor[:3, 3].astype(np.float32)
        yield points @ rotation.T.astype(np.float32) + position, position


def _calibration(file):
    """Without calib.txt the poses are the sensor's own."""
    if not os.path.exists(file):
        return np.eye(4)
    with open(file, encoding="ascii") as lines:
        tr = [line[3:].split() for line in lines if line.startswith("Tr:")]
    return _matrix(tr[0]) if tr else np.eye(4)


def _matrix(twelve):
    return np.vstack([np.array(twelve, float).reshape(3, 4), [0, 0, 0, 1]])


def _read_bag(file):
    """A bag as `stillmap simulate` and `stillmap bag` write it: cloud and pose of the same stamp, pose first."""
    import rosbag  # pylint: disable=import-outside-toplevel  # a folder is read without ROS

    poses = {}
    with rosbag.Bag(file) as bag:
        for topic, message, _ in bag.read_messages(topics=["/Odometry", "/cloud_registered"]):
            if topic == "/Odometry":
                poses[message.header.stamp] = message
                continue
            pose = poses.pop(message.header.stamp)
            if message.header.frame_id != pose.header.frame_id:
                raise SystemExit(f"{file}: clouds in {message.header.frame_id}; pictures need them in the world frame")
            at = pose.pose.pose.position
            yield _xyz(message), np.array([at.x, at.y, at.z], np.float32)


def _xyz(cloud):
    offsets = {field.name: field.offset for field in cloud.fields}
    rows = np.dtype({"names": ["x", "y", "z"], "formats": ["<f4"] * 3,
                     "offsets": [offsets[axis] for axis in "xyz"], "itemsize": cloud.point_step})
    points = np.frombuffer(cloud.data, rows)
    return np.stack([points[axis] for axis in "xyz"], axis=1)
