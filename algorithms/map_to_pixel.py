"""Map features -> image coordinates on oriented photographs, each visible, hidden or outside."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsWkbTypes,
)

from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.fields import qgis_fields
from .shared.i18n import tr
from .shared.image_features import ImageFeatures, Placement, line_specs, point_specs, read_map_features
from .shared.map_places import crs_of, to_dem_transform
from .shared.outputs import write_features
from .shared.picture_files import PictureFolder
from .shared.styling import style_on_completion
from .shared.summit_input import point_heights, snap_distance
from .shared.views import Opening, add_view_parameters, open_views, sight_options


class MapToPixel(DemAlgorithm):
    """Find where map features appear in photographs."""

    ID = "maptopixel"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Map to pixels")

    def tags(self):
        """Search words."""
        return tr("project,overlay,photo,pixel,visible,hidden,trail,outline,annotate,augmented").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Where points, lines and areas of the map appear in oriented photos, and what hides them")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Converts points, lines (such as a trail) and areas (such as a glacier's outline of 1900) to "
                "image coordinates. Lines and outlines follow the terrain and are cut where they disappear "
                "behind it or leave the picture. The state of each piece is <b>visible</b>, <b>hidden</b>, "
                "<b>outside</b> or <b>unknown</b> (no elevation there). For areas, the visible share is "
                "given as well."
            ),
            tr(
                "A point with a height is a summit if the ground at its place is lower. It is then moved to the nearby "
                "top in the DEM, as in <i>Label peaks in photos</i>: published positions and coarse DEMs differ by "
                "hundreds of metres."
            ),
            tr(
                "The output has the coordinates of the picture as QGIS shows it without georeference: x to "
                "the right, y negative downwards from the upper left corner. Load it together with the "
                "photo. The fields <b>x_px</b> and <b>y_px</b> count from the centre of the first pixel, "
                "with y downwards."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        features = QgsProcessingParameterFeatureSource(
            "FEATURES", tr("Map features"), [QgsProcessing.SourceType.TypeVectorAnyGeometry]
        )
        text = tr(
            "Points, lines or areas in any coordinate system. Heights are taken from the DEM; Z values are ignored."
        )
        self.addParameter(shared.explained(features, text))
        name = QgsProcessingParameterField("NAME_FIELD", tr("Field with names"), None, "FEATURES", optional=True)
        self.addParameter(shared.explained(name, tr("Written to the output and into the pictures.")))
        text = tr(
            "Points with a height that their ground does not reach are summits. NULL: the point lies on the ground."
        )
        self.addParameter(shared.advanced(point_heights("FEATURES", text)))
        add_view_parameters(self)
        self.addParameter(shared.advanced(snap_distance()))
        above = shared.distance(
            "HEIGHT_ABOVE",
            tr("Height above ground (m)"),
            0.0,
            tr("Height of points above the ground. Lines and areas lie on the ground."),
        )
        self.addParameter(shared.advanced(above))
        step = shared.number(
            "STEP", tr("Step along lines (px)"), 2.0, tr("Lines are followed in steps of this length."), 0.1
        )
        self.addParameter(shared.advanced(step))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Points in pictures"),
                optional=True,
                text=tr(
                    "Points in pixels of the photo as QGIS shows it (not rotated), with negative y for rows; x_px and "
                    "y_px count on the upright picture. The field state tells whether the photo shows them."
                ),
            )
        )
        self.addParameter(
            shared.points_out(
                "LINES",
                tr("Lines and outlines in pictures"),
                QgsProcessing.SourceType.TypeVectorLine,
                optional=True,
                text=tr(
                    "Lines and outlines in pixels of the photo as QGIS shows it (not rotated), with negative y for "
                    "rows, cut where their visibility changes."
                ),
            )
        )
        text = tr("One PNG and one SVG per photo with the features drawn in; hidden parts are dashed.")
        self.addParameter(shared.folder_out("PICTURES", tr("Folder for annotated photos"), text))
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of points and pieces")))
        self.addOutput(QgsProcessingOutputNumber("VISIBLE_COUNT", tr("Number of visible points and pieces")))

    def compute(self, parameters, context, feedback):
        """Project photo by photo, then write."""
        source = self.parameterAsSource(parameters, "FEATURES", context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, "FEATURES"))
        terrain, options = self.dem.open(), sight_options(self, parameters, context)
        columns = (self.parameterAsString(parameters, name, context) for name in ("NAME_FIELD", "ELEVATION_FIELD"))
        transform = to_dem_transform(crs_of(self, parameters, "FEATURES", context), self.dem.crs, context)
        features = read_map_features(source, transform, *columns)
        numbers = (self.parameterAsDouble(parameters, name, context) for name in ("HEIGHT_ABOVE", "STEP", "SNAP"))
        found = ImageFeatures(terrain, features, options, Placement(*numbers), feedback)
        folder = self.parameterAsString(parameters, "PICTURES", context)
        pictures = PictureFolder(folder)
        reach = options.max_distance_m
        for photo in open_views(self, parameters, context, feedback, terrain, Opening(reach, (0.0, 0.95))):
            pictures.annotate(photo, *found.add(photo), feedback)
        results = {"COUNT": len(found.points) + len(found.lines), "VISIBLE_COUNT": found.visible_count}
        for name, style, title, specs, kind, rows in (
            ("OUTPUT", "image_points", tr("Points in pictures"), point_specs(), QgsWkbTypes.Type.Point, found.points),
            ("LINES", "image_lines", tr("Lines in pictures"), line_specs(), QgsWkbTypes.Type.LineString, found.lines),
        ):
            if parameters.get(name) is None:
                continue
            nowhere = QgsCoordinateReferenceSystem()
            written = write_features(
                self, parameters, name, context, qgis_fields(specs), kind, nowhere, rows, style=style
            )
            if written is not None:
                style_on_completion(context, written, style, title, specs, self.displayName())
                results[name] = written
        return {**results, "PICTURES": folder} if folder else results
