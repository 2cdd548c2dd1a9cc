"""Places and a DEM -> how accurate orientation will be there, from simulated photographs."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from ..core.base.progress import checkpoint, subtask
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, qgis_fields
from .shared.i18n import in_users_language, tr
from .shared.outputs import write_features
from .shared.places_along import places_of
from .shared.reporting import PhotoReport
from .shared.styling import style_on_completion

WEATHERS = ("clear", "mixed", "season")


class ExpectedAccuracy(DemAlgorithm):
    """Simulate photographs at places and orient them."""

    ID = "expectedaccuracy"
    GROUP_ID = "checks"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Expected accuracy")

    def tags(self):
        """Search words."""
        return tr("simulation,accuracy,benchmark,planning,acceptance,coverage,montecarlo").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("How accurate orientation will be at given places over a given DEM, from simulated photographs")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Simulates photographs from the places with random directions, lenses, weather and errors of position "
                "and focal length, orients each of them as Orient photos does, and compares the answers with the "
                "truth: errors, share of accepted photographs, wrong ones among them, and how often the 90 % interval "
                "holds the truth."
            ),
            tr(
                "The simulated mountains are rougher than the DEM. Each photograph takes some "
                "seconds. Real photographs can give worse results: compare with the figures for real "
                "photographs in the documentation."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        kinds = [QgsProcessing.SourceType.TypeVectorPoint, QgsProcessing.SourceType.TypeVectorLine]
        places = QgsProcessingParameterFeatureSource("INPUT", tr("Places"), kinds)
        self.addParameter(shared.explained(places, tr("Points, or lines along which places are taken.")))
        text = tr("Distance between the places that are taken along lines.")
        self.addParameter(shared.distance("STEP", tr("Step along lines (m)"), 500.0, text, minimum=10.0))
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        text = tr("They are spread evenly over the places.")
        self.addParameter(
            shared.number("PHOTOS", tr("Number of photographs"), 20, text, minimum=1, maximum=10_000, integer=True)
        )
        weather = QgsProcessingParameterEnum(
            "WEATHER",
            tr("Weather"),
            [tr("clear days"), tr("half clear, half a season's weather"), tr("a season's weather")],
            defaultValue=WEATHERS.index("season"),
        )
        text = tr("A season's weather has clouds, haze, trees, people and camera faults.")
        self.addParameter(shared.explained(weather, text))
        text = tr("Fields of view are drawn between the two.")
        for name, label, default in (
            ("HFOV_MIN", tr("Narrowest field of view (°)"), 40.0),
            ("HFOV_MAX", tr("Widest field of view (°)"), 70.0),
        ):
            self.addParameter(shared.number(name, label, default, text, minimum=5.0, maximum=110.0))
        self.addParameter(shared.advanced(shared.eye_height()))
        text = tr("Standard deviation of the recorded position in each direction.")
        error = shared.distance("POSITION_ERROR", tr("Error of the position (m)"), 6.0, text)
        self.addParameter(shared.advanced(error))
        text = tr(
            "Roughness of the mountains that the DEM does not show, in cells of the DEM. 0: the "
            "photographs show the DEM itself."
        )
        rough = shared.number("DETAIL", tr("Roughness beyond the DEM"), 0.22, text, minimum=0.0, maximum=2.0)
        self.addParameter(shared.advanced(rough))
        text = tr("The same seed gives the same photographs.")
        seed = shared.number("SEED", tr("Seed"), 1, text, minimum=0, integer=True)
        self.addParameter(shared.advanced(seed))
        text = tr("One point per simulated photograph with its truth, the answer and the error.")
        self.addParameter(shared.points_out("OUTPUT", tr("Simulated photographs"), text=text))
        self.addParameter(shared.report_out())
        for name, label in (
            ("COUNT", tr("Number of photos")),
            ("ACCEPTED", tr("Number of accepted photos")),
            ("WRONG", tr("Accepted photos that are wrong by more than 3°")),
            ("WITHIN_1", tr("Share of headings within 1°")),
            ("WITHIN_3", tr("Share of headings within 3°")),
            ("COVERED", tr("Share of the accepted whose interval holds the truth")),
        ):
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def input_fault(self, parameters, context):
        """Check the fields of view and the DEM."""
        low, high = (self.parameterAsDouble(parameters, name, context) for name in ("HFOV_MIN", "HFOV_MAX"))
        if low > high:
            return tr("The narrowest field of view must not be wider than the widest.")
        return dem_fault(self, parameters, context)

    def compute(self, parameters, context, feedback):
        """Simulate and orient photo by photo, then write."""
        from ..core.planning import summarise

        rows = places_of(self, parameters, context, "INPUT", "STEP")
        count = self.parameterAsInt(parameters, "PHOTOS", context)
        trials, features = [], []
        with PhotoReport(self, parameters, context, count) as report:
            for name, position, trial in self._trials(rows, count, parameters, context, feedback):
                trials.append(trial)
                features.append(trial_row(name, position, trial))
                report.add(trial.oriented, trial_facts(trial))
            if not trials:
                raise QgsProcessingException(tr("None of the places has a usable position on this DEM."))
            found = summarise(trials)
            crs, specs = QgsCoordinateReferenceSystem("EPSG:4326"), trial_specs()
            output = write_features(
                self, parameters, "OUTPUT", context, qgis_fields(specs), QgsWkbTypes.Type.Point, crs, features
            )
        feedback.pushInfo(sentence(found))
        style_on_completion(context, output, "trials", tr("Simulated photographs"), specs, self.displayName())
        within = dict(found.within)
        numbers = {
            "COUNT": found.photos,
            "ACCEPTED": found.accepted,
            "WRONG": found.accepted_wrong,
            "WITHIN_1": within[1.0],
            "WITHIN_3": within[3.0],
            "COVERED": found.covered,
        }
        return {"OUTPUT": output, **numbers, **report.outputs()}

    def _trials(self, rows, count, parameters, context, feedback):
        from ..core.base.terrain import Observer
        from ..core.planning import TrialOptions, simulate_trial

        def number(name):
            return self.parameterAsDouble(parameters, name, context)

        options = TrialOptions(
            weather=WEATHERS[self.parameterAsEnum(parameters, "WEATHER", context)],
            hfov_deg=(number("HFOV_MIN"), number("HFOV_MAX")),
            position_error_m=number("POSITION_ERROR"),
            detail=number("DETAIL"),
            seed=self.parameterAsInt(parameters, "SEED", context),
        )
        dem, height_m, progress = self.dem.open(), number("EYE_HEIGHT"), FeedbackProgress(feedback)
        for photo in range(count):
            name, position = rows[photo % len(rows)]
            announce(feedback, name, photo, count)
            part = subtask(progress, 0.95 * photo / count, 0.95 * (photo + 1) / count)
            if position[0] is None:
                warn(feedback, name, tr("The point has no usable position."))
                continue
            try:
                yield (
                    name,
                    position,
                    simulate_trial(dem, Observer(position[0], position[1], height_m), photo, options, part),
                )
            except PhotoError as error:
                warn(feedback, name, error.message)
        checkpoint(progress, 0.95)


def sentence(found):
    """Summarise the trials in a sentence."""
    text = tr(
        "{photos} photographs: {accepted} accepted, {wrong} of them wrong by more than 3°; {within} % of all headings "
        "are within 1° of the truth."
    )
    within = f"{100 * dict(found.within)[1.0]:.0f}"
    return text.format(photos=found.photos, accepted=found.accepted, wrong=found.accepted_wrong, within=within)


def trial_facts(trial):
    """Further labels and values for the report."""
    error = "-" if trial.error_deg is None else f"{trial.error_deg:.2f}°"
    return {
        tr("True heading (°)"): f"{trial.heading_deg:.2f}°",
        tr("Heading found minus true heading (°)"): error,
        tr("Probability of a unique answer, predicted from the DEM"): f"{trial.predicted:.2f}",
    }


def trial_row(name, position, trial):
    """Geometry and values of one simulated photograph."""
    oriented = trial.oriented
    covered = None if trial.covered is None else bool(trial.covered)
    values = [name, trial.heading_deg, trial.hfov_deg, oriented.heading_deg, trial.error_deg, covered]
    values += [oriented.p_correct, trial.predicted, oriented.status, in_users_language(oriented.message)]
    values = [None if isinstance(value, float) and value != value else value for value in values]
    return QgsGeometry.fromPointXY(QgsPointXY(*position)), values


def trial_specs():
    """Fields of the simulated photographs; the names are a contract."""
    return [
        FieldSpec("place", "text", tr("Place")),
        FieldSpec("true_head", "real", tr("True heading (°)")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("heading", "real", tr("Heading (° from true north)")),
        FieldSpec("error_deg", "real", tr("Heading found minus true heading (°)")),
        FieldSpec("covered", "yes", tr("The 90 % interval holds the true heading")),
        FieldSpec("p_correct", "real", tr("Probability that the heading is right within 3°")),
        FieldSpec("predicted", "real", tr("Probability of a unique answer, predicted from the DEM")),
        FieldSpec("status", "text", tr("Status")),
        FieldSpec("message", "text", tr("Message")),
    ]
