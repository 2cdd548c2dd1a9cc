"""Find and change names of fields that a format reserves or does not distinguish, before anything is written."""

from __future__ import annotations

import re

from qgis.core import QgsField, QgsFields

from .i18n import tr

RESERVED = {
    "gpkg": ("fid", "geom"),
    "sqlite": ("ogc_fid", "geometry"),
    "db": ("ogc_fid", "geometry"),
    "gdb": ("objectid", "shape", "shape_length", "shape_area"),
}
"""By suffix of the file, in lower case; other formats keep every name. The names were found by writing each to each
format."""

NUMBERS_OF_FEATURES = ("fid", "ogc_fid")
"""These may stay if they can number the features: whole numbers, each once."""

SUFFIX = re.compile(r"\.(gpkg|sqlite|db|gdb)\b", re.IGNORECASE)


def writable(fields, rows, destination):
    """Rename fields that the output's format cannot hold.

    Parameters
    ----------
    fields : QgsFields
    rows : list of (QgsGeometry or None, list)
        Geometry and attributes.
    destination : str or None
        As the user gave it.

    Returns
    -------
    fields : QgsFields
        The same object if no name changes.
    changed : list of (str, str)
        Old and new names.
    """
    found = SUFFIX.findall(destination or "")
    if not found:
        return fields, []
    reserved = RESERVED[found[-1].lower()]
    renamed, changed, taken = QgsFields(), [], {field.name().lower() for field in fields}
    seen = set()
    for index, field in enumerate(fields):
        name = field.name()
        bad = name.lower() in reserved and not _numbers_features(field, index, rows)
        if bad or name.lower() in seen:  # SQL does not tell upper from lower case
            field = QgsField(field)
            field.setName(_free(name, taken))
            changed.append((name, field.name()))
        seen.add(field.name().lower())
        taken.add(field.name().lower())
        renamed.append(field)
    return (renamed, changed) if changed else (fields, [])


def _numbers_features(field, index, rows):
    if field.name().lower() not in NUMBERS_OF_FEATURES:
        return False
    values = [attributes[index] for _, attributes in rows]
    return all(type(value) is int and value >= 0 for value in values) and len(set(values)) == len(values)


def _free(name, taken):
    number = 1
    while f"{name}_{number}".lower() in taken:
        number += 1
    return f"{name}_{number}"


def tell_changed(feedback, changed):
    """Report the new names of fields in the log."""
    if changed and feedback is not None:
        names = ", ".join(f"{old} → {new}" for old, new in changed)
        feedback.pushInfo(
            tr("Fields renamed because the format of the output reserves the name: {names}").format(names=names)
        )
