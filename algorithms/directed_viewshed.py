"""Oriented points and a DEM -> the ground that the photographs show, as a raster and polygons."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from qgis.core import QgsProcessing, QgsProcessingOutputNumber

from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.doubtful_places import warn_of_place
from .shared.elevation import dem_fault
from .shared.i18n import tr
from .shared.layers import number_column, points_fault, read_points
from .shared.photo_points import INTERVAL_FIELDS, POSE_FIELDS, PoseReading, photo_point
from .shared.result_figures import ResultFigures, figures_out, stations_of
from .shared.skyline_limits import add_table_parameters, table_fault, with_table
from .shared.statuses import relied_on
from .shared.viewer import Viewer
from .shared.viewshed_extras import Extras, add_extra_parameters, extra_options
from .shared.viewshed_outputs import ViewshedOutputs
from .shared.visibility import add_range_parameters, range_fault, viewshed_options
from .shared.workers import add_workers_parameter

NUMBER_FIELDS = (*POSE_FIELDS, *INTERVAL_FIELDS)


class DirectedViewshed(DemAlgorithm):
    """Compute which ground oriented photographs show."""

    ID = "directedviewshed"
    GROUP_ID = "terrain"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Directed viewshed")

    def tags(self):
        """Search words."""
        return tr("viewshed,visibility,photo,field of view,frustum,wedge,dem,sector").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Ground that oriented photographs show: cumulative raster and one polygon per photo")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Tests for every cell of the elevation model in range whether it is visible from the camera "
                "and lies inside the picture. <i>Photo frame</i> uses heading, pitch, roll and both fields "
                "of view; <i>heading wedge</i> uses only the heading and the horizontal field of view; "
                "<i>full circle</i> uses none of them."
            ),
            tr(
                "The raster uses the DEM's grid and counts the photographs that show each cell; cells for "
                "which this is unknown are nodata. The polygons have the area on the ellipsoid (m²) and the "
                "farthest distance (m) as attributes. Azimuths count from true north and distances are "
                "ground metres, whatever the coordinate system."
            ),
            tr(
                "Advanced options: layers with values per cell (distance, elevation angle, how much higher a "
                "target must be to be visible, position in the picture), probabilities that account for the "
                "errors of pose, position and DEM, and the photographs' own skylines, which exclude ground "
                "that the foreground hides. Photographs from exactly the same place are computed together."
            ),
            tr(
                "To continue a run that was stopped, repeat it with the same parameters. Finished files in "
                "the folders of rasters, layers and probabilities are reused if the DEM, the pose and the "
                "settings have not changed."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        from ..core.viewshed.viewshed import ViewshedOptions

        defaults = ViewshedOptions()
        points = shared.photo_source()
        points.setDescription(tr("Oriented photo points"))
        points.setHelp(tr("From Orient photos, or any points with heading, pitch, roll and field of view."))
        self.addParameter(points)
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        for parameter in pose_parameters():
            self.addParameter(parameter)
        self.addParameter(
            shared.advanced(
                shared.number_field(
                    "HEIGHT_FIELD",
                    tr("Field with the camera's elevation (m)"),
                    tr("Absolute elevation in the DEM's height system. NULL: DEM plus camera height."),
                )
            )
        )
        for parameter in interval_parameters():
            self.addParameter(shared.advanced(parameter))
        self.addParameter(shared.statuses())
        self.addParameter(shared.sector())
        self.addParameter(shared.max_distance(defaults.max_distance_m))
        add_range_parameters(self)
        self.addParameter(shared.advanced(shared.refraction(defaults.refraction_coefficient)))
        self.addParameter(
            shared.raster_out(
                "OUTPUT",
                tr("Viewshed"),
                text=tr("Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown."),
            )
        )
        self.addParameter(
            shared.points_out(
                "POLYGONS",
                tr("Ground in view"),
                QgsProcessing.SourceType.TypeVectorPolygon,
                optional=True,
                text=tr("One multipolygon per photograph, with the area seen (m²) and the farthest distance (m)."),
            )
        )
        self.addParameter(
            shared.folder_out(
                "RASTERS",
                tr("Folder for one raster per photo"),
                tr("GeoTIFFs: 1 seen, 0 not seen, nodata unknown."),
            )
        )
        self.addParameter(figures_out())
        add_extra_parameters(self)
        add_table_parameters(self)
        add_workers_parameter(self)
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of viewsheds")))

    def input_fault(self, parameters, context):
        """Check the layer, the DEM and the range."""
        return (
            points_fault(self, parameters, context, "INPUT", None, NUMBER_FIELDS)
            or self._heading_fault(parameters, context)
            or dem_fault(self, parameters, context)
            or range_fault(self, parameters, context)
            or table_fault(self, parameters, context)
        )

    def _heading_fault(self, parameters, context):
        kind = shared.SECTORS[self.parameterAsEnum(parameters, "SECTOR", context)]
        source = self.parameterAsSource(parameters, "INPUT", context)
        if kind == "full circle" or source is None:
            return None
        if number_column(self, parameters, context, source, "HEADING_FIELD") is None:
            return tr("The layer has no heading. Choose the field that holds it, orient the photos first, or take the "
                      "full circle.")  # fmt: skip
        return None

    def compute(self, parameters, context, feedback):
        """Compute photo by photo, then write."""
        _, rows = read_points(self, parameters, context, "INPUT", None, NUMBER_FIELDS)
        kind = shared.SECTORS[self.parameterAsEnum(parameters, "SECTOR", context)]
        if kind != "full circle":  # which does not depend on the heading
            rows = relied_on(self, parameters, context, feedback, rows)
        wanted = extra_options(self, parameters, context)
        reading = PoseReading(self.parameterAsDouble(parameters, "EYE_HEIGHT", context), wanted.uncertainty)
        points = with_table(self, parameters, context, [point_of(row, reading) for row in rows], feedback)
        options, dem = viewshed_options(self, parameters, context), self.dem.open()
        folders = {name: self.parameterAsString(parameters, name, context) for name in ("RASTERS", "FIGURES")}
        outputs = ViewshedOutputs(dem, self.parameterAsDouble(parameters, "MIN_AREA", context))
        viewer = Viewer(dem, kind, options, feedback, folders["RASTERS"])
        extras = Extras(viewer, wanted, feedback)
        figures = ResultFigures(dem, folders["FIGURES"], stations_of(rows), feedback)
        for point in points:
            warn_of_place(feedback, point, dem, point.observer)
        for point, viewshed in viewer.each(points, (0.0, 0.9), self.parameterAsInt(parameters, "WORKERS", context)):
            outputs.add(point, viewshed, extras.of(point, viewshed))
            figures.draw(point, viewshed)
        outputs.arrange(points)
        results = {
            "OUTPUT": outputs.write_count(self, parameters, "OUTPUT", context, feedback),
            "POLYGONS": outputs.write_polygons(self, parameters, "POLYGONS", context, self.dem.crs),
            "COUNT": len(outputs.rows),
        }
        return {**results, **{name: folder for name, folder in folders.items() if folder}, **extras.folders}


def pose_parameters():
    """Field parameters of the pose."""
    field = shared.number_field
    heading = field("HEADING_FIELD", tr("Field with the heading (°)"), tr("True, clockwise from north."), "heading")
    others = [
        field(
            "HFOV_FIELD",
            tr("Field with the horizontal field of view (°)"),
            tr("Field of view of the upright picture."),
            "hfov",
        ),
        field("PITCH_FIELD", tr("Field with the pitch (°)"), tr("Up is positive. NULL: wedge, not frame."), "pitch"),
        field("ROLL_FIELD", tr("Field with the roll (°)"), tr("Right side down is positive. NULL: 0."), "roll"),
        field("VFOV_FIELD", tr("Field with the vertical field of view (°)"), tr("NULL: wedge, not frame."), "vfov"),
    ]
    return [heading, *map(shared.advanced, others)]


def interval_parameters():
    """Fields with the ends of the heading's interval, as `orientphotos` writes them."""
    text = tr("End of the 90 % interval, used for probabilities. NULL: a standard deviation of 0.5° is used instead.")
    return [
        shared.number_field("HEADING_LO_FIELD", tr("Field with the heading's lower end (°)"), text, "heading_lo"),
        shared.number_field("HEADING_HI_FIELD", tr("Field with the heading's upper end (°)"), text, "heading_hi"),
    ]


def point_of(row, reading):
    """Read a point, with the photograph named in its field `photo`."""
    names = row.feature.fields().names()
    photo = row.feature["photo"] if "photo" in names else None
    photo = str(photo) if isinstance(photo, str) and photo else None
    point = photo_point(row, row.numbers, reading, photo)
    return replace(point, name=Path(photo).name) if photo else point
