"""The frame around a scanned picture: white or black borders and the caption beneath.

A frame shows as lines of one colour along the full length of two opposite sides, ending at once where the picture
begins. An overexposed sky or a night sky is uniform too, but not down the whole left and right side, and it does not
end along a straight line.
"""

from __future__ import annotations

import numpy as np

TOLERANCE = 24.0
"""How far a frame's pixels stray from its colour, largest channel [grey levels]."""

DEEPEST_SHARE = 0.3
"""No side of a frame takes more of the picture than this."""

EXTREME_LEVELS = (40.0, 215.0)
"""Frames are dark or bright: every channel below the first or above the second [grey levels]."""


def find_crop(rgb):
    """Width of the frame on each side of an RGB picture, (top, bottom, left, right) [pixels]; zeros without one."""
    rgb = np.asarray(rgb, np.float32)
    height, width = rgb.shape[:2]
    if min(height, width) < 32:
        return 0, 0, 0, 0
    ring = np.concatenate([rgb[0], rgb[-1], rgb[:, 0], rgb[:, -1]])
    colour = np.median(ring, 0)
    if not ((colour < EXTREME_LEVELS[0]).all() or (colour > EXTREME_LEVELS[1]).all()):
        return 0, 0, 0, 0
    is_frame = np.abs(rgb - colour).max(2) <= TOLERANCE
    left, right = _clean_depth(is_frame.mean(0)), _clean_depth(is_frame.mean(0)[::-1])
    top, bottom = _clean_depth(is_frame.mean(1)), _clean_depth(is_frame.mean(1)[::-1])
    if left and right:
        inner = is_frame[:, left : width - right].mean(1)
        return _depth(inner), _depth(inner[::-1]), left, right
    if top and bottom:
        return top, bottom, 0, 0
    return 0, 0, 0, 0


def _depth(share):
    """Lines until fewer than half the pixels have the frame's colour (a caption's letters leave most of it)."""
    ended = share < 0.5
    depth = int(ended.argmax()) if ended.any() else 0
    return depth if depth <= DEEPEST_SHARE * len(share) else 0


def _clean_depth(share):
    """`_depth` for a side that must be pure frame from its first line on and end within three lines; else 0."""
    depth = _depth(share)
    pure = depth - 2 if depth > 2 else depth
    return depth if depth and share[:pure].min(initial=1.0) >= 0.97 else 0
