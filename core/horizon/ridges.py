r"""Inner ridges: where the terrain in view hides farther terrain, around one observer.

Along each ray the surface is visible where its tangent exceeds all nearer ones. It stops being visible behind a
crest and comes back farther away::

      eye *            crest
           `-..      _/\  hidden   _ - - seen again: the distance jumps
               `--../    \_______/

Crests are what a photograph shows as lines inside the terrain, the sharper the larger the jump in distance, since
haze, light and texture change with it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class RidgeOptions:
    """Which crests count.

    Attributes
    ----------
    least_jump : float
        Crests are kept where the terrain seen next is this many times farther.
    least_depth_deg : float
        And where what is hidden lies this far below the line of sight [degrees].
    """

    least_jump: float = 1.1
    least_depth_deg: float = 0.05

    def __post_init__(self):
        if self.least_jump <= 1:
            raise ValueError(f"unusable search for ridges {self}")


@dataclass(frozen=True, eq=False)
class RidgeEdges:
    """Crests around one observer; (N,) arrays.

    Attributes
    ----------
    azimuth_deg, elevation_deg : clockwise from true north, and above the horizontal [degrees].
    distance_m : of the crest [m].
    jump : distance of what is seen above it over its own.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    jump: np.ndarray


def occlusion_edges(rays, options=RidgeOptions()):  # noqa: B008 - frozen
    """Find the crests in view of an observer, the horizon itself excepted.

    Parameters
    ----------
    rays : ground_rays.GroundRays
        Voids end a ray.
    options : RidgeOptions

    Returns
    -------
    RidgeEdges
        Sorted by azimuth.
    """
    azimuth, distance = rays.azimuth_deg, rays.distance_m
    if not len(distance):
        return RidgeEdges(*np.zeros((4, 0)))
    tangent = np.where(np.isfinite(rays.tangent), rays.tangent, -np.inf)
    highest = np.maximum.accumulate(tangent, axis=1)
    visible = np.isfinite(tangent)
    visible[:, 1:] &= tangent[:, 1:] >= highest[:, :-1]
    # Index of the next visible sample at or behind each one; len(distance) where there is none.
    index = np.where(visible, np.arange(len(distance)), len(distance))
    following = np.minimum.accumulate(index[:, ::-1], axis=1)[:, ::-1]
    crest = np.zeros_like(visible)
    crest[:, :-1] = visible[:, :-1] & ~visible[:, 1:]
    ray, near = np.nonzero(crest)
    far = following[ray, near + 1]
    seen_again = far < len(distance)
    ray, near, far = ray[seen_again], near[seen_again], far[seen_again]
    jump = distance[far] / distance[near]
    depth = tangent[ray, near] - _lowest_between(tangent, ray, near, far)
    kept = (jump >= options.least_jump) & (depth >= np.tan(np.radians(options.least_depth_deg)))
    ray, near = ray[kept], near[kept]
    elevation = np.degrees(np.arctan(tangent[ray, near]))
    return RidgeEdges(azimuth[ray], elevation, distance[near], jump[kept])


def _lowest_between(tangent, ray, near, far):
    """Lowest tangent strictly between two samples of a ray; the hidden ground's deepest point."""
    if len(ray) == 0:
        return np.zeros(0)
    bounds = np.stack([ray * tangent.shape[1] + near + 1, ray * tangent.shape[1] + far], axis=1).ravel()
    flat = np.append(np.where(np.isfinite(tangent), tangent, np.inf).ravel(), np.inf)
    return np.minimum.reduceat(flat, bounds)[::2]
