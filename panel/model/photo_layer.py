"""A layer of photo points as the panel sees it: which photographs, in which order, and the values of each point."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path, PureWindowsPath
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsFeatureRequest,
    QgsRasterLayer,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ...algorithms.shared.elevation import layer_fault as raster_fault
from ...algorithms.shared.fields import is_null, number_or_none
from ...algorithms.shared.i18n import tr
from ...algorithms.shared.layers import PATH_FIELDS, absolute_path, folders_of, label_of, position_of
from ...algorithms.shared.lost_crs import loss
from ...algorithms.shared.photo_points import POSE_FIELDS, PoseReading, photo_point, pose_values
from ...core.base.camera import Pose

DOUBTFUL = ("ambiguous", "rejected", "failed")
REVIEW_FIELD, PREVIEW_FIELD = "review", "preview"
VERDICTS = ("accepted", "rejected", "doubtful")
NUMBERS = ("width", "height", "compass", "heading_2", "heading_3", "radius")
"""Further fields whose numbers the panel uses."""


@dataclass(frozen=True, eq=False)
class PhotoItem:
    """One photograph of the layer.

    Attributes
    ----------
    fid : int
    name : str
    path : str or None
    preview : str or None
        A smaller picture to look at if there is no file at `path`.
    point : PhotoPoint
    values : dict
        Number or None for `POSE_FIELDS`, the heading's interval and `NUMBERS`.
    status, message, review : str
        '' if unknown.
    """

    fid: int
    name: str
    path: str | None
    preview: str | None
    point: Any
    values: dict[str, Any] = field(default_factory=dict)
    status: str = ""
    message: str = ""
    review: str = ""

    @property
    def known(self):
        """What the layer says of the photograph, to be compared."""
        place = self.point.observer and (self.point.observer.longitude_deg, self.point.observer.latitude_deg)
        return self.path, self.preview, place, self.values, self.status, self.message, self.review

    @property
    def pose(self):
        """Pose of the point; None without a heading."""
        heading = self.values["HEADING_FIELD"]
        if heading is None:
            return None
        return Pose(heading, self.values["PITCH_FIELD"] or 0.0, self.values["ROLL_FIELD"] or 0.0)


@dataclass(frozen=True)
class _Row:
    """What `photo_point` asks of a point."""

    feature: Any
    name: str
    longitude_deg: Any
    latitude_deg: Any


def layer_fault(layer):
    """Sentence on why a layer cannot be shown, or None."""
    if layer is None or not layer.isValid():
        return tr("Choose a layer of oriented photo points.")
    if layer.geometryType() != QgsWkbTypes.GeometryType.PointGeometry or path_field(layer) is None:
        return tr("The layer has no field with the photographs' paths. Choose the result of Orient photos.")
    if not layer.crs().isValid():
        return tr("The point layer has no coordinate reference system. Assign the right one in the layer's properties.")
    return loss(layer.crs())


def is_photo_layer(layer):
    """Return whether a map layer holds photo points."""
    return isinstance(layer, QgsVectorLayer) and layer_fault(layer) is None


def may_be_dem(layer):
    """Return whether a map layer is a raster file with a single band, as elevation models are."""
    return isinstance(layer, QgsRasterLayer) and raster_fault(layer) is None and layer.bandCount() == 1


def path_field(layer):
    """Name of the field with the paths, or None."""
    names = {column.name().lower(): column.name() for column in layer.fields()}
    return next((names[name] for name in PATH_FIELDS if name in names), None)


class PhotoLayer:
    """Reads a layer; what is in its edit buffer counts.

    Parameters
    ----------
    layer : QgsVectorLayer
        One for which `layer_fault` is None.
    project : QgsProject
    """

    def __init__(self, layer, project):
        self.layer, self.project = layer, project
        self.path_field = path_field(layer)

    def ids(self):
        """Identifiers of all features that the layer shows, in its order."""
        request = QgsFeatureRequest().setFlags(QgsFeatureRequest.Flag.NoGeometry).setNoAttributes()
        return [feature.id() for feature in self.layer.getFeatures(request)]

    def column(self, name):
        """Text of a field by identifier; '' if it is NULL or missing."""
        index = self.layer.fields().lookupField(name)
        if index < 0:
            return {}
        request = QgsFeatureRequest().setFlags(QgsFeatureRequest.Flag.NoGeometry).setSubsetOfAttributes([index])
        return {f.id(): "" if is_null(f[index]) else str(f[index]) for f in self.layer.getFeatures(request)}

    def files(self):
        """Path of each photograph and of what stands in for it, by identifier; see `_files`."""
        folders, previews = folders_of(self.layer, self.project), self.column(PREVIEW_FIELD)
        texts = self.column(self.path_field)
        return {fid: _files(text, previews.get(fid, ""), folders) for fid, text in texts.items()}

    def item(self, fid):
        """Read one photograph; None if the feature does not exist any more."""
        feature = self.layer.getFeature(fid)
        if not feature.isValid() or (
            self.layer.subsetString() and fid not in self.ids()
        ):  # GDAL gives a hidden one too
            return None
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        transform = QgsCoordinateTransform(self.layer.crs(), wgs84, self.project.transformContext())
        path, preview = _files(
            _text(feature, self.path_field), _text(feature, PREVIEW_FIELD), folders_of(self.layer, self.project)
        )
        name = Path(path).name if path else label_of(feature)
        values = {**pose_values(feature, POSE_FIELDS), **{key: _number(feature, key) for key in NUMBERS}}
        size = (values["width"], values["height"]) if values["width"] and values["height"] else None
        row = _Row(feature, name, *position_of(feature, transform))
        point = photo_point(row, values, PoseReading(level=True), path, size)
        texts = [_text(feature, key) for key in ("status", "message", REVIEW_FIELD)]
        return PhotoItem(fid, name, path, preview, point, values, *texts)

    def after(self, fid, step, among=None):
        """Identifier of the next (+1) or previous (-1) photograph, only those in `among` if given; None at the end."""
        ids = self.ids()
        if fid not in ids:
            wanted = [other for other in ids if among is None or other in among]
            return wanted[0] if wanted else None
        rest = ids[ids.index(fid) + 1 :] if step > 0 else ids[: ids.index(fid)][::-1]
        return next((other for other in rest if among is None or other in among), None)

    def doubtful(self):
        """Identifiers of the photographs with a doubtful status."""
        return {fid for fid, status in self.column("status").items() if status in DOUBTFUL}

    def reviewed(self):
        """Identifiers of the photographs that have a verdict."""
        return {fid for fid, verdict in self.column(REVIEW_FIELD).items() if verdict}


def _files(text, preview, folders):
    """Absolute path of a photograph, or None, and of a picture that stands in for it if there is no such file, or None.

    The field `preview` counts from the layer's folder. Orient photos writes the photograph itself there if QGIS can
    show it, so that a photograph can be found there too; otherwise it is a smaller copy, in which pixels do not count.

    Parameters
    ----------
    text, preview : str
        Content of the fields.
    folders : sequence of Path
        From `folders_of`.
    """
    path = absolute_path(text, folders) if text else None
    if not preview or (path and Path(path).is_file()):
        return path, None
    shown = absolute_path(preview, folders)
    if not Path(shown).is_file():
        return path, None
    if path and Path(shown).name == PureWindowsPath(path).name:
        return shown, None
    return path, shown


def _number(feature, name):
    index = feature.fields().lookupField(name)
    return None if index < 0 else number_or_none(feature[index])


def _text(feature, name):
    index = feature.fields().lookupField(name)
    return "" if index < 0 or is_null(feature[index]) else str(feature[index])
