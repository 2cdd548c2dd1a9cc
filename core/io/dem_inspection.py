"""Find out whether a raster holds heights, before anything is computed with it."""

from __future__ import annotations

import os
import re

import numpy as np
from osgeo import gdal

from ..base.errors import UnusableDemError
from ..base.messages import Message
from ..base.terrain import Window
from .gdal_quiet import quiet_gdal

STRIP_BYTES = 16 * 2**20

SEARCHED_CELLS = 500_000_000
"""Number of cells searched for a valid one before a raster counts as empty, which takes some seconds."""

LOWLAND_M = 100.0
"""Terrain with 99 % of its cells above this has no sea, so that zeros along its edges are missing data [m]."""

COLOURS = (gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_AlphaBand)

TERRAIN_RGB = {
    "Mapbox": (lambda r, g, b: -10000 + 0.1 * (65536 * r + 256 * g + b), "-10000+0.1*(65536*R+256*G+B)"),
    "Terrarium": (lambda r, g, b: 256 * r + g + b / 256 - 32768, "256*R+G+B/256-32768"),
}
"""Encodings of heights in the colours of map tiles: the function, and its text for the raster calculator."""

DERIVED_VALUES = (-1.5, 360.5)
"""Slopes, shades and aspects lie in this range."""

TERRAIN_SMOOTHNESS, NAMED_SMOOTHNESS = 0.985, 0.997
"""Correlation of neighbouring cells below which values of that range are not heights. For eleven DEMs it is 0.995 or
more, for slope, hillshade and aspect maps of them 0.52 to 0.98. The second one holds if the file's name says so too."""

DERIVED_NAMES = re.compile(r"hill_?shad|shaded|slope|aspect|roughness|\btri\b|\btpi\b|neigung|pente", re.IGNORECASE)

LEAST_CELLS = 1000
"""Fewer cells of a sample say nothing about the smoothness of the whole."""

BEYOND_EARTH = 2e6
"""Values above the highest mountain, but below this, are heights in a smaller unit if there are many different ones."""

BEYOND_SHARE, BEYOND_DIFFERENT = 0.02, 20


def check_colours(path, dataset, band, chosen_unit):
    """Raise `UnusableDemError` for a palette, a picture, and for 8 bits unless a unit was chosen.

    Parameters
    ----------
    path : str
        Path of the DEM, for the error message.
    dataset : osgeo.gdal.Dataset
    band : int
        Number of the band, from 1.
    chosen_unit : str, float or None
        Unit of the heights that the user has set.
    """
    chosen = dataset.GetRasterBand(band)
    if chosen.DataType != gdal.GDT_Byte:
        return
    if chosen.GetColorTable() is not None:
        reason = Message(
            "The DEM {path} is a picture with a colour palette, not a raster of heights. Choose the elevation raster "
            "itself.",
            path=path,
        )
        raise UnusableDemError(reason)
    if dataset.RasterCount >= 3 and chosen.GetColorInterpretation() in COLOURS:
        _refuse_picture(path, dataset)
    plain = chosen.GetScale() in (None, 1.0) and not chosen.GetUnitType()
    if plain and chosen_unit is None:
        reason = Message(
            "The DEM {path} has only 8 bits per cell, like a hillshade or another picture of the terrain. Choose the "
            "elevation raster itself; if these are heights, set their unit (DEM_UNIT).",
            path=path,
        )
        raise UnusableDemError(reason)


def _refuse_picture(path, dataset):
    for name, (height_of, formula) in TERRAIN_RGB.items():
        if _is_encoded(dataset, height_of):
            reason = Message(
                "The DEM {path} holds heights encoded as colours (terrain-RGB, {name}). Decode them first with the "
                "raster calculator: {formula}, where R, G and B are the bands.",
                path=path,
                name=name,
                formula=formula,
            )
            raise UnusableDemError(reason)
    raise UnusableDemError(
        Message(
            "The DEM {path} is a colour picture (red, green, blue), not a raster of heights. Choose the elevation "
            "raster itself.",
            path=path,
        )
    )


def _is_encoded(dataset, height_of):
    """Tell whether the colours give possible heights, and smooth ones, when they are decoded."""
    rows, cols = min(dataset.RasterYSize, 256), min(dataset.RasterXSize, 256)
    row, col = (dataset.RasterYSize - rows) // 2, (dataset.RasterXSize - cols) // 2
    with quiet_gdal():
        try:
            red, green, blue = (
                dataset.GetRasterBand(band).ReadAsArray(col, row, cols, rows).astype(float) for band in (1, 2, 3)
            )
        except (RuntimeError, AttributeError):
            return False
    height = height_of(red, green, blue)
    possible = (height > -500) & (height < 9000)
    if possible.mean() < 0.5 or blue.max() - blue.min() < 100:
        return False
    step = np.abs(np.diff(height, axis=1))[possible[:, 1:] & possible[:, :-1]]
    return bool(len(step) and np.median(step) < 0.1 * max(np.ptp(height[possible]), 50.0))


