"""One photograph's viewshed as a file of its own, which a repeated run recognises and does not compute again.

A file carries the fingerprint of everything that its result depends on. It takes its name only when it is whole, so
that a run killed at any moment leaves finished files and none that only looks like one.
"""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass

import numpy as np
from osgeo import gdal

from ..base.terrain import Window
from .gdal_quiet import open_quietly, quiet_gdal
from .write_raster import new_raster

VERSION = 1
"""Raised when the engine's results change, so that older files are computed anew."""

UNKNOWN = 255
STRIP_ROWS = 1024
KEY = "SKYLINE_VIEWSHED_FINGERPRINT"


@dataclass(frozen=True, eq=False)
class StoredViewshed:
    """What a file holds: window of the DEM, and values as in `core.viewshed.viewshed.Viewshed`."""

    window: Window
    values: np.ndarray

    @property
    def visible(self):
        """(rows, cols) bool: cells that are certainly seen."""
        return self.values == 1


def fingerprint(dem, observer, sector, options, *others):
    """Digest of all that a viewshed depends on: the DEM's file and band, observer, sector, options, engine, others.

    A changed DEM is noticed by its size and time of change, as by `make`.
    """
    facts = [VERSION, *_file_facts(dem), dem.shape, dem.geotransform, dem.crs_wkt, observer, options]
    facts += [type(sector).__name__, *(_plain(value) for value in vars(sector).values()), *others]
    return hashlib.sha256(repr(facts).encode()).hexdigest()[:32]


def _file_facts(dem):
    try:
        state = os.stat(dem.path)
    except OSError:  # not a plain file: a database, an archive
        return dem.path, dem.band
    return os.path.abspath(dem.path), dem.band, state.st_size, state.st_mtime_ns


def _plain(value):
    """Arrays in full: their usual text leaves out the middle."""
    return hashlib.sha256(value.tobytes()).hexdigest() if isinstance(value, np.ndarray) else value


def write_viewshed(path, viewshed, dem, mark, metadata=None):
    """Write a viewshed with its fingerprint, whole or not at all.

    Raises
    ------
    OutputError
    """
    facts = {**(metadata or {}), KEY: mark}
    with new_raster(path, dem, viewshed.window, dtype="uint8", nodata=UNKNOWN, metadata=facts) as file:
        for row in range(0, viewshed.window.rows, STRIP_ROWS):
            file.write(viewshed.values[row : row + STRIP_ROWS, :], row)


class _WholeArray:
    """Holds what is read, as `core.viewshed.viewshed.ArraySink` does."""

    def __init__(self, window):
        self.window, self.values = window, np.empty((window.rows, window.cols), np.uint8)

    def add(self, window, values):
        row = window.row - self.window.row
        self.values[row : row + window.rows] = values


def read_viewshed(path, dem, mark, hold=_WholeArray):
    """Give the stored viewshed if the file is there, whole and of this fingerprint; else None.

    `hold` makes from the window what takes the strips, as the sinks of `core.viewshed.viewshed` do.
    """
    if not os.path.exists(path):
        return None
    dataset = open_quietly(path)
    if dataset is None or dataset.GetMetadataItem(KEY) != mark:
        return None
    x0, dx, _, y0, _, dy = dataset.GetGeoTransform()
    left, width, _, top, _, height = dem.geotransform
    band = dataset.GetRasterBand(1)
    window = Window(round((y0 - top) / height), round((x0 - left) / width), dataset.RasterYSize, dataset.RasterXSize)
    if band.DataType != gdal.GDT_Byte or window.clipped(dem.shape) != window:
        return None
    held = hold(window)
    with quiet_gdal():
        try:
            for row in range(0, window.rows, STRIP_ROWS):
                rows = min(STRIP_ROWS, window.rows - row)
                values = band.ReadAsArray(0, row, window.cols, rows)
                if values is None:
                    return None
                held.add(Window(window.row + row, window.col, rows, window.cols), values)
        except RuntimeError:
            return None
    return StoredViewshed(window, held.values)


def write_layers(path, dem, window, bands, strips, mark, metadata=None):
    """Write float layers of a photograph with their fingerprint, whole or not at all.

    Parameters
    ----------
    path : str
    dem : Dem
    window : Window
    bands : dict
        Name of each band and its unit.
    strips : iterable of (Window, list of (rows, cols) float32 arrays)
        NaN becomes nodata.
    mark : str
        Of `fingerprint`.
    metadata : dict or None

    Raises
    ------
    OutputError
    """
    texts = {"descriptions": list(bands), "units": list(bands.values())}
    facts = {**(metadata or {}), KEY: mark}
    with new_raster(path, dem, window, bands=len(bands), nodata=np.nan, metadata=facts, **texts) as file:
        for strip, values in strips:
            for number, band in enumerate(values, start=1):
                file.write(band, strip.row - window.row, strip.col - window.col, number)


def stored_facts(path, mark):
    """Texts in the header of a finished file of this fingerprint, or None."""
    dataset = open_quietly(path) if os.path.exists(path) else None
    if dataset is None or dataset.GetMetadataItem(KEY) != mark:
        return None
    return dict(dataset.GetMetadata())


def viewshed_once(path, dem, mark, compute, metadata=None, hold=_WholeArray):
    """Take a finished result from its file, or compute and store it.

    Parameters
    ----------
    path : str
    dem : Dem
    mark : str
        Of `fingerprint`.
    compute : callable
        Without arguments -> Viewshed.
    metadata : dict or None
    hold : callable
        See `read_viewshed`.

    Returns
    -------
    result : StoredViewshed or Viewshed
    repeated : bool
        False where the file was there already.
    """
    stored = read_viewshed(path, dem, mark, hold)
    if stored is not None:
        return stored, False
    result = compute()
    write_viewshed(path, result, dem, mark, metadata)
    return result, True
