"""More than visible or hidden: distance, elevation angle, clearance and image position of every cell.

Distance, angle and image position follow from the geometry alone and are computed piece by piece. The clearance needs
the lines of sight and therefore a sweep of its own, in which no hidden ground can be skipped.
"""

from __future__ import annotations

import numpy as np

from ..base.camera import project, unproject
from ..base.curvature import apparent_drop_m
from ..base.progress import SILENT
from ..base.terrain import Window
from ..base.viewed import ArraySink
from .sector import FullCircle
from .viewshed import ViewshedOptions, viewshed

TILE_ROWS = 256

LAYERS = ("m", "degrees", "m", "px", "px")
"""Units of the layers of `sector_layers`: distance, elevation angle, height above the line of sight, and column and row
in the photograph, if there is one."""

NOTHING_BETWEEN_M = 9999.0
"""Height above the line of sight of cells next to the eye, which no ground obstructs [m]."""


class ClearanceSink(ArraySink):
    """Height of each cell, target height included, above the line of sight that passes over it [m].

    A negative value is the height by which the target must rise to be seen. NaN where the DEM has no data, huge where
    nothing lies between, exactly 0 where the cell is outside the range or the sector.
    """

    def __init__(self, window):
        super().__init__(window, np.float32)

    def set(self, row, col, value):
        """See `Sink.set`. The observer's own cell, which has no line of sight, stays as it is."""


def clearance(terrain, observer, sector=FullCircle(), options=ViewshedOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Compute the height of cells above (+) or below (-) their line of sight.

    Parameters
    ----------
    terrain, observer, sector, options, progress
        As for `viewshed`. Only the azimuths of a sector count, with a margin of a few rays.

    Returns
    -------
    Viewshed
        `values` float32 (rows, cols) [m], see `ClearanceSink`.
    """
    return viewshed(terrain, observer, sector, options, progress, ClearanceSink)


def layers(terrain, seen, photo=None):
    """Compute the geometry of the cells of a viewshed's window, strip by strip.

    Parameters
    ----------
    terrain : Terrain
    seen : Viewshed
    photo : PosedPhoto or None
        Photograph whose pixel positions are added, if any.

    Yields
    ------
    window : Window
        A strip of the raster.
    values : dict of (rows, cols) float32 arrays
        'distance_m'; 'azimuth_deg'; 'elevation_deg', the angle at which the target on the cell appears; with
        a photograph 'column_px' and 'row_px', NaN behind the camera. NaN where the DEM has no data.
    """
    window, frame, options = seen.window, seen.frame, seen.options
    for first in range(0, window.rows, TILE_ROWS):
        strip = Window(window.row + first, window.col, min(TILE_ROWS, window.rows - first), window.cols)
        elevation = terrain.read(strip)
        row = np.arange(strip.row, strip.row + strip.rows)[:, None]
        col = np.arange(strip.col, strip.col + strip.cols)[None, :]
        east, north = frame.to_local(col, row)
        distance = np.hypot(east, north)
        drop = apparent_drop_m(distance, options.refraction_coefficient) if options.curvature else 0.0
        rise = elevation + options.target_height_m - seen.eye_elevation_m - drop
        values = {
            "distance_m": distance,
            "azimuth_deg": np.degrees(np.arctan2(east, north)) % 360.0,
            "elevation_deg": np.degrees(np.arctan2(rise, distance)),
        }
        if photo is not None:
            place = project(photo.camera, photo.pose, values["azimuth_deg"], values["elevation_deg"])
            values["column_px"], values["row_px"] = place
        void = np.isnan(elevation)
        yield strip, {name: np.where(void, np.nan, one).astype(np.float32) for name, one in values.items()}


def sector_layers(terrain, seen, lifted, photo=None):
    """Compute the layers of the cells in a viewshed's sector and range, visible or not, strip by strip.

    Parameters
    ----------
    terrain : Terrain
    seen : Viewshed
    lifted : Viewshed
        Result of `clearance` for the same window.
    photo : PosedPhoto or None
        Photograph whose pixel positions are added, if any.

    Yields
    ------
    window : Window
        A strip of the raster.
    values : list of (rows, cols) float32 arrays
        In the order of `LAYERS`; NaN outside the sector and the range, and where the DEM has no data.
    """
    options, sector = seen.options, seen.sector
    for strip, values in layers(terrain, seen, photo):
        distance = values["distance_m"]
        first = strip.row - seen.window.row
        above = np.minimum(lifted.values[first : first + strip.rows], np.float32(NOTHING_BETWEEN_M))
        above[above == 0] = np.nan  # in the sweep's own margin around the sector, or the eye's own cell
        with np.errstate(invalid="ignore"):
            inside = (distance >= options.min_distance_m) & (distance <= options.max_distance_m)
        inside[inside] = sector.accepts(
            *(values[name][inside].astype(float) for name in ("azimuth_deg", "elevation_deg", "distance_m"))
        )
        bands = [distance, values["elevation_deg"], above]
        bands += [] if photo is None else [values["column_px"], values["row_px"]]
        yield strip, [np.where(inside, band, np.float32(np.nan)) for band in bands]


def terrain_share(camera, pose, horizon, grid=64):
    """Compute the share of the photograph's frame that the DEM explains as ground.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    horizon : HorizonProfile
    grid : int
        Samples along each side of the frame.

    Returns
    -------
    terrain : float
        Share of the pixels that point below the DEM's horizon.
    unknown : float
        Share of the pixels above it where the horizon is unknown, clipped or void, so that there may be ground.
    """
    x = (np.arange(grid) + 0.5) / grid * camera.width_px - 0.5
    y = (np.arange(grid) + 0.5) / grid * camera.height_px - 0.5
    azimuth, elevation = unproject(camera, pose, *np.meshgrid(x, y))
    nearest = np.rint(azimuth / 360.0 * len(horizon.azimuth_deg)).astype(int) % len(horizon.azimuth_deg)
    height = horizon.elevation_deg[nearest]
    with np.errstate(invalid="ignore"):
        ground = elevation <= height
    doubtful = ~ground & (np.isnan(height) | horizon.clipped[nearest] | horizon.void[nearest])
    return float(ground.mean()), float(doubtful.mean())
