"""The field `preview`: a picture that QGIS can show for each photo, found from where the layer is.

Qt draws JPEG but not HEIC or raw files, so those get a JPEG in a folder beside the layer. The path counts from the
layer's folder, so that it stays right if photos and layer move together.
"""

from __future__ import annotations

import os
import re
import shutil
from contextlib import suppress
from pathlib import Path

from qgis.core import QgsFields, QgsProcessingUtils

from ...core.base.errors import MissingPackageError, PhotoError
from ...core.io.whole_file import unused_name
from .fields import FieldSpec, is_null, qgis_field
from .i18n import tr
from .outputs import destination, is_plain_file, make_folder_of, unwritable

SHOWN = (".jpg", ".jpeg", ".png", ".bmp", ".gif", ".webp")
"""Suffixes of pictures that every Qt draws."""

PREVIEW_PX = 960
MOST_UP = 2
"""Folders that a relative path may climb; beyond, layer and photo are unlikely to move together."""

DATABASE_FILE = re.compile(r"ogr:dbname='([^']+)'", re.IGNORECASE)


def preview_specs():
    """Field of the picture."""
    return [FieldSpec("preview", "text", tr("Picture"))]


class Previews:
    """Pictures of one run's photos; a context manager, so that a failed or cancelled run leaves none.

    Parameters
    ----------
    parameters, context
        As in `processAlgorithm`.
    name : str
        Parameter of the layer that gets the field.
    """

    def __init__(self, parameters, context, name="OUTPUT"):
        given = destination(parameters.get(name), context) or ""
        table = DATABASE_FILE.match(given)
        path = table.group(1) if table else given if is_plain_file(given) else None
        self._layer = Path(path).expanduser().absolute() if path else None
        self._stage = None
        self._paths, self._taken = [], set()

    @property
    def folder(self):
        """Folder of the JPEG files."""
        if self._layer is None:
            return Path(QgsProcessingUtils.tempFolder()) / "previews"
        return self._layer.parent / f"{self._layer.stem}_previews"

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        try:
            if kind is None and self._stage is not None:
                self.folder.mkdir(parents=True, exist_ok=True)
                for file in sorted(self._stage.iterdir()):
                    os.replace(file, self.folder / file.name)
        except OSError as fault:
            raise unwritable(self.folder, fault) from None
        finally:
            if self._stage is not None:
                shutil.rmtree(self._stage, ignore_errors=True)

    def add(self, path, pixels=None):
        """Take the next photo; its pixels are read only if it needs a JPEG and none are given.

        Parameters
        ----------
        path : str or None
        pixels : uint8 (h, w, 3) array or None
            The upright picture.
        """
        if is_null(path):
            self._paths.append(None)
        elif Path(path).suffix.lower() in SHOWN:
            self._paths.append(self._seen_from_layer(Path(path)))
        else:
            self._paths.append(self._jpeg(Path(path), pixels))

    def _jpeg(self, path, pixels):
        from ...core.base.imaging import shrink_to
        from ...core.figures.raster import encode_jpeg

        try:
            data = encode_jpeg(
                shrink_to(_pixels_of(path) if pixels is None else pixels, PREVIEW_PX).round().astype("u1")
            )
        except (MissingPackageError, PhotoError):
            return str(path)
        name = f"{unused_name(path.stem, self._taken)}.jpg"
        try:
            (self._staging() / name).write_bytes(data)
        except OSError as error:
            raise unwritable(self.folder / name, error) from None
        return self._seen_from_layer(self.folder / name)

    def _staging(self):
        if self._stage is None:
            make_folder_of(str(self.folder))
            self._stage = self.folder.with_name(f".skyline-{os.urandom(6).hex()}")
            self._stage.mkdir()
        return self._stage

    def _seen_from_layer(self, path):
        """Path from the layer's folder with forward slashes; the absolute one if the two lie far apart."""
        if self._layer is not None:
            with suppress(ValueError):  # another drive
                relative = os.path.relpath(path.absolute(), self._layer.parent)
                if Path(relative).parts[: MOST_UP + 1] != ("..",) * (MOST_UP + 1):
                    return Path(relative).as_posix()
        return path.as_posix()

    def column(self, fields, rows):
        """Return the layer's fields and rows with the pictures that were added, one per row."""
        place, joined = fields.lookupField("preview"), QgsFields(fields)
        if place < 0:
            joined.append(qgis_field(preview_specs()[0]))
            return joined, [(shape, [*values, path]) for (shape, values), path in zip(rows, self._paths)]
        filled = []
        for (shape, values), path in zip(rows, self._paths):
            filled.append((shape, [*values[:place], path, *values[place + 1 :]]))
        return joined, filled


def _pixels_of(path):
    from ...core.io.photo import read_photo

    return read_photo(path, PREVIEW_PX).pixels[..., :3]
