"""The outline panorama as a drawing: SVG and pixels from one layout.

The strip starts at its left azimuth and runs clockwise. Both axes have the same scale unless heights are exaggerated.
Near ridges are dark and bold, distant ones pale and thin.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .labels import LabelOptions, lay_out_labels
from .raster import LineStyle, TypeStyle, draw_line, draw_words, words_width
from .svg import element, polyline_path
from .text import compass_point, escape

NEAR_INK, FAR_INK = np.array([38, 33, 28]), np.array([126, 152, 184])
SKY, GROUND_LINE, PHOTO_INK, TEXT_INK = (250, 252, 255), (200, 206, 214), (217, 95, 2), (28, 36, 48)
MARGIN_TOP_DEG, MARGIN_BOTTOM_DEG = 1.0, 1.5


@dataclass(frozen=True)
class PanoramaLabel:
    """A name in a given direction; more important names come first in a list."""

    words: str
    azimuth_deg: float
    elevation_deg: float


@dataclass(frozen=True, eq=False)
class PanoramaFrame:
    """The outer edge of a photograph, as directions."""

    words: str
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray


@dataclass(frozen=True, eq=False)
class PanoramaDrawing:
    """Everything in drawing units, ready to be written in either form."""

    width: float
    height: float
    lines: tuple
    frames: tuple
    labels: tuple
    words: tuple
    axis: tuple
    level_y: float
    type_px: float


@dataclass(frozen=True)
class PanoramaLayout:
    """The layout of the strip.

    Attributes
    ----------
    left_deg : float
        Azimuth at the left edge [degrees].
    pixels_per_degree : float
    exaggeration : float
        Exaggeration of heights over widths.
    label_room_px : float
        Room for names above the highest outline.
    """

    left_deg: float = 0.0
    pixels_per_degree: float = 20.0
    exaggeration: float = 1.0
    label_room_px: float = 170.0


def lay_out_panorama(panorama, labels=(), frames=(), layout=PanoramaLayout(), say=str):  # noqa: B008 - frozen
    """Place outlines, names and photo frames on the strip.

    Parameters
    ----------
    panorama : Panorama
    labels : sequence of PanoramaLabel
        Most important first.
    frames : sequence of PanoramaFrame
    layout : PanoramaLayout
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    PanoramaDrawing
    """
    heights = np.concatenate([o.elevation_deg for o in panorama.outlines] or [np.zeros(1)])
    top, bottom = float(heights.max()) + MARGIN_TOP_DEG, float(heights.min()) - MARGIN_BOTTOM_DEG
    left_deg, pixels_per_degree, label_room_px = layout.left_deg, layout.pixels_per_degree, layout.label_room_px
    scale_y = pixels_per_degree * layout.exaggeration
    width, height = 360.0 * pixels_per_degree, label_room_px + (top - bottom) * scale_y + 34

    def place(azimuth_deg, elevation_deg):
        x = np.mod(np.subtract(azimuth_deg, left_deg), 360.0) * pixels_per_degree
        return x, label_room_px + (top - np.asarray(elevation_deg, float)) * scale_y

    lines = tuple(_ink(outline, place) for outline in panorama.outlines)
    edges = tuple((frame.words, *_unbroken(*place(frame.azimuth_deg, frame.elevation_deg))) for frame in frames)
    x, y = place([label.azimuth_deg for label in labels], [label.elevation_deg for label in labels])
    widths = [words_width(label.words, 13) + 4 for label in labels]
    options = LabelOptions(line_px=17, gap_px=3, lead_px=16, longest_lead_px=label_room_px + 80)
    placed = lay_out_labels(x, y, widths, (width, height - 34), options)
    ticks = tuple(
        (float(np.mod(a - left_deg, 360) * pixels_per_degree), f"{a}\u00b0" if a % 45 else compass_point(a, say))
        for a in range(0, 360, 15)
    )
    words = tuple(label.words for label in labels)
    return PanoramaDrawing(width, height, lines, edges, placed, words, ticks, float(place(0.0, 0.0)[1]), 13.0)


def _ink(outline, place):
    """(x, y, colour, stroke width) of an outline, broken at the strip's ends."""
    far = np.clip(np.log(np.median(outline.distance_m) / 500.0) / np.log(100.0), 0, 1)
    colour = tuple(int(v) for v in np.rint(NEAR_INK + (FAR_INK - NEAR_INK) * far))
    x, y = _unbroken(*place(outline.azimuth_deg, outline.elevation_deg))
    return x, y, colour, (2.0 if outline.horizon else 1.5) - 0.7 * far


