"""Photographs, a DEM and an area -> where each photograph was taken."""

from __future__ import annotations

import traceback
from dataclasses import replace
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsWkbTypes,
)

from ..core.base.errors import Cancelled, OutputError, TerrainError
from ..core.base.messages import Message
from ..core.base.progress import subtask
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.elevation import dem_fault
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import photo_specs, qgis_fields
from .shared.folder_photos import folder_fault, read_files
from .shared.i18n import tr
from .shared.layers import read_points
from .shared.located_outputs import best_row, candidate_rows, located_specs, region_row, region_specs
from .shared.located_report import add_places
from .shared.outputs import write_features
from .shared.photo_attributes import photos_in
from .shared.reporting import PhotoReport
from .shared.search_area import SearchArea, add_area_parameters, area_fault, weights_source
from .shared.styling import style_on_completion


class LocatePhotos(DemAlgorithm):
    """Search an area for the place from which each photograph was taken."""

    ID = "locatephotos"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Locate photos")

    def tags(self):
        """Search words."""
        return tr("position,place,where,geolocation,photo,skyline,horizon,archive,search,gps,geotag").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Where photographs were taken, from their skyline and a DEM alone")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Compares the skyline of each photograph with the horizons of all places of an area, and gives the "
                "place, heading, pitch and roll that fit best. No position is needed in the photographs."
            ),
            tr(
                "<b>status</b> is <i>accepted</i> (the place can be trusted), <i>ambiguous</i> (compare the "
                "candidates), <i>rejected</i> (the photograph was probably not taken in this area, or its skyline does "
                "not decide) or <i>failed</i>. <b>p_correct</b> is the probability that the place is within 500 m "
                "and the heading within 3 degrees of the truth."
            ),
            tr(
                "The horizons of the area are computed once, about 2 ms for each place. Choose a folder for them to "
                "use them again. A wide view of far mountains can be located well; a telephoto view or a near slope "
                "cannot. A place can reveal where people live or were: use the answer responsibly."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        folder = shared.folder_in(
            "FOLDER",
            tr("Folder of photographs"),
            tr("JPEG and HEIC files, and PNG, TIFF and WebP files that record a position."),
            True,
        )
        self.addParameter(folder)
        recursive = QgsProcessingParameterBoolean("RECURSIVE", tr("Include subfolders"), False)
        self.addParameter(shared.explained(shared.advanced(recursive), tr("Also searches all subfolders.")))
        points = shared.photo_source(optional=True)
        points.setHelp(
            tr(
                "One point per photograph, in place of a folder. Its position is the centre of a search in a radius; "
                "otherwise it is only compared with the answer."
            )
        )
        self.addParameter(points)
        self.addParameter(shared.advanced(shared.photo_field()))
        self.addParameter(shared.dem())
        self.addParameter(shared.band())
        self.addParameter(shared.dem_unit())
        add_area_parameters(self)
        self._add_search_parameters()
        self.addParameter(
            shared.points_out("OUTPUT", tr("Best places"), text=tr("One point per photograph at the best place."))
        )
        candidates = shared.points_out(
            "CANDIDATES",
            tr("Candidate places"),
            optional=True,
            text=tr("The best places of each photograph, ranked, with the pose at each."),
        )
        self.addParameter(candidates)
        self.addParameter(
            shared.points_out(
                "REGION",
                tr("Regions of 90 % probability"),
                QgsProcessing.SourceType.TypeVectorPolygon,
                optional=True,
                text=tr("Polygons that hold 90 % of the probability if the photograph was taken in the area."),
            )
        )
        self.addParameter(shared.report_out())
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("ACCEPTED", tr("Number of accepted photos")))

    def _add_search_parameters(self):
        spacing = tr("Distance between the places that are tried; the best of them are moved afterwards.")
        step = shared.distance("SPACING", tr("Spacing of the places (m)"), 250.0, spacing, minimum=10.0)
        self.addParameter(shared.advanced(step))
        self.addParameter(shared.advanced(shared.compass(tested=False)))
        text = tr("Field of view of the upright picture. NULL: computed from the focal length in the file.")
        field = shared.number_field("HFOV_FIELD", tr("Field with the horizontal field of view (°)"), text)
        self.addParameter(shared.advanced(field))
        text = tr("Tried for photographs without a focal length and without a given field of view.")
        for name, label, default in (
            ("HFOV_MIN", tr("Narrowest field of view to try (°)"), 30.0),
            ("HFOV_MAX", tr("Widest field of view to try (°)"), 75.0),
        ):
            self.addParameter(shared.advanced(shared.number(name, label, default, text, minimum=4.0, maximum=130.0)))
        text = tr("Greatest height of the camera above the ground, for towers and drones. Heights up to it are tried.")
        self.addParameter(shared.advanced(shared.eye_height()))
        highest = shared.distance("EYE_MAX", tr("Greatest camera height (m)"), 1.7, text)
        self.addParameter(shared.advanced(highest))
        text = tr("Maximum distance of the mountains on the skyline, in metres on the ground.")
        self.addParameter(shared.advanced(shared.max_distance(60_000.0, text)))
        self.addParameter(shared.advanced(shared.refraction(0.13)))
        text = tr("Largest index of horizons that is held in memory; a folder for the index has no such limit.")
        self.addParameter(
            shared.advanced(shared.number("MEMORY", tr("Memory for the index (MB)"), 1000.0, text, minimum=1.0))
        )
        text = tr("Keeps the horizons of the area, about 3 kB for each place, so that later runs start at once.")
        self.addParameter(shared.advanced(shared.folder_out("INDEX", tr("Folder for the index"), text)))

    def input_fault(self, parameters, context):
        """Check the photographs, the area and the DEM."""
        return (
            folder_fault(self, parameters, context)
            or area_fault(self, parameters, context)
            or dem_fault(self, parameters, context)
        )

    def prepareAlgorithm(self, parameters, context, feedback):
        """Read from the layers what they provide in the main thread only."""
        self.weights = weights_source(self, parameters, context)
        return super().prepareAlgorithm(parameters, context, feedback)

    def compute(self, parameters, context, feedback):
        """Build the index, search photo by photo, then write."""
        rows = self._rows(parameters, context, feedback)
        search = Search(self, parameters, context, feedback)
        best, candidates, regions, statuses = [], [], [], []
        with PhotoReport(self, parameters, context, len(rows)) as report:
            for number, row in enumerate(rows):
                located, index = search.locate(row, number, len(rows))
                path, recorded = row.path or "", (row.longitude_deg, row.latitude_deg)
                best.append(best_row(path, located, recorded))
                candidates += candidate_rows(path, located, recorded)
                region = None if index is None else region_row(path, located, index)
                regions += [] if region is None else [region]
                statuses.append(located.status)
                add_places(report, located, index)
            written = self._write(parameters, context, (best, candidates, regions))
        return {**written, "COUNT": len(rows), "ACCEPTED": statuses.count("accepted"), **report.outputs()}

    def _rows(self, parameters, context, feedback):
        folder = self.parameterAsString(parameters, "FOLDER", context)
        if not folder:
            return read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", ("HFOV_FIELD",))[1]
        paths = photos_in(folder, self.parameterAsBoolean(parameters, "RECURSIVE", context), feedback)
        return [with_position(row) for row in read_files(paths, qgis_fields(photo_specs()), feedback)]

    def _write(self, parameters, context, rows):
        wgs84, written = QgsCoordinateReferenceSystem("EPSG:4326"), {}
        kinds = (
            ("OUTPUT", located_specs(), QgsWkbTypes.Type.Point, tr("Best places"), "located"),
            ("CANDIDATES", located_specs(), QgsWkbTypes.Type.Point, tr("Candidate places"), "candidates"),
            ("REGION", region_specs(), QgsWkbTypes.Type.MultiPolygon, tr("Regions of 90 % probability"), "region"),
        )
        for (name, specs, kind, title, style), features in zip(kinds, rows):
            layer = write_features(self, parameters, name, context, qgis_fields(specs), kind, wgs84, features)
            if layer is not None:
                written[name] = layer
                style_on_completion(context, layer, style, title, specs, self.displayName())
        return written


