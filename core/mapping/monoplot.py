"""Monoplotting: from pixels of one oriented photograph to places on the terrain, with an error ellipse.

A pixel's ray is cast to the terrain, and so are the rays of poses drawn from the pose's uncertainty. Their end points
scatter as the true place may, whatever the shape of the ground: a long thin ellipse if the ray grazes it, and two
clouds if it passes an edge with other ground behind it. The ellipse describes the cloud on the pixel's own surface;
`p_other` is the share of the draws that ended elsewhere.

References
----------
.. [1] Bozzini, C., Conedera, M., Krebs, P., A new monoplotting tool to extract georeferenced vector data and
   orthorectified raster data from oblique non-metric photographs, Int. J. Heritage in the Digital Era 1 (2012)
   499-518, doi:10.1260/2047-4970.1.3.499.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.camera import Pose, unproject
from ..base.progress import SILENT, subtask
from ..base.surface import incidence_deg, normal_at
from ..base.uncertainty import pose_draws
from .sightline import GROUND, GroundHits, SightLines, SightOptions, cast_rays

OTHER_SURFACE = 0.1
"""Neighbouring draws may lie on two surfaces if they are farther apart than this share of their distance."""

GAP_RATIO = 8.0
"""They do lie on two surfaces if the gap is also this many times the pixel's usual one."""

PIXELS_AT_ONCE = 4000


@dataclass(frozen=True, eq=False)
class PlacedPixels:
    """Pixels and their places on the ground.

    Attributes
    ----------
    x_px, y_px : (N,) arrays
    hits : GroundHits
    azimuth_deg, elevation_deg : (N,) arrays
        Direction of the rays [degrees].
    incidence_deg : (N,) array
        Angle between the ray and the surface's normal, 0 head-on, 90 grazing [degrees].
    metres_per_pixel : (N,) array
        Size of a pixel across the line of sight [m].
    """

    x_px: np.ndarray
    y_px: np.ndarray
    hits: GroundHits
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    incidence_deg: np.ndarray
    metres_per_pixel: np.ndarray


@dataclass(frozen=True, eq=False)
class GroundEllipse:
    """The ellipse that contains the true place of each pixel with probability `coverage`.

    Attributes
    ----------
    coverage : float
    semi_major_m, semi_minor_m : (N,) arrays
        Half axes around the placed point [m]; NaN if it is not on the ground.
    azimuth_deg : (N,) array
        Azimuth of the major axis, clockwise from true north, in [0, 180) [degrees].
    sigma_z_m : (N,) array
        Standard deviation of the elevation [m].
    near_m, far_m : (N,) arrays
        5 % and 95 % quantiles of the distance over all draws that reach the ground [m].
    p_other : (N,) array
        Share of the draws that end on another surface, beyond an edge, or in the sky.
    """

    coverage: float
    semi_major_m: np.ndarray
    semi_minor_m: np.ndarray
    azimuth_deg: np.ndarray
    sigma_z_m: np.ndarray
    near_m: np.ndarray
    far_m: np.ndarray
    p_other: np.ndarray


def place_pixels(terrain, view, x_px, y_px, options=None, progress=SILENT):
    """Place pixels on the ground.

    Parameters
    ----------
    terrain : Terrain
    view : View
    x_px, y_px : (N,) arrays
        Pixels of the full upright picture, the first one's centre at 0. Pixels outside the picture are placed too.
    options : SightOptions or None
    progress : Progress

    Returns
    -------
    PlacedPixels
    """
    options = _with_refraction(options, view)
    x_px, y_px = np.asarray(x_px, float), np.asarray(y_px, float)
    azimuth, elevation = view.ray_of(x_px, y_px)
    hits = cast_rays(terrain, view.frame, SightLines(view.eye_elevation_m, azimuth, elevation), options, progress)
    normal = normal_at(terrain, view.frame, hits.east_m, hits.north_m)
    slant = hits.distance_m / np.cos(np.radians(elevation))
    per_pixel = slant * _radians_per_pixel(view, x_px, y_px)
    return PlacedPixels(x_px, y_px, hits, azimuth, elevation, incidence_deg(normal, azimuth, elevation), per_pixel)


def _with_refraction(options, view):
    return replace(options or SightOptions(), refraction_coefficient=view.refraction_coefficient)


def _radians_per_pixel(view, x_px, y_px):
    """Angle between rays half a pixel to the left and right; smaller than 1 / focal towards the corners."""
    a1, e1 = np.radians(view.ray_of(x_px - 0.5, y_px))
    a2, e2 = np.radians(view.ray_of(x_px + 0.5, y_px))
    half = np.sin((e2 - e1) / 2) ** 2 + np.cos(e1) * np.cos(e2) * np.sin((a2 - a1) / 2) ** 2
    return 2 * np.arcsin(np.sqrt(half))


@dataclass(frozen=True)
class EllipseOptions:
    """How the errors of placed pixels are computed.

    Attributes
    ----------
    coverage : float
        Probability that the ellipse contains the true place.
    pairs : int
        Half the number of draws per pixel.
    """

    coverage: float = 0.9
    pairs: int = 24

    def __post_init__(self):
        if not 0 < self.coverage < 1:
            raise ValueError(f"coverage must lie between 0 and 1, not {self.coverage}")


