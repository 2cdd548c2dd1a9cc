"""Points and a DEM -> the labelled outline panorama of each point, with the frames of photos."""

from __future__ import annotations

from qgis.core import (
    QgsGeometry,
    QgsPoint,
    QgsProcessing,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from ..core.base.progress import subtask
from ..core.horizon.panorama import PanoramaOptions
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.doubtful_places import warn_of_place
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, is_null, qgis_fields
from .shared.i18n import tr
from .shared.layers import read_points
from .shared.map_places import map_of_local
from .shared.outputs import write_features
from .shared.panorama_files import PanoramaFolder
from .shared.statuses import relied_on
from .shared.styling import style_on_completion
from .shared.summit_input import add_summit_parameters, summits_of


class Panorama(DemAlgorithm):
    """Draw the outlines of the terrain all around."""

    ID = "panorama"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Outline panorama")

    def tags(self):
        """Search words."""
        return tr("panorama,horizon,skyline,ridge,outline,360,peaks,labels,svg").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Labelled horizon and inner ridges in all directions from a point, as SVG, PNG and map lines")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "For each point, draws the horizon and every inner ridge that hides ground behind it. Near "
                "ridges are dark and thick, distant ones pale. Summits come from a layer, or are found in "
                "the DEM by their prominence. Optionally, the frames of oriented photos near the point are "
                "drawn."
            ),
            tr("The line layer holds the same ridges on the map, with distance and elevation angle."),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        defaults = PanoramaOptions()
        points = QgsProcessingParameterFeatureSource("INPUT", tr("Points"), [QgsProcessing.SourceType.TypeVectorPoint])
        self.addParameter(shared.explained(points, tr("Positions of the observer's eye, in any coordinate system.")))
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        self.addParameter(shared.max_distance(defaults.max_distance_m))
        add_summit_parameters(self)
        photos = shared.photo_source("PHOTOS", optional=True)
        photos.setDescription(tr("Oriented photo points"))
        photos.setHelp(
            tr(
                "The frames of photos within 100 m of a point are drawn, from the fields heading, pitch, roll, hfov "
                "and vfov."
            )
        )
        self.addParameter(photos)
        self.addParameter(shared.statuses())
        step = shared.number(
            "AZIMUTH_STEP", tr("Azimuth step (°)"), defaults.step_deg, tr("Angle between neighbouring rays."), 0.02, 5.0
        )
        left = shared.number(
            "LEFT", tr("Azimuth at the left edge (°)"), 0.0, tr("Azimuth at which the panorama begins."), 0.0, 360.0
        )
        scale = shared.number("SCALE", tr("Pixels per degree"), 20.0, tr("Size of the drawing."), 2.0, 200.0)
        higher = shared.number("EXAGGERATION", tr("Exaggeration of heights"), 1.0, tr("1: true shape."), 0.1, 20.0)
        for parameter in (step, left, scale, higher, shared.eye_height(),
                          shared.refraction(defaults.refraction_coefficient)):  # fmt: skip
            self.addParameter(shared.advanced(parameter))
        text = tr("One PNG and one SVG per point.")
        self.addParameter(shared.folder_out("FOLDER", tr("Folder for panoramas"), text, optional=False, create=True))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Ridges in view"),
                QgsProcessing.SourceType.TypeVectorLine,
                optional=True,
                create=False,
                text=tr("The drawn ridges as lines on the map, with distance (m) and elevation angle (°)."),
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of panoramas")))

    def compute(self, parameters, context, feedback):
        """Draw point by point, then write the ridges."""
        from ..core.base.terrain import Observer
        from ..core.horizon.panorama import outline_panorama

        _, rows = read_points(self, parameters, context)
        terrain = self.dem.open()
        options = self._options(parameters, context)
        summits = summits_of(self, parameters, context, terrain, self.dem.crs)
        photos = self._photos(parameters, context, feedback)
        folder = PanoramaFolder(self, parameters, context, terrain, summits, photos)
        eye_height_m = self.parameterAsDouble(parameters, "EYE_HEIGHT", context)
        ridges, progress = [], FeedbackProgress(feedback)
        for index, row in enumerate(rows):
            announce(feedback, row.name, index, len(rows))
            if row.longitude_deg is None:
                warn(feedback, row.name, tr("The point has no usable position."))
                continue
            observer = Observer(row.longitude_deg, row.latitude_deg, eye_height_m)
            warn_of_place(feedback, row, terrain, observer)
            part = subtask(progress, index / len(rows), (index + 1) / len(rows))
            try:
                panorama = outline_panorama(terrain, observer, options, subtask(part, 0.0, 0.7))
            except PhotoError as error:
                warn(feedback, row.name, error.message)
                continue
            view = folder.write(row, observer, panorama, options)
            ridges += [ridge_row(terrain, view.frame, row, outline) for outline in panorama.outlines]
        results = {"FOLDER": str(folder.path), "COUNT": folder.count}
        if not is_null(parameters.get("OUTPUT")):
            specs = ridge_specs()
            results["OUTPUT"] = write_features(
                self,
                parameters,
                "OUTPUT",
                context,
                qgis_fields(specs),
                QgsWkbTypes.Type.LineString,
                self.dem.crs,
                ridges,
                style="ridges",
            )
            style_on_completion(context, results["OUTPUT"], "ridges", tr("Ridges in view"), specs, self.displayName())
        return results

    def _photos(self, parameters, context, feedback):
        """Points of the photos whose frames are drawn."""
        if is_null(parameters.get("PHOTOS")):
            return []
        return relied_on(self, parameters, context, feedback, read_points(self, parameters, context, "PHOTOS")[1])

    def _options(self, parameters, context):
        return PanoramaOptions(
            step_deg=self.parameterAsDouble(parameters, "AZIMUTH_STEP", context),
            max_distance_m=max(self.parameterAsDouble(parameters, "MAX_DISTANCE", context), 101.0),
            refraction_coefficient=self.parameterAsDouble(parameters, "REFRACTION", context),
        )


def ridge_specs():
    """Fields of the ridges."""
    return [
        FieldSpec("source_id", "whole", tr("Source point")),
        FieldSpec("kind", "text", tr("horizon or ridge")),
        FieldSpec("azim_from", "real", tr("Begins at azimuth (° from true north)")),
        FieldSpec("azim_to", "real", tr("Ends at azimuth (° from true north)")),
        FieldSpec("dist_med", "real", tr("Median distance (m)")),
        FieldSpec("elev_max", "real", tr("Highest elevation angle (°)")),
    ]


def ridge_row(terrain, frame, row, outline):
    """Geometry on the map and attributes of one outline."""
    import numpy as np

    angle = np.radians(outline.azimuth_deg)
    x, y = map_of_local(terrain, frame, outline.distance_m * np.sin(angle), outline.distance_m * np.cos(angle))
    geometry = QgsGeometry.fromPolyline([QgsPoint(a, b) for a, b in zip(x, y)]) if x.size > 1 else None
    ends = float(outline.azimuth_deg[0] % 360), float(outline.azimuth_deg[-1] % 360)
    values = [row.feature.id(), "horizon" if outline.horizon else "ridge", *ends]
    return geometry, [*values, float(np.median(outline.distance_m)), float(outline.elevation_deg.max())]
