"""A folder or layer of photographs and a DEM -> oriented points, ground in view, and a report, in one run."""

from __future__ import annotations

from qgis.core import QgsProcessing, QgsProcessingOutputNumber, QgsProcessingParameterBoolean

from ..core.base.progress import subtask
from ..core.base.status import RELIABLE
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.feedback import FeedbackProgress, StillProgress
from .shared.fields import is_null, photo_specs
from .shared.folder_photos import folder_fault, photo_rows
from .shared.i18n import tr
from .shared.kept_orientations import orientations_out
from .shared.lens_table import add_lens_table_parameter, lens_table_fault
from .shared.orientation import (
    add_altitude_parameter,
    add_field_parameters,
    add_lens_parameter,
    options_of,
    orient_each,
    oriented_out,
    oriented_row,
    requests_of,
    summary,
)
from .shared.oriented import oriented_specs
from .shared.outputs import rehearse, write_features
from .shared.photo_points import oriented_point
from .shared.placing import Placing
from .shared.previews import Previews, preview_specs
from .shared.reporting import PhotoReport
from .shared.rescue import add_rescue_parameters
from .shared.result_figures import ResultFigures, figures_out, stations_of
from .shared.skyline_limits import add_own_parameters, with_own
from .shared.statuses import tell_withheld
from .shared.styling import style_on_completion
from .shared.together import BLOCK, add_joint_parameter, are_together, help_on_together
from .shared.viewer import Viewer
from .shared.viewshed_extras import Extras, add_extra_parameters, extra_options
from .shared.viewshed_outputs import ViewshedOutputs
from .shared.visibility import add_range_parameters, range_fault, viewshed_options
from .shared.workers import add_workers_parameter

SHARE = (0.0, 0.95)
ORIENTATION_PART = 0.8
"""The orientation's part of a photo's share of the progress bar; its viewshed takes the rest."""


