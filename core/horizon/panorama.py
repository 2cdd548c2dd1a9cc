"""The outline panorama of a place: the horizon and every inner ridge, as lines over azimuth and elevation angle.

Terrain is sampled along rays all around. A ridge stands where visible ground is followed by a hidden stretch: its
last visible sample is a point of an outline, and the last visible sample of the whole ray is the horizon. Points of
neighbouring rays at similar heights and distances are joined into lines.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import SILENT, checkpoint
from ..base.surface import sample_pixels
from ..base.terrain import eye_elevation_m

RAYS_AT_ONCE = 120
NEAR_SHARE = 0.01
"""Samples are never farther apart than this share of their distance."""
MAX_CLIMB = 8.0
"""Steepest outline that is followed: elevation steps per azimuth step (83 degrees)."""
MAX_DISTANCE_JUMP = 0.2
"""Neighbouring points of one outline differ in distance by no more than this share."""


@dataclass(frozen=True)
class PanoramaOptions:
    """How to draw the view all around.

    Attributes
    ----------
    step_deg : float
        Spacing of the rays [degrees].
    min_distance_m, max_distance_m : float
        Range of distances [m]; ground nearer than the minimum is left out.
    hidden_share : float
        An inner ridge is drawn if the ground hidden behind it is deeper than this share of its distance.
    shortest_deg : float
        Inner outlines narrower than this are left out [degrees].
    refraction_coefficient : float
    """

    step_deg: float = 0.1
    min_distance_m: float = 100.0
    max_distance_m: float = 60_000.0
    hidden_share: float = 0.15
    shortest_deg: float = 0.8
    refraction_coefficient: float = REFRACTION_COEFFICIENT

    def __post_init__(self):
        if not 0 < self.step_deg <= 5:
            raise ValueError(f"step_deg must lie in (0, 5], not {self.step_deg}")
        if not 0 < self.min_distance_m < self.max_distance_m:
            raise ValueError("distances need 0 < min_distance_m < max_distance_m")


@dataclass(frozen=True, eq=False)
class Outline:
    """One line of the panorama.

    Attributes
    ----------
    azimuth_deg : (N,) array
        Increasing, not wrapped: a line across north continues beyond 360 [degrees].
    elevation_deg, distance_m : (N,) arrays
        Elevation angle [degrees] and distance [m] of each point.
    horizon : bool
        The line is part of the boundary with the sky.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    horizon: bool


@dataclass(frozen=True, eq=False)
class Panorama:
    """Outlines around an eye, farthest first, and the horizon as one profile.

    Attributes
    ----------
    outlines : tuple of Outline
    azimuth_deg, horizon_deg, horizon_m : (A,) arrays
        Azimuth, elevation angle [degrees] and distance [m] of the horizon; NaN where nothing is known.
    eye_elevation_m : float
    """

    outlines: tuple
    azimuth_deg: np.ndarray
    horizon_deg: np.ndarray
    horizon_m: np.ndarray
    eye_elevation_m: float


