"""Drawing into uint8 RGB arrays (smooth lines, dots, areas and text), and encoding as PNG and JPEG.

Pillow draws without smoothing, so shapes are drawn several times too large into a coverage mask and then reduced.
Pillow is imported on first use; without it a message reports that pictures are missing, and everything else works.
"""

from __future__ import annotations

import io
from dataclasses import dataclass

import numpy as np

from ..base.messages import Message
from ..base.optional import require
from .fonts import runs_of
from .text import plain

OVERSAMPLING = 3
CASING = (0, 0, 0)


def encode_png(pixels, quickly=False):
    """PNG bytes of a uint8 array: (H, W) grey, (H, W, 3) RGB or (H, W, 4) RGBA.

    `quickly` suits whole photographs: the strongest compression makes them a tenth smaller and takes ten times as long.
    """
    return _encoded(pixels, "PNG", compress_level=3) if quickly else _encoded(pixels, "PNG", optimize=True)


def encode_jpeg(pixels, quality=82):
    """JPEG bytes of a uint8 (H, W, 3) RGB array."""
    return _encoded(pixels, "JPEG", quality=quality, optimize=True)


def resized(pixels, width_px, height_px):
    """Resample a uint8 picture smoothly to another size.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    width_px, height_px : float
        New size, rounded to whole pixels, at least 1.

    Returns
    -------
    uint8 array
    """
    image = _pillow("Image")
    size = max(round(width_px), 1), max(round(height_px), 1)
    return np.asarray(image.fromarray(np.ascontiguousarray(pixels)).resize(size, image.LANCZOS))


def tint(pixels, coverage, colour):
    """Blend a colour into a picture, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    coverage : (H, W) float array
        0 leaves the picture unchanged, 1 covers it.
    colour : (3,) uint8
    """
    share = np.clip(coverage, 0, 1)[..., None]
    np.copyto(pixels, np.rint(pixels * (1 - share) + np.asarray(colour, float) * share).astype(np.uint8))


@dataclass(frozen=True)
class LineStyle:
    """The style of a line apart from its colour and width.

    Attributes
    ----------
    dash_px : (float, float) or None
        Lengths drawn and skipped along the line [pixels].
    casing_px : float
        Width of a dark border on either side, which keeps the line legible on any background [pixels].
    opacity : float
        0 to 1.
    """

    dash_px: tuple | None = None
    casing_px: float = 0.0
    opacity: float = 1.0


def draw_line(pixels, x_px, y_px, colour, width_px=2.0, style=LineStyle()):  # noqa: B008 - frozen
    """Draw a smooth line, in place, broken where a coordinate is not finite.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    x_px, y_px : (N,) arrays
        Points, with the centre of the first pixel at 0; they may lie outside the picture.
    colour : (3,) uint8
    width_px : float
        Width of the line [pixels].
    style : LineStyle
    """
    pieces = _pieces(np.asarray(x_px, float), np.asarray(y_px, float), style.dash_px)
    pieces = [piece for piece in pieces if len(piece) > 1]
    if style.casing_px:
        _cover(pixels, pieces, CASING, width_px + 2 * style.casing_px, 0.65 * style.opacity)
    _cover(pixels, pieces, colour, width_px, style.opacity)


def draw_area(pixels, x_px, y_px, colour, opacity=1.0):
    """Fill the polygon through the points, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    x_px, y_px : (N,) arrays
        Corners [pixels].
    colour : tuple of int
        (red, green, blue)
    opacity : float
        0 to 1.
    """
    points = np.column_stack([x_px, y_px])
    _paint(pixels, lambda draw, scaled: draw.polygon(scaled(points), fill=255), points, 1, colour, opacity)


def draw_dot(pixels, x_px, y_px, radius_px, colour, casing_px=1.5):
    """Draw a disc with a dark border, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    x_px, y_px, radius_px : float
        Centre and radius of the disc [pixels].
    colour : tuple of int
        (red, green, blue)
    casing_px : float
        Width of the border [pixels].
    """
    for radius, fill in ((radius_px + casing_px, CASING), (radius_px, colour)):
        corners = np.array([[x_px - radius, y_px - radius], [x_px + radius, y_px + radius]])
        _paint(pixels, lambda draw, scaled, box=corners: draw.ellipse(scaled(box), fill=255), corners, 1, fill, 1.0)


