"""Photographs from a folder or from a layer, as rows of one type."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from qgis.core import QgsCoordinateReferenceSystem, QgsFeature, QgsFields, QgsWkbTypes

from ...core.base.attributes import has_position
from ...core.base.errors import PhotoError
from ...core.base.progress import checkpoint
from .feedback import FeedbackProgress
from .fields import is_null, joined_fields, photo_specs, qgis_fields
from .i18n import tr
from .layers import PointRow, points_fault, read_points
from .lens_table import with_lens_table
from .orientation import NUMBER_FIELDS
from .oriented import oriented_specs
from .photo_attributes import attributes_of, photos_in, point_of


@dataclass(frozen=True)
class PhotoRows:
    """Photographs to orient, and the structure of their output layer.

    Attributes
    ----------
    rows : list of PointRow
    fields : QgsFields
        Fields of the source, and ours.
    kept : list of int
        Indices of the source's fields that are kept.
    wkb_type : QgsWkbTypes.Type
    crs : QgsCoordinateReferenceSystem
    """

    rows: list
    fields: QgsFields
    kept: list
    wkb_type: Any
    crs: QgsCoordinateReferenceSystem


def folder_fault(algorithm, parameters, context):
    """Sentence on a missing or duplicate choice of photographs, or None."""
    folder = algorithm.parameterAsString(parameters, "FOLDER", context)
    layer = parameters.get("INPUT")
    if not folder and is_null(layer):
        return tr("Choose a folder of photographs or a layer of photo points.")
    if folder and not is_null(layer):
        return tr("Choose either a folder of photographs or a layer of photo points, not both.")
    if folder and not Path(folder).is_dir():
        return tr("The folder {folder} does not exist.").format(folder=folder)
    if not folder:
        return points_fault(algorithm, parameters, context, "INPUT", "PHOTO_FIELD", NUMBER_FIELDS)
    return None


def photo_rows(algorithm, parameters, context, feedback):
    """Read the photographs that the user chose."""
    folder = algorithm.parameterAsString(parameters, "FOLDER", context)
    if folder:
        paths = photos_in(folder, algorithm.parameterAsBoolean(parameters, "RECURSIVE", context), feedback)
        source_fields = qgis_fields(photo_specs())
        rows = read_files(paths, source_fields, feedback)
        source_fields, rows = with_lens_table(algorithm, parameters, context, source_fields, rows)
        fields, kept = joined_fields(source_fields, oriented_specs())
        return PhotoRows(rows, fields, kept, QgsWkbTypes.Type.PointZ, QgsCoordinateReferenceSystem("EPSG:4326"))
    source, rows = read_points(algorithm, parameters, context, "INPUT", "PHOTO_FIELD", NUMBER_FIELDS)
    source_fields, rows = with_lens_table(algorithm, parameters, context, source.fields(), rows)
    fields, kept = joined_fields(source_fields, oriented_specs())
    return PhotoRows(rows, fields, kept, source.wkbType(), source.sourceCrs())


def read_files(paths, fields, feedback):
    """Rows of all files; thousands of them take a while, so cancelling must work here too."""
    progress, rows = FeedbackProgress(feedback), []
    for index, path in enumerate(paths):
        checkpoint(progress, 0.0)
        rows.append(file_row(path, index, fields))
    return rows


def file_row(path, index, fields):
    """Row of one file; an unreadable file has only its path, and the orientation reports the reason."""
    from ...core.io.photo import read_metadata

    feature = QgsFeature(fields, index + 1)
    try:
        metadata = read_metadata(path)
        feature.setAttributes(attributes_of(metadata))
        if has_position(metadata):
            feature.setGeometry(point_of(metadata))
    except PhotoError:
        feature["photo"], feature["filename"] = str(path), Path(path).stem
        feature["directory"] = str(Path(path).parent)
    return PointRow(feature, Path(path).name, None, None, str(path))