def outline_panorama(terrain, observer, options=None, progress=SILENT):
    """Compute the outline panorama of a place.

    Parameters
    ----------
    terrain : Terrain
    observer : Observer
    options : PanoramaOptions or None
    progress : Progress

    Returns
    -------
    Panorama

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    options = options or PanoramaOptions()
    frame = terrain.frame(observer.longitude_deg, observer.latitude_deg, 1.01 * options.max_distance_m)
    eye = eye_elevation_m(terrain, frame, observer)
    azimuth = np.arange(round(360 / options.step_deg)) * (360 / round(360 / options.step_deg))
    distance = sample_distances_m(frame.cell_m, options)
    columns = []
    for start in range(0, azimuth.size, RAYS_AT_ONCE):
        checkpoint(progress, start / azimuth.size)
        part = np.radians(azimuth[start : start + RAYS_AT_ONCE])[:, None]
        col, row = frame.to_pixel(distance * np.sin(part), distance * np.cos(part))
        height = sample_pixels(terrain, col, row)
        rise = height - eye - apparent_drop_m(distance, options.refraction_coefficient)
        columns.extend(_ridges(np.degrees(np.arctan2(rise, distance)), distance, frame.cell_m, options))
    horizon = np.array([column[-1][:2] if len(column) else (np.nan, np.nan) for column in columns])
    outlines = _join(columns, azimuth, options)
    return Panorama(outlines, azimuth, horizon[:, 0], horizon[:, 1], eye)


def sample_distances_m(cell_m, options):
    """Distances along a ray: a hundredth of the way apart, until that is half a cell or half a step of azimuth."""
    growth = np.radians(options.step_deg) / 2
    distances, distance = [], options.min_distance_m
    while distance < options.max_distance_m:
        distances.append(distance)
        # Close to the eye, a crest between two samples would be missed by whole degrees.
        distance += min(max(0.5 * cell_m, growth * distance), NEAR_SHARE * distance)
    return np.array([*distances, options.max_distance_m])


def _ridges(elevation_deg, distance_m, cell_m, options):
    """Points (elevation, distance, is horizon) of each ray where visible ground ends, near to far."""
    known = np.where(np.isfinite(elevation_deg), elevation_deg, -np.inf)
    highest = np.maximum.accumulate(known, axis=1)
    visible = (known >= highest) & np.isfinite(known)
    for angles, seen in zip(elevation_deg, visible):
        index = np.flatnonzero(seen)
        if not index.size:
            yield []
            continue
        here, there = distance_m[index[:-1]], distance_m[index[1:]]
        hidden = there - here - 2 * np.gradient(distance_m)[index[:-1]]
        ends = index[:-1][hidden > np.maximum(options.hidden_share * here, 3 * cell_m)]
        points = [(angles[k], distance_m[k], False) for k in ends]
        yield [*points, (angles[index[-1]], distance_m[index[-1]], True)]


def _join(columns, azimuth_deg, options):
    """Join points of neighbouring rays to outlines, across north too; farthest outlines first."""
    climb = MAX_CLIMB * options.step_deg
    open_lines, done, first_column = {}, [], []
    for k, column in enumerate(columns):
        following = {}
        for point in sorted(column, key=lambda p: -p[1]):
            line = _nearest_line(open_lines, point, climb)
            if line is None:
                line = []
            line.append((azimuth_deg[k], *point))
            following[id(line)] = line
        done += [line for key, line in open_lines.items() if key not in following]
        open_lines = following
        if k == 0:
            first_column = list(following.values())
    done += _close_circle(list(open_lines.values()), first_column, climb)
    outlines = [piece for line in done for piece in _outlines_of(line)]
    shortest = options.shortest_deg
    outlines = [o for o in outlines if o.horizon or o.azimuth_deg[-1] - o.azimuth_deg[0] >= shortest]
    return tuple(sorted(outlines, key=lambda o: -float(np.median(o.distance_m))))


def _nearest_line(lines, point, climb):
    """Take from `lines` the one whose end continues best in `point`; None if there is none."""
    best, best_cost = None, 2.0
    for key, line in lines.items():
        _, elevation, distance, _ = line[-1]
        rise = abs(elevation - point[0]) / climb
        jump = abs(np.log(distance / point[1])) / MAX_DISTANCE_JUMP
        if max(rise, jump) <= 1 and rise + jump < best_cost:
            best, best_cost = key, rise + jump
    return lines.pop(best) if best is not None else None


def _close_circle(ends, starts, climb):
    """Join lines that end before north to lines that start at it."""
    closed = []
    for line in ends:
        for start in starts:
            rise, jump = abs(start[0][1] - line[-1][1]), abs(np.log(start[0][2] / line[-1][2]))
            if start is not line and rise <= climb and jump <= MAX_DISTANCE_JUMP:
                line.append((start[0][0] + 360.0, *start[0][1:]))
                break
        closed.append(line)
    return closed


def _outlines_of(line):
    """Cut a joined line at the places where it emerges from the horizon or passes behind it."""
    azimuth, elevation, distance, horizon = (np.array(column) for column in zip(*line))
    change = np.flatnonzero(np.diff(horizon.astype(int))) + 1
    for start, stop in zip(np.r_[0, change], np.r_[change, azimuth.size]):
        part = slice(start, min(stop + 1, azimuth.size))  # one point more, so that no gap shows
        yield Outline(azimuth[part], elevation[part], distance[part], bool(horizon[start]))
