"""A plan of a run: the positions and directions of the photographs, north up, without a base map."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.angles import wrap_180
from ..base.curvature import METRES_PER_DEGREE
from .svg import element, figure, line, round_below, sector_path, text
from .text import azimuth, compass_point, escape, is_known

SMALLEST_SPAN_M = 200.0
"""The plan spans at least this much, so that GPS noise does not spread photographs of one place over the sheet [m]."""


@dataclass(frozen=True)
class Station:
    """A photograph on the plan.

    Attributes
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 [degrees].
    name : str
    status : str
        One of the four statuses, used in the class 'is-<status>'.
    heading_deg, hfov_deg : float or None
        True heading and horizontal field of view [degrees].
    anchor : str or None
        Anchor of the page that a click opens.
    """

    longitude_deg: float
    latitude_deg: float
    name: str
    status: str
    heading_deg: float | None = None
    hfov_deg: float | None = None
    anchor: str | None = None


def stations_svg(stations, width=1280, height=420, say=str):
    """Draw stations as dots with their fields of view.

    Parameters
    ----------
    stations : sequence of Station
    width, height : float
        Size of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG; '' if no station has a position. East and north are to scale at the middle latitude,
        also across the 180th meridian.
    """
    stations = [s for s in stations if is_known(s.longitude_deg) and is_known(s.latitude_deg)]
    if not stations:
        return ""
    east_m, north_m = east_north(stations)
    margin = 60
    span_x, span_y = max(np.ptp(east_m), SMALLEST_SPAN_M), max(np.ptp(north_m), SMALLEST_SPAN_M)
    px_per_m = min((width - 2 * margin) / span_x, (height - 2 * margin) / span_y)
    x = width / 2 + (east_m - (east_m.min() + east_m.max()) / 2) * px_per_m
    y = height / 2 - (north_m - (north_m.min() + north_m.max()) / 2) * px_per_m
    marks = [_wedge(station, *place) for station, *place in zip(stations, x, y)]
    marks += [_dot(station, *place) for station, *place in zip(stations, x, y)]
    parts = [*marks, _scale_bar(px_per_m, width, height), _north(width, say)]
    extent = f"{max(np.ptp(east_m), np.ptp(north_m)) / 1000:.1f}"
    said = say("{count} photographs within {extent} kilometres.").format(count=len(stations), extent=extent)
    return figure(width, height, say("Camera positions and headings"), said, *parts)


def east_north(stations):
    """Metres to the east and north of the first station, to scale at the middle latitude.

    Parameters
    ----------
    stations : sequence of Station
        All with positions.

    Returns
    -------
    east_m, north_m : (N,) arrays
    """
    longitude = np.array([s.longitude_deg for s in stations], float)
    latitude = np.array([s.latitude_deg for s in stations], float)
    middle = np.cos(np.radians((latitude.min() + latitude.max()) / 2))
    east = wrap_180(longitude - longitude[0]) * METRES_PER_DEGREE * middle
    return east, (latitude - latitude[0]) * METRES_PER_DEGREE


def _wedge(station, x, y):
    if not (is_known(station.heading_deg) and is_known(station.hfov_deg)):
        return ""
    path = sector_path(x, y, 0, 46, station.heading_deg - station.hfov_deg / 2, station.hfov_deg)
    return element("path", d=path, class_=f"station-view is-{station.status}")


def _dot(station, x, y):
    words = station.name if station.heading_deg is None else f"{station.name}: {azimuth(station.heading_deg)}"
    dot = element(
        "circle", element("title", escape(words) or "-"), cx=x, cy=y, r=4.5, class_=f"station is-{station.status}"
    )
    return dot if station.anchor is None else element("a", dot, **{"xlink:href": f"#{station.anchor}"})


def _scale_bar(px_per_m, width, height):
    length_m = round_below(0.2 * width / px_per_m)
    words = f"{length_m / 1000:g} km" if length_m >= 1000 else f"{length_m:g} m"
    stop = 20 + length_m * px_per_m
    ends = line(20, height - 20, 20, height - 14, "axis") + line(stop, height - 20, stop, height - 14, "axis")
    return line(20, height - 14, stop, height - 14, "axis") + ends + text(24, height - 20, words, "name")


def _north(width, say):
    x = width - 24
    arrow = element("path", d=f"M{x} 14l-6 20l6 -5l6 5Z", class_="arrow")
    return arrow + text(x, 48, compass_point(0, say), "strong", "middle")