def with_position(row):
    """Row of a file, with the position that the file records."""
    if not row.feature.hasGeometry():
        return row
    point = row.feature.geometry().asPoint()
    return replace(row, longitude_deg=point.x(), latitude_deg=point.y())


class Search:
    """The search of one run: options, area and the index, which photographs share if they share the area."""

    def __init__(self, algorithm, parameters, context, feedback):
        from ..core.locate.places import IndexOptions
        from ..core.searching import LocateOptions

        def number(name):
            return algorithm.parameterAsDouble(parameters, name, context)

        index = IndexOptions(
            spacing_m=number("SPACING"),
            eye_height_m=number("EYE_HEIGHT"),
            max_distance_m=number("MAX_DISTANCE"),
            refraction_coefficient=number("REFRACTION"),
            memory_mb=number("MEMORY"),
        )
        self.options = LocateOptions.of(index, (number("HFOV_MIN"), number("HFOV_MAX")), number("EYE_MAX"))
        self.folder = algorithm.parameterAsString(parameters, "INDEX", context)
        self.use_compass = shared.COMPASS_USES[algorithm.parameterAsEnum(parameters, "COMPASS", context)] == "prior"
        self.area = SearchArea(algorithm, parameters, context)
        self.dem, self.feedback = algorithm.dem.open(), feedback
        self._kept = (None, None, None)

    def locate(self, row, number, count):
        """Locate one photograph; return the answer and the index of its area, or None."""
        name = Path(row.path).name if row.path else tr("A point without a photo")
        announce(self.feedback, name, number, count)
        progress = subtask(FeedbackProgress(self.feedback), 0.95 * number / count, 0.95 * (number + 1) / count)
        located, index = self._search(row, progress)
        if located.status in ("failed", "rejected"):
            warn(self.feedback, name, located.message)
        return located, index

    def _search(self, row, progress):
        from ..core.locate.answer import Located
        from ..core.locate.places import AreaError

        if row.path is None:
            return Located("", "failed", Message("The point names no photo. Fill its path field.")), None
        try:
            area = self.area.around(row.longitude_deg, row.latitude_deg)
            index, log_weight = self._index(area, subtask(progress, 0.0, 0.5))
        except (AreaError, QgsProcessingException) as error:
            if self.area.is_common:
                raise
            message = error.message if isinstance(error, AreaError) else Message("{reason}", reason=str(error))
            return Located(row.path, "failed", message), None
        try:
            located = self._located(row, index, log_weight, subtask(progress, 0.5, 1.0))
        except (TerrainError, OutputError, Cancelled):
            raise
        except Exception:  # a fault of ours, but no reason to lose the other photographs
            self.feedback.pushDebugInfo(traceback.format_exc())
            message = Message("An unexpected error occurred on this photo. Please report it and attach the log.")
            located = Located(row.path, "failed", message)
        return located, index

    def _index(self, area, progress):
        from ..core.locating import index_of_area

        if area != self._kept[0]:
            index = index_of_area(self.dem, area, self.options.index, self.folder, progress)
            self.feedback.pushInfo(tr("{count} places are searched.").format(count=len(index)))
            self._kept = area, index, self.area.log_weight(index)
        return self._kept[1:]

    def _located(self, row, index, log_weight, progress):
        from ..core.batch import PhotoRequest
        from ..core.locating import locate_request

        request = PhotoRequest(row.path, hfov_deg=row.numbers.get("HFOV_FIELD"))
        return locate_request(request, (self.dem, index), self.options, log_weight, self.use_compass, progress)
