r"""Sky view factor of a point's horizon, and of every cell of an area.

The factor is the share of the light of an evenly bright sky that reaches a facet past the terrain, weighted by the
cosine of incidence::

        1   /                                                        H  zenith angle of the horizon
    V = --- | cos S sin^2 H + sin S cos(phi - A) (H - sin H cos H) dphi    S, A  slope and aspect of the facet
       2 pi /

References
----------
.. [1] Dozier, J., Frew, J. (1990). Rapid calculation of terrain parameters for radiation modeling from digital
   elevation data. IEEE Trans. Geosci. Remote Sens. 28, 963-969, doi:10.1109/36.58986 (eq. 7b).
.. [2] Steger, C. R., Steger, B., Schaer, C. (2022). HORAYZON v1.2. Geosci. Model Dev. 15, 6817-6840,
   doi:10.5194/gmd-15-6817-2022: the facet's own plane bounds the sky as terrain does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..base.angles import difference
from ..base.curvature import REFRACTION_COEFFICIENT, apparent_drop_m
from ..base.progress import SILENT, checkpoint
from ..base.terrain import Window


def sky_view_of_horizon(azimuth_deg, horizon_deg, slope_deg=0.0, aspect_deg=0.0):
    """Sky view factor of one facet.

    Parameters
    ----------
    azimuth_deg : (A,) array
        Regular over the circle, clockwise from true north [degrees].
    horizon_deg : (A, ...) array
        Elevation angle of the horizon [degrees]; NaN (nothing known) and less than 0 count as the horizontal.
    slope_deg, aspect_deg : float or array
        Inclination of the facet and the azimuth to which it falls [degrees]; shape of the horizon's further axes.

    Returns
    -------
    float or array
        0 to 1; (1 + cos S) / 2 for an unobstructed facet.
    """
    horizon = np.nan_to_num(np.asarray(horizon_deg, float), nan=0.0)
    azimuth = np.asarray(azimuth_deg, float).reshape((-1,) + (1,) * (horizon.ndim - 1))
    slope, turn = np.radians(slope_deg), np.radians(difference(azimuth, aspect_deg))
    # Uphill, the facet's own plane blocks the sky. Below the horizontal there is haze and ground, but no sky.
    plane = np.arctan(-np.tan(slope) * np.cos(turn))
    zenith = np.pi / 2 - np.maximum(np.maximum(np.radians(horizon), 0.0), plane)
    part = np.cos(slope) * np.sin(zenith) ** 2
    part = part + np.sin(slope) * np.cos(turn) * (zenith - np.sin(zenith) * np.cos(zenith))
    return np.clip(part.mean(axis=0), 0.0, 1.0)[()]


def sky_view_factor(profile, slope_deg=0.0, aspect_deg=0.0):
    """Sky view factor of a horizon profile's observer.

    Parameters
    ----------
    profile : HorizonProfile
    slope_deg, aspect_deg : float
        Slope of the observer's facet, and the azimuth that it faces [degrees]; level by default.
    """
    return float(sky_view_of_horizon(profile.azimuth_deg, profile.elevation_deg, slope_deg, aspect_deg))


@dataclass(frozen=True)
class SkyViewOptions:
    """How to compute the sky view factors of an area.

    Attributes
    ----------
    azimuths : int
        Number of directions searched.
    max_distance_m : float
        Search range [m].
    step_growth : float
        Samples lie one cell apart at first; each step is longer by this share of the distance.
    inclined : bool
        True for the cells' own facets, False for level ones.
    refraction_coefficient : float
        k of `apparent_drop_m`.
    tile : int
        Cells per side that are processed at once.
    """

    azimuths: int = 32
    max_distance_m: float = 10_000.0
    step_growth: float = 0.05
    inclined: bool = True
    refraction_coefficient: float = REFRACTION_COEFFICIENT
    tile: int = 256

    def __post_init__(self):
        if self.azimuths < 4 or not self.max_distance_m > 0 or not 0 <= self.step_growth <= 1 or self.tile < 8:
            raise ValueError(f"sky view options out of range: {self}")


def sky_view_raster(terrain, window, options=SkyViewOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Sky view factor of every cell of a window, tile by tile.

    Parameters
    ----------
    terrain : Terrain
        Terrain that offers `position_of`.
    window : Window
    options : SkyViewOptions
    progress : Progress

    Yields
    ------
    window : Window
        A tile.
    factor : (rows, cols) float32 array
        NaN where the DEM has no data. Directions and distances are true ones at the tile's centre.

    Notes
    -----
    The tiling affects the result only through the drift of the grid's scale and north within a tile.
    """
    rows = range(window.row, window.row + window.rows, options.tile)
    cols = range(window.col, window.col + window.cols, options.tile)
    for done, (row, col) in enumerate((row, col) for row in rows for col in cols):
        checkpoint(progress, done / (len(rows) * len(cols)))
        tile = Window(row, col, options.tile, options.tile)
        last = Window(
            row, col, min(tile.rows, window.row + window.rows - row), min(tile.cols, window.col + window.cols - col)
        )
        yield last, _tile(terrain, last, options)


