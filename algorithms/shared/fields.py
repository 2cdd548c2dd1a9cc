"""The attributes we write: names (a contract, at most 10 characters), types, and aliases with units."""

from __future__ import annotations

from dataclasses import dataclass

from qgis.core import Qgis, QgsField, QgsFields
from qgis.PyQt.QtCore import QMetaType, QVariant

from .i18n import tr

_QT_NAMES = {
    "text": ("QString", "String"),
    "real": ("Double", "Double"),
    "whole": ("Int", "Int"),
    "yes": ("Bool", "Bool"),
}


@dataclass(frozen=True)
class FieldSpec:
    """Name, kind ('text', 'real', 'whole', 'yes', 'time') and alias of an attribute."""

    name: str
    kind: str
    alias: str


def qgis_field(spec):
    """Make the `QgsField`, by the type system of the running QGIS (QMetaType from 3.38 on)."""
    names = {**_QT_NAMES, "time": ("QDateTime", "DateTime")}[spec.kind]
    if Qgis.QGIS_VERSION_INT >= 33800:
        kind = getattr(QMetaType.Type, names[0])
    else:
        kind = getattr(QVariant, names[1])
    field = QgsField(spec.name, kind)
    field.setAlias(spec.alias)
    return field


def qgis_fields(specs):
    """Make `QgsFields` from specifications."""
    fields = QgsFields()
    for spec in specs:
        fields.append(qgis_field(spec))
    return fields


def joined_fields(source_fields, specs):
    """All source fields plus ours; ours take the place of source fields of the same name.

    Returns
    -------
    fields : QgsFields
    kept : list of int
        Indices of the source fields that stay, in order.
    """
    ours = {spec.name for spec in specs}
    kept = [index for index, field in enumerate(source_fields) if field.name().lower() not in ours]
    fields = QgsFields()
    for index in kept:
        fields.append(source_fields.at(index))
    for spec in specs:
        fields.append(qgis_field(spec))
    return fields, kept


def is_null(value):
    """Tell a missing attribute: None, QVariant's NULL (not None on Qt5) or an empty text."""
    if value is None or (isinstance(value, str) and not value.strip()):
        return True
    return isinstance(value, QVariant) and value.isNull()


def number_or_none(value):
    """Give a number, or None for NULL, empty text and what is not a finite number."""
    if is_null(value):
        return None
    try:
        number = float(value)
    except (TypeError, ValueError):
        return None
    return number if number - number == 0 else None


def photo_specs():
    """QGIS's own nine fields of Import geotagged photos, then ours."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("filename", "text", tr("Name")),
        FieldSpec("directory", "text", tr("Folder")),
        FieldSpec("altitude", "real", tr("GPS altitude (m)")),
        FieldSpec("direction", "real", tr("Recorded heading (°)")),
        FieldSpec("rotation", "whole", tr("Rotation by EXIF (°)")),
        FieldSpec("longitude", "text", tr("Longitude (°)")),
        FieldSpec("latitude", "text", tr("Latitude (°)")),
        FieldSpec("timestamp", "time", tr("Taken at (camera's local time)")),
        FieldSpec("f35", "real", tr("35 mm equivalent focal length (mm)")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("vfov", "real", tr("Vertical field of view (°)")),
        FieldSpec("width", "whole", tr("Width of the upright picture (px)")),
        FieldSpec("height", "whole", tr("Height of the upright picture (px)")),
        FieldSpec("dir_ref", "text", tr("Recorded heading counts from (T true, M magnetic north)")),
        FieldSpec("h_acc", "real", tr("GPS horizontal error (m)")),
        FieldSpec("camera", "text", tr("Camera")),
    ]


def rejected_specs():
    """Fields of the table of rejected photographs."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("filename", "text", tr("Name")),
        FieldSpec("directory", "text", tr("Folder")),
        FieldSpec("reason", "text", tr("Reason")),
    ]
