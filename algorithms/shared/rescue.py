"""User input for photographs that fail: landmarks, drawn skylines and sky masks, assigned by the photo's name."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
)

from ...core.base.errors import PhotoError
from ...core.base.photo_names import owners
from ...core.base.pixel_features import PixelFeature, counts_upwards, downward
from ...core.base.sun_moon import BODIES
from ...core.base.upright import on_upright
from . import parameters as shared
from .fields import is_null, metres_of, number_or_none
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
                "enough to determine the heading. If a field body says sun or moon, the pixel shows that, and no "
                "map point is needed: its direction follows from the time of the photograph."
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
    paths : list of str
        All photographs of the run.
    """

    def __init__(self, algorithm, parameters, context, paths):
        landmarks = _landmarks(algorithm.parameterAsSource(parameters, "LANDMARKS", context), context)
        skylines = _skylines(algorithm.parameterAsSource(parameters, "SKYLINES", context))
        self._landmarks = _by_photo(landmarks, paths, "LANDMARKS")
        self._skylines = _by_photo(skylines, paths, "SKYLINES")
        self._masks = _by_photo(
            _masks(algorithm.parameterAsString(parameters, "SKY_MASKS", context)), paths, "SKY_MASKS"
        )

    def of(self, path):
        """Keyword arguments for the `PhotoRequest` of a photo."""
        marks = self._landmarks.get(path, ())
        found = {"landmarks": tuple(replace(m, **_upright_pixel(path, m)) if m.y_px < 0 else m for m in marks)}
        line = self._skylines.get(path)
        if line:
            found["drawn_skyline"] = tuple(sorted(map(tuple, _upright(path, line))))
        masks = self._masks.get(path)
        if masks:
            found["sky_mask_path"] = masks[-1]
        return found


def _by_photo(table, paths, parameter):
    """Entries of a table {reference: list} by the photo that each reference means."""
    found: dict = {}
    unclear: list = []
    for reference, path in owners(table, paths).items():
        if path is None:
            unclear.append(str(reference))
        else:
            found.setdefault(path, []).extend(table[reference])
    if unclear:
        raise QgsProcessingException(
            tr(
                "{parameter}: several photos have the name {names}. Write the folders too, for example "
                "day1/IMG_0001.jpg; put sky masks into folders of the same names."
            ).format(parameter=parameter, names=", ".join(unclear[:5]))
        )
    return found


def _upright(path, places):
    """Pixels of the upright picture; those that QGIS counts upwards were drawn on the picture as it is stored."""
    parts = [np.asarray(places, float)]
    if not counts_upwards(parts) or not Path(path).exists():
        return places
    from ...core.io.photo import read_metadata, stored_orientation

    drawn = PixelFeature(path, "line", downward(parts), as_stored=True)
    try:
        metadata = read_metadata(path)
        drawn, _ = on_upright(drawn, metadata.width_px, metadata.height_px, stored_orientation(path))
    except PhotoError:  # the orientation reports the reason
        return places
    return drawn.parts[0].tolist()


def _upright_pixel(path, mark):
    ((x, y),) = _upright(path, [(mark.x_px, mark.y_px)])
    return {"x_px": x, "y_px": y}


def _landmarks(source, context):
    from ...core.base.landmark_hint import LandmarkHint

    found: dict = {}
    if source is None:
        return found
    to_wgs84 = wgs84_transform(source, context)
    columns = _columns(source, "LANDMARKS")
    for feature in source.getFeatures():
        photo, x, y = (feature[column] for column in columns)
        longitude, latitude = position_of(feature, to_wgs84)
        x, y = number_or_none(x), number_or_none(y)
        body = _optional(source, feature, ("body",), _body_of)
        if is_null(photo) or None in (x, y) or (longitude is None and body is None):
            continue
        height = _optional(source, feature, ("elevation", "elev", "z", "height"), metres_of)
        found.setdefault(str(photo), []).append(LandmarkHint(x, y, longitude, latitude, height, body=body))
    return found


def _body_of(value):
    """The sun or the moon, or None for a map point."""
    text = "" if is_null(value) else str(value).strip().lower()
    if text in ("", *BODIES):
        return text or None
    raise QgsProcessingException(
        tr("LANDMARKS: the field body says {value}; it may say sun or moon, or be empty.").format(value=text)
    )


def _skylines(source):
    found: dict = {}
    if source is None:
        return found
    columns = _columns(source, "SKYLINES")
    for feature in source.getFeatures():
        photo, x, y = (feature[column] for column in columns)
        x, y = number_or_none(x), number_or_none(y)
        confidence = _optional(source, feature, ("confidence",), number_or_none)
        if not is_null(photo) and None not in (x, y) and (confidence is None or confidence > 0):
            found.setdefault(str(photo), []).append((x, y))
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


def _optional(source, feature, wanted, read):
    for field in source.fields():
        if field.name().lower() in wanted:
            return read(feature[field.name()])
    return None


def _masks(folder):
    if not folder:
        return {}
    if not Path(folder).is_dir():
        raise QgsProcessingException(tr("The folder of sky masks {folder} does not exist.").format(folder=folder))
    files = (path for path in sorted(Path(folder).rglob("*")) if path.suffix.lower() in MASK_SUFFIXES)
    return {str(path): [str(path)] for path in files}
