"""Features drawn on photographs, from a layer or a file, as the core's `PixelFeature`s."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
)

from ...core.base.messages import Message
from ...core.base.photo_names import owners
from ...core.base.pixel_features import PixelFeature, counts_upwards, downward, open_ring
from . import parameters as shared
from .feedback import warn
from .fields import is_null, number_or_none
from .i18n import tr
from .map_places import kind_of, of_one_kind, places_of, simple_parts

PHOTO_NAMES = ("photo", "image", "filename", "file_name", "file", "path")
X_NAMES = ("x_px", "x", "column", "col", "pixel_x")
Y_NAMES = ("y_px", "y", "row", "pixel_y")
LABEL_NAMES = ("label", "name", "class")


def add_pixel_parameters(algorithm):
    """Declare the two inputs for drawn features."""
    layer = QgsProcessingParameterFeatureSource(
        "PIXELS", tr("Image features"), [QgsProcessing.SourceType.TypeVector], optional=True
    )
    text = tr(
        "Points, lines or polygons as drawn in QGIS over the photo itself (not rotated, y negative), or in pixels of "
        "the upright picture with y counted downwards, or a table with fields x and y. A field photo "
        "names the photograph; without it the features belong to every photo."
    )
    algorithm.addParameter(shared.explained(layer, text))
    file = QgsProcessingParameterFile(
        "PIXEL_FILE",
        tr("Image features from a labelling tool"),
        QgsProcessingParameterFile.Behavior.File,
        optional=True,
        fileFilter=tr("Label files (*.json *.geojson *.csv);;All files (*)"),
    )
    text = tr("LabelMe, COCO, VIA, GeoJSON with pixel coordinates, or CSV with photo, x, y (and feature, kind, label).")
    algorithm.addParameter(shared.explained(file, text))


def pixel_fault(algorithm, parameters, context):
    """Sentence on missing or unreadable input, or None."""
    path = algorithm.parameterAsFile(parameters, "PIXEL_FILE", context)
    if is_null(parameters.get("PIXELS")) and not path:
        return tr("Give image features: a layer, or a file from a labelling tool.")
    return None


def pixel_features(algorithm, parameters, context, feedback):
    """Features of both inputs together; raises the core's error or `QgsProcessingException`."""
    from ...core.io.features import read_features

    path = algorithm.parameterAsFile(parameters, "PIXEL_FILE", context)
    features, notes = read_features(path) if path else ([], [])
    for note in notes:
        warn(feedback, Path(path).name, note)
    if not is_null(parameters.get("PIXELS")):
        source = algorithm.parameterAsSource(parameters, "PIXELS", context)
        if source is None:
            raise QgsProcessingException(algorithm.invalidSourceError(parameters, "PIXELS"))
        features += _of_source(source)
    if not features:
        raise QgsProcessingException(tr("The image features are empty: draw something on a photo first."))
    return features


def _of_source(source):
    names = {field.name().lower(): field.name() for field in source.fields()}
    photo, label, x, y = (
        next((names[n] for n in wanted if n in names), None) for wanted in (PHOTO_NAMES, LABEL_NAMES, X_NAMES, Y_NAMES)
    )
    features = []
    for feature in source.getFeatures():
        named = "" if photo is None or is_null(feature[photo]) else str(feature[photo])
        called = "" if label is None or is_null(feature[label]) else str(feature[label])
        geometry = feature.geometry()
        if not geometry.isNull() and not geometry.isEmpty():
            features += _of_geometry(named, called, geometry)
        elif x is not None and y is not None:
            place = number_or_none(feature[x]), number_or_none(feature[y])
            if None not in place:
                parts = [np.array([place])]
                stored = counts_upwards(parts)
                features.append(PixelFeature(named, "point", downward(parts), called, as_stored=stored))
        else:
            raise QgsProcessingException(
                tr(
                    "The image features have neither a geometry in pixels nor fields x and y; they have {fields}."
                ).format(fields=", ".join(names.values()))
            )
    return features


def _of_geometry(photo, label, geometry):
    """Features of a drawn geometry; each polygon of a multipolygon has its own holes."""
    drawn = []
    for shape in of_one_kind(geometry):
        kind = kind_of(shape)
        for piece in [shape] if kind == "point" else simple_parts(shape):
            rings = [np.column_stack([x, y]) for x, y, _ in places_of(piece, kind)]
            drawn.append((kind, [open_ring(ring) for ring in rings] if kind == "polygon" else rings))
    rings = [ring for _, rings in drawn for ring in rings]
    turned, as_stored = iter(downward(rings)), counts_upwards(rings)
    return [
        PixelFeature(photo, kind, tuple(next(turned) for _ in rings), label, as_stored=as_stored)
        for kind, rings in drawn
    ]


class FeaturesByPhoto:
    """The drawn features of a run, by the photo on which each was drawn.

    Parameters
    ----------
    features : list of PixelFeature
    photos : list of str
        Paths or names of all photos of the run.
    """

    def __init__(self, features, photos):
        self._features = features
        self._owners = owners((f.photo for f in features if f.photo), photos)
        self._used = set()

    def of(self, photo):
        """Features of a photo; those that name no photo belong to every one."""
        mine = [f for f in self._features if not f.photo or self._owners.get(f.photo) == photo]
        self._used.update(mine)
        return mine

    def tell_unused(self, feedback):
        """Warn of features whose photo is not among the points, or is not clear."""
        lost = sorted({f.photo for f in self._features if f not in self._used})
        unclear = [photo for photo in lost if self._owners.get(photo, "") is None]
        absent = [photo for photo in lost if photo not in unclear]
        if unclear:
            feedback.pushWarning(
                tr(
                    "Several photos have these names, so the features were left out: {names}. Write the folders too, "
                    "for example day1/IMG_0001.jpg."
                ).format(names=_some(unclear))
            )
        if absent:
            feedback.pushWarning(tr("No oriented photo point for: {names}").format(names=_some(absent)))


def _some(names):
    return ", ".join(names[:5]) + (" ..." if len(names) > 5 else "")


def upright_features(photo, features, feedback):
    """Features in pixels of the upright picture of an `OpenedPhoto`; those that do not fit it get a warning."""
    from ...core.base.errors import PhotoError
    from ...core.base.upright import on_upright

    camera, upright, told = photo.view.camera, [], set()
    orientation = orientation_of(photo.path)
    for feature in features:
        try:
            feature, note = on_upright(feature, camera.width_px, camera.height_px, orientation)
            upright.append(feature)
        except PhotoError as error:
            note = error.message
        if note is None and _other_file(photo.path, feature.file_bytes):
            note = Message(
                "Its features were drawn on a file of {bytes} bytes, which is another copy of this photo. If that copy "
                "is reduced, they are in the wrong place.",
                bytes=feature.file_bytes,
            )
        if note is not None and str(note) not in told:
            told.add(str(note))
            warn(feedback, photo.name, note)
    return upright


def orientation_of(path):
    """EXIF Orientation by which a stored picture becomes upright; 1 if none has to be applied or there is no file."""
    from ...core.io.photo import stored_orientation

    return stored_orientation(path) if path and Path(path).exists() else 1


def _other_file(path, file_bytes):
    return bool(file_bytes and path and Path(path).exists() and Path(path).stat().st_size != file_bytes)
