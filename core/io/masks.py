"""Masks of labelling tools (run lengths of COCO, bitmaps of LabelMe) as outlines.

References
----------
.. [1] COCO API, maskApi.c (rleFrString, rleDecode): run lengths down the columns, beginning with a run of zeros.
"""

from __future__ import annotations

import base64
import io

import numpy as np
from scipy import ndimage

from ..base.optional import available
from .formats import MAX_PIXELS


def mask_of_runs(segmentation):
    """Decode COCO's {size: [height, width], counts: list or compressed text} to a bool (H, W) array.

    Raises
    ------
    ValueError
        The runs do not fill the picture.
    """
    height, width = (int(side) for side in segmentation["size"])
    counts = segmentation["counts"]
    runs = np.asarray(_counts_of_text(counts) if isinstance(counts, str) else counts, np.int64)
    if not 0 < height * width <= MAX_PIXELS or (runs < 0).any() or runs.sum() != height * width:
        raise ValueError("the run lengths do not fill the picture")
    flat = np.repeat(np.arange(runs.size) % 2 == 1, runs)
    return flat.reshape(width, height).T


def _counts_of_text(text):
    """Decode COCO's compressed counts: five bits a character, and differences to the run before the last."""
    counts: list = []
    place = 0
    while place < len(text):
        value, shift, more = 0, 0, True
        while more:
            bits = ord(text[place]) - 48
            value |= (bits & 0x1F) << shift
            more, place, shift = bool(bits & 0x20), place + 1, shift + 5
            if not more and bits & 0x10:
                value -= 1 << shift
        counts.append(value + (counts[-2] if len(counts) > 2 else 0))
    return counts


def mask_of_picture(text):
    """Decode LabelMe's mask, a picture in base64, to a bool (H, W) array; None without Pillow.

    Raises
    ------
    ValueError
        The text is no picture, or a damaged or too large one.
    """
    pil = available("PIL.Image")
    if pil is None:
        return None
    data = base64.b64decode(text)
    try:
        with pil.open(io.BytesIO(data)) as picture:
            if picture.size[0] * picture.size[1] <= MAX_PIXELS:
                return np.asarray(picture.convert("L")) > 0
    except Exception as error:  # on damaged files Pillow raises SyntaxError, struct.error, OSError, ...
        raise ValueError(f"the mask is no picture: {error}") from None
    raise ValueError("the mask is too large")


def outlines(mask):
    """Outline each connected area of a mask along the edges of its pixels.

    Parameters
    ----------
    mask : (H, W) bool array

    Returns
    -------
    list of list of (N, 2) arrays
        For each area its outer ring, then its holes: x and y of corners of pixels, with the upper left corner of the
        mask at (0, 0). Pixels that touch only at a corner belong to different areas.
    """
    labelled, _ = ndimage.label(mask)
    areas = []
    for number, (rows, cols) in enumerate(ndimage.find_objects(labelled), start=1):
        rings = [ring + (cols.start, rows.start) for ring in _rings(labelled[rows, cols] == number)]
        areas.append(sorted(rings, key=_area, reverse=True))  # the outer ring runs the other way than its holes
    return areas


def _area(ring):
    x, y = ring.T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def _rings(mask):
    """Closed chains of pixel edges with the mask on their right (y down), without the corners within straight runs."""
    padded = np.pad(mask, 1).astype(np.int8)
    down, right = np.diff(padded, axis=0), np.diff(padded, axis=1)
    leaving: dict = {}
    for array, sign, start, step in (
        (down[:, 1:-1], 1, (0, 0), (1, 0)),  # above a pixel: to the right
        (down[:, 1:-1], -1, (1, 0), (-1, 0)),  # below it: to the left
        (right[1:-1], -1, (0, 0), (0, 1)),  # to its right: down
        (right[1:-1], 1, (0, 1), (0, -1)),  # to its left: up
    ):
        for y, x in np.argwhere(array == sign).tolist():
            leaving.setdefault((x + start[0], y + start[1]), []).append(step)
    rings = []
    while leaving:
        corner = first = next(iter(leaving))
        ring: list = []
        walked: tuple | None = None
        while corner != first or walked is None:
            turned = _next_step(leaving, corner, walked)
            if turned != walked:
                ring.append(corner)
            walked = turned
            corner = corner[0] + turned[0], corner[1] + turned[1]
        rings.append(np.array(ring, float))
    return rings


def _next_step(leaving, corner, step):
    """Take an edge that leaves a corner; where two do, turn right, which keeps areas that touch there apart."""
    steps = leaving[corner]
    right = steps[0] if step is None else (-step[1], step[0])
    taken = right if right in steps else steps[0]
    steps.remove(taken)
    if not steps:
        del leaving[corner]
    return taken
