"""GDAL without its noise: no messages on stderr, no process-wide exception switch."""

from __future__ import annotations

from contextlib import contextmanager

from ..optional import available

CACHE_BYTES = 64 * 2**20
"""Of GDAL's block cache while a window passes through; its own default is 5 % of the memory."""


@contextmanager
def quiet_gdal(warnings=False):
    """Collect GDAL's failures (and warnings, if asked for) in the yielded list instead of printing them.

    GDAL's own exceptions stay as the host application has set them; callers check for None and catch RuntimeError.
    """
    gdal = available("osgeo.gdal")
    least, messages = gdal.CE_Warning if warnings else gdal.CE_Failure, []

    def collect(severity, number, text):
        if severity >= least:
            messages.append(text.strip())

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
def small_cache():
    """Hold GDAL's block cache small while data pass through, and leave it as the host had it."""
    gdal = available("osgeo.gdal")
    before = gdal.GetCacheMax()
    if before > CACHE_BYTES:
        gdal.SetCacheMax(CACHE_BYTES)
    try:
        yield
    finally:
        if before > CACHE_BYTES:
            gdal.SetCacheMax(before)
