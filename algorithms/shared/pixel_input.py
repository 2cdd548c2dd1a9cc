"""Features drawn on photographs, from a layer or a file, as the core's `PixelFeature`s."""

from __future__ import annotations

import numpy as np
from qgis.core import (
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
)

from ...core.base.pixel_features import PixelFeature, downward, open_ring
from . import parameters as shared
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
        "Points, lines or polygons whose coordinates are pixels of the upright picture (as drawn in QGIS over the "
        "photo itself, where y is negative, or y counted downwards), or a table with fields x and y. A field photo "
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


def pixel_features(algorithm, parameters, context):
    """Features of both inputs together; raises the core's error or `QgsProcessingException`."""
    from ...core.io.features import read_features

    path = algorithm.parameterAsFile(parameters, "PIXEL_FILE", context)
    features = read_features(path) if path else []
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
                features.append(PixelFeature(named, "point", (np.array([place]),), called))
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
    turned = iter(downward([ring for _, rings in drawn for ring in rings]))
    return [PixelFeature(photo, kind, tuple(next(turned) for _ in rings), label) for kind, rings in drawn]
