"""The attributes that we write: names (a contract, at most 10 characters), types, and aliases with units."""

from __future__ import annotations

from qgis.core import Qgis, QgsField, QgsFields
from qgis.PyQt.QtCore import QMetaType, QVariant

from ...core.base.attributes import FieldSpec, photo_fields
from ...core.base.summit_heights import height_m
from .i18n import marked, tr

_QT_NAMES = {
    "text": ("QString", "String"),
    "real": ("Double", "Double"),
    "whole": ("Int", "Int"),
    "yes": ("Bool", "Bool"),
    "time": ("QDateTime", "DateTime"),
    "bytes": ("QByteArray", "ByteArray"),
}


def qgis_field(spec):
    """Make the `QgsField`."""
    field = QgsField(spec.name, _type(spec.kind))
    field.setAlias(spec.alias)
    return field


def _type(kind):
    """Type of a field in the type system of the running QGIS (QMetaType from 3.38 on)."""
    names = _QT_NAMES[kind]
    return getattr(QMetaType.Type, names[0]) if Qgis.QGIS_VERSION_INT >= 33800 else getattr(QVariant, names[1])


def is_binary(field):
    """Return whether a `QgsField` holds bytes, such as a picture."""
    return field.type() == _type("bytes")


def qgis_fields(specs):
    """Make `QgsFields` from specifications."""
    fields = QgsFields()
    for spec in specs:
        fields.append(qgis_field(spec))
    return fields


def joined_fields(source_fields, specs):
    """All source fields plus ours, which replace source fields of the same name.

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
    """Return whether an attribute is missing: None, QVariant's NULL (not None on Qt5) or an empty text."""
    if value is None or (isinstance(value, str) and not value.strip()):
        return True
    return isinstance(value, QVariant) and value.isNull()


def number_or_none(value):
    """Return a number, or None for NULL, empty text and any value that is not a finite number."""
    if is_null(value):
        return None
    try:
        number = float(value)
    except (TypeError, ValueError):
        return None
    return number if number - number == 0 else None


def metres_of(value):
    """Height in metres of a number, or of text as OpenStreetMap has it ("2290 m", "7513 ft"); None if there is none."""
    if is_null(value):
        return None
    number = number_or_none(value)
    return height_m(str(value)) if number is None else number


def photo_specs():
    """QGIS's own nine fields of Import geotagged photos, then ours."""
    return photo_fields(marked)


def rejected_specs():
    """Fields of the table of rejected photographs."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("filename", "text", tr("Name")),
        FieldSpec("directory", "text", tr("Folder")),
        FieldSpec("reason", "text", tr("Reason")),
    ]