class PhotoViewshed(DemAlgorithm):
    """Run the whole pipeline in one algorithm."""

    ID = "photoviewshed"
    GROUP_ID = "all"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Photos to viewsheds")

    def tags(self):
        """Search words."""
        return tr("photo,viewshed,heading,orientation,skyline,visibility,heic,exif,report,batch").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("From mountain photographs and a DEM to headings, ground in view and a report")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Reads geotagged photographs, finds the heading of each from its skyline and the elevation "
                "model, and computes the ground that it shows. Choose a folder or a layer of photo points."
            ),
            tr(
                "Open the report to check each match: it has one card per photograph, with the horizon drawn "
                "over the picture. Photographs with a doubtful heading (status <i>ambiguous</i>) get no "
                "viewshed unless you request it under Advanced. With the <i>paper</i> method, which does not "
                "test its answers, all photographs get one."
            ),
            help_on_together(),
            tr("Distances are ground metres and headings count from true north, whatever the coordinate systems."),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        from ..core.horizon.horizon import HorizonOptions
        from ..core.viewshed.viewshed import ViewshedOptions

        self.addParameter(
            shared.folder_in(
                "FOLDER",
                tr("Folder of photographs"),
                tr("JPEG and HEIC files, and PNG, TIFF and WebP files that record a position."),
                optional=True,
            )
        )
        self.addParameter(shared.photo_source(optional=True))
        self.addParameter(shared.dem())
        text = tr("Maximum viewshed distance from the camera, in metres on the ground.")
        self.addParameter(shared.max_distance(ViewshedOptions().max_distance_m, text))
        self.addParameter(shared.sector())
        recursive = QgsProcessingParameterBoolean("RECURSIVE", tr("Include subfolders"), False)
        doubtful = QgsProcessingParameterBoolean("DOUBTFUL", tr("Viewsheds of doubtful photos too"), False)
        horizon_distance = shared.distance(
            "HORIZON_DISTANCE",
            tr("Search range of the horizon (m)"),
            HorizonOptions().max_distance_m,
            shared.horizon_distance_text(),
            minimum=100.0,
        )
        for parameter in (
            shared.explained(recursive, tr("Also searches all subfolders.")),
            shared.photo_field(),
            shared.band(),
            shared.dem_unit(),
            shared.method(),
            shared.compass(),
            shared.explained(
                doubtful, tr("Computes the ground for the best heading even if another heading is as likely.")
            ),
            horizon_distance,
            shared.refraction(HorizonOptions().refraction_coefficient),
        ):
            self.addParameter(shared.advanced(parameter))
        add_range_parameters(self)
        add_field_parameters(self)
        add_rescue_parameters(self)
        add_altitude_parameter(self)
        add_lens_parameter(self)
        add_lens_table_parameter(self)
        add_joint_parameter(self)
        add_workers_parameter(self)
        self._add_outputs()

    def _add_outputs(self):
        polygon = QgsProcessing.SourceType.TypeVectorPolygon
        self.addParameter(oriented_out())
        self.addParameter(
            shared.points_out(
                "POLYGONS",
                tr("Ground in view"),
                polygon,
                text=tr("One multipolygon per photograph, with the area seen (m²) and the farthest distance (m)."),
            )
        )
        self.addParameter(
            shared.raster_out(
                "VIEWSHED",
                tr("Viewshed"),
                text=tr("Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown."),
            )
        )
        self.addParameter(shared.report_out())
        self.addParameter(
            shared.folder_out(
                "RASTERS", tr("Folder for one raster per photo"), tr("GeoTIFFs: 1 seen, 0 not seen, nodata unknown.")
            )
        )
        self.addParameter(figures_out())
        self.addParameter(orientations_out())
        add_extra_parameters(self)
        add_own_parameters(self)
        for name, label in (
            ("COUNT", tr("Number of photos")),
            ("ACCEPTED", tr("Number of accepted photos")),
            ("VIEWSHEDS", tr("Number of viewsheds")),
        ):
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def input_fault(self, parameters, context):
        """Check the photographs, the DEM and the range."""
        return (
            folder_fault(self, parameters, context)
            or lens_table_fault(self, parameters, context)
            or dem_fault(self, parameters, context)
            or range_fault(self, parameters, context)
        )

    def compute(self, parameters, context, feedback):
        """Orient the photos, compute the ground that each shows, then write."""
        photos = photo_rows(self, parameters, context, feedback)
        options = options_of(self, parameters, context, "HORIZON_DISTANCE")
        requests = requests_of(self, parameters, context, photos.rows)
        dem = self.dem.open()
        ground = ViewshedOutputs(dem, self.parameterAsDouble(parameters, "MIN_AREA", context))
        rehearse(self, parameters, "OUTPUT", context, (photos.fields, photos.wkb_type, photos.crs))
        placing = Placing(photos.wkb_type, photos.crs, context)
        features, statuses = [], []
        workers = self.parameterAsInt(parameters, "WORKERS", context)
        joint = self.parameterAsBoolean(parameters, "JOINT", context)
        # Evaluated once: each evaluation of a temporary folder returns a different one.
        names = ("RASTERS", "FIGURES", "ORIENTATIONS")
        folders = {name: self.parameterAsString(parameters, name, context) for name in names}
        report = PhotoReport(self, parameters, context, len(photos.rows))
        with report, Previews(parameters, context) as previews:
            viewer = self._viewer(parameters, context, dem, feedback, folders["RASTERS"])
            extras = Extras(viewer, extra_options(self, parameters, context), feedback)
            view = self._view_of(parameters, context, viewer, options.method, len(photos.rows))
            figures = ResultFigures(dem, folders["FIGURES"], stations_of(photos.rows), feedback, bool(report.path))
            oriented_photos = orient_each(
                requests, dem, options, feedback, folders["ORIENTATIONS"], SHARE, ORIENTATION_PART, workers, joint
            )
            for oriented, row in zip(oriented_photos, photos.rows):  # in this order the loop runs to its end
                place = placing.of(row, oriented)
                features.append(oriented_row(row, photos.kept, oriented, options.horizon.max_distance_m, place))
                statuses.append(oriented.orientation.status)
                previews.add(row.path, oriented.preview)
                point = oriented_point(row, oriented, extras.options.uncertainty)
                point = self._limited(parameters, context, point, oriented)
                viewshed = view(point, oriented.orientation.status, len(statuses) - 1)
                if viewshed is None:
                    report.add(oriented)
                    continue
                more = extras.of(point, viewshed, oriented.horizon)
                facts, panels = ground.add(point, viewshed, more), figures.draw(point, viewshed, oriented.preview)
                report.add(oriented, facts, panels)
            feedback.pushInfo(summary(statuses))
            if not self._doubtful(parameters, context, options.method):
                tell_withheld(feedback, statuses, len(ground.rows))
            written = previews.column(photos.fields, features)
            outputs = self._write(parameters, context, feedback, photos, written, ground)
        counts = {"COUNT": len(statuses), "ACCEPTED": statuses.count("accepted"), "VIEWSHEDS": len(ground.rows)}
        folders = {name: folder for name, folder in folders.items() if folder}
        return {**outputs, **folders, **extras.folders, **counts, **report.outputs()}

    def _viewer(self, parameters, context, dem, feedback, folder):
        kind = shared.SECTORS[self.parameterAsEnum(parameters, "SECTOR", context)]
        options = viewshed_options(self, parameters, context)
        return Viewer(dem, kind, options, feedback, folder)

    def _limited(self, parameters, context, point, oriented):
        """Give the point its photo's own skyline if requested."""
        if not self.parameterAsBoolean(parameters, "OWN_SKYLINE", context):
            return point
        return with_own(point, oriented, self.parameterAsDouble(parameters, "SKYLINE_TOLERANCE", context))

    def _doubtful(self, parameters, context, method):
        """Whether doubtful headings get viewsheds too; the paper method does not test its answers."""
        return method == "paper" or self.parameterAsBoolean(parameters, "DOUBTFUL", context)

    def _view_of(self, parameters, context, viewer, method, count):
        """Return the function that computes one photo's viewshed, or None for a photo whose heading is not reliable."""
        doubtful = self._doubtful(parameters, context, method)
        progress = subtask(FeedbackProgress(viewer.feedback), *SHARE)
        together = are_together(self.parameterAsBoolean(parameters, "JOINT", context), count, method)
        if together:  # all photographs have been oriented before the first viewshed
            progress = subtask(progress, ORIENTATION_PART, 1.0)
        if together and count > BLOCK:  # viewsheds come between the blocks, and the orientation has the bar
            progress = StillProgress(viewer.feedback)
        before = 0.0 if together else ORIENTATION_PART

        def view(point, status, index):
            if point.posed is None or not (status in RELIABLE or doubtful):
                return None
            return viewer.view(point, subtask(progress, (index + before) / count, (index + 1) / count))

        return view

    def _write(self, parameters, context, feedback, photos, table, ground):
        viewshed = ground.write_count(self, parameters, "VIEWSHED", context, feedback)
        polygons = ground.write_polygons(self, parameters, "POLYGONS", context, self.dem.crs)
        fields, rows = table
        kind = photos.wkb_type, photos.crs
        output = write_features(self, parameters, "OUTPUT", context, fields, *kind, rows, style="oriented")
        specs = (photo_specs() if is_null(parameters.get("INPUT")) else []) + oriented_specs() + preview_specs()
        style_on_completion(context, output, "oriented", tr("Oriented photos"), specs, self.displayName())
        return {"OUTPUT": output, "POLYGONS": polygons, "VIEWSHED": viewshed}
