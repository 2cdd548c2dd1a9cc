"""Summits with names -> labels on oriented photographs."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPoint,
    QgsProcessingOutputNumber,
    QgsWkbTypes,
)

from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.fields import FieldSpec, qgis_fields
from .shared.i18n import tr
from .shared.map_places import map_of_local, number
from .shared.outputs import write_features
from .shared.picture_files import PictureFolder
from .shared.styling import style_on_completion
from .shared.summit_input import add_summit_parameters, summits_of
from .shared.views import Opening, add_view_parameters, open_views, sight_options


class LabelPeaks(DemAlgorithm):
    """Find which summits photographs show, and write in their names."""

    ID = "labelpeaks"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Label peaks in photos")

    def tags(self):
        """Search words."""
        return tr("peak,summit,mountain,name,label,annotate,prominence,openstreetmap,geonames").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Summits in the picture with visibility, distance and position; annotated PNG and SVG")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Uses a point layer with names and heights (OpenStreetMap <i>natural=peak</i>, GeoNames), or "
                "finds summits in the elevation model by their prominence. Each published summit is moved "
                "to the nearby top in the DEM, because published positions and coarse DEMs differ by "
                "hundreds of metres. Then its visibility in the photo is tested."
            ),
            tr(
                "Labels never overlap. The more important summit (by prominence, otherwise by height above "
                "the others in view) gets the better place. Labels without room are left out of the picture; "
                "the layer contains all summits."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        add_view_parameters(self, 100_000.0)
        add_summit_parameters(self)
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Summits in photos"),
                text=tr(
                    "One point for each photo and each summit in its frame, with name, distance (m) and "
                    "position in the picture (px)."
                ),
            )
        )
        text = tr("One PNG and one SVG per photo with the names written in.")
        self.addParameter(shared.folder_out("PICTURES", tr("Folder for labelled photos"), text))
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of summits in frame")))
        self.addOutput(QgsProcessingOutputNumber("VISIBLE_COUNT", tr("Number of visible summits")))

    def compute(self, parameters, context, feedback):
        """Label photo by photo, then write."""
        terrain, options = self.dem.open(), sight_options(self, parameters, context)
        summits = summits_of(self, parameters, context, terrain, self.dem.crs)
        folder = self.parameterAsString(parameters, "PICTURES", context)
        pictures, rows, visible = PictureFolder(folder), [], 0
        reach = options.max_distance_m
        for photo in open_views(self, parameters, context, feedback, terrain, Opening(reach, (0.0, 0.95))):
            shown = summits.shown(photo.view, options)
            marks = [summit.mark for summit in shown if summit.visible and photo.sized]
            visible += len([summit for summit in shown if summit.visible])
            rows += [_row(terrain, photo, summit) for summit in shown]
            pictures.annotate(photo, marks, (), feedback)
        specs = peak_specs()
        crs = self.dem.crs or QgsCoordinateReferenceSystem()
        output = write_features(
            self, parameters, "OUTPUT", context, qgis_fields(specs), QgsWkbTypes.Type.PointZ, crs, rows, style="peaks"
        )
        style_on_completion(context, output, "peaks", tr("Summits in photos"), specs, self.displayName())
        results = {"OUTPUT": output, "COUNT": len(rows), "VISIBLE_COUNT": visible}
        return {**results, "PICTURES": folder} if folder else results


def peak_specs():
    """Fields of summits in photos: one row per summit in a photo's frame."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("name", "text", tr("Summit")),
        FieldSpec("height_m", "real", tr("Published height, otherwise height in the DEM (m)")),
        FieldSpec("dem_m", "real", tr("Height of the DEM's top (m)")),
        FieldSpec("moved_m", "real", tr("Moved to the DEM's top by (m)")),
        FieldSpec("prominence", "real", tr("Prominence in the DEM (m), if summits were searched")),
        FieldSpec("state", "text", tr("visible, hidden, unknown")),
        FieldSpec("x_px", "real", tr("Column (px)")),
        FieldSpec("y_px", "real", tr("Row (px)")),
        FieldSpec("dist_m", "real", tr("Distance (m)")),
        FieldSpec("azimuth", "real", tr("Azimuth (° from true north)")),
        FieldSpec("elev_deg", "real", tr("Elevation angle (°)")),
    ]


def _row(terrain, photo, summit):
    x, y = map_of_local(terrain, photo.view.frame, summit.east_m, summit.north_m)
    values = [photo.path or photo.name, summit.name, number(summit.height_m), number(summit.dem_m)]
    values += [number(summit.moved_m), number(summit.prominence_m), summit.state, number(summit.x_px)]
    values += [number(v) for v in (summit.y_px, summit.distance_m, summit.azimuth_deg, summit.elevation_deg)]
    return QgsGeometry(QgsPoint(float(x), float(y), summit.height_m)), values
