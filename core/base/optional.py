"""Import of optional packages when they are first needed; the error for a missing package says how to install it."""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from .errors import MissingPackageError
from .messages import Message

PIP_NAMES = {"cv2": "opencv-python-headless", "pillow_heif": "pillow-heif", "exifread": "exifread", "PIL": "Pillow",
             "osgeo.gdal": '"skyline-viewshed[gdal]"', "distributed": '"skyline-viewshed[dask]"'}  # fmt: skip


def available(module: str) -> Any:
    """Import and return an optional module; None if it is missing or broken."""
    if sys.modules.get(module) is not None:
        return sys.modules[module]
    try:
        with _own_libraries_first(module):
            return importlib.import_module(module)
    except Exception:  # a binary built against another NumPy raises more than ImportError
        return None


@contextmanager
def _own_libraries_first(module: str) -> Iterator[None]:
    """Bind Pillow and pillow-heif to the libraries in their own wheels.

    On Linux the QGIS programs have GDAL's libheif and Qt's freetype in their global scope. Without RTLD_DEEPBIND a
    wheel calls those other versions: decoding HEIC then crashes the process, and text is drawn far too large.
    """
    if module.split(".")[0] not in ("PIL", "pillow_heif") or not hasattr(os, "RTLD_DEEPBIND"):
        yield
        return
    flags = sys.getdlopenflags()
    sys.setdlopenflags(os.RTLD_NOW | os.RTLD_DEEPBIND)
    try:
        yield
    finally:
        sys.setdlopenflags(flags)


def require(module: str, feature: str) -> Any:
    """Import an optional module, or raise `MissingPackageError` with the feature (a `Message`) and the command."""
    found = available(module)
    if found is None:
        raise MissingPackageError(
            Message(
                "{feature} needs the Python package {package}. {hint}",
                feature=feature,
                package=module,
                hint=install_hint(module),
            )
        )
    return found


def install_hint(module: str) -> Message:
    """Give a sentence on how to install a package into this Python or into that of QGIS."""
    package = PIP_NAMES.get(module, module)
    if "qgis" not in sys.modules:
        command = f"python -m pip install {package}"
        return Message("Run: {command} (or install your distribution's package)", command=command)
    if sys.platform == "win32":
        return Message("In the OSGeo4W Shell run: {command}", command=f"python -m pip install --user {package}")
    if sys.platform == "darwin":
        command = f"/Applications/QGIS.app/Contents/MacOS/bin/python3 -m pip install --user {package}"
        return Message("Run: {command}", command=command)
    command = f"python3 -m pip install --user {package}"
    return Message("Run: {command} (or install your distribution's package)", command=command)
