"""Map layers and summits as directions from the eye, as Map to pixels and Label peaks find them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from qgis.core import QgsProcessingContext, QgsProcessingException, QgsVectorLayer, QgsWkbTypes

from ...algorithms.shared.image_features import ImageFeatures, Placement, read_map_features
from ...algorithms.shared.map_places import to_dem_transform
from ...algorithms.shared.summit_input import Summitry, read_summits
from ...algorithms.shared.views import OpenedPhoto
from ...core.base.progress import SILENT
from .ground import REACH_M, posed_photo, view_of
from .overlays import Trace

MOST_FEATURES = 3_000
"""A layer with more is left out: projecting it would take longer than a look at the picture."""

STEP_PX = 3.0
HEIGHT_NAMES = ("ele", "elevation", "height", "height_m")


@dataclass(frozen=True)
class _Source:
    """A layer as the classes of the algorithms read it."""

    layer: Any

    def sourceCrs(self):
        """CRS of the features."""
        return self.layer.crs()

    def getFeatures(self):
        """Yield the features."""
        return self.layer.getFeatures()

    def fields(self):
        """Fields of the features."""
        return self.layer.fields()


def _name_field(layer):
    return next((field.name() for field in layer.fields() if field.name().lower() == "name"), "")


def shown_layers(layers, photo_layer):
    """Vector layers of a map that can be projected.

    Parameters
    ----------
    layers : list of QgsMapLayer
    photo_layer : QgsVectorLayer
    """
    return [
        layer
        for layer in layers
        if isinstance(layer, QgsVectorLayer)
        and layer.isValid()
        and layer is not photo_layer
        and layer.geometryType() != QgsWkbTypes.GeometryType.NullGeometry
        and layer.crs().isValid()
        and 0 < layer.featureCount() <= MOST_FEATURES
        and not _is_derived(layer)
    ]


def _is_derived(layer):
    """Whether a layer shows what photographs see, which would cover the picture with itself."""
    return layer.fields().lookupField("photo") >= 0


def read_layers(layers, dem_crs, project):
    """Read layers for `traces_of`; in the thread to which they belong.

    Parameters
    ----------
    layers : list of QgsVectorLayer
    dem_crs : QgsCoordinateReferenceSystem
    project : QgsProject
    """
    context = QgsProcessingContext()
    context.setProject(project)
    found = []
    for layer in layers:
        try:
            transform = to_dem_transform(layer.crs(), dem_crs, context)
            found.append(read_map_features(_Source(layer), transform, _name_field(layer), ""))
        except QgsProcessingException:  # nothing of the layer lies where the DEM's CRS is valid
            continue
    return found


def traces_of(readings, item, ground, camera, pose):
    """Traces and names of what `read_layers` read.

    Parameters
    ----------
    readings : list of lists of MapFeature
    item : PhotoItem
    ground : Ground
    camera : Camera
    pose : Pose

    Returns
    -------
    traces : list of Trace
    names : list of (text, azimuth, elevation angle)
    """
    from ...core.mapping.sightline import SightOptions

    options = SightOptions(max_distance_m=REACH_M)
    view = view_of(ground, posed_photo(ground, camera, pose))
    photo = OpenedPhoto(item.point.feature, item.name, item.path, view, ground.terrain, True, SILENT)
    traces, names = [], []
    for features in readings:
        drawn = ImageFeatures(ground.terrain, features, options, Placement(step_px=STEP_PX), None)
        named, strokes = drawn.add(photo)
        names += [(point.words, *map(float, view.ray_of(point.x_px, point.y_px))) for point in named]
        for stroke in strokes:
            azimuth, elevation = view.ray_of(stroke.x_px, stroke.y_px)
            traces.append(Trace("map", azimuth, elevation, stroke.visible))
    return traces, names


def summit_layer(project, photo_layer):
    """First point layer with names and heights, or None.

    Parameters
    ----------
    project : QgsProject
    photo_layer : QgsVectorLayer
    """
    for layer in shown_layers(project.mapLayers().values(), photo_layer):
        names = {field.name().lower() for field in layer.fields()}
        points = layer.geometryType() == QgsWkbTypes.GeometryType.PointGeometry
        if points and "name" in names and names & set(HEIGHT_NAMES):
            return layer
    return None


def read_summit_layer(layer, dem_crs, project):
    """Read named summits; None if there is no layer, or none of it can be used, so that the DEM is searched.

    Parameters
    ----------
    layer : QgsVectorLayer or None
    dem_crs : QgsCoordinateReferenceSystem
    project : QgsProject
    """
    if layer is None:
        return None
    context = QgsProcessingContext()
    context.setProject(project)
    height = next(f.name() for f in layer.fields() if f.name().lower() in HEIGHT_NAMES)
    transform = to_dem_transform(layer.crs(), dem_crs, context)
    try:
        return read_summits(_Source(layer), _name_field(layer), height, transform)
    except QgsProcessingException:  # nothing of the layer lies where the DEM's CRS is valid
        return None


def visible_summits(ground, camera, pose, given):
    """Visible summits all around the eye: (name, azimuth, elevation angle) [degrees], most important first.

    Parameters
    ----------
    ground : Ground
    camera : Camera
    pose : Pose
    given : list or None
        From `summit_input.read_summits`; None finds summits in the DEM.
    """
    from ...core.mapping.sightline import SightOptions

    options = SightOptions(max_distance_m=REACH_M)
    view = view_of(ground, posed_photo(ground, camera, pose))
    shown = Summitry(ground.terrain, given).shown(view, options, all_round=True)
    return [(summit.mark.words, summit.azimuth_deg, summit.elevation_deg) for summit in shown if summit.visible]
