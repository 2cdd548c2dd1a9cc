"""The table of lenses: its rows, and the distortion that it gives to photo points."""

from __future__ import annotations

from dataclasses import replace

from qgis.core import QgsFeature, QgsFields, QgsProcessing, QgsProcessingException, QgsProcessingParameterFeatureSource

from ...core.base.attributes import FieldSpec
from ...core.base.errors import PhotoError
from ...core.base.lens_table import LensRow, fitting_rows
from . import parameters as shared
from .fields import is_null, number_or_none, qgis_field
from .i18n import tr
from .photo_points import DISTORTION_FIELDS, lens_of, value_of

TEXTS = {"make": ("make",), "model": ("model",), "lens": ("lens", "lensmodel", "lens_model")}
LENGTHS = {
    "focal_mm": ("focal", "focal_mm", "focal_length", "focallength"),
    "focal_35mm": ("f35", "focal_35mm", "focal_length_35mm", "focallengthin35mmfilm"),
}
"""Fields by which a row fits a photograph, and the names that they may have."""

MOST_NAMES = 5
"""Largest number of photographs that a sentence names."""


def add_lens_table_parameter(algorithm):
    """Declare the table."""
    parameter = QgsProcessingParameterFeatureSource(
        "LENS_TABLE", tr("Table of lenses"), [QgsProcessing.SourceType.TypeVector], optional=True
    )
    text = tr(
        "Distortion of known lenses, for example a CSV file: fields k1 and k2 (Brown, as in OpenCV), and at least one "
        "of make, model, lens, focal (mm) and f35 (mm), as in the photos' EXIF data; empty values fit all. The row "
        "that names most of a photo is used. Values in fields k1 and k2 of the points take precedence."
    )
    algorithm.addParameter(shared.advanced(shared.explained(parameter, text)))


def lens_table_fault(algorithm, parameters, context):
    """Sentence on what is wrong with the table, or None."""
    try:
        _read(algorithm, parameters, context)
    except QgsProcessingException as error:
        return str(error)
    return None


# parameters: as in QGIS, and the layer
def with_lens_table(algorithm, parameters, context, fields, rows):
    """Add the table's distortion to photo points, as if it stood in their fields k1 and k2.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`.
    fields : QgsFields
        Fields of the points.
    rows : list of PointRow

    Returns
    -------
    fields : QgsFields
        With k1 and k2, if there is a table.
    rows : list of PointRow

    Raises
    ------
    QgsProcessingException
        If the table is unusable, or two of its rows fit a photograph equally well.
    """
    table = _read(algorithm, parameters, context)
    if table is None:
        return fields, rows
    fields = _with_distortion(fields)
    filled, unknown, count = [], [], 0
    for row in rows:
        given = any(value_of(row.feature, name) is not None for name in DISTORTION_FIELDS)
        lens, said = (None, "") if given else _lens_of(row, table)
        values = lens_of(row.feature) if given else {name: getattr(lens, name, None) for name in DISTORTION_FIELDS}
        filled.append(replace(row, feature=_filled(row.feature, fields, values)))
        count += lens is not None
        if said and lens is None:
            unknown.append(f"{row.name} ({said})")
    _tell(context.feedback(), count, len(rows), unknown)
    return fields, filled


def _tell(feedback, count, total, unknown):
    feedback.pushInfo(tr("{count} of {total} photos take k1 and k2 from the table of lenses.").format(
        count=count, total=total
    ))  # fmt: skip
    if unknown:
        names = ", ".join(unknown[:MOST_NAMES]) + (", ..." if len(unknown) > MOST_NAMES else "")
        feedback.pushWarning(
            tr(
                "No row of the table of lenses fits {count} photos, which are treated as free of distortion: {names}."
            ).format(count=len(unknown), names=names)
        )


