"""The ground that each pixel of a simulated photograph sees.

Terrain is sampled once on a fan of vertical planes (columns of azimuth, rings of distance). Along a plane, terrain is
hidden by the running maximum of the sight-line tangent: the first ring at which it reaches a pixel's own tangent holds
the ground that the pixel shows. Pose, roll and lens distortion only determine the azimuth and tangent of each pixel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.camera import project, unproject
from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import checkpoint
from .patch import VOID_M

UNSEEN_TAN = -1e3
"""Tangent given to places without terrain."""
COLUMNS_PER_BLOCK = 192


@dataclass(frozen=True, eq=False)
class Fan:
    """Terrain tangents on vertical planes around the eye.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Regular, clockwise from true north, increasing and not wrapped [degrees].
    distance_m : (D,) array
        Increasing ground distances [m].
    tangent : (A, D) float32 array
        Tangent of the terrain's apparent elevation angle.
    highest : (A, D) float32 array
        Running maximum of `tangent` along the distance.
    """

    azimuth_deg: np.ndarray
    distance_m: np.ndarray
    tangent: np.ndarray
    highest: np.ndarray


def pixel_directions(camera, pose, rows=None):
    """Compute the direction of every pixel.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    rows : range or None
        Rows to compute; None for all.

    Returns
    -------
    turn_deg, tangent : (rows, W) arrays
        Azimuth from the heading, in [-180, 180) [degrees], and tangent of the elevation angle.
    """
    rows = range(camera.height_px) if rows is None else rows
    x, y = np.meshgrid(np.arange(camera.width_px, dtype=float), np.arange(rows.start, rows.stop, dtype=float))
    azimuth, elevation = unproject(camera, pose, x, y)
    turn = np.mod(azimuth - pose.heading_deg + 180.0, 360.0) - 180.0
    return turn, np.tan(np.radians(np.clip(elevation, -89.9, 89.9)))


def ring_distances_m(cell_m, focal_px, range_m):
    """Distances at which planes are sampled: dense near the eye, then about half a cell or a pixel.

    Parameters
    ----------
    cell_m : float
        Ground size of the terrain's cells [m].
    focal_px : float
        Focal length [pixels].
    range_m : float
        The distances end before it [m].
    """
    distances, distance = [], 0.7
    while distance < range_m:
        distances.append(distance)
        distance += min(0.02 * distance, max(0.5 * cell_m, 0.7 * distance / focal_px))
    return np.array(distances)


def cast_fan(terrain_patch, view, turns_deg, range_m, progress):
    """Sample the terrain on vertical planes.

    Parameters
    ----------
    terrain_patch : TerrainPatch
    view : View
        View whose camera's focal length determines the density of the samples.
    turns_deg : (float, float)
        First and last plane, relative to the heading [degrees].
    range_m : float
        Range of the samples [m].
    progress : Progress

    Returns
    -------
    Fan
    """
    frame, camera, pose, eye_elevation_m = view.frame, view.camera, view.pose, view.eye_elevation_m
    step = 0.5 * np.degrees(1 / camera.focal_px)
    count = int(np.ceil((turns_deg[1] - turns_deg[0]) / step)) + 3
    azimuth = pose.heading_deg + turns_deg[0] + step * (np.arange(count) - 1)
    distance = ring_distances_m(frame.cell_m, camera.focal_px, range_m)
    tangent = np.empty((count, distance.size), np.float32)

    def tangents(angle, at_m):
        height = terrain_patch.sample(
            terrain_patch.elevation_m, frame, at_m * np.sin(angle), at_m * np.cos(angle), VOID_M
        )
        rise = height - eye_elevation_m - apparent_drop_m(at_m, REFRACTION_COEFFICIENT)
        return np.where(height > VOID_M / 10, rise / at_m, UNSEEN_TAN)

    for start in range(0, count, COLUMNS_PER_BLOCK):
        checkpoint(progress, start / count)
        angle = np.radians(azimuth[start : start + COLUMNS_PER_BLOCK])
        block = tangent[start : start + COLUMNS_PER_BLOCK]
        block[:] = tangents(angle[:, None], distance)
        _sharpen_crests(block, angle, distance, tangents)
    return Fan(azimuth, distance, tangent, np.maximum.accumulate(tangent, axis=1))


SAMPLES_AT_CREST = 12


def _sharpen_crests(tangent, angle, distance, tangents):
    """Raise rings next to a visible crest to the crest's true height, which lies between rings."""
    highest = np.maximum.accumulate(tangent, axis=1)
    inner = tangent[:, 1:-1]
    crest = (inner >= highest[:, 1:-1]) & (inner > tangent[:, 2:]) & (inner > UNSEEN_TAN)
    plane, ring = np.nonzero(crest)
    ring = ring + 1
    share = np.linspace(0, 1, SAMPLES_AT_CREST + 2)[1:-1]
    between = distance[ring - 1, None] + share * (distance[ring + 1] - distance[ring - 1])[:, None]
    best = tangents(angle[plane, None], between).max(axis=1)
    tangent[plane, ring] = np.maximum(tangent[plane, ring], best)


