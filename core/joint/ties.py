"""Photographs from nearly one place: the turn of the camera between them, from features that both show.

A camera that only turns turns the directions in which features are seen, all by the same rotation. Three numbers are
sought rather than the eight of a homography, which a narrow field of view does not determine. OpenCV finds the
features; without it there are no ties.
"""

from __future__ import annotations

import numpy as np

from ..base.camera import Pose
from ..base.optional import available

LEAST_MATCHES = 20
"""Matching features that agree on one turn."""
LEAST_SHARE = 0.25
"""Smallest share of the matches that must agree."""
RATIO = 0.75
"""A match counts if its distance is below this share of the next best one's (Lowe's test)."""
INLIER_PX = 6.0
"""Largest distance of a match that agrees: an error of 1 % of the focal length moves the edge of the picture by 5."""
DRAWS = 500
"""Pairs of matches from which a turn is tried."""
SKYLINE_MARGIN = 0.01
"""Features this far above the skyline still count, as a share of the picture's height."""


def has_features():
    """Tell whether OpenCV 4.4 or newer is there, which finds features."""
    return hasattr(available("cv2"), "SIFT_create")


def features(picture, skyline=None):
    """Find features of a picture; None without OpenCV 4.4 or newer, or with too few.

    Parameters
    ----------
    picture : (H, W, 3) uint8 array
    skyline : Skyline or None
        Features above it are left out, because clouds move.

    Returns
    -------
    (points, descriptors) or None
    """
    if picture is None or not has_features():
        return None
    cv2 = available("cv2")
    grey = cv2.cvtColor(np.ascontiguousarray(picture), cv2.COLOR_RGB2GRAY)
    points, descriptors = cv2.SIFT_create(3000).detectAndCompute(grey, _ground(grey.shape, skyline))
    if descriptors is None or len(points) < LEAST_MATCHES:
        return None
    return np.array([point.pt for point in points]), descriptors


def turn_between(one, other, one_focal_px, other_focal_px):
    """Find the rotation from one camera's axes to another's.

    Parameters
    ----------
    one, other : (picture shape, features)
        Of both pictures.
    one_focal_px, other_focal_px : float
        Focal lengths in pixels of these pictures [pixels].

    Returns
    -------
    rotation : (3, 3) array
    count : int
        Matches that agree on it.

    None if the pictures show too little in common, or differ by more than a turn.
    """
    cv2 = available("cv2")
    (shape, (points, descriptors)), (other_shape, (other_points, other_descriptors)) = one, other
    pairs = cv2.BFMatcher().knnMatch(descriptors, other_descriptors, k=2)
    good = [pair[0] for pair in pairs if len(pair) == 2 and pair[0].distance < RATIO * pair[1].distance]
    if len(good) < LEAST_MATCHES:
        return None
    source = rays(points[[match.queryIdx for match in good]], shape, one_focal_px)
    target = rays(other_points[[match.trainIdx for match in good]], other_shape, other_focal_px)
    rotation, agrees = common_turn(source, target, INLIER_PX / min(one_focal_px, other_focal_px))
    count = int(agrees.sum())
    return None if count < max(LEAST_MATCHES, LEAST_SHARE * len(good)) else (rotation, count)


def rays(points_px, shape, focal_px):
    """Directions (N, 3) of pixels in the camera's axes: right, down, forward.

    Parameters
    ----------
    points_px : (N, 2) array
    shape : tuple
        Of the picture.
    focal_px : float
    """
    height, width = shape[:2]
    flat = (np.asarray(points_px, float) - [(width - 1) / 2, (height - 1) / 2]) / focal_px
    found = np.column_stack([flat, np.ones(len(flat))])
    return found / np.linalg.norm(found, axis=1, keepdims=True)


def common_turn(source, target, limit):
    """Find the rotation on which most pairs of directions agree.

    Parameters
    ----------
    source, target : (N, 3) arrays
        Directions in one and the other camera's axes.
    limit : float
        Largest distance of a pair that agrees [rad].

    Returns
    -------
    rotation : (3, 3) array
    agrees : (N,) bool array
    """
    generator = np.random.default_rng(len(source))
    agrees = np.zeros(len(source), bool)
    for _ in range(DRAWS):
        drawn = generator.choice(len(source), 2, replace=False)
        found = _agreeing(_rotation(source[drawn], target[drawn]), source, target, limit)
        if found.sum() > agrees.sum():
            agrees = found
    for _ in range(3):
        if agrees.sum() < 2:
            break
        agrees = _agreeing(_rotation(source[agrees], target[agrees]), source, target, limit)
    return _rotation(source[agrees], target[agrees]), agrees


def _agreeing(rotation, source, target, limit):
    return np.linalg.norm(source @ rotation.T - target, axis=1) < limit


def _rotation(source, target):
    """Rotation that brings directions closest to others (Kabsch)."""
    left, _, right = np.linalg.svd(target.T @ source)
    return left @ np.diag([1.0, 1.0, np.linalg.det(left @ right)]) @ right


def turned(pose, rotation):
    """Pose of the other camera, given that of the first and the rotation between their axes.

    Parameters
    ----------
    pose : Pose
    rotation : (3, 3) array
        From `turn_between`.
    """
    return pose_of(rotation @ axes_of(pose))


def axes_of(pose):
    """Rows: the camera's right, down and forward, in east, north, up."""
    heading, pitch, roll = np.radians([pose.heading_deg, pose.pitch_deg, pose.roll_deg])
    forward = np.array([np.sin(heading) * np.cos(pitch), np.cos(heading) * np.cos(pitch), np.sin(pitch)])
    level = np.array([np.cos(heading), -np.sin(heading), 0.0])
    up = np.cross(level, forward)
    right = np.cos(roll) * level - np.sin(roll) * up
    return np.array([right, np.cross(forward, right), forward])


def pose_of(axes):
    """Invert `axes_of`."""
    right, _, forward = axes
    heading, pitch = np.arctan2(forward[0], forward[1]), np.arcsin(np.clip(forward[2], -1, 1))
    level = np.array([np.cos(heading), -np.sin(heading), 0.0])
    roll = np.arctan2(-right @ np.cross(level, forward), right @ level)
    return Pose(float(np.degrees(heading) % 360), float(np.degrees(pitch)), float(np.degrees(roll)))


def _ground(shape, skyline):
    """Mask of the pixels below a skyline, with a margin for its own error; None without one."""
    if skyline is None or not skyline.valid.any():
        return None
    height, width = shape
    columns = (np.arange(width) + 0.5) * skyline.width_px / width - 0.5
    row = np.interp(columns, np.flatnonzero(skyline.valid), skyline.row_px[skyline.valid])
    row = (row + 0.5) * height / skyline.height_px - 0.5
    return (255 * (np.arange(height)[:, None] >= row - SKYLINE_MARGIN * height)).astype(np.uint8)