def _lens_of(row, table):
    """Row of the table that fits a photograph, and what the file says of its camera; None and "" if unreadable."""
    from ...core.io.photo import read_metadata

    if row.path is None:
        return None, ""
    try:
        metadata = read_metadata(row.path)
    except PhotoError:  # the orientation reports the reason
        return None, ""
    found = fitting_rows(table, metadata)
    if len({(row.k1, row.k2) for row in found}) > 1:
        raise QgsProcessingException(
            tr(
                "Rows {first} and {second} of LENS_TABLE fit {photo} equally well. Name more of its lens in one."
            ).format(first=found[0].number, second=found[1].number, photo=row.name)
        )
    focal = metadata.focal_length_mm
    said = [metadata.camera, metadata.lens, None if focal is None else f"{focal:g} mm"]
    return (found[0] if found else None), ", ".join(filter(None, said)) or tr("no camera in the file")


def _with_distortion(fields):
    joined = QgsFields(fields)
    for name, alias in zip(DISTORTION_FIELDS, (tr("Radial distortion k1"), tr("Radial distortion k2"))):
        if fields.lookupField(name) < 0:
            joined.append(qgis_field(FieldSpec(name, "real", alias)))
    return joined


def _filled(feature, fields, values):
    """Copy of a feature with the distortion in its fields."""
    copy = QgsFeature(fields, feature.id())
    copy.setGeometry(feature.geometry())
    copy.setAttributes(feature.attributes() + [None] * (len(fields) - len(feature.fields())))
    for name, value in values.items():
        copy.setAttribute(fields.lookupField(name), value)
    return copy


def _read(algorithm, parameters, context):
    """Rows of the table; None if none is chosen. Raises QgsProcessingException with what is wrong with it."""
    if is_null(parameters.get("LENS_TABLE")):
        return None
    source = algorithm.parameterAsSource(parameters, "LENS_TABLE", context)
    if source is None:
        raise QgsProcessingException(algorithm.invalidSourceError(parameters, "LENS_TABLE"))
    own = {field.name().lower(): field.name() for field in source.fields()}
    named = {**TEXTS, **LENGTHS}
    columns = {key: next((own[name] for name in named[key] if name in own), None) for key in named}
    if "k1" not in own or not any(columns.values()):
        raise QgsProcessingException(
            tr(
                "The table LENS_TABLE needs the fields k1 and k2 and at least one of make, model, lens, focal and f35; "
                "it has {fields}."
            ).format(fields=", ".join(own.values()))
        )
    columns.update(k1=own["k1"], k2=own.get("k2"))
    table = [_row(number, feature, columns) for number, feature in enumerate(source.getFeatures(), 1)]
    if not table:
        raise QgsProcessingException(tr("The table LENS_TABLE has no row."))
    first: dict = {}
    for row in table:
        twin = first.setdefault(row.named, row)
        if (twin.k1, twin.k2) != (row.k1, row.k2):
            raise QgsProcessingException(
                tr("Rows {first} and {second} of LENS_TABLE give one lens different distortions. Delete one.").format(
                    first=twin.number, second=row.number
                )
            )
    return table


def _row(number, feature, columns):
    texts: dict = {key: "" if columns[key] is None else _text(feature[columns[key]]) for key in TEXTS}
    lengths = {key: _number(number, feature, columns[key]) for key in LENGTHS}
    for key, value in lengths.items():
        if value is not None and value <= 0:
            raise _no_number(number, feature, columns[key])
    k1, k2 = (_number(number, feature, columns[name]) for name in DISTORTION_FIELDS)
    row = LensRow(number, **texts, **lengths, k1=k1 or 0.0, k2=k2 or 0.0)
    if k1 is None:
        raise QgsProcessingException(tr("Row {row} of LENS_TABLE has no k1.").format(row=number))
    if row.count == 0:
        raise QgsProcessingException(
            tr("Row {row} of LENS_TABLE names no camera, lens or focal length that it is for.").format(row=number)
        )
    return row


def _number(number, feature, column):
    """Number of a row's field; None if the field is missing or empty."""
    if column is None or is_null(feature[column]):
        return None
    value = number_or_none(feature[column])
    if value is None:
        raise _no_number(number, feature, column)
    return value


def _no_number(number, feature, column):
    return QgsProcessingException(
        tr(
            "Row {row} of LENS_TABLE: {field} is {value}. Give one positive number for a focal length, and numbers "
            "with a decimal point for k1 and k2."
        ).format(row=number, field=column, value=feature[column])
    )


def _text(value):
    return "" if is_null(value) else str(value).strip()
