"""Use of GDAL without messages on stderr and without changing its process-wide settings permanently."""

from __future__ import annotations

import os
from contextlib import contextmanager

from ..base.optional import available

CACHE_BYTES = 8 * 2**20, 64 * 2**20
"""Smallest and largest size of GDAL's block cache during a transfer [bytes]; its default is 5 % of the memory. A
smaller cache is faster: on an uncompressed file, 8 MB take a third of the time of 64 MB."""

MOSAICS = ("VRT", "GTI")
"""Drivers that give the size of their own blocks, which is not that of the blocks in their tiles."""


@contextmanager
def quiet_gdal(warnings=False):
    """Collect GDAL's failures (and warnings, if asked for) in the yielded list instead of printing them.

    GDAL's use of exceptions stays as the host application has set it; callers check for None and catch RuntimeError.
    """
    gdal = available("osgeo.gdal")
    least, messages = gdal.CE_Warning if warnings else gdal.CE_Failure, []

    def collect(*given):
        try:
            severity, _, text = given
        except ValueError:  # for text that is not UTF-8, GDAL before 3.7 passes no arguments and leaves a pending error
            severity, text = gdal.CE_Failure, "a message that cannot be read"
        if severity >= least:
            messages.append((text.decode("utf-8", "replace") if isinstance(text, bytes) else text).strip())

    gdal.PushErrorHandler(collect)
    try:
        yield messages
    finally:
        gdal.PopErrorHandler()


OPTION = "|option:"


def split_options(source):
    """Split a source as QGIS writes it, `file|option:KEY=VALUE|...`, into the path and a tuple of open options."""
    if OPTION not in source or os.path.exists(source):
        return source, ()
    path, *options = source.split(OPTION)
    return path, tuple(option for option in options if "=" in option)


def open_quietly(path, drivers=(), options=()):
    """Open a raster for reading; None if GDAL is missing or cannot open it.

    Parameters
    ----------
    path : str
    drivers : sequence of str
        Names of the only drivers that may open it; empty for any.
    options : sequence of str
        Open options, "KEY=VALUE".
    """
    gdal = available("osgeo.gdal")
    if gdal is None:
        return None
    with quiet_gdal():
        try:
            flags = gdal.OF_RASTER | gdal.OF_READONLY
            return gdal.OpenEx(str(path), flags, allowed_drivers=list(drivers), open_options=list(options))
        except RuntimeError:
            return None


def direct_reading():
    """Make GDAL bypass its block cache for uncompressed TIFFs that are opened within the block.

    Reading a small window of them then costs only its own bytes, not those of the blocks that it overlaps. Other files
    are not affected.
    """
    return _setting("GTIFF_DIRECT_IO", "YES")


def without_sidecars():
    """Keep GDAL from writing (and reading) .aux.xml files of rasters that are opened within the block."""
    return _setting("GDAL_PAM_ENABLED", "NO")


@contextmanager
def _setting(name, value):
    """Set one of GDAL's options for this thread within the block."""
    gdal = available("osgeo.gdal")
    if gdal is None or not hasattr(gdal, "SetThreadLocalConfigOption"):
        yield
        return
    before = gdal.GetThreadLocalConfigOption(name)
    gdal.SetThreadLocalConfigOption(name, value)
    try:
        yield
    finally:
        gdal.SetThreadLocalConfigOption(name, before)


def bytes_of_block_row(dataset, band, cols):
    """Return the size in GDAL's cache of one row of blocks across a window [bytes].

    Of a mosaic, whose tiles may have larger blocks than it tells, it is the most that `small_cache` takes.

    Parameters
    ----------
    dataset, band : gdal.Dataset, gdal.Band
    cols : int
        Width of the window [cells].
    """
    if dataset.GetDriver().ShortName in MOSAICS:
        return CACHE_BYTES[1]
    width, height = band.GetBlockSize()
    return (cols // width + 2) * width * height * max(available("osgeo.gdal").GetDataTypeSize(band.DataType) // 8, 1)


@contextmanager
def small_cache(block_row=CACHE_BYTES[1]):
    """Limit GDAL's block cache within the block, and restore the host's setting afterwards.

    Parameters
    ----------
    block_row : int
        Size of the blocks that must stay cached from one strip to the next, so that they are not decoded twice
        [bytes].
    """
    gdal = available("osgeo.gdal")
    before, (least, most) = gdal.GetCacheMax(), CACHE_BYTES
    size = min(max(block_row + least // 2, least), most)
    if before > size:
        gdal.SetCacheMax(size)
    try:
        yield
    finally:
        if before > size:
            gdal.SetCacheMax(before)
