"""Photographs on a web server or in a cloud's storage, as GDAL names them, copied to a file that decoders can open."""

from __future__ import annotations

import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

from ..base.errors import UnreadablePhotoError
from ..base.messages import Message
from .gdal_quiet import quiet_gdal

PIECE = 1 << 22


@contextmanager
def local_copy(path):
    """Yield a local path with the content of a GDAL path such as `/vsis3/...`; any other path as it is.

    Raises
    ------
    UnreadablePhotoError
        GDAL cannot read it.
    """
    path = os.fspath(path)
    if not path.startswith("/vsi"):
        yield path
        return
    with tempfile.TemporaryDirectory(prefix="skyline-") as folder:
        copy = Path(folder) / (Path(path).name or "photo")
        _fetch(path, copy)
        yield str(copy)


def _fetch(path, copy):
    from osgeo import gdal

    with quiet_gdal() as messages:
        source = gdal.VSIFOpenL(path, "rb")
        if source is None:
            reason = "; ".join(messages) or Message("the file cannot be opened")
            raise UnreadablePhotoError(path, reason)
        try:
            with open(copy, "wb") as target:
                while piece := gdal.VSIFReadL(1, PIECE, source):
                    target.write(piece)
        finally:
            gdal.VSIFCloseL(source)
