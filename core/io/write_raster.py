"""Write GeoTIFFs on the grid of an elevation model in strips; a file appears complete or not at all."""

from __future__ import annotations

import errno
import os
import secrets
from collections.abc import Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace

import numpy as np
from osgeo import gdal

from ..base.errors import OutputError
from ..base.messages import Message
from ..base.terrain import Window
from .crs import spatial_reference
from .gdal_quiet import quiet_gdal, small_cache

GDAL_TYPES = {
    "uint8": gdal.GDT_Byte,
    "int16": gdal.GDT_Int16,
    "uint16": gdal.GDT_UInt16,
    "int32": gdal.GDT_Int32,
    "float32": gdal.GDT_Float32,
}
BLOCK_PX = 256
SYSTEM_CAUSES = tuple(map(os.strerror, (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EIO)))


@dataclass(frozen=True)
class RasterLayout:
    """Format and metadata of a raster file.

    Attributes
    ----------
    dtype : str
        'uint8', 'int16', 'uint16', 'int32' or 'float32'.
    bands : int
        Number of bands.
    nodata : float or None
    descriptions, units : sequence of str
        One text per band.
    metadata : dict or None
        Items for the file's header.
    alpha : bool
        Whether the four bands are red, green, blue and opacity.
    """

    dtype: str = "float32"
    bands: int = 1
    nodata: float | None = None
    descriptions: Sequence[str] = ()
    units: Sequence[str] = ()
    metadata: dict | None = None
    alpha: bool = False


@contextmanager
def new_raster(path, grid, window=None, layout=RasterLayout()):  # noqa: B008 - frozen
    """Create a GeoTIFF, which gets its final name if the block ends without an error and is removed otherwise.

    Parameters
    ----------
    path : str
    grid : object
        Object with `shape`, `crs_wkt` and `geotransform`, such as a `Dem`.
    window : Window or None
        Part of the grid that the file covers; None for all of it.
    layout : RasterLayout

    Yields
    ------
    RasterFile

    Raises
    ------
    OutputError
        If the folder is missing or read-only, the disk is full, ...
    """
    path = os.fspath(path)
    window = window or Window(0, 0, *grid.shape)
    part = os.path.join(os.path.dirname(path), f".skyline-{secrets.token_hex(6)}.part")
    try:
        with quiet_gdal() as messages, small_cache():
            file = None
            try:
                file = RasterFile(path, _create(part, window, layout), messages)
                file._describe(grid, window, layout)
                yield file
                file._close()
            finally:
                if file is not None:
                    file._dataset = None
            os.replace(part, path)
    except (RuntimeError, OSError) as error:
        raise _output_error(path, messages, error) from None
    finally:
        for leftover in (part, part + ".aux.xml"):
            with suppress(OSError):
                os.remove(leftover)


def _create(part, window, layout):
    dtype, alpha = layout.dtype, layout.alpha
    options = ["TILED=YES", f"BLOCKXSIZE={BLOCK_PX}", f"BLOCKYSIZE={BLOCK_PX}", "BIGTIFF=IF_SAFER", "INTERLEAVE=BAND"]
    if dtype == "uint8" and not alpha:
        # Masks contain long runs, and every TIFF reader supports PackBits: it makes a fortieth of the plain file, in a
        # sixth of the time that DEFLATE takes for a third of that size.
        options += ["COMPRESS=PACKBITS"]
    else:
        options += ["COMPRESS=DEFLATE", f"PREDICTOR={3 if dtype == 'float32' else 2}"]
    # At higher levels pictures are hardly smaller and take three times as long.
    options += ["PHOTOMETRIC=RGB", "ALPHA=YES", "ZLEVEL=1"] if alpha else []
    dataset = gdal.GetDriverByName("GTiff").Create(
        part, window.cols, window.rows, layout.bands, GDAL_TYPES[dtype], options
    )
    if dataset is None:
        raise OSError(Message("cannot be created"))
    return dataset


