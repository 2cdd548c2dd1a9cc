"""User input for photographs that fail: landmarks, drawn skylines and sky masks, assigned by the photo's name."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
)

from . import parameters as shared
from .fields import is_null, number_or_none
from .i18n import tr
from .layers import position_of, wgs84_transform

X_NAMES, Y_NAMES = ("x", "column", "x_px", "col"), ("y", "row", "y_px")
MASK_SUFFIXES = (".png", ".tif", ".tiff", ".jpg", ".jpeg")


def add_rescue_parameters(algorithm):
    """Declare the optional inputs, all under 'Advanced'."""
    algorithm.addParameter(
        shared.advanced(
            shared.number_field(
                "HEADING_HINT_FIELD",
                tr("Field with an approximate heading (°)"),
                tr("Approximate true heading, clockwise from north. The answer must be near it. NULL: none."),
            )
        )
    )
    algorithm.addParameter(
        shared.advanced(
            shared.number_field(
                "TOLERANCE_FIELD",
                tr("Field with the tolerance of that heading (°)"),
                tr("How far the heading may differ from the approximate one. NULL: 20 degrees."),
            )
        )
    )
    algorithm.addParameter(
        _table(
            "LANDMARKS",
            tr("Landmarks"),
            tr(
                "Points on the map that are visible in photographs, with the fields photo, x and y (pixels "
                "of the upright picture; the first pixel is 0) and optionally elevation (m). One landmark is "
                "enough to determine the heading."
            ),
            [QgsProcessing.SourceType.TypeVectorPoint],
        )
    )
    algorithm.addParameter(
        _table(
            "SKYLINES",
            tr("Drawn skylines"),
            tr("Table with fields photo, column and row (pixels of the upright picture): the vertices of the skyline."),
            [QgsProcessing.SourceType.TypeVector],
        )
    )
    algorithm.addParameter(
        shared.advanced(
            shared.folder_in(
                "SKY_MASKS",
                tr("Folder of sky masks"),
                tr("Pictures named like the photographs (IMG_1.png for IMG_1.heic) in which the sky is white."),
                optional=True,
            )
        )
    )


def _table(name, label, text, kinds):
    parameter = QgsProcessingParameterFeatureSource(name, label, kinds, optional=True)
    return shared.explained(shared.advanced(parameter), text)


class Rescue:
    """The hints of one run, by photograph.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the parameters of `add_rescue_parameters` are read.
    """

    def __init__(self, algorithm, parameters, context):
        self.landmarks = _landmarks(algorithm.parameterAsSource(parameters, "LANDMARKS", context), context)
        self.skylines = _skylines(algorithm.parameterAsSource(parameters, "SKYLINES", context))
        self.masks = _masks(algorithm.parameterAsString(parameters, "SKY_MASKS", context))

    def of(self, path):
        """Keyword arguments for the `PhotoRequest` of a photo."""
        found = {"landmarks": tuple(_for_photo(self.landmarks, path) or ())}
        line = _for_photo(self.skylines, path)
        if line:
            found["drawn_skyline"] = tuple(sorted(line))
        mask = self.masks.get(Path(path).stem.lower())
        if mask:
            found["sky_mask_path"] = mask
        return found


def _key(photo):
    return str(photo).replace("\\", "/").rsplit("/", 1)[-1].lower()


def _for_photo(table, path):
    """Entries under the file's name, with or without its extension."""
    return table.get(_key(path)) or table.get(Path(_key(path)).stem)


def _landmarks(source, context):
    from ...core.batch import LandmarkHint

    found = {}
    if source is None:
        return found
    to_wgs84 = wgs84_transform(source, context)
    columns = _columns(source, "LANDMARKS")
    for feature in source.getFeatures():
        photo, x, y = (feature[column] for column in columns)
        longitude, latitude = position_of(feature, to_wgs84)
        x, y = number_or_none(x), number_or_none(y)
        if is_null(photo) or None in (x, y, longitude):
            continue
        height = _optional_number(source, feature, ("elevation", "elev", "z", "height"))
        found.setdefault(_key(photo), []).append(LandmarkHint(x, y, longitude, latitude, height))
    return found


def _skylines(source):
    found = {}
    if source is None:
        return found
    columns = _columns(source, "SKYLINES")
    for feature in source.getFeatures():
        photo, x, y = (feature[column] for column in columns)
        x, y = number_or_none(x), number_or_none(y)
        confidence = _optional_number(source, feature, ("confidence",))
        if not is_null(photo) and None not in (x, y) and (confidence is None or confidence > 0):
            found.setdefault(_key(photo), []).append((x, y))
    return found


def _columns(source, parameter):
    """Names of the fields for photo, x and y."""
    names = {field.name().lower(): field.name() for field in source.fields()}
    columns = [
        next((names[name] for name in wanted if name in names), None)
        for wanted in (("photo", "image", "filename"), X_NAMES, Y_NAMES)
    ]
    if None in columns:
        raise QgsProcessingException(
            tr("The table {parameter} needs the fields photo, x and y (or column and row); it has {fields}.").format(
                parameter=parameter, fields=", ".join(names.values())
            )
        )
    return columns


def _optional_number(source, feature, wanted):
    for field in source.fields():
        if field.name().lower() in wanted:
            return number_or_none(feature[field.name()])
    return None


def _masks(folder):
    if not folder:
        return {}
    if not Path(folder).is_dir():
        raise QgsProcessingException(tr("The folder of sky masks {folder} does not exist.").format(folder=folder))
    files = (path for path in sorted(Path(folder).iterdir()) if path.suffix.lower() in MASK_SUFFIXES)
    return {path.stem.lower(): str(path) for path in files}
