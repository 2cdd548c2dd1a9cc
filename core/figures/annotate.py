"""The annotated photograph: names with leaders, points, lines and areas over the picture, as pixels and as SVG.

One list of marks serves both forms: burnt into a uint8 array (for PNG), or as vector shapes over the embedded picture.
"""

from __future__ import annotations

import base64
from dataclasses import dataclass

import numpy as np

from .labels import LabelOptions, lay_out_labels
from .raster import LineStyle, TypeStyle, draw_dot, draw_line, draw_words, encode_jpeg, resized, words_width
from .svg import element, polyline_path
from .text import escape

VISIBLE_COLOUR = (255, 154, 31)
HIDDEN_COLOUR = (255, 255, 255)
LABEL_COLOUR = (255, 255, 255)
CASING_COLOUR = "#10151c"
WIDEST_PX = 1600


@dataclass(frozen=True)
class NamedPoint:
    """A point with a name, in pixels of the full picture; more important points come first in a list."""

    words: str
    x_px: float
    y_px: float


@dataclass(frozen=True, eq=False)
class Stroke:
    """A line in pixels of the full picture; hidden ones are dashed and pale."""

    x_px: np.ndarray
    y_px: np.ndarray
    visible: bool = True


@dataclass(frozen=True, eq=False)
class Annotation:
    """A picture with its marks, scaled and laid out.

    Attributes
    ----------
    pixels : uint8 (h, w, 3) array
    unit_px : float
        Scale of everything drawn, 1 on a picture 1280 pixels long.
    points : tuple of NamedPoint
    labels : tuple of PlacedLabel
    strokes : tuple of Stroke
    """

    pixels: np.ndarray
    unit_px: float
    points: tuple
    labels: tuple
    strokes: tuple


def annotate(pixels, full_width_px, points=(), strokes=(), width_px=None):
    """Scale marks to a drawing and lay out the names.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
        The upright picture, full size or reduced.
    full_width_px : int
        Width of the picture that the marks' pixels refer to.
    points : sequence of NamedPoint
        Most important first.
    strokes : sequence of Stroke
    width_px : int or None
        Width of the drawing [pixels]; None keeps the picture's width, up to `WIDEST_PX`.

    Returns
    -------
    Annotation
    """
    width_px = width_px or min(pixels.shape[1], WIDEST_PX)
    height_px = max(round(pixels.shape[0] * width_px / pixels.shape[1]), 1)
    picture = resized(np.asarray(pixels)[..., :3], width_px, height_px).copy()
    scale, unit = width_px / full_width_px, max(width_px, height_px) / 1280

    def shrink(value):
        return (np.asarray(value, float) + 0.5) * scale - 0.5

    points = tuple(NamedPoint(p.words, float(shrink(p.x_px)), float(shrink(p.y_px))) for p in points)
    strokes = tuple(Stroke(shrink(s.x_px), shrink(s.y_px), s.visible) for s in strokes)
    widths = [words_width(p.words, _type_px(unit)) + 4 * unit for p in points]
    options = LabelOptions(line_px=19 * unit, gap_px=3 * unit, lead_px=16 * unit, longest_lead_px=320 * unit)
    labels = lay_out_labels([p.x_px for p in points], [p.y_px for p in points], widths, (width_px, height_px), options)
    return Annotation(picture, unit, points, labels, strokes)


def annotation_pixels(annotation):
    """Burn the marks in: uint8 (h, w, 3)."""
    pixels, unit = annotation.pixels.copy(), annotation.unit_px
    for stroke in annotation.strokes:
        colour = VISIBLE_COLOUR if stroke.visible else HIDDEN_COLOUR
        dash = None if stroke.visible else (6 * unit, 5 * unit)
        style = LineStyle(dash, unit, 1.0 if stroke.visible else 0.55)
        draw_line(pixels, stroke.x_px, stroke.y_px, colour, 2.2 * unit, style)
    for label in annotation.labels:
        x, start, stop = label.leader
        draw_line(pixels, [x, x], [start, stop], LABEL_COLOUR, 1.2 * unit, LineStyle(casing_px=unit))
    for point in annotation.points:
        draw_dot(pixels, point.x_px, point.y_px, 2.6 * unit, VISIBLE_COLOUR, 1.2 * unit)
    for label in annotation.labels:
        x, y = label.left_px + 2 * unit, label.top_px + 0.76 * label.height_px
        words = annotation.points[label.index].words
        draw_words(pixels, x, y, words, LABEL_COLOUR, TypeStyle(_type_px(unit), "ls", max(round(1.6 * unit), 1)))
    return pixels


def annotation_svg(annotation, say=str):
    """Draw the marks over the embedded picture: SVG text, complete in one file; `say` as in `core.figures.text`."""
    height, width = annotation.pixels.shape[:2]
    unit = annotation.unit_px
    picture = base64.b64encode(encode_jpeg(annotation.pixels)).decode("ascii")
    parts = [element("image", href=f"data:image/jpeg;base64,{picture}", width=width, height=height)]
    parts += [_stroke_svg(stroke, unit) for stroke in annotation.strokes]
    parts += [_label_svg(annotation, label) for label in annotation.labels]
    parts += [
        element("circle", cx=p.x_px, cy=p.y_px, r=2.6 * unit, fill=_hex(VISIBLE_COLOUR), stroke=CASING_COLOUR,
                stroke_width=1.2 * unit)
        for p in annotation.points
    ]  # fmt: skip
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" role="img" '
        f'aria-label="{escape(say("annotated photograph"))}" font-family="DejaVu Sans,Arial,sans-serif">'
        f"{''.join(parts)}</svg>"
    )


def _stroke_svg(stroke, unit):
    path = polyline_path(stroke.x_px, stroke.y_px)
    dash = None if stroke.visible else f"{6 * unit:.1f} {5 * unit:.1f}"
    common = {"d": path, "fill": "none", "stroke_linejoin": "round", "stroke_dasharray": dash}
    colour = _hex(VISIBLE_COLOUR if stroke.visible else HIDDEN_COLOUR)
    return element("path", stroke=CASING_COLOUR, stroke_width=4.2 * unit, stroke_opacity=0.5, **common) + element(
        "path", stroke=colour, stroke_width=2.2 * unit, **common
    )


def _label_svg(annotation, label):
    unit = annotation.unit_px
    x, start, stop = label.leader
    leader = element("path", d=polyline_path([x, x], [start, stop]), stroke="#fff", stroke_width=1.2 * unit)
    words = element(
        "text",
        escape(annotation.points[label.index].words),
        x=label.left_px + 2 * unit,
        y=label.top_px + 0.76 * label.height_px,
        font_size=_type_px(unit),
        textLength=max(label.width_px - 4 * unit, 1.0),  # the layout holds with whatever font the viewer has
        fill="#fff",
        stroke=CASING_COLOUR,
        stroke_width=2.4 * unit,
        paint_order="stroke",
    )
    return leader + words


def _type_px(unit):
    return 14.0 * unit


def _hex(colour):
    return "#{:02x}{:02x}{:02x}".format(*colour)
