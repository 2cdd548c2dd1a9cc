"""What a photograph's file says, as the attributes of a point."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsGeometry, QgsPoint, QgsProcessingException
from qgis.PyQt.QtCore import QDateTime

from ...core.base.camera import Camera, focal_from_35mm_px
from .i18n import tr

ROTATION_OF_ORIENTATION = {1: 0, 2: 0, 3: 180, 4: 180, 5: 90, 6: 90, 7: 270, 8: 270}


def photos_in(folder, recursive):
    """Paths of the photographs in a folder, or a clear refusal."""
    from ...core.io.photo import list_photos

    if not Path(folder).is_dir():
        raise QgsProcessingException(tr("The folder {folder} does not exist.").format(folder=folder))
    paths = list(list_photos(folder, recursive))
    if not paths:
        raise QgsProcessingException(
            tr(
                "No photograph (JPEG, HEIC) was found in {folder}. Choose another folder, or include its subfolders."
            ).format(folder=folder)
        )
    return paths


def has_position(metadata):
    """Tell whether the file gives a position; 0/0 is what cameras write that have none."""
    if metadata.latitude_deg is None or metadata.longitude_deg is None:
        return False
    return not (metadata.latitude_deg == 0 and metadata.longitude_deg == 0)


def point_of(metadata):
    """Point in WGS 84; as in QGIS's own import, Z is 0 where the altitude is unknown."""
    return QgsGeometry(QgsPoint(metadata.longitude_deg, metadata.latitude_deg, metadata.altitude_m or 0.0))


def attributes_of(metadata):
    """Attributes in the order of `fields.photo_specs`."""
    path = Path(metadata.path)
    hfov_deg = vfov_deg = None
    if metadata.focal_length_35mm:
        size = metadata.width_px, metadata.height_px
        camera = Camera(*size, focal_from_35mm_px(*size, metadata.focal_length_35mm))
        hfov_deg, vfov_deg = camera.hfov_deg, camera.vfov_deg
    return [
        str(path),
        path.stem,
        str(path.parent),
        metadata.altitude_m,
        metadata.compass_heading_deg,
        ROTATION_OF_ORIENTATION.get(metadata.orientation),
        _text(metadata.longitude_deg),
        _text(metadata.latitude_deg),
        QDateTime(metadata.taken_at) if metadata.taken_at else None,
        metadata.focal_length_35mm,
        hfov_deg,
        vfov_deg,
        metadata.width_px,
        metadata.height_px,
        metadata.compass_reference,
        metadata.position_error_m,
        metadata.camera,
    ]


def _text(angle_deg):
    """Shortest text that gives the number back; NULL for what is unknown."""
    return None if angle_deg is None else repr(float(angle_deg))
