"""GDAL without its noise: no messages on stderr, no process-wide exception switch."""

from __future__ import annotations

from contextlib import contextmanager

from ..optional import available


@contextmanager
def quiet_gdal():
    """Collect GDAL's messages in the yielded list instead of printing them.

    GDAL's own exceptions stay as the host application has set them; callers check for None and catch RuntimeError.
    """
    gdal = available("osgeo.gdal")
    messages = []
    gdal.PushErrorHandler(lambda severity, number, text: messages.append(text))
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