def _output_error(path, messages, error):
    said = error.args[0] if error.args and isinstance(error.args[0], Message) else str(error)
    words = [*messages, getattr(error, "strerror", None) or said]
    # Among GDAL's messages, that of the operating system states the cause; those of libtiff follow from it.
    reason = next((cause for cause in SYSTEM_CAUSES for text in words if cause in text), words[0])
    folder = os.path.dirname(path) or "."
    if not os.path.isdir(folder):
        reason = Message("the folder {folder} does not exist", folder=folder)
    elif not os.access(folder, os.W_OK):
        reason = Message("the folder {folder} is read-only", folder=folder)
    elif not isinstance(reason, Message):
        reason = reason.split("\n")[0]
    return OutputError.of_file(path, reason)


class RasterFile:
    """A GeoTIFF that is being written, as `new_raster` gives it."""

    def __init__(self, path, dataset, messages):
        self.path, self._dataset, self._messages = path, dataset, messages

    def write(self, values, row=0, col=0, band=1):
        """Write a block of cells; strips of a multiple of `BLOCK_PX` rows are fastest.

        Parameters
        ----------
        values : (rows, cols) array
        row, col : int
            Cell of the file at which the block begins.
        band : int
            Number of the band, from 1.
        """
        target = self._dataset.GetRasterBand(band)
        for start in range(0, values.shape[0], 16 * BLOCK_PX):
            strip = np.ascontiguousarray(values[start : start + 16 * BLOCK_PX])
            if target.WriteArray(strip, col, row + start) != gdal.CE_None:
                raise OSError(Message("the disk may be full"))

    def _describe(self, grid, window, layout):
        x0, dx, _, y0, _, dy = grid.geotransform
        self._dataset.SetGeoTransform((x0 + window.col * dx, dx, 0.0, y0 + window.row * dy, 0.0, dy))
        self._dataset.SetSpatialRef(spatial_reference(grid.crs_wkt))
        if layout.metadata:
            self._dataset.SetMetadata({str(key): str(value) for key, value in layout.metadata.items()})
        for number in range(1, self._dataset.RasterCount + 1):
            band = self._dataset.GetRasterBand(number)
            if layout.nodata is not None:
                band.SetNoDataValue(float(layout.nodata))
            for tell, values in ((band.SetDescription, layout.descriptions), (band.SetUnitType, layout.units)):
                if number <= len(values):
                    tell(values[number - 1])

    def _close(self):
        self._dataset.FlushCache()
        self._dataset = None  # GDAL writes the directory now; errors are only in the messages
        if self._messages:
            raise OSError("it was not written completely")


def write_raster(path, values, grid, window=None, layout=RasterLayout()):  # noqa: B008 - frozen
    """Write a whole array as a tiled, compressed GeoTIFF on a DEM's grid.

    Parameters
    ----------
    path : str
    values : (R, C) or (B, R, C) array
        bool, uint8, int16, uint16, int32 or float32; bool becomes uint8, float64 becomes float32.
    grid : object
        Object with `shape`, `crs_wkt` and `geotransform`, such as a `Dem`.
    window : Window or None
        Part of the grid that the file covers, of the array's size; None for all of it.
    layout : RasterLayout
        Format of the file; its `dtype` and `bands` are ignored in favour of the array's.

    Raises
    ------
    OutputError
    """
    values = np.asarray(values)
    values = values.astype({"bool": np.uint8, "float64": np.float32}.get(values.dtype.name, values.dtype), copy=False)
    bands = values if values.ndim == 3 else values[None]
    expected = grid.shape if window is None else (window.rows, window.cols)
    if bands.shape[1:] != tuple(expected) or values.dtype.name not in GDAL_TYPES:
        raise ValueError(f"{values.shape} {values.dtype} does not suit a window of {expected} cells")
    with new_raster(path, grid, window, replace(layout, dtype=values.dtype.name, bands=len(bands))) as file:
        for number, band in enumerate(bands, start=1):
            file.write(band, band=number)
