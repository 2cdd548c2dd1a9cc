"""The metadata of a photograph's file, as the attributes of a point."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsGeometry, QgsPoint, QgsProcessingException
from qgis.PyQt.QtCore import QDateTime

from ...core.base.attributes import photo_fields, photo_values
from .i18n import tr


def photos_in(folder, recursive, feedback):
    """Paths of the photographs in a folder, with a report of what else it holds; a clear error if there are none."""
    from ...core.io.folder import scan_folder

    if not Path(folder).is_dir():
        raise QgsProcessingException(tr("The folder {folder} does not exist.").format(folder=folder))
    paths, skipped = scan_folder(Path(folder).absolute(), recursive)  # layers are opened from other folders
    if skipped:
        kinds = ", ".join(f"{suffix or tr('without suffix')} ({count})" for suffix, count in skipped.items())
        feedback.pushInfo(tr("Files that were not read as photographs: {kinds}").format(kinds=kinds))
    if not paths:
        raise QgsProcessingException(
            tr(
                "No photograph (JPEG, HEIC) was found in {folder}. Choose another folder, or include its subfolders."
            ).format(folder=folder)
        )
    return paths


def point_of(metadata):
    """Point in WGS 84; as in QGIS's own import, Z is 0 where the altitude is unknown."""
    return QgsGeometry(QgsPoint(metadata.longitude_deg, metadata.latitude_deg, metadata.altitude_m or 0.0))


def attributes_of(metadata):
    """Attributes in the order of `fields.photo_specs`."""
    values = photo_values(metadata)
    values["timestamp"] = QDateTime(metadata.taken_at) if metadata.taken_at else None
    return [values[spec.name] for spec in photo_fields()]
