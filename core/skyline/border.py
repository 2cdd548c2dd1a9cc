"""Find the border of a scanned or letterboxed picture: a dark or bright frame of one colour."""

from __future__ import annotations

import numpy as np

FRAME_TOLERANCE = 24.0
"""Largest deviation of a frame's pixels from its colour, in any channel [grey levels]."""

DEEPEST_FRAME_SHARE = 0.3
"""Largest share of the picture that one side of a frame can take."""

FRAME_LEVELS = (40.0, 215.0)
"""Frames are dark or bright: every channel below the first or above the second [grey levels]."""


def find_crop(rgb):
    """Width of the frame on each side of an RGB picture, (top, bottom, left, right) [pixels]; zeros if none."""
    rgb = np.asarray(rgb, np.float32)
    height, width = rgb.shape[:2]
    if min(height, width) < 32:
        return 0, 0, 0, 0
    ring = np.concatenate([rgb[0], rgb[-1], rgb[:, 0], rgb[:, -1]])
    colour = np.median(ring, 0)
    if not ((colour < FRAME_LEVELS[0]).all() or (colour > FRAME_LEVELS[1]).all()):
        return 0, 0, 0, 0
    is_frame = np.abs(rgb - colour).max(2) <= FRAME_TOLERANCE
    left, right = _clean_depth(is_frame.mean(0)), _clean_depth(is_frame.mean(0)[::-1])
    top, bottom = _clean_depth(is_frame.mean(1)), _clean_depth(is_frame.mean(1)[::-1])
    if left and right:
        inner = is_frame[:, left : width - right].mean(1)
        return _depth(inner), _depth(inner[::-1]), left, right
    if top and bottom:
        return top, bottom, 0, 0
    return 0, 0, 0, 0


def _depth(share):
    """Lines before fewer than half the pixels have the frame's colour (letters of a caption cover less than half)."""
    ended = share < 0.5
    depth = int(ended.argmax()) if ended.any() else 0
    return depth if depth <= DEEPEST_FRAME_SHARE * len(share) else 0


def _clean_depth(share):
    """`_depth` of a side that is pure frame from its first line on and ends within three lines; else 0."""
    depth = _depth(share)
    pure = depth - 2 if depth > 2 else depth
    return depth if depth and share[:pure].min(initial=1.0) >= 0.97 else 0
