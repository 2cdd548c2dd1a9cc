"""Photo points and a DEM -> points with heading, pitch, roll, and their certainty."""

from __future__ import annotations

from qgis.core import QgsProcessingOutputNumber

from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.compass_audit import CompassReadings, add_compass_audit
from .shared.elevation import dem_fault
from .shared.i18n import tr
from .shared.kept_orientations import orientations_out
from .shared.layers import points_fault, read_points
from .shared.lens_table import add_lens_table_parameter, lens_table_fault, with_lens_table
from .shared.orientation import (
    NUMBER_FIELDS,
    add_altitude_parameter,
    add_field_parameters,
    add_lens_parameter,
    add_terrain_parameters,
    options_of,
    orient_each,
    oriented_fields,
    oriented_out,
    oriented_row,
    requests_of,
    summary,
)
from .shared.oriented import oriented_specs
from .shared.outputs import rehearse, write_features
from .shared.placing import Placing
from .shared.previews import Previews, preview_specs
from .shared.reporting import PhotoReport
from .shared.rescue import add_rescue_parameters
from .shared.styling import style_on_completion
from .shared.together import add_joint_parameter, help_on_together
from .shared.workers import add_workers_parameter

SHARE = (0.0, 0.95)
"""The orientations' share of the progress bar."""


class OrientPhotos(DemAlgorithm):
    """Find heading, pitch and roll of each photograph from its skyline and the DEM's horizon."""

    ID = "orientphotos"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Orient photos")

    def tags(self):
        """Search words."""
        return tr("photo,heading,azimuth,direction,orientation,pose,skyline,horizon,compass,pitch,roll").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Heading, pitch and roll of mountain photographs from their skyline and a DEM")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Compares the skyline in each photograph with the horizon computed from the elevation model "
                "at its position, over all headings, and fits heading, pitch, roll and focal length. No "
                "compass is needed."
            ),
            tr(
                "<b>status</b> is <i>accepted</i> (the answer can be trusted), <i>ambiguous</i> (another "
                "heading fits nearly as well, or the fit is weak; see heading_2 and the report), "
                "<i>rejected</i> (there is no usable skyline, or no heading fits) or <i>failed</i> (the "
                "input cannot be used). <b>message</b> gives the reason and suggests what to do. heading_lo "
                "and heading_hi enclose the true heading with a probability of 90 %. For an accepted photo "
                "this holds if its heading is the right one; <b>p_correct</b> is the probability of that."
            ),
            help_on_together(),
            tr(
                "Headings count clockwise from true north. A point's geometry is the camera's position. For photos "
                "that fail, give an approximate heading, a landmark, a drawn skyline or a sky mask (Advanced)."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        self.addParameter(shared.photo_source())
        self.addParameter(shared.photo_field())
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        self.addParameter(shared.method())
        self.addParameter(shared.compass())
        add_field_parameters(self)
        add_terrain_parameters(self)
        add_rescue_parameters(self)
        add_altitude_parameter(self)
        add_lens_parameter(self)
        add_lens_table_parameter(self)
        add_joint_parameter(self)
        add_workers_parameter(self)
        self.addParameter(oriented_out())
        self.addParameter(shared.report_out())
        add_compass_audit(self)
        self.addParameter(orientations_out())
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("ACCEPTED", tr("Number of accepted photos")))

    def input_fault(self, parameters, context):
        """Check the layer and the DEM."""
        fault = points_fault(self, parameters, context, "INPUT", "PHOTO_FIELD", NUMBER_FIELDS)
        return fault or lens_table_fault(self, parameters, context) or dem_fault(self, parameters, context)

    def compute(self, parameters, context, feedback):
        """Orient the photos, then write."""
        source, rows = read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", NUMBER_FIELDS)
        fields, rows = with_lens_table(self, parameters, context, source.fields(), rows)
        options = options_of(self, parameters, context)
        requests = requests_of(self, parameters, context, rows)
        fields, kept = oriented_fields(fields)
        rehearse(self, parameters, "OUTPUT", context, (fields, source.wkbType(), source.sourceCrs()))
        placing = Placing(source.wkbType(), source.sourceCrs(), context)
        features, statuses, compasses = [], [], CompassReadings()
        workers = self.parameterAsInt(parameters, "WORKERS", context)
        joint = self.parameterAsBoolean(parameters, "JOINT", context)
        folder = self.parameterAsString(parameters, "ORIENTATIONS", context)
        report = PhotoReport(self, parameters, context, len(rows))
        with report, Previews(parameters, context) as previews:
            oriented_photos = orient_each(
                requests, self.dem.open(), options, feedback, folder, SHARE, workers=workers, joint=joint
            )
            for oriented, row in zip(oriented_photos, rows):  # in this order the loop runs to its end
                place = placing.of(row, oriented)
                features.append(oriented_row(row, kept, oriented, options.horizon.max_distance_m, place))
                statuses.append(oriented.orientation.status)
                report.add(oriented)
                compasses.add(oriented)
                previews.add(row.path, oriented.preview)
            feedback.pushInfo(summary(statuses))
            fields, features = previews.column(fields, features)
            kind = source.wkbType(), source.sourceCrs()
            output = write_features(self, parameters, "OUTPUT", context, fields, *kind, features, style="oriented")
            audit = compasses.write(self, parameters, context)
        specs = oriented_specs() + preview_specs()
        style_on_completion(context, output, "oriented", tr("Oriented photos"), specs, self.displayName())
        results = {"OUTPUT": output, "COUNT": len(statuses), "ACCEPTED": statuses.count("accepted")}
        return {**results, **audit, **report.outputs(), **({"ORIENTATIONS": folder} if folder else {})}
