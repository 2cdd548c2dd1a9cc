"""The paper's figure of a result in three panels: photograph, where it looks, what ground it shows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .draw_raster import draw_words, resized
from .draw_text import azimuth
from .figures_map import map_image

GAP_PX = 10
PAPER = (255, 255, 255)


def three_panels(photo, data, height_px=560, captions=True, say=str):
    """Draw photograph, wedge on the grey elevation model, and viewshed on shaded relief side by side.

    Parameters
    ----------
    photo : uint8 (h, w, 3) array or None
        The upright picture, or its overlay; without it there are two panels.
    data : MapData
        With the observer first, its heading and field of view, the viewshed as `seen`, and the track if there is one.
    height_px : int
        Of the figure [pixels].
    captions : bool
        Write a letter and a word into each panel.
    say : callable
        See `draw_text`.

    Returns
    -------
    uint8 (height_px, w, 3) array
    """
    east_m, south_m = data.size_m
    map_px = round(height_px * east_m / south_m)
    plain = replace(data, seen=None, track_px=None, observers=data.observers[:1])
    heading = data.observers[0].heading_deg if data.observers else None
    wedge_words = say("view") if heading is None else f"{say('heading')} {azimuth(heading)}"
    panels = [
        (map_image(plain, map_px, "grey", wedge_reach_m=2 * max(east_m, south_m)), wedge_words),
        (map_image(data, map_px, "hillshade", wedges=False), say("viewshed")),
    ]
    if photo is not None:
        photo = np.asarray(photo)[..., :3]
        width_px = round(height_px * photo.shape[1] / photo.shape[0])
        panels.insert(0, (resized(photo, width_px, height_px).copy(), say("photograph")))
    gap = np.full((height_px, GAP_PX, 3), PAPER, np.uint8)
    drawn = []
    for letter, (pixels, words) in zip("abc", panels):
        if captions:
            draw_words(pixels, 14, 12, f"{letter}  {words}", (255, 255, 255), height_px / 26, "la", bold=True)
        drawn += [gap, resized(pixels, pixels.shape[1], height_px)]
    return np.hstack(drawn[1:])
