"""GDAL without its noise: no messages on stderr, no process-wide exception switch."""

from __future__ import annotations

from contextlib import contextmanager

from ..base.optional import available

CACHE_BYTES = 8 * 2**20, 64 * 2**20
"""Least and most of GDAL's block cache while a window passes through; its own default is 5 % of the memory. The less
of it is touched, the faster: on an uncompressed file 8 MB take a third of the time of 64."""


@contextmanager
def quiet_gdal(warnings=False):
    """Collect GDAL's failures (and warnings, if asked for) in the yielded list instead of printing them.

    GDAL's own exceptions stay as the host application has set them; callers check for None and catch RuntimeError.
    """
    gdal = available("osgeo.gdal")
    least, messages = gdal.CE_Warning if warnings else gdal.CE_Failure, []

    def collect(*given):
        try:
            severity, _, text = given
        except ValueError:  # GDAL before 3.7 makes of a text that is no UTF-8 no arguments at all and a pending error
            severity, text = gdal.CE_Failure, "a message that cannot be read"
        if severity >= least:
            messages.append((text.decode("utf-8", "replace") if isinstance(text, bytes) else text).strip())

    gdal.PushErrorHandler(collect)
    try:
        yield messages
    finally:
        gdal.PopErrorHandler()


def open_quietly(path, drivers=()):
    """Open a raster for reading, or give None where GDAL is missing or cannot."""
    gdal = available("osgeo.gdal")
    if gdal is None:
        return None
    with quiet_gdal():
        try:
            return gdal.OpenEx(str(path), gdal.OF_RASTER | gdal.OF_READONLY, allowed_drivers=list(drivers))
        except RuntimeError:
            return None


@contextmanager
def direct_reading():
    """Let uncompressed TIFFs that are opened meanwhile be read past GDAL's block cache.

    A small window of them then costs its own bytes, not those of the blocks that it touches. Other files are read as
    ever.
    """
    gdal = available("osgeo.gdal")
    name = "GTIFF_DIRECT_IO"
    if gdal is None or not hasattr(gdal, "SetThreadLocalConfigOption"):
        yield
        return
    before = gdal.GetThreadLocalConfigOption(name)
    gdal.SetThreadLocalConfigOption(name, "YES")
    try:
        yield
    finally:
        gdal.SetThreadLocalConfigOption(name, before)


@contextmanager
def small_cache(row_of_blocks=CACHE_BYTES[1]):
    """Hold GDAL's block cache small while data pass through, and leave it as the host had it.

    Parameters
    ----------
    row_of_blocks : int
        Bytes of the blocks that must stay from one strip to the next, lest they be decoded twice.
    """
    gdal = available("osgeo.gdal")
    before, (least, most) = gdal.GetCacheMax(), CACHE_BYTES
    size = min(max(row_of_blocks + least // 2, least), most)
    if before > size:
        gdal.SetCacheMax(size)
    try:
        yield
    finally:
        if before > size:
            gdal.SetCacheMax(before)
