"""Files that each store the viewshed of one photograph, so that a repeated run need not compute it again.

A file contains a fingerprint of everything on which its result depends. It gets its final name only once it is
complete, so that a run that is killed leaves only complete files under such names.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from osgeo import gdal

from ..base.terrain import Window
from ..base.viewed import UNKNOWN, ArraySink
from .gdal_quiet import open_quietly, quiet_gdal
from .write_raster import RasterLayout, new_raster

VERSION = 1
"""Increment this if the engine's results change, so that older files are computed again."""

STRIP_ROWS = 1024
KEY = "SKYLINE_VIEWSHED_FINGERPRINT"


@dataclass(frozen=True, eq=False)
class LayerStack:
    """Bands of a file and their values.

    Attributes
    ----------
    bands : dict
        Unit of each band, by its name.
    strips : iterable of (Window, list of (rows, cols) float32 arrays)
        Windows and their values in the order of the bands; NaN becomes nodata.
    """

    bands: dict
    strips: Iterable


def fingerprint(dem, observer, sector, options, *others):
    """Make a digest of all on which a viewshed depends.

    Parameters
    ----------
    dem : Dem
        Its `state` is included.
    observer : Observer
    sector : Sector
    options : ViewshedOptions
    others
        All else on which the result depends; compared by `repr`.

    Returns
    -------
    str
    """
    facts = [VERSION, dem.state, observer, options]
    facts += [type(sector).__name__, *(_plain(value) for value in vars(sector).values()), *others]
    return hashlib.sha256(repr(facts).encode()).hexdigest()[:32]


def _plain(value):
    """Digest arrays in full, because their usual text omits the middle."""
    return hashlib.sha256(value.tobytes()).hexdigest() if isinstance(value, np.ndarray) else value


def write_viewshed(path, viewshed, dem, mark, metadata=None):
    """Write a viewshed with its fingerprint; the file appears complete or not at all.

    Parameters
    ----------
    path : str
    viewshed : Viewshed
    dem : Dem
    mark : str
        Fingerprint from `fingerprint`.
    metadata : dict or None
        Further items for the file's header.

    Raises
    ------
    OutputError
    """
    facts = {**(metadata or {}), KEY: mark}
    layout = RasterLayout("uint8", nodata=UNKNOWN, metadata=facts)
    with new_raster(path, dem, viewshed.window, layout) as file:
        for row in range(0, viewshed.window.rows, STRIP_ROWS):
            file.write(viewshed.values[row : row + STRIP_ROWS, :], row)


def read_viewshed(path, dem, mark, sink=ArraySink):
    """Read a stored viewshed.

    Parameters
    ----------
    path : str
    dem : Dem
    mark : str
        Fingerprint from `fingerprint`.
    sink : callable
        Function that makes from the window the `Sink` that receives the values.

    Returns
    -------
    (Window, values) or None
        Window and values of the sink, as in `Viewshed`; None unless the file is complete and has this fingerprint.
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
    held = sink(window)
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
    return window, held.values


def write_layers(path, dem, window, layers, mark, metadata=None):
    """Write float layers of a photograph with their fingerprint; the file appears complete or not at all.

    Parameters
    ----------
    path : str
    dem : Dem
    window : Window
        Part of the DEM's grid that the file covers.
    layers : LayerStack
    mark : str
        Fingerprint from `fingerprint`.
    metadata : dict or None
        Further items for the file's header.

    Raises
    ------
    OutputError
    """
    bands, facts = layers.bands, {**(metadata or {}), KEY: mark}
    layout = RasterLayout(
        bands=len(bands), nodata=np.nan, descriptions=tuple(bands), units=tuple(bands.values()), metadata=facts
    )
    with new_raster(path, dem, window, layout) as file:
        for strip, values in layers.strips:
            for number, band in enumerate(values, start=1):
                file.write(band, strip.row - window.row, strip.col - window.col, number)


def stored_facts(path, mark):
    """Read the items in the header of a complete file with this fingerprint; None without such a file."""
    dataset = open_quietly(path) if os.path.exists(path) else None
    if dataset is None or dataset.GetMetadataItem(KEY) != mark:
        return None
    return dict(dataset.GetMetadata())