@dataclass(frozen=True)
class TypeStyle:
    """The style of text.

    Attributes
    ----------
    size_px : float
        Height of the type [pixels].
    anchor : str
        Pillow's two letters: l, m, r and a (top), m, s (baseline).
    casing_px : int
        Width of the border, which is dark under light text and light under dark text.
    bold : bool
    """

    size_px: float = 14
    anchor: str = "ls"
    casing_px: int = 2
    bold: bool = False


def draw_words(pixels, x_px, y_px, words, colour, style=TypeStyle()):  # noqa: B008 - frozen
    """Write text with a border of the opposite brightness, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    x_px, y_px : float
        Position of the anchor [pixels].
    words : str
        One line of text from any source.
    colour : (3,) uint8
    style : TypeStyle
    """
    image, draw_module = _pillow("Image"), _pillow("ImageDraw")
    canvas = image.fromarray(pixels)
    halo = (0, 0, 0) if np.mean(colour) > 110 else (255, 255, 255)
    runs = runs_of(plain(words, 120), style.size_px, style.bold)
    widths = [font.getlength(text) for text, font in runs]
    across, up = style.anchor
    at_px = x_px - {"l": 0.0, "m": 0.5, "r": 1.0}[across] * sum(widths)
    for (text, font), width in zip(runs, widths):
        draw_module.Draw(canvas).text(
            (at_px, y_px),
            text,
            fill=tuple(int(c) for c in colour),
            font=font,
            anchor="l" + up,
            stroke_width=style.casing_px,
            stroke_fill=halo,
        )
        at_px += width
    np.copyto(pixels, np.asarray(canvas))


def words_width(words, size_px=14, bold=False):
    """Compute the width of text [pixels].

    Parameters
    ----------
    words : str
    size_px : float
        Height of the type [pixels].
    bold : bool
    """
    return float(sum(font.getlength(text) for text, font in runs_of(plain(words, 120), size_px, bold)))


def _pillow(module):
    feature = Message("Drawing and writing pictures")
    require("PIL", feature)
    return require(f"PIL.{module}", feature)


def _encoded(pixels, kind, **options):
    stream = io.BytesIO()
    _pillow("Image").fromarray(np.ascontiguousarray(pixels, dtype=np.uint8)).save(stream, kind, **options)
    return stream.getvalue()


def _cover(pixels, pieces, colour, width_px, opacity):
    if not pieces:
        return

    def paint(draw, scaled):
        for piece in pieces:
            draw.line(scaled(piece), fill=255, width=max(round(width_px * OVERSAMPLING), 1), joint="curve")

    _paint(pixels, paint, np.vstack(pieces), width_px, colour, opacity)


def _paint(pixels, paint, points, margin_px, colour, opacity):
    """Draw with `paint` into a large mask of the part of the picture around `points`, and tint the picture with it."""
    image, draw_module = _pillow("Image"), _pillow("ImageDraw")
    height, width = pixels.shape[:2]
    low = np.maximum(np.floor(points.min(axis=0) - margin_px - 2), 0).astype(int)
    high = np.minimum(np.ceil(points.max(axis=0) + margin_px + 3), [width, height]).astype(int)
    if np.any(high <= low):
        return
    size = tuple(int(n) for n in high - low)
    mask = image.new("L", (size[0] * OVERSAMPLING, size[1] * OVERSAMPLING))

    def scaled(xy):
        return [(float(x), float(y)) for x, y in (np.asarray(xy) + 0.5 - low) * OVERSAMPLING - 0.5]

    paint(draw_module.Draw(mask), scaled)
    coverage = np.asarray(mask.resize(size, image.BOX), np.float32) * (opacity / 255)
    tint(pixels[low[1] : high[1], low[0] : high[0]], coverage, colour)


def _pieces(x, y, dash_px):
    """Cut a line at unknown points, and into dashes."""
    known = np.isfinite(x) & np.isfinite(y)
    edges = np.flatnonzero(np.diff(np.r_[False, known, False].astype(int)))
    for first, stop in zip(edges[::2], edges[1::2]):
        piece = np.column_stack([x[first:stop], y[first:stop]])
        yield from [piece] if dash_px is None or len(piece) < 2 else _dashes(piece, dash_px)


def _dashes(points, dash_px):
    on, off = dash_px
    along = np.r_[0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T))]
    for start in np.arange(0, along[-1], on + off):
        stop = min(start + on, along[-1])
        inner = (along > start) & (along < stop)
        ends = [[np.interp(at, along, points[:, axis]) for axis in (0, 1)] for at in (start, stop)]
        yield np.vstack([ends[:1], points[inner], ends[1:]])
