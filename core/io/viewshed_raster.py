"""One photograph's viewshed as a file of its own, which a repeated run recognises and does not compute again.

A file carries the fingerprint of everything that its result depends on. It takes its name only when it is whole, so
that a run killed at any moment leaves finished files and none that only looks like one.
"""

from __future__ import annotations

import hashlib
import os
from dataclasses import dataclass

import numpy as np

from ..terrain import Window
from .gdal_quiet import open_quietly, quiet_gdal
from .write_raster import write_raster

VERSION = 1
"""Raised when the engine's results change, so that older files are computed anew."""

UNKNOWN = 255
KEY = "SKYLINE_VIEWSHED_FINGERPRINT"


@dataclass(frozen=True, eq=False)
class StoredViewshed:
    """What a file holds: window of the DEM, and values as in `core.viewshed.Viewshed`."""

    window: Window
    values: np.ndarray

    @property
    def visible(self):
        """(rows, cols) bool: cells that are certainly seen."""
        return self.values == 1


def fingerprint(dem, observer, sector, options):
    """Digest of all that a viewshed depends on: the DEM's file and band, observer, sector, options, engine.

    A changed DEM is noticed by its size and time of change, as by `make`.
    """
    facts = [VERSION, *_file_facts(dem), dem.shape, dem.geotransform, dem.crs_wkt, observer, options]
    facts += [type(sector).__name__, *(_plain(value) for value in vars(sector).values())]
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
    write_raster(path, viewshed.values, dem, viewshed.window, nodata=UNKNOWN, metadata=facts)


def read_viewshed(path, dem, mark):
    """Give the stored viewshed if the file is there, whole and of this fingerprint; else None."""
    if not os.path.exists(path):
        return None
    dataset = open_quietly(path)
    if dataset is None or dataset.GetMetadataItem(KEY) != mark:
        return None
    x0, dx, _, y0, _, dy = dataset.GetGeoTransform()
    left, width, _, top, _, height = dem.geotransform
    with quiet_gdal():
        try:
            values = dataset.GetRasterBand(1).ReadAsArray()
        except RuntimeError:
            values = None
    if values is None or values.dtype != np.uint8:
        return None
    window = Window(round((y0 - top) / height), round((x0 - left) / width), *values.shape)
    return StoredViewshed(window, values) if window.clipped(dem.shape) == window else None


def viewshed_once(path, dem, mark, compute, metadata=None):
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

    Returns
    -------
    result : StoredViewshed or Viewshed
    repeated : bool
        False where the file was there already.
    """
    stored = read_viewshed(path, dem, mark)
    if stored is not None:
        return stored, False
    result = compute()
    write_viewshed(path, result, dem, mark, metadata)
    return result, True