def inspect(dem):
    """Refuse a raster without a valid cell or without heights; tell whether zero means missing data.

    Parameters
    ----------
    dem : core.io.raster.Dem

    Returns
    -------
    bool
        Whether zeros lie untagged along the edges of a highland.

    Raises
    ------
    UnusableDemError
    """
    patches, edge = _sample(dem)
    sample = np.concatenate([patch.ravel() for patch in patches])
    valid = sample[np.isfinite(sample)]
    if dem.reading.unit is None:
        _check_range(dem)
        _check_smoothness(dem, patches, valid)
    if valid.size == 0 and not _any_valid(dem):
        raise UnusableDemError(
            Message(
                "Band {band} of the DEM {path} has no valid cell. Choose another DEM.", band=dem.band, path=dem.path
            )
        )
    land = valid[valid != 0]
    return bool((edge == 0).any() and land.size >= 100 and np.percentile(land, 1) > LOWLAND_M)


def _check_range(dem):
    """Refuse heights beyond those of the earth, which are in decimetres or a smaller unit."""
    values = dem.raw_sample()
    beyond = values[(values > 9000) & (values < BEYOND_EARTH)]
    beyond = beyond[beyond > dem.highest_value]
    if len(beyond) < BEYOND_SHARE * len(values) or len(np.unique(beyond)) < BEYOND_DIFFERENT:
        return
    raise UnusableDemError(
        Message(
            "The DEM {path} has values up to {highest}, which are no heights in metres: perhaps they are decimetres or "
            "centimetres. Set their unit (DEM_UNIT).",
            path=dem.path,
            highest=f"{beyond.max():.0f}",
        )
    )


def _check_smoothness(dem, patches, valid):
    """Refuse slopes, shades and aspects: within the range of these, and rougher than heights can be."""
    if valid.size < LEAST_CELLS or valid.min() < DERIVED_VALUES[0] or valid.max() > DERIVED_VALUES[1]:
        return
    spread = float(np.var(valid.astype(float)))
    steps = np.concatenate([np.diff(patch.astype(float), axis=1).ravel() for patch in patches])
    steps = steps[np.isfinite(steps)]
    # Where most neighbours are equal, a few cells decide the smoothness: a plain with a tower, or a lake.
    if spread <= 0 or not len(steps) or np.median(np.abs(steps)) == 0:
        return
    smoothness = 1 - float(np.mean(steps**2)) / (2 * spread)
    named = DERIVED_NAMES.search(f"{os.path.basename(dem.path)} {dem.description}")
    if smoothness >= (NAMED_SMOOTHNESS if named else TERRAIN_SMOOTHNESS):
        return
    raise UnusableDemError(
        Message(
            "The values of the DEM {path} lie between {low} and {high} and change from cell to cell like those of a "
            "hillshade, slope or aspect map, not like heights. Choose the elevation raster itself; if these are "
            "heights, set their unit (DEM_UNIT).",
            path=dem.path,
            low=f"{valid.min():.0f}",
            high=f"{valid.max():.0f}",
        )
    )


def windows(shape, side=9, patch=16):
    """Give `side` x `side` small windows of a raster, evenly spread with the corners.

    Parameters
    ----------
    shape : (rows, columns)
    side : int
        Number of windows along either axis.
    patch : int
        Cells along the side of a window.
    """
    rows, cols = shape
    return [
        Window(int(row), int(col), patch, patch).clipped(shape)
        for row in np.unique(np.linspace(0, max(rows - patch, 0), side).astype(int))
        for col in np.unique(np.linspace(0, max(cols - patch, 0), side).astype(int))
    ]


def _sample(dem):
    """Read small windows; give their cells, and those at the raster's edge."""
    rows, cols = dem.shape
    patches, edge = [], []
    for window in windows(dem.shape):
        cells = dem.read(window)
        patches.append(cells)
        if window.row == 0:
            edge.append(cells[0])
        if window.col == 0:
            edge.append(cells[:, 0])
        if window.row + window.rows >= rows:
            edge.append(cells[-1])
        if window.col + window.cols >= cols:
            edge.append(cells[:, -1])
    return patches, np.concatenate(edge)


def _any_valid(dem):
    """Search strips for a valid cell: all of them up to `SEARCHED_CELLS`, else evenly spaced ones."""
    rows, cols = dem.shape
    height = dem.block_rows
    height *= max(STRIP_BYTES // (4 * cols * height), 1)
    starts = np.arange(0, rows, height)
    most = max(SEARCHED_CELLS // (height * cols), 1)
    if len(starts) > most:
        starts = starts[np.linspace(0, len(starts) - 1, most).astype(int)]
    return any(np.isfinite(dem.read(Window(int(row), 0, height, cols).clipped(dem.shape))).any() for row in starts)
