"""Places and a DEM -> how well a photograph from there could be oriented, by direction and field of view."""

from __future__ import annotations

from qgis.core import (
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingOutputNumber,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterString,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from ..core.base.progress import checkpoint, subtask
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, is_null, qgis_fields
from .shared.i18n import tr
from .shared.orientability_outputs import OrientabilityReport, write_orientability
from .shared.outputs import write_features
from .shared.places_along import places_of
from .shared.styling import style_on_completion

COMPASS = ("n", "ne", "e", "se", "s", "sw", "w", "nw")
MOST_FIELDS = 6


class Orientability(DemAlgorithm):
    """Predict from the DEM alone how well photographs could be oriented."""

    ID = "orientability"
    GROUP_ID = "checks"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Orientability")

    def tags(self):
        """Search words."""
        return tr("planning,camera,webcam,repeat photography,horizon,ambiguity,accuracy,prediction").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("How well a photo from a place could be oriented, by direction and field of view, from the DEM alone")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Compares each stretch of the horizon with all others, as a photograph of it would be compared, and "
                "predicts the probability that its heading is found and the error of that heading. Use it to plan "
                "cameras and repeat photography."
            ),
            tr(
                "A horizon that repeats itself, a flat one and a narrow field of view are hard to orient, and the "
                "probability tells them from distinct ones. Where the terrain is distinct, photographs still fail on "
                "clouds, trees and near slopes, which the DEM does not show."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        kinds = [QgsProcessing.SourceType.TypeVectorPoint, QgsProcessing.SourceType.TypeVectorLine]
        places = QgsProcessingParameterFeatureSource("INPUT", tr("Places"), kinds, optional=True)
        self.addParameter(shared.explained(places, tr("Points, or lines along which places are taken.")))
        text = tr("Distance between the places that are taken along lines.")
        self.addParameter(shared.distance("STEP", tr("Step along lines (m)"), 500.0, text, minimum=10.0))
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        fields = QgsProcessingParameterString("HFOVS", tr("Horizontal fields of view (°)"), "25, 45, 65")
        self.addParameter(shared.explained(fields, tr("Numbers between 5 and 120, separated by commas.")))
        self.addParameter(shared.eye_height())
        text = tr("Standard deviation of the camera's position; it matters if terrain is near.")
        error = shared.distance("POSITION_ERROR", tr("Error of the position (m)"), 8.0, text)
        self.addParameter(shared.advanced(error))
        self.addParameter(shared.advanced(shared.max_distance(80_000.0)))
        extent = QgsProcessingParameterExtent("EXTENT", tr("Extent of the raster"), optional=True)
        self.addParameter(shared.explained(shared.advanced(extent), tr("Area of the optional raster.")))
        text = tr("Size of the cells of the raster, rounded to whole cells of the DEM.")
        self.addParameter(shared.advanced(shared.distance("CELL", tr("Cells of the raster (m)"), 500.0, text, 10.0)))
        text = tr("One point per place and field of view, with the probability in eight directions.")
        self.addParameter(shared.points_out("OUTPUT", tr("Orientability of places"), optional=True, text=text))
        text = tr(
            "Bands: mean probability, probability in eight directions, and expected error (°), for the "
            "first field of view."
        )
        raster = shared.raster_out("RASTER", tr("Orientability"), optional=True, create=False, text=text)
        self.addParameter(raster)
        self.addParameter(shared.report_out())
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of places")))

    def input_fault(self, parameters, context):
        """Check the places, the fields of view and the DEM."""
        if is_null(parameters.get("INPUT")) and is_null(parameters.get("RASTER")):
            return tr("Choose places, or an extent and a raster to write.")
        if not is_null(parameters.get("RASTER")) and is_null(parameters.get("EXTENT")):
            return tr("Choose the extent of the raster.")
        if fields_of_view(self.parameterAsString(parameters, "HFOVS", context)) is None:
            return tr("The fields of view must be numbers between 5 and 120, separated by commas.")
        return dem_fault(self, parameters, context)

    def compute(self, parameters, context, feedback):
        """Predict place by place, then write."""
        from ..core.horizon.horizon import HorizonOptions
        from ..core.locate.unique import UniqueOptions
        from ..core.planning import PredictOptions

        hfovs = fields_of_view(self.parameterAsString(parameters, "HFOVS", context))
        reach = self.parameterAsDouble(parameters, "MAX_DISTANCE", context)
        unique = UniqueOptions(position_error_m=self.parameterAsDouble(parameters, "POSITION_ERROR", context))
        options = PredictOptions(HorizonOptions(0.5, reach), unique)
        end = 0.95 if is_null(parameters.get("RASTER")) else 0.4
        features, results = [], {}
        with OrientabilityReport(self, parameters, context) as report:
            rows = [] if is_null(parameters.get("INPUT")) else places_of(self, parameters, context, "INPUT", "STEP")
            for name, position, found in self._predicted(rows, hfovs, options, parameters, context, feedback, end):
                report.add_place(name, position, found[0], list(zip(hfovs, found[1])))
                features += [place_row(position, name, hfov, one) for hfov, one in zip(hfovs, found[1])]
            raster = write_orientability(self, parameters, context, feedback, hfovs[0], options, (end, 0.95))
            if raster is not None:
                results["RASTER"] = raster
            specs = place_specs()
            crs = wgs84()
            output = write_features(
                self, parameters, "OUTPUT", context, qgis_fields(specs), QgsWkbTypes.Type.Point, crs, features
            )
        if output is not None:
            results["OUTPUT"] = output
            title = tr("Orientability of places")
            style_on_completion(context, output, "orientability", title, specs, self.displayName())
        return {**results, "COUNT": len(features) // len(hfovs), **report.outputs()}

    # parameters: what a run shares
    def _predicted(self, rows, hfovs, options, parameters, context, feedback, end):
        from ..core.base.terrain import Observer
        from ..core.planning import predict

        dem, height_m = self.dem.open(), self.parameterAsDouble(parameters, "EYE_HEIGHT", context)
        progress = FeedbackProgress(feedback)
        for number, (name, position) in enumerate(rows):
            announce(feedback, name, number, len(rows))
            part = subtask(progress, end * number / len(rows), end * (number + 1) / len(rows))
            if position[0] is None:
                warn(feedback, name, tr("The point has no usable position."))
                continue
            try:
                yield name, position, predict(dem, Observer(position[0], position[1], height_m), hfovs, options, part)
            except PhotoError as error:
                warn(feedback, name, error.message)
        checkpoint(progress, end)


def fields_of_view(text):
    """Numbers of a list [degrees]; None if one of them is unusable."""
    try:
        values = [float(part) for part in text.split(",") if part.strip()]
    except ValueError:
        return None
    usable = 0 < len(values) <= MOST_FIELDS and all(5 <= value <= 120 for value in values)
    return values if usable else None


def wgs84():
    """CRS of the outputs."""
    from qgis.core import QgsCoordinateReferenceSystem

    return QgsCoordinateReferenceSystem("EPSG:4326")


def place_row(position, name, hfov, found):
    """Geometry and values of one place and field of view."""
    sectors = [found.towards(45.0 * number) for number in range(len(COMPASS))]
    values = [name, hfov, found.mean, *sectors, found.typical_error_deg]
    values = [None if isinstance(value, float) and value != value else value for value in values]
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*position)))
    return feature.geometry(), values


def place_specs():
    """Fields of the places; the names are a contract."""
    direction = tr("Probability of a unique answer towards {direction}")
    return [
        FieldSpec("place", "text", tr("Place")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("p_mean", "real", tr("Mean probability of a unique answer")),
        *(FieldSpec(f"p_{name}", "real", direction.format(direction=name.upper())) for name in COMPASS),
        FieldSpec("error_deg", "real", tr("Expected error of the heading (°)")),
    ]
