"""Photo points and a DEM -> whether each recorded position is believable."""

from __future__ import annotations

import traceback
from pathlib import Path

from qgis.core import QgsProcessingOutputNumber

from ..core.base.errors import Cancelled, OutputError, TerrainError
from ..core.base.messages import Message
from ..core.base.progress import subtask
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, joined_fields
from .shared.i18n import in_users_language, tr
from .shared.layers import points_fault, read_points
from .shared.orientation import without_photo
from .shared.outputs import write_features
from .shared.reporting import PhotoReport
from .shared.styling import style_on_completion


class PositionCheck(DemAlgorithm):
    """Look for a better place near each recorded position."""

    ID = "positioncheck"
    GROUP_ID = "checks"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Check photo positions")

    def tags(self):
        """Search words."""
        return tr("position,gps,check,wrong,shift,photo,skyline,horizon,quality").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Whether the recorded position of a photo agrees with its skyline, and where a better place is")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Orients each photograph from its recorded position and then tries places around it. If the skyline "
                "fits much better somewhere else, <b>verdict</b> is <i>doubtful</i>, and <b>dx</b> and <b>dy</b> give "
                "the way there in metres to the east and north. Positions are reported and never changed."
            ),
            tr(
                "A skyline of far mountains says little about a position: a <i>believable</i> verdict only means that "
                "no place nearby fits much better. The error ellipse says how well the skyline fixes the better place."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        self.addParameter(shared.photo_source())
        self.addParameter(shared.photo_field())
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        text = tr("Rings of places are tried out to this distance; the larger it is, the farther apart they lie.")
        self.addParameter(shared.distance("RADIUS", tr("Search radius (m)"), 500.0, text, minimum=50.0))
        text = tr("Field of view of the upright picture. NULL: computed from the focal length in the file.")
        field = shared.number_field("HFOV_FIELD", tr("Field with the horizontal field of view (°)"), text)
        self.addParameter(shared.advanced(field))
        self.addParameter(shared.advanced(shared.eye_height()))
        text = tr("Maximum distance of the mountains on the skyline, in metres on the ground.")
        self.addParameter(shared.advanced(shared.max_distance(60_000.0, text)))
        self.addParameter(shared.advanced(shared.refraction(0.13)))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Checked positions"),
                text=tr("The photo points with the verdict and the way to the better place."),
            )
        )
        self.addParameter(shared.report_out(create=False))
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("DOUBTFUL", tr("Number of doubtful positions")))

    def input_fault(self, parameters, context):
        """Check the layer and the DEM."""
        fault = points_fault(self, parameters, context, "INPUT", "PHOTO_FIELD", ("HFOV_FIELD",))
        return fault or dem_fault(self, parameters, context)

    def compute(self, parameters, context, feedback):
        """Check photo by photo, then write."""
        source, rows = read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", ("HFOV_FIELD",))
        specs = checked_specs()
        fields, kept = joined_fields(source.fields(), specs)
        options, dem = self._options(parameters, context), self.dem.open()
        features, verdicts = [], []
        with PhotoReport(self, parameters, context, len(rows)) as report:
            for number, row in enumerate(rows):
                announce(feedback, row.name, number, len(rows))
                part = subtask(FeedbackProgress(feedback), 0.95 * number / len(rows), 0.95 * (number + 1) / len(rows))
                check = self._check(row, dem, options, feedback, part)
                if check.verdict in ("doubtful", "failed"):
                    warn(feedback, row.name, check.message)
                attributes = row.feature.attributes()
                geometry = row.feature.geometry() if row.feature.hasGeometry() else None
                features.append((geometry, [attributes[index] for index in kept] + checked_values(check)))
                verdicts.append(check.verdict)
                report.add(check.oriented, {tr("Position"): in_users_language(check.message)})
            output = write_features(
                self, parameters, "OUTPUT", context, fields, source.wkbType(), source.sourceCrs(), features
            )
        style_on_completion(context, output, "checked", tr("Checked positions"), specs, self.displayName())
        counts = {"COUNT": len(rows), "DOUBTFUL": verdicts.count("doubtful")}
        return {"OUTPUT": output, **counts, **report.outputs()}

    def _options(self, parameters, context):
        from ..core.checking import CheckOptions
        from ..core.horizon.horizon import HorizonOptions
        from ..core.locate.places import IndexOptions
        from ..core.pipeline import OrientOptions
        from ..core.searching import LocateOptions

        index = IndexOptions(
            eye_height_m=self.parameterAsDouble(parameters, "EYE_HEIGHT", context),
            max_distance_m=self.parameterAsDouble(parameters, "MAX_DISTANCE", context),
            refraction_coefficient=self.parameterAsDouble(parameters, "REFRACTION", context),
        )
        locate = LocateOptions.of(index, (30.0, 75.0), 0.0)
        orient = OrientOptions(
            horizon=HorizonOptions(
                max_distance_m=index.max_distance_m, refraction_coefficient=index.refraction_coefficient
            )
        )
        return CheckOptions(self.parameterAsDouble(parameters, "RADIUS", context), locate=locate, orient=orient)

    # parameters: what a run shares, what a photograph brings, and its progress
    def _check(self, row, dem, options, feedback, progress):
        from ..core import checking
        from ..core.base.model import Orientation, OrientedPhoto
        from ..core.batch import PhotoRequest

        if row.path is None:
            oriented = without_photo()
            return checking.PositionCheck("", "failed", oriented.orientation.message, oriented)
        request = PhotoRequest(
            row.path,
            row.longitude_deg,
            row.latitude_deg,
            eye_height_m=options.locate.index.eye_height_m,
            hfov_deg=row.numbers.get("HFOV_FIELD"),
        )
        try:
            return checking.check_position(request, dem, options, None, progress)
        except (TerrainError, OutputError, Cancelled):
            raise
        except Exception:  # a fault of ours, but no reason to lose the other photographs
            feedback.pushDebugInfo(traceback.format_exc())
            message = Message("An unexpected error occurred on this photo. Please report it and attach the log.")
            nothing = OrientedPhoto(str(Path(row.path)), Orientation("failed", message))
            return checking.PositionCheck(row.path, "failed", message, nothing)


def checked_specs():
    """Fields that the check adds; the names are a contract."""
    return [
        FieldSpec("verdict", "text", tr("Verdict")),
        FieldSpec("dx", "real", tr("Better place, metres to the east")),
        FieldSpec("dy", "real", tr("Better place, metres to the north")),
        FieldSpec("gain", "real", tr("Gain in agreement there")),
        FieldSpec("semi_maj", "real", tr("Error ellipse (90 %), longer half axis (m)")),
        FieldSpec("semi_min", "real", tr("Error ellipse (90 %), shorter half axis (m)")),
        FieldSpec("semi_az", "real", tr("Azimuth of the longer half axis (°)")),
        FieldSpec("heading", "real", tr("Heading (° from true north)")),
        FieldSpec("p_correct", "real", tr("Probability that the heading is right within 3°")),
        FieldSpec("message", "text", tr("Message")),
    ]


def checked_values(check):
    """Values of `checked_specs`."""
    axes = [None] * 3
    if check.ellipse is not None:
        axes = [check.ellipse.major_m, check.ellipse.minor_m, check.ellipse.azimuth_deg]
    oriented = check.oriented
    place = [check.verdict, check.east_m, check.north_m, check.gain, *axes]
    return [*place, oriented.heading_deg, oriented.p_correct, in_users_language(check.message)]
