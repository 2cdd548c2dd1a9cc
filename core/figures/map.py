"""Maps drawn into arrays: shaded relief with viewshed, wedges, observers, track, scale bar and north arrow."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ..base.angles import true_to_grid
from .hillshade import hillshade
from .raster import LineStyle, TypeStyle, draw_area, draw_dot, draw_line, draw_words, resized, tint, words_width
from .svg import round_below

WEDGE = (255, 154, 31)
SEEN = (255, 196, 0)
SEEN_OFTEN = (196, 30, 58)
TRACK = (64, 160, 255)
OBSERVER = (255, 255, 255)
INK = (255, 255, 255)
_LOW, _MIDDLE, _HIGH = np.array([[178, 196, 160], [206, 190, 160], [250, 250, 252]], float)
"""Hypsometric colours: valley green, rock, snow."""

VOID = (120, 128, 138)


@dataclass(frozen=True)
class MapObserver:
    """A camera on a map.

    Attributes
    ----------
    col_px, row_px : float
        Position on the map's elevation array, with the first cell's centre at 0.
    heading_deg : float or None
        True heading [degrees].
    hfov_deg : float or None
        Horizontal field of view [degrees].
    label : str
    beside : bool
        The observer is not the main one; it is drawn small.
    """

    col_px: float
    row_px: float
    heading_deg: float | None = None
    hfov_deg: float | None = None
    label: str = ""
    beside: bool = False


@dataclass(frozen=True, eq=False)
class MapData:
    """The content of a map, on the grid of an elevation array.

    Attributes
    ----------
    elevation_m : (R, C) array
        Row 0 is grid north [m]; NaN where unknown.
    cell_size_m : float or (float, float)
        Ground size of a cell along a row and along a column [m].
    convergence_deg : float
        Bearing of grid north from true north, clockwise [degrees].
    seen : (R, C) array or None
        Bool, or the number of photographs that see a cell.
    observers : sequence of MapObserver
    track_px : (N, 2) array or None
        (col, row) of the route walked; NaN breaks it.
    """

    elevation_m: np.ndarray
    cell_size_m: object
    convergence_deg: float = 0.0
    seen: np.ndarray | None = None
    observers: tuple = field(default_factory=tuple)
    track_px: np.ndarray | None = None

    @property
    def cell_xy_m(self):
        """Size of a cell (along a row, along a column) [m]."""
        return tuple(float(side) for side in np.broadcast_to(np.asarray(self.cell_size_m, float), 2))

    @property
    def size_m(self):
        """Size of the map (width, height) on the ground [m]."""
        rows, cols = np.shape(self.elevation_m)
        return cols * self.cell_xy_m[0], rows * self.cell_xy_m[1]


def map_image(data, width_px=1200, relief="coloured", wedges=True, title="", wedge_reach_m=None):
    """Draw a map.

    Parameters
    ----------
    data : MapData
    width_px : int
        Width of the result [pixels]; the height follows from the ground.
    relief : str
        'coloured' for tinted shaded relief, 'hillshade' for grey shaded relief, 'grey' for elevation as brightness.
    wedges : bool
        Draw each observer's field of view.
    title : str
        Text at the upper left.
    wedge_reach_m : float or None
        Length of the wedges [m]; None takes a fifth of the map's longer side.

    Returns
    -------
    uint8 (h, w, 3) array
    """
    if relief not in ("coloured", "hillshade", "grey"):
        raise ValueError(f"relief must be 'coloured', 'hillshade' or 'grey', not {relief!r}")
    east_m, south_m = data.size_m
    height_px = max(round(width_px * south_m / east_m), 1)
    pixels = _relief(data, relief, width_px, height_px)
    metres_per_px = east_m / width_px
    if data.seen is not None:
        _lay_viewshed(pixels, np.asarray(data.seen))
    unit = max(max(width_px, height_px) / 1000, 0.8)
    reach_px = (0.2 * max(east_m, south_m) if wedge_reach_m is None else wedge_reach_m) / metres_per_px
    places = [_place(data, pixels, observer.col_px, observer.row_px) for observer in data.observers]
    if wedges:
        for observer, place in zip(data.observers, places):
            _wedge(pixels, observer, place, data.convergence_deg, reach_px, unit)
    if data.track_px is not None and len(data.track_px):
        x, y = _place(data, pixels, *np.asarray(data.track_px, float).T)
        draw_line(pixels, x, y, TRACK, 2.5 * unit, LineStyle(casing_px=1.2 * unit))
    for observer, place in sorted(zip(data.observers, places), key=lambda pair: not pair[0].beside):
        radius = (2.4, TRACK, 1.0) if observer.beside else (4.5, OBSERVER, 1.8)
        draw_dot(pixels, *place, radius[0] * unit, radius[1], radius[2] * unit)
    _label(pixels, data.observers, places, unit)
    scale_bar(pixels, metres_per_px, unit)
    north_arrow(pixels, data.convergence_deg, unit)
    if title:
        draw_words(pixels, 14 * unit, 14 * unit, title, INK, TypeStyle(20 * unit, "la", bold=True))
    return pixels


def scale_bar(pixels, metres_per_px, unit=1.0):
    """Draw a scale bar of a round length at the lower left, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    metres_per_px : float
        [m per pixel]
    unit : float
        Size of text and marks, as a multiple of their usual size.
    """
    length_m = round_below(0.28 * pixels.shape[1] * metres_per_px)
    words = f"{length_m / 1000:g} km" if length_m >= 1000 else f"{length_m:g} m"
    left, base = 18 * unit, pixels.shape[0] - 18 * unit
    right = left + length_m / metres_per_px
    x, y = [left, left, right, right], [base - 7 * unit, base, base, base - 7 * unit]
    draw_line(pixels, x, y, INK, 2.2 * unit, LineStyle(casing_px=1.4 * unit))
    draw_words(pixels, (left + right) / 2, base - 6 * unit, words, INK, TypeStyle(15 * unit, "ms"))


def north_arrow(pixels, convergence_deg=0.0, unit=1.0):
    """Draw an arrow to true north at the upper right, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    convergence_deg : float
        See `core.base.angles.true_to_grid` [degrees].
    unit : float
        Size of text and marks, as a multiple of their usual size.
    """
    x, y = pixels.shape[1] - 34 * unit, 42 * unit
    bearing = np.radians(true_to_grid(0.0, convergence_deg))
    along, across = np.array([np.sin(bearing), -np.cos(bearing)]), np.array([np.cos(bearing), np.sin(bearing)])
    tip, tail = np.array([x, y]) + 22 * unit * along, np.array([x, y]) - 16 * unit * along
    for side, colour in ((1, (255, 255, 255)), (-1, (40, 44, 52))):
        wing = tail + side * 10 * unit * across
        corner = np.array([tip, wing, np.array([x, y]) - 9 * unit * along])
        draw_area(pixels, *corner.T, colour)
        draw_line(pixels, *np.vstack([corner, corner[:1]]).T, (20, 24, 30), 1.2 * unit)
    label = np.array([x, y]) - 27 * unit * along
    draw_words(pixels, *label, "N", INK, TypeStyle(16 * unit, "mm", bold=True))


def _relief(data, relief, width_px, height_px):
    elevation = np.asarray(data.elevation_m, np.float32)
    known = np.isfinite(elevation)
    low, high = np.percentile(elevation[known], [1, 99]) if known.any() else (0.0, 1.0)
    level = np.clip((np.where(known, elevation, low) - low) / max(high - low, 1e-6), 0, 1)[..., None]
    if relief == "grey":
        colour = np.repeat(40 + 190 * level, 3, axis=2)
    else:
        shade = np.nan_to_num(hillshade(elevation, data.cell_xy_m, exaggeration=1.4), nan=0.7)[..., None]
        colour = np.repeat(60 + 190 * shade, 3, axis=2)
        if relief == "coloured":
            ground = np.where(
                level < 0.5, _LOW + (_MIDDLE - _LOW) * 2 * level, _MIDDLE + (_HIGH - _MIDDLE) * (2 * level - 1)
            )
            colour = ground * (0.38 + 0.68 * shade)
    colour = np.where(known[..., None], colour, VOID)
    return resized(np.clip(colour, 0, 255).astype(np.uint8), width_px, height_px).copy()


def _lay_viewshed(pixels, seen):
    """Tint the ground that is seen, deeper and redder if more photographs see it."""
    count = np.nan_to_num(np.asarray(seen, np.float32))
    most = max(float(count.max()), 1.0)
    height, width = pixels.shape[:2]
    cover = resized((255 * (count > 0)).astype(np.uint8), width, height) / 255.0
    share = resized(np.rint(255 * np.clip(count / most, 0, 1)).astype(np.uint8), width, height) / 255.0
    tint(pixels, 0.5 * cover, SEEN)
    if most > 1:
        tint(pixels, 0.55 * cover * share**1.5, SEEN_OFTEN)


def _place(data, pixels, col_px, row_px):
    rows, cols = np.shape(data.elevation_m)
    height, width = pixels.shape[:2]
    return (np.asarray(col_px) + 0.5) * width / cols - 0.5, (np.asarray(row_px) + 0.5) * height / rows - 0.5


def _wedge(pixels, observer, place, convergence_deg, reach_px, unit):
    if observer.heading_deg is None or observer.hfov_deg is None:
        return
    centre = true_to_grid(observer.heading_deg, convergence_deg)
    bearing = np.radians(centre + np.linspace(-0.5, 0.5, 49) * observer.hfov_deg)
    x = np.r_[place[0], place[0] + reach_px * np.sin(bearing), place[0]]
    y = np.r_[place[1], place[1] - reach_px * np.cos(bearing), place[1]]
    draw_area(pixels, x, y, WEDGE, 0.16)
    draw_line(pixels, x, y, WEDGE, 1.8 * unit, LineStyle(casing_px=0.9 * unit))


def _label(pixels, observers, places, unit):
    """Write observers' names if they neither cover one another nor leave the map; the other observers get no name."""
    size, taken = 15 * unit, []
    for observer, (x, y) in zip(observers, places):
        if not observer.label:
            continue
        wide = words_width(observer.label, size)
        for left, base in (
            (x + 8 * unit, y - 6 * unit),
            (x - 8 * unit - wide, y - 6 * unit),
            (x + 8 * unit, y + 17 * unit),
        ):
            box = (left, base - size, left + wide, base)
            inside = left >= 0 and box[1] >= 0 and box[2] <= pixels.shape[1] and base <= pixels.shape[0]
            if inside and not any(_overlap(box, other) for other in taken):
                taken.append(box)
                draw_words(pixels, left, base, observer.label, INK, TypeStyle(size))
                break


def _overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def legend(pixels, entries, unit=1.0):
    """Write (colour, text) entries at the lower right, one below the other, in place.

    Parameters
    ----------
    pixels : uint8 (H, W, 3) array
    entries : sequence of (colour, text)
        Colours as (red, green, blue).
    unit : float
        Size of text and marks, as a multiple of their usual size.
    """
    size = 15 * unit
    wide = max((words_width(words, size) for _, words in entries), default=0.0)
    left, base = pixels.shape[1] - wide - 40 * unit, pixels.shape[0] - 16 * unit
    for colour, words in reversed(list(entries)):
        draw_dot(pixels, left + 8 * unit, base - 5 * unit, 6 * unit, colour, 1.2 * unit)
        draw_words(pixels, left + 20 * unit, base, words, INK, TypeStyle(size))
        base -= 22 * unit
