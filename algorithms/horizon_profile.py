"""Points and a DEM -> the horizon around each point, and the share of the sky that it sees."""

from __future__ import annotations

from qgis.core import (
    QgsGeometry,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from ..core.base.progress import checkpoint, subtask
from ..core.horizon.horizon import HorizonOptions
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.doubtful_places import warn_of_place
from .shared.elevation import dem_fault, dem_source
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, qgis_fields
from .shared.horizon_report import HorizonReport
from .shared.i18n import tr
from .shared.layers import read_points
from .shared.outputs import write_features
from .shared.sky_view_output import add_sky_view_parameters, sky_view_fault, write_sky_view
from .shared.styling import style_on_completion

PROFILES_PART = 0.4
"""Share of the progress bar for the profiles if a raster of sky view factors follows."""


class HorizonProfile(DemAlgorithm):
    """Compute the horizon around points."""

    ID = "horizonprofile"
    GROUP_ID = "terrain"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Horizon profile")

    def tags(self):
        """Search words."""
        return tr("horizon,skyline,panorama,sky view factor,shading,elevation angle,dem").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Elevation angle and distance of the horizon around points, and their sky view factor")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Computes the elevation angle, the distance and the position of the horizon for each point "
                "and azimuth. Azimuths count from true north and distances are ground metres in any "
                "coordinate system of the DEM. The earth's curvature and refraction are taken into account."
            ),
            tr(
                "<b>clipped</b> is true if the elevation model ends before the search range and there could "
                "be higher terrain beyond it. <b>svf</b> is the sky view factor of the source point (1 = "
                "open sky)."
            ),
            tr(
                "Under Advanced you can add a raster with the sky view factor of each cell in an extent, "
                "which takes the cell's own slope into account (Dozier and Frew 1990)."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        defaults = HorizonOptions()
        points = QgsProcessingParameterFeatureSource("INPUT", tr("Points"), [QgsProcessing.SourceType.TypeVectorPoint])
        self.addParameter(shared.explained(points, tr("Positions of the observer's eye, in any coordinate system.")))
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        self.addParameter(shared.eye_height())
        self.addParameter(shared.max_distance(defaults.max_distance_m))
        self.addParameter(
            shared.number(
                "AZIMUTH_STEP",
                tr("Azimuth step (°)"),
                0.5,
                tr("Spacing of the directions; it is rounded so that it divides the circle."),
                minimum=0.01,
                maximum=90.0,
            )
        )
        self.addParameter(shared.advanced(shared.refraction(defaults.refraction_coefficient)))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Horizon"),
                text=tr(
                    "One point per azimuth at the position of the horizon, with elevation angle (°) and distance (m)."
                ),
            )
        )
        self.addParameter(shared.report_out())
        add_sky_view_parameters(self)
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of points with a horizon")))

    def input_fault(self, parameters, context):
        """Check the DEM, and the raster of sky view factors."""
        return dem_fault(self, parameters, context) or sky_view_fault(
            self, parameters, context, dem_source(self, parameters, context)
        )

    def compute(self, parameters, context, feedback):
        """Compute the horizon point by point, then write."""
        source, rows = read_points(self, parameters, context)
        options = HorizonOptions(
            azimuth_step_deg=self.parameterAsDouble(parameters, "AZIMUTH_STEP", context),
            max_distance_m=self.parameterAsDouble(parameters, "MAX_DISTANCE", context),
            refraction_coefficient=self.parameterAsDouble(parameters, "REFRACTION", context),
        )
        eye_height_m = self.parameterAsDouble(parameters, "EYE_HEIGHT", context)
        end = PROFILES_PART if parameters.get("SKY_VIEW") is not None else 0.95
        features, count = [], 0
        with HorizonReport(self, parameters, context) as report:
            for row, profile in cast_each(rows, self.dem.open(), eye_height_m, options, feedback, end):
                svf = sky_view(profile)
                features += horizon_features(row, profile, svf, source.sourceCrs())
                report.add(row, profile, svf)
                count += 1
            sky = write_sky_view(self, parameters, context, self.dem, feedback, (end, 0.95))
            specs = horizon_specs()
            output = write_features(
                self,
                parameters,
                "OUTPUT",
                context,
                qgis_fields(specs),
                QgsWkbTypes.Type.Point,
                source.sourceCrs(),
                features,
                style="horizon",
            )
        style_on_completion(context, output, "horizon", tr("Horizon"), specs, self.displayName())
        outputs = {"OUTPUT": output, "COUNT": count, **report.outputs()}
        return outputs if sky is None else {**outputs, "SKY_VIEW": sky}


def cast_each(rows, dem, eye_height_m, options, feedback, end=0.95):
    """Yield (row, profile) for each point that the DEM covers; the others get a warning. Progress ends at `end`."""
    from ..core.base.terrain import Observer
    from ..core.horizon.horizon import horizon_profile

    progress = FeedbackProgress(feedback)
    for index, row in enumerate(rows):
        announce(feedback, row.name, index, len(rows))
        part = subtask(progress, end * index / len(rows), end * (index + 1) / len(rows))
        if row.longitude_deg is None:
            warn(feedback, row.name, tr("The point has no usable position."))
            continue
        observer = Observer(row.longitude_deg, row.latitude_deg, eye_height_m)
        warn_of_place(feedback, row, dem, observer)
        try:
            yield row, horizon_profile(dem, observer, options, part)
        except PhotoError as error:
            warn(feedback, row.name, error.message)
    checkpoint(progress, end)


def sky_view(profile):
    """Sky view factor of a flat place with this horizon."""
    from ..core.horizon.sky_view import sky_view_factor

    return float(sky_view_factor(profile))


def horizon_features(row, profile, svf, crs):
    """Rows of the output for one source point."""
    import numpy as np

    from ..core.io.crs import Transformer, local_plane

    azimuth = np.radians(profile.azimuth_deg)
    plane = local_plane(row.longitude_deg, row.latitude_deg)
    known = np.isfinite(profile.distance_m) & np.isfinite(profile.elevation_deg)
    distance = np.where(known, profile.distance_m, 0.0)
    x, y = Transformer(plane, crs.toWkt())(distance * np.sin(azimuth), distance * np.cos(azimuth))
    features = []
    for index in range(len(azimuth)):
        at = known[index] and np.isfinite(x[index])
        point = QgsGeometry.fromPointXY(QgsPointXY(x[index], y[index])) if at else None
        angles = [float(profile.elevation_deg[index]), float(profile.distance_m[index])] if at else [None, None]
        features.append(
            (point, [row.feature.id(), float(profile.azimuth_deg[index]), *angles, bool(profile.clipped[index]), svf])
        )
    return features


def horizon_specs():
    """Fields of the output."""
    return [
        FieldSpec("source_id", "whole", tr("Source point")),
        FieldSpec("azimuth", "real", tr("Azimuth (° from true north)")),
        FieldSpec("elevation", "real", tr("Elevation angle of the horizon (°)")),
        FieldSpec("distance", "real", tr("Distance of the horizon (m)")),
        FieldSpec("clipped", "yes", tr("Cut off by the DEM's edge")),
        FieldSpec("svf", "real", tr("Sky view factor of the source point")),
    ]