def first_hits_m(fan, azimuth_deg, tangent):
    """Compute the ground distance of the first terrain that each sight line meets.

    Parameters
    ----------
    fan : Fan
    azimuth_deg, tangent : (N,) arrays
        Direction of the sight lines; azimuths as counted in the fan [degrees].

    Returns
    -------
    (N,) array
        [m]; inf for sky.
    """
    step = fan.azimuth_deg[1] - fan.azimuth_deg[0]
    plane = np.clip(np.rint((azimuth_deg - fan.azimuth_deg[0]) / step), 0, fan.azimuth_deg.size - 1).astype(np.intp)
    order = np.argsort(plane, kind="stable")
    starts = np.searchsorted(plane[order], np.arange(fan.azimuth_deg.size + 1))
    ring = np.empty(tangent.size, np.intp)
    wanted = tangent.astype(np.float32)
    for index in range(fan.azimuth_deg.size):
        mine = order[starts[index] : starts[index + 1]]
        if mine.size:
            ring[mine] = np.searchsorted(fan.highest[index], wanted[mine])
    sky = ring == fan.distance_m.size
    far = np.minimum(ring, fan.distance_m.size - 1)
    near = np.maximum(far - 1, 0)
    # Heights of the terrain above the sight line at both rings; the line reaches the ground where that is zero.
    far_gap = (fan.tangent[plane, far] - tangent) * fan.distance_m[far]
    near_gap = (fan.tangent[plane, near] - tangent) * fan.distance_m[near]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(far_gap > near_gap, near_gap / (near_gap - far_gap), 1.0)
    share = np.where(fan.tangent[plane, near] <= UNSEEN_TAN, 1.0, np.clip(share, 0.0, 1.0))
    distance = fan.distance_m[near] + share * (fan.distance_m[far] - fan.distance_m[near])
    return np.where(sky, np.inf, distance)


def skyline_row_px(fan, camera, pose):
    """Compute the exact boundary of sky and terrain.

    Parameters
    ----------
    fan : Fan
    camera : Camera
    pose : Pose

    Returns
    -------
    (W,) array
        Continuous row of the horizon at each column's centre [pixels]; NaN where it is above or below the frame.
    """
    tangent = fan.highest[:, -1].astype(float)
    x, y = project(camera, pose, fan.azimuth_deg, np.degrees(np.arctan(tangent)))
    # Terrain right below or behind the frame's edge can fold x; the uppermost of all crossings is the skyline.
    column = np.arange(camera.width_px, dtype=float)
    row = np.full(camera.width_px, np.inf)
    known = np.isfinite(x[:-1]) & np.isfinite(x[1:]) & (tangent[:-1] > UNSEEN_TAN) & (tangent[1:] > UNSEEN_TAN)
    for index in np.flatnonzero(known):
        low, high = sorted((x[index], x[index + 1]))
        first, last = max(int(np.ceil(low)), 0), min(int(np.floor(high)), camera.width_px - 1)
        if first <= last and high > low:
            inside = column[first : last + 1]
            share = (inside - x[index]) / (x[index + 1] - x[index])
            crossing = y[index] + share * (y[index + 1] - y[index])
            row[first : last + 1] = np.minimum(row[first : last + 1], crossing)
    return np.where((row >= -0.5) & (row <= camera.height_px - 0.5), row, np.nan)


PIXELS_PER_BLOCK = 400_000


@dataclass(frozen=True, eq=False)
class Traced:
    """Directions of all pixels and the terrain they show, (H, W) float32 arrays.

    Attributes
    ----------
    turn_deg, tangent : arrays
        Azimuth from the heading [degrees] and tangent of the elevation angle.
    distance_m : array
        Ground distance; inf for sky [m].
    east_m, north_m, elevation_m : arrays
        Position of the ground; NaN for sky [m].
    """

    turn_deg: np.ndarray
    tangent: np.ndarray
    distance_m: np.ndarray
    east_m: np.ndarray
    north_m: np.ndarray
    elevation_m: np.ndarray


def row_blocks(camera):
    """Ranges of rows of about `PIXELS_PER_BLOCK` pixels."""
    height = max(PIXELS_PER_BLOCK // camera.width_px, 1)
    return [range(start, min(start + height, camera.height_px)) for start in range(0, camera.height_px, height)]


def turns_deg(camera, pose):
    """Leftmost and rightmost azimuth in the frame, relative to the heading [degrees]."""
    seen = [pixel_directions(camera, pose, rows)[0] for rows in row_blocks(camera)]
    return float(min(turn.min() for turn in seen)), float(max(turn.max() for turn in seen))


def trace(fan, camera, pose, eye_m, progress):
    """Find the ground behind every pixel.

    Parameters
    ----------
    fan : Fan
    camera : Camera
    pose : Pose
    eye_m : float
        Elevation of the eye [m].
    progress : Progress

    Returns
    -------
    Traced
    """
    shape = camera.height_px, camera.width_px
    fields = [np.empty(shape, np.float32) for _ in range(6)]
    for rows in row_blocks(camera):
        checkpoint(progress, rows.start / camera.height_px)
        turn, tangent = pixel_directions(camera, pose, rows)
        angle = np.radians(pose.heading_deg + turn)
        distance = first_hits_m(fan, (pose.heading_deg + turn).ravel(), tangent.ravel()).reshape(turn.shape)
        reach = np.where(np.isfinite(distance), distance, np.nan)
        elevation = eye_m + reach * tangent + apparent_drop_m(reach, REFRACTION_COEFFICIENT)
        found = turn, tangent, distance, reach * np.sin(angle), reach * np.cos(angle), elevation
        for field, values in zip(fields, found):
            field[rows.start : rows.stop] = values
    return Traced(*fields)
