r"""Inner ridges: lines along which the visible terrain hides terrain farther away, around one observer.

Along each ray the surface is visible where its tangent exceeds all nearer ones. It disappears behind a crest and
reappears farther away::

      eye *            crest
           `-..      _/\  hidden   _ - - seen again: the distance jumps
               `--../    \_______/

A photograph shows crests as lines inside the terrain. The larger the jump in distance, the sharper the line, since
haze, light and texture change with the distance.
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
        A crest is kept if the terrain seen next is at least this many times farther away,
    least_depth_deg : float
        and if the hidden ground lies at least this far below the line of sight [degrees].
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
    distance_m : distance of the crest [m].
    jump : distance of the terrain seen above the crest, divided by the distance of the crest.
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    jump: np.ndarray


def occlusion_edges(rays, options=RidgeOptions()):  # noqa: B008 - frozen
    """Find the crests in view of an observer, except the horizon itself.

    Parameters
    ----------
    rays : GroundRays
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
    """Lowest tangent strictly between two samples of a ray: the deepest point of the hidden ground."""
    if len(ray) == 0:
        return np.zeros(0)
    bounds = np.stack([ray * tangent.shape[1] + near + 1, ray * tangent.shape[1] + far], axis=1).ravel()
    flat = np.append(np.where(np.isfinite(tangent), tangent, np.inf).ravel(), np.inf)
    return np.minimum.reduceat(flat, bounds)[::2]
