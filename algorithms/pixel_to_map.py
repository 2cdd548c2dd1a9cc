"""Image features on oriented photographs -> map features on the DEM: monoplotting."""

from __future__ import annotations

from qgis.core import QgsProcessing, QgsProcessingOutputNumber, QgsWkbTypes

from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.fields import qgis_fields
from .shared.i18n import tr
from .shared.monoplotting import MapFeatures, drawn_specs, ellipse_specs, point_specs
from .shared.outputs import write_features
from .shared.pixel_input import FeaturesByPhoto, add_pixel_parameters, pixel_fault, pixel_features
from .shared.styling import style_on_completion
from .shared.views import (
    Opening,
    add_uncertainty_parameters,
    add_view_parameters,
    open_views,
    photo_names,
    sight_options,
    uncertainty_of,
)


class PixelToMap(DemAlgorithm):
    """Place features drawn on photographs on the map."""

    ID = "pixeltomap"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Pixels to map (monoplotting)")

    def tags(self):
        """Search words."""
        return tr("monoplotting,pixel,photo,georeference,digitise,glacier,labelme,coco,via,ellipse,accuracy").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Points, lines and areas drawn on oriented photos become map features with an error ellipse")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Follows the line of sight of each pixel to the elevation model, with the earth's curvature "
                "and refraction. Lines and outlines are followed pixel by pixel and cut where the ground "
                "behind them jumps. If a pixel shows the sky, or its line of sight enters a void of the DEM "
                "or reaches its edge, the field <b>status</b> records this."
            ),
            tr(
                "The error ellipse contains the true position with the chosen probability, given the "
                "uncertainties of heading, pitch, roll, focal length, position and DEM. <b>p_other</b> is "
                "the probability that the pixel shows different ground, beyond an edge in the picture. It is "
                "often large near ridges."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        add_pixel_parameters(self)
        add_view_parameters(self, 60_000.0)
        coverage = shared.number(
            "COVERAGE",
            tr("Probability of the error ellipse (%)"),
            90.0,
            tr("Probability that the ellipse contains the true position; 90 % is usual."),
            1.0,
            99.9,
        )
        self.addParameter(shared.advanced(coverage))
        step = shared.number(
            "STEP",
            tr("Step along lines (px)"),
            3.0,
            tr("Lines and outlines are followed in steps of this length."),
            0.1,
        )
        self.addParameter(shared.advanced(step))
        add_uncertainty_parameters(self)
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Points on the map"),
                optional=True,
                text=tr("Where the lines of sight of drawn points meet the ground, with status and distance (m)."),
            )
        )
        self.addParameter(
            shared.points_out(
                "LINES",
                tr("Lines on the map"),
                QgsProcessing.SourceType.TypeVectorLine,
                optional=True,
                text=tr("Drawn lines on the ground, cut where the ground behind them jumps."),
            )
        )
        self.addParameter(
            shared.points_out(
                "POLYGONS",
                tr("Areas on the map"),
                QgsProcessing.SourceType.TypeVectorPolygon,
                optional=True,
                text=tr("Drawn areas on the ground."),
            )
        )
        self.addParameter(
            shared.points_out(
                "ELLIPSES",
                tr("Error ellipses"),
                QgsProcessing.SourceType.TypeVectorPolygon,
                optional=True,
                create=False,
                text=tr("One ellipse per point, which contains the true position with the chosen probability."),
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of map features")))
        self.addOutput(QgsProcessingOutputNumber("SKY_COUNT", tr("Number of features that show no ground")))

    def input_fault(self, parameters, context):
        """Check the DEM and that something was drawn."""
        return dem_fault(self, parameters, context) or pixel_fault(self, parameters, context)

    def compute(self, parameters, context, feedback):
        """Place photo by photo, then write."""
        drawn = pixel_features(self, parameters, context, feedback)
        terrain, options = self.dem.open(), sight_options(self, parameters, context)
        coverage = self.parameterAsDouble(parameters, "COVERAGE", context) / 100
        step_px = self.parameterAsDouble(parameters, "STEP", context)
        whose = FeaturesByPhoto(drawn, photo_names(self, parameters, context))
        placed = MapFeatures(terrain, whose, options, coverage, step_px)
        reach = options.max_distance_m
        opening = Opening(reach, (0.0, 0.95), uncertainty=uncertainty_of(self, parameters, context))
        for photo in open_views(self, parameters, context, feedback, terrain, opening):
            placed.add(photo, feedback)
        whose.tell_unused(feedback)
        results = {"COUNT": placed.count, "SKY_COUNT": placed.sky_count}
        for name, style, title, specs, kind, rows in (
            ("OUTPUT", "placed_points", tr("Points on the map"), point_specs(), QgsWkbTypes.Type.PointZ, placed.points),
            (
                "LINES",
                "placed_lines",
                tr("Lines on the map"),
                drawn_specs(),
                QgsWkbTypes.Type.MultiLineStringZ,
                placed.lines,
            ),
            (
                "POLYGONS",
                "placed_areas",
                tr("Areas on the map"),
                drawn_specs(),
                QgsWkbTypes.Type.MultiPolygonZ,
                placed.polygons,
            ),
            (
                "ELLIPSES",
                "error_ellipses",
                tr("Error ellipses"),
                ellipse_specs(),
                QgsWkbTypes.Type.Polygon,
                placed.ellipses,
            ),
        ):
            if name != "OUTPUT" and parameters.get(name) is None:
                continue
            written = write_features(
                self, parameters, name, context, qgis_fields(specs), kind, self.dem.crs, rows, style=style
            )
            if written is not None:
                style_on_completion(context, written, style, title, specs, self.displayName())
                results[name] = written
        return results
