"""Photographs as QImages at several sizes, decoded in the background and kept within a bound of memory."""

from __future__ import annotations

import ctypes
import sys
from collections import OrderedDict
from dataclasses import dataclass
from typing import Any

import numpy as np
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QImage

from ...core.base.model import PhotoMetadata

MOST_BYTES = 160_000_000
"""Memory for pictures: about three of 12 megapixels, the present one and its neighbours."""

PREVIEW_PX = 1024
"""Long side of the pixels from which the skyline is extracted."""

SMALLEST_LEVEL_PX = 500
THUMBNAIL_PX = 96
MOST_THUMBNAILS = 2_000


@dataclass(frozen=True, eq=False)
class Picture:
    """A decoded photograph.

    Attributes
    ----------
    metadata : PhotoMetadata
    levels : tuple of QImage
        Full size first, each half as large as the one before.
    preview : (h, w, 3) uint8 array
        Reduced pixels.
    """

    metadata: PhotoMetadata
    levels: tuple[Any, ...]
    preview: np.ndarray

    @property
    def size(self):
        """Bytes in memory."""
        return sum(level.sizeInBytes() for level in self.levels) + self.preview.nbytes


def open_picture(path):
    """Decode a file; raises `PhotoError`."""
    from ...core.base.imaging import shrink_to
    from ...core.io.photo import read_photo

    photo = read_photo(path)
    height, width = photo.pixels.shape[:2]
    full = QImage(photo.pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()
    preview = photo.pixels
    if max(width, height) > PREVIEW_PX:
        preview = np.rint(shrink_to(photo.pixels, PREVIEW_PX)).astype(np.uint8)
    levels = [full]
    while max(levels[-1].width(), levels[-1].height()) > 2 * SMALLEST_LEVEL_PX:
        levels.append(_smaller(levels[-1], 0.5).convertToFormat(QImage.Format.Format_RGB32))
    return Picture(photo.metadata, tuple(levels), preview)


def _smaller(image, factor):
    size = image.size() * factor
    return image.scaled(size, Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation)


def thumbnail_of(image):
    """Reduce a picture to the size of the strip."""
    return image.scaled(
        THUMBNAIL_PX,
        THUMBNAIL_PX,
        Qt.AspectRatioMode.KeepAspectRatio,
        Qt.TransformationMode.SmoothTransformation,
    )


def open_thumbnail(path):
    """Decode a file to the size of the strip; raises `PhotoError`."""
    from ...core.io.photo import read_photo

    pixels = read_photo(path, 4 * THUMBNAIL_PX).pixels
    height, width = pixels.shape[:2]
    return thumbnail_of(QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy())


def give_back_memory():
    """Give memory that is free back to the system.

    The C library of Linux keeps what a thread frees between blocks that are still in use. While an archive is browsed,
    that grows to more than what is in use. Other systems have no such call, and do not need it.
    """
    if sys.platform.startswith("linux"):
        trim = getattr(ctypes.CDLL(None), "malloc_trim", None)  # the library musl lacks it
        if trim is not None:
            trim(0)


class PictureStore:
    """Gives pictures and thumbnails by path, from memory or through a lane.

    Parameters
    ----------
    lane : Lane
    """

    def __init__(self, lane):
        self.lane = lane
        self._pictures, self._thumbnails = OrderedDict(), OrderedDict()
        self._coming = self._wanted = None
        self._asked = []

    @property
    def size(self):
        """Bytes of all pictures in memory."""
        return sum(picture.size for picture in self._pictures.values())

    def request(self, path, done, failed):
        """Give a picture to `done`: at once if it is in memory."""
        self._wanted = None
        if path in self._pictures:
            self._pictures.move_to_end(path)
            done(self._pictures[path])
        elif path == self._coming:
            self._wanted = path, done, failed
        else:
            self._load("picture", path, done, failed, urgency=0)

    def ahead(self, path):
        """Decode the picture that will probably be asked for next."""
        if path and path not in self._pictures and path != self._coming:
            self._coming = path
            self._load("ahead", path, self._arrived, self._lost, urgency=3)

    def _load(self, key, path, done, failed, urgency):
        def kept(picture):
            done(self._keep(path, picture))

        self.lane.submit(key, lambda job: open_picture(path), kept, failed, urgency)

    def _arrived(self, picture):
        self._pass_on(picture.metadata.path, 1, picture)

    def _lost(self, sentence):
        self._pass_on(self._coming, 2, sentence)

    def _pass_on(self, path, which, result):
        """Give what was decoded ahead to whoever has asked for it meanwhile."""
        wanted, self._coming, self._wanted = self._wanted, None, None
        if wanted is not None and wanted[0] == path:
            wanted[which](result)

    def thumbnail(self, path, done):
        """Give a thumbnail to `done`, sooner or later; a file that cannot be read has none."""
        if path in self._thumbnails:
            done(self._thumbnails[path])
            return
        self._asked.append(path)
        self.lane.submit(("thumbnail", path), lambda job: open_thumbnail(path),
                         lambda image: done(self._keep_thumbnail(path, image)), urgency=4)  # fmt: skip

    def cancel_thumbnails(self):
        """Forget the thumbnails that are still to be made; others have come into view."""
        for path in self._asked:
            self.lane.cancel(("thumbnail", path))
        self._asked = []

    def clear(self):
        """Free the memory."""
        self._coming = self._wanted = None
        self._pictures.clear()
        self._thumbnails.clear()

    def _keep(self, path, picture):
        self._pictures[path] = picture
        self._pictures.move_to_end(path)
        while self.size > MOST_BYTES and len(self._pictures) > 1:
            self._pictures.popitem(last=False)
            # At once, since the lane is never idle while a person goes from picture to picture, and once it is idle.
            for urgency in (0, 5):
                key = "memory", urgency
                self.lane.submit(key, lambda job: give_back_memory(), lambda result: None, urgency=urgency)
        self._keep_thumbnail(path, thumbnail_of(picture.levels[-1]))
        return picture

    def _keep_thumbnail(self, path, image):
        self._thumbnails[path] = image
        while len(self._thumbnails) > MOST_THUMBNAILS:
            self._thumbnails.popitem(last=False)
        return image