def ground_ellipses(terrain, view, placed, ellipse=EllipseOptions(), options=None, progress=SILENT):  # noqa: B008
    """Propagate the uncertainty of pose, position and DEM to the places of pixels.

    Parameters
    ----------
    terrain : Terrain
    view : View
        View of a photograph with its uncertainty.
    placed : PlacedPixels
        Result of `place_pixels` for the same view.
    ellipse : EllipseOptions
    options : SightOptions or None
    progress : Progress

    Returns
    -------
    GroundEllipse
    """
    options = _with_refraction(options, view)
    uncertainty, coverage = view.uncertainty, ellipse.coverage
    draws = pose_draws(uncertainty, ellipse.pairs)
    count = placed.x_px.size
    columns = np.full((7, count), np.nan)
    ground = np.flatnonzero(placed.hits.state.ravel() == GROUND)
    for start in range(0, ground.size, PIXELS_AT_ONCE):
        part = ground[start : start + PIXELS_AT_ONCE]
        share = subtask(progress, start / ground.size, (start + part.size) / ground.size)
        pixels = placed.x_px.ravel()[part], placed.y_px.ravel()[part]
        cloud = _cloud(terrain, view, pixels, draws, options, share)
        nominal = [column.ravel()[part] for column in (placed.hits.east_m, placed.hits.north_m)]
        distance = placed.hits.distance_m.ravel()[part]
        columns[:, part] = _summarise(cloud, nominal, distance, uncertainty.dem_m, coverage)
    return GroundEllipse(coverage, *columns.reshape((7,) + placed.x_px.shape))


def _cloud(terrain, view, pixels, draws, options, progress):
    """End points (D, N) of the drawn rays through pixels (x, y)."""
    rays = np.empty((2, len(draws), pixels[0].size))
    for k, (heading, pitch, roll, log_focal, *_) in enumerate(draws):
        pose = Pose(view.pose.heading_deg + heading, view.pose.pitch_deg + pitch, view.pose.roll_deg + roll)
        camera = replace(view.camera, focal_px=view.camera.focal_px * float(np.exp(log_focal)))
        rays[:, k] = unproject(camera, pose, *pixels)
    east, north, height = (draws[:, k, None] for k in (4, 5, 6))
    lines = SightLines(view.eye_elevation_m + height, rays[0], rays[1], east, north)
    return cast_rays(terrain, view.frame, lines, options, progress)


def _summarise(cloud, nominal, distance_m, dem_m, coverage):
    same = _same_surface(cloud, distance_m)
    enough = same.sum(axis=0) >= 5
    weight = np.where(enough, same, np.nan) / np.where(enough, same.sum(axis=0), 1)
    east, north = (np.where(same, value, 0.0) - np.where(same, place, 0.0)
                   for value, place in zip((cloud.east_m, cloud.north_m), nominal))  # fmt: skip
    ee, nn, en = ((weight * product).sum(axis=0) for product in (east * east, north * north, east * north))
    middle, split = (ee + nn) / 2, np.hypot((ee - nn) / 2, en)
    scale = -2 * np.log(1 - coverage)  # quantile of chi squared with two degrees of freedom
    major, minor = np.sqrt(scale * (middle + split)), np.sqrt(scale * np.maximum(middle - split, 0))
    azimuth = np.mod(np.degrees(np.arctan2(2 * en, nn - ee)) / 2, 180.0)
    z = np.where(same, cloud.elevation_m, 0.0)
    mean_z = (weight * z).sum(axis=0)
    sigma_z = np.sqrt((weight * np.where(same, z - mean_z, 0.0) ** 2).sum(axis=0) + dem_m**2)
    with np.errstate(invalid="ignore"):
        near, far = np.nanquantile(np.vstack([cloud.distance_m, distance_m]), (0.05, 0.95), axis=0)
    return np.array([major, minor, azimuth, sigma_z, near, far, 1 - same.mean(axis=0)])


def _same_surface(cloud, distance_m):
    """(D, N) bool array: draws that end on the same surface as the pixel itself.

    Sorted by distance, the draws of one pixel are divided into groups at each gap that is both a large share of the
    distance and much wider than the usual step. The group that contains the pixel's own point is its surface.
    """
    everything = np.vstack([distance_m, cloud.distance_m])
    order = np.argsort(everything, axis=0)
    sorted_log = np.log(np.take_along_axis(everything, order, axis=0))
    gap = np.diff(sorted_log, axis=0)
    with np.errstate(invalid="ignore"):
        usual = np.nanmedian(gap, axis=0)
        cut = (gap > OTHER_SURFACE) & (gap > GAP_RATIO * usual)
    group_sorted = np.vstack([np.zeros((1, gap.shape[1]), int), np.cumsum(cut, axis=0)])
    group = np.empty_like(group_sorted)
    np.put_along_axis(group, order, group_sorted, axis=0)
    return (cloud.state == GROUND) & (group[1:] == group[0])