def _tile(terrain, tile, options):
    centre = tile.col + (tile.cols - 1) / 2, tile.row + (tile.rows - 1) / 2
    longitude, latitude = (float(value) for value in terrain.position_of(*centre))
    frame = terrain.frame(longitude, latitude, max(options.max_distance_m, 1000.0))
    jacobian = frame.jacobian_px_per_m
    margin = int(np.ceil(options.max_distance_m * np.abs(jacobian).sum(axis=1).max())) + 2
    cells = _with_margin(terrain, tile, margin)
    ground = cells[margin:-margin, margin:-margin]
    azimuth = np.arange(options.azimuths) * (360.0 / options.azimuths)
    horizon = np.stack([_horizon(cells, ground, margin, np.radians(one), frame, options) for one in azimuth])
    slope, aspect = _facets(cells, margin, jacobian) if options.inclined else (0.0, 0.0)
    factor = sky_view_of_horizon(azimuth, horizon, slope, aspect).astype(np.float32)
    return np.where(np.isnan(ground), np.float32(np.nan), factor)


def _with_margin(terrain, tile, margin):
    """Cells of a tile and of a margin around it, NaN beyond the raster."""
    wanted = Window(tile.row - margin, tile.col - margin, tile.rows + 2 * margin, tile.cols + 2 * margin)
    inside = wanted.clipped(terrain.shape)
    cells = np.full((wanted.rows, wanted.cols), np.nan, np.float32)
    row, col = inside.row - wanted.row, inside.col - wanted.col
    cells[row : row + inside.rows, col : col + inside.cols] = terrain.read(inside)
    return cells


def _horizon(cells, ground, margin, azimuth, frame, options):
    """Horizon of all cells of a tile in one direction [degrees], found by shifting the tile along the ray."""
    highest = np.full(ground.shape, -np.inf, np.float32)
    along = frame.jacobian_px_per_m @ [np.sin(azimuth), np.cos(azimuth)]
    distance = frame.cell_m
    while distance <= options.max_distance_m:
        # Rounded, so that noise in the twelfth digit gives no weight to a void beside a cell that is hit exactly.
        rise = _shifted(
            cells, ground.shape, margin + round(along[1] * distance, 6), margin + round(along[0] * distance, 6)
        )
        rise -= ground
        rise -= np.float32(apparent_drop_m(distance, options.refraction_coefficient))
        rise *= np.float32(1 / distance)
        np.fmax(highest, rise, out=highest)
        distance += max(frame.cell_m, options.step_growth * distance)
    return np.degrees(np.arctan(np.where(np.isfinite(highest), highest, np.float32(0.0))))


def _shifted(cells, shape, row_px, col_px):
    """Bilinear elevations of a grid of `shape` whose first place is (row, column).

    All places have the same weights, so whole slices are added; `bilinear` would look up each place.
    """
    total = None
    for row, row_weight in _weights(row_px):
        for col, col_weight in _weights(col_px):
            part = cells[row : row + shape[0], col : col + shape[1]] * np.float32(row_weight * col_weight)
            total = part if total is None else np.add(total, part, out=total)
    return total


def _weights(place_px):
    """The one or two whole pixels around a place, and their weights."""
    first = int(np.floor(place_px))
    share = place_px - first
    return ((first, 1 - share), (first + 1, share)) if share > 0 else ((first, 1.0),)


def _facets(cells, margin, jacobian):
    """Slope and aspect of a tile's cells [degrees], by central differences in true metres; one-sided at edges."""
    low, high = slice(margin - 1, -margin - 1), slice(margin + 1, -margin + 1 or None)
    middle = slice(margin, -margin)
    ground = cells[middle, middle]
    per_row = _difference(cells[low, middle], ground, cells[high, middle])
    per_col = _difference(cells[middle, low], ground, cells[middle, high])
    east = per_col * jacobian[0, 0] + per_row * jacobian[1, 0]
    north = per_col * jacobian[0, 1] + per_row * jacobian[1, 1]
    return np.degrees(np.arctan(np.hypot(east, north))), np.degrees(np.arctan2(-east, -north))


def _difference(before, here, after):
    """Rise per cell, from both neighbours or from the one that is known; 0 if neither is."""
    return np.nan_to_num(np.where(np.isnan(before), after - here, np.where(np.isnan(after), here - before,
                                                                           (after - before) / 2)))  # fmt: skip
