"""Photographs from nearly one place: the turn of the camera between them, from features that both show.

A camera that only turns moves the picture by a homography that its lens and the turn determine. OpenCV finds the
features; without it there are no ties.
"""

from __future__ import annotations

import numpy as np

from ..base.camera import Pose
from ..base.optional import available

LEAST_MATCHES = 30
"""Matching features that agree on one turn."""
LEAST_SHARE = 0.25
"""Smallest share of the matches that must agree."""
RATIO = 0.75
"""A match counts if its distance is below this share of the next best one's (Lowe's test)."""
INLIER_PX = 3.0
LARGEST_STRETCH = 0.06
"""A homography whose singular values differ by more is no turn: the camera moved, or the focal length is wrong."""


def features(picture):
    """Find features of a picture; None without OpenCV 4.4 or newer, or with too few.

    Parameters
    ----------
    picture : (H, W, 3) uint8 array

    Returns
    -------
    (points, descriptors) or None
    """
    cv2 = available("cv2")
    if picture is None or not hasattr(cv2, "SIFT_create"):  # missing, or older than 4.4
        return None
    grey = cv2.cvtColor(np.ascontiguousarray(picture), cv2.COLOR_RGB2GRAY)
    points, descriptors = cv2.SIFT_create(3000).detectAndCompute(grey, None)
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
    (3, 3) array or None
        None if the pictures show too little in common, or differ by more than a turn.
    """
    cv2 = available("cv2")
    (shape, (points, descriptors)), (other_shape, (other_points, other_descriptors)) = one, other
    pairs = cv2.BFMatcher().knnMatch(descriptors, other_descriptors, k=2)
    good = [pair[0] for pair in pairs if len(pair) == 2 and pair[0].distance < RATIO * pair[1].distance]
    if len(good) < LEAST_MATCHES:
        return None
    source = points[[match.queryIdx for match in good]]
    target = other_points[[match.trainIdx for match in good]]
    homography, inside = cv2.findHomography(source, target, cv2.RANSAC, INLIER_PX)
    if (
        homography is None
        or np.linalg.det(homography) == 0
        or inside.sum() < max(LEAST_MATCHES, LEAST_SHARE * len(good))
    ):
        return None
    stretched = np.linalg.inv(_lens(other_focal_px, other_shape)) @ homography @ _lens(one_focal_px, shape)
    left, values, right = np.linalg.svd(stretched / np.cbrt(np.linalg.det(stretched)))
    if values[0] / values[2] > 1 + LARGEST_STRETCH:
        return None
    return left @ right


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


def _lens(focal_px, shape):
    height, width = shape[:2]
    return np.array([[focal_px, 0, (width - 1) / 2], [0, focal_px, (height - 1) / 2], [0, 0, 1.0]])