def _unbroken(x, y):
    """Insert a gap where a line leaves the strip at one end and re-enters at the other."""
    jump = np.flatnonzero(np.abs(np.diff(x)) > 0.5 * max(np.ptp(x), 1.0) + 1000.0) + 1
    return np.insert(np.asarray(x, float), jump, np.nan), np.insert(np.asarray(y, float), jump, np.nan)


def panorama_svg(drawing, title="panorama"):
    """Write the drawing as a complete SVG file with a title in the reader's language."""
    width, height = drawing.width, drawing.height
    parts = [element("rect", width=width, height=height, fill=_hex(SKY)), element("title", escape(title))]
    level = polyline_path([0, width], [drawing.level_y] * 2)
    parts.append(element("path", d=level, stroke=_hex(GROUND_LINE), fill="none", stroke_dasharray="6 6"))
    for x, y, colour, stroke in drawing.lines:
        parts.append(element("path", d=polyline_path(x, y), stroke=_hex(colour), stroke_width=stroke, fill="none",
                             stroke_linejoin="round"))  # fmt: skip
    for words, x, y in drawing.frames:
        parts.append(element("path", d=polyline_path(x, y), stroke=_hex(PHOTO_INK), stroke_width=2, fill="none"))
        parts.append(element("text", escape(words), x=x[0] + 4, y=y[0] + 15, fill=_hex(PHOTO_INK), font_size=13))
    for label in drawing.labels:
        at, start, stop = label.leader
        parts.append(element("path", d=polyline_path([at, at], [start, stop]), stroke=_hex(TEXT_INK), stroke_width=0.8))
        parts.append(element("text", escape(drawing.words[label.index]), x=label.left_px + 2,
                             y=label.top_px + 0.76 * label.height_px, font_size=drawing.type_px, fill=_hex(TEXT_INK),
                             textLength=max(label.width_px - 4, 1.0)))  # fmt: skip
    for at, words in drawing.axis:
        parts.append(element("path", d=polyline_path([at, at], [height - 30, height - 22]), stroke=_hex(TEXT_INK)))
        parts.append(element("text", escape(words), x=at, y=height - 8, text_anchor="middle", font_size=13,
                             fill=_hex(TEXT_INK)))  # fmt: skip
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
        f'height="{height:.0f}" role="img" font-family="DejaVu Sans,Arial,sans-serif">{"".join(parts)}</svg>'
    )


def panorama_pixels(drawing):
    """Draw the panorama into uint8 (h, w, 3) pixels."""
    pixels = np.empty((round(drawing.height), round(drawing.width), 3), np.uint8)
    pixels[:] = SKY
    draw_line(pixels, [0, drawing.width], [drawing.level_y] * 2, GROUND_LINE, 1, LineStyle((6, 6)))
    for x, y, colour, stroke in drawing.lines:
        draw_line(pixels, x, y, colour, stroke)
    for words, x, y in drawing.frames:
        draw_line(pixels, x, y, PHOTO_INK, 2)
        draw_words(pixels, x[0] + 4, y[0] + 15, words, PHOTO_INK, TypeStyle(13, casing_px=0))
    for label in drawing.labels:
        at, start, stop = label.leader
        draw_line(pixels, [at, at], [start, stop], TEXT_INK, 1)
        draw_words(pixels, label.left_px + 2, label.top_px + 0.76 * label.height_px, drawing.words[label.index],
                   TEXT_INK, TypeStyle(drawing.type_px, casing_px=0))  # fmt: skip
    for at, words in drawing.axis:
        draw_line(pixels, [at, at], [drawing.height - 30, drawing.height - 22], TEXT_INK, 1)
        draw_words(pixels, at, drawing.height - 8, words, TEXT_INK, TypeStyle(13, "ms", casing_px=0))
    return pixels


def _hex(colour):
    return "#{:02x}{:02x}{:02x}".format(*(int(c) for c in colour))
