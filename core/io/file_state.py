"""Tell whether the files behind a result have changed since it was made, by size and modification time, as `make` does.

A DEM may consist of several files: the tiles behind a VRT, the raster in an archive, a header, a mask. Statistics and
overviews are left out, because QGIS and GDAL write them while a DEM is only looked at; what else a sidecar may hold
(CRS, nodata, unit, scale) is compared as the DEM's own properties.
"""

from __future__ import annotations

import hashlib
import os
import re

from .gdal_quiet import open_quietly

MOST_NESTED = 20_000
"""Largest number of files of one DEM that are looked at."""

STATISTICS = re.compile(rb"<MDI key=\"STATISTICS_[^>]*>[^<]*</MDI>|<Histograms>.*?</Histograms>|\s+", re.DOTALL)
"""What GDAL adds to a VRT when its statistics are computed."""


def file_state(path):
    """Give path, size and time of a file; only the path if it is none."""
    try:
        state = os.stat(path)
    except (OSError, TypeError, ValueError):
        return path
    return os.path.abspath(path), state.st_size, state.st_mtime_ns


def dataset_state(path, dataset):
    """Give the state of all files of an open raster.

    Parameters
    ----------
    path : str
        As GDAL opened it.
    dataset : osgeo.gdal.Dataset

    Returns
    -------
    tuple
        Comparable by its `repr`.
    """
    return (path, *(_state(name) for name in sorted(_files(path, dataset))))


def _files(path, dataset):
    """Collect the files on the disk, also of VRTs within VRTs; an archive stands for its members."""
    found: set = set()
    waiting = [path, *(dataset.GetFileList() or ())]
    while waiting and len(found) < MOST_NESTED:
        name = on_disk(waiting.pop())
        if name is None or name in found or name.lower().endswith((".aux.xml", ".ovr")):
            continue
        found.add(name)
        if name.lower().endswith(".vrt"):
            inner = open_quietly(name)
            waiting += [] if inner is None else inner.GetFileList() or []
    return found


def on_disk(name):
    """Give the file on the disk that holds a file of GDAL's virtual systems (/vsizip/, ...); None if there is none."""
    path = re.sub(r"^(/vsi(?!mem)[a-z0-9_]+/)+", "", name)
    if path.startswith("{"):
        path = path[1:].split("}")[0]
    path = re.sub(r"^\d+_\d+,", "", path)  # /vsisubfile/
    while path and path != os.path.dirname(path):
        if os.path.isfile(path):
            return os.path.abspath(path)
        path = os.path.dirname(path)
    return None


def _state(name):
    if not name.lower().endswith(".vrt"):
        return file_state(name)
    with open(name, "rb") as file:
        content = STATISTICS.sub(b"", file.read()).replace(b"<Metadata></Metadata>", b"")
    return name, hashlib.sha256(content).hexdigest()
