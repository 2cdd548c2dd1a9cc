"""A collection of oriented photographs -> how often and how well the ground is seen, and which photos are needed."""

from __future__ import annotations

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputBoolean,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
    QgsWkbTypes,
)

from ..core.base.errors import PhotoError
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.coverage_outputs import area_mask, coverage_specs, coverage_window, table_rows, write_coverage
from .shared.feedback import warn
from .shared.fields import is_null, qgis_fields
from .shared.i18n import tr
from .shared.outputs import write_features
from .shared.styling import style_on_completion
from .shared.views import Opening, add_view_parameters, open_views


class PhotoCoverage(DemAlgorithm):
    """Determine what a collection covers."""

    ID = "photocoverage"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Coverage of a photo collection")

    def tags(self):
        """Search words."""
        return tr("coverage,blind spot,viewshed,cumulative,set cover,monitoring,fewest,photos,gsd").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("How often and how finely each cell is photographed, blind spots, and the fewest photos needed")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Counts the photographs that see each cell of the area (0 is a blind spot) and gives the finest "
                "ground sampling distance among them in metres per pixel, across the line of sight."
            ),
            tr(
                "The table gives how much each photograph shows, and which photographs are needed: as few as "
                "possible that together show everything the collection shows, in the order of how much each "
                "adds (<b>pick</b>). PROVEN is true if it was proven that no smaller selection exists."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        add_view_parameters(self, photo_needed=False)
        area = QgsProcessingParameterFeatureSource(
            "AREA", tr("Area"), [QgsProcessing.SourceType.TypeVectorPolygon], optional=True
        )
        text = tr(
            "Only ground inside the area counts. If this is empty, all ground of the DEM within the maximum "
            "distance of the photos counts."
        )
        self.addParameter(shared.explained(area, text))
        self.addParameter(
            shared.raster_out(
                "OUTPUT",
                tr("Number of photos"),
                text=tr(
                    "Number of photographs that show each cell, on the DEM's grid. 0 is a blind spot; nodata "
                    "is outside the area."
                ),
            )
        )
        self.addParameter(
            shared.raster_out(
                "GSD",
                tr("Best ground sampling distance"),
                optional=True,
                create=False,
                text=tr("Metres per pixel of the best photo, across the view."),
            )
        )
        self.addParameter(
            shared.points_out(
                "TABLE",
                tr("Photos and what they add"),
                QgsProcessing.SourceType.TypeVector,
                optional=True,
                text=tr(
                    "One row per photograph with the ground that it shows and, if it is needed, its place in "
                    "the selection."
                ),
            )
        )
        for name, label in (
            ("COUNT", tr("Number of photos")),
            ("SEEN_SHARE", tr("Share of the area seen by at least one")),
            ("BLIND_CELLS", tr("Number of cells that no photo sees")),
            ("FEWEST", tr("Fewest photos that see all that the collection sees")),
        ):
            self.addOutput(QgsProcessingOutputNumber(name, label))
        self.addOutput(QgsProcessingOutputBoolean("PROVEN", tr("No smaller choice exists")))

    def compute(self, parameters, context, feedback):
        """Compute the viewsheds photo by photo, choose, then write."""
        from ..core.mapping.coverage import Coverage

        terrain = self.dem.open()
        reach = self.parameterAsDouble(parameters, "MAX_DISTANCE", context)
        opening = Opening(reach, (0.0, 0.05), pixels=False)
        photos = list(open_views(self, parameters, context, feedback, terrain, opening))
        if not photos:
            raise QgsProcessingException(tr("None of the points is an oriented photo of a chosen status on this DEM."))
        geometries = self._area(parameters, context)
        window = coverage_window(terrain, photos, reach, geometries)
        coverage = Coverage(window, area_mask(terrain, window, geometries))
        cells = self._see(photos, terrain, coverage, parameters, context, feedback)
        chosen, proven, gains = coverage.fewest_photos()
        output, gsd = write_coverage(self, parameters, context, coverage, terrain, feedback)
        specs, nowhere = coverage_specs(), QgsCoordinateReferenceSystem()
        rows = table_rows(photos, cells, coverage, chosen, gains, terrain)
        results = {"OUTPUT": output, "COUNT": len(photos), "FEWEST": len(chosen), "PROVEN": proven}
        results["BLIND_CELLS"] = int(coverage.blind.sum())
        results["SEEN_SHARE"] = 1 - results["BLIND_CELLS"] / max(int(coverage.area.sum()), 1)
        if gsd:
            results["GSD"] = gsd
        if parameters.get("TABLE") is not None:
            results["TABLE"] = write_features(
                self, parameters, "TABLE", context, qgis_fields(specs), QgsWkbTypes.Type.NoGeometry, nowhere, rows
            )
            style_on_completion(context, results["TABLE"], "coverage", tr("Photos"), specs, self.displayName())
        return results

    def _see(self, photos, terrain, coverage, parameters, context, feedback):
        """Add every photo's viewshed and return the cells that each sees."""
        from ..core.base.progress import subtask
        from ..core.viewshed.viewshed import ViewshedOptions, photo_viewshed
        from .shared.feedback import FeedbackProgress

        options = ViewshedOptions(
            max_distance_m=self.parameterAsDouble(parameters, "MAX_DISTANCE", context),
            refraction_coefficient=self.parameterAsDouble(parameters, "REFRACTION", context),
        )
        progress, cells = FeedbackProgress(feedback), []
        for index, photo in enumerate(photos):
            part = subtask(progress, 0.05 + 0.85 * index / len(photos), 0.05 + 0.85 * (index + 1) / len(photos))
            try:
                seen = photo_viewshed(terrain, photo.view.photo, options, part)
            except PhotoError as error:
                warn(feedback, photo.name, error.message)
                cells.append(0)
                continue
            cells.append(coverage.add(photo.name, terrain, photo.view, seen))
        return cells

    def _area(self, parameters, context):
        """Polygons of the area in the DEM's CRS; None for no area."""
        if is_null(parameters.get("AREA")):
            return None
        from .shared.map_places import to_dem_transform, transformed

        source = self.parameterAsSource(parameters, "AREA", context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, "AREA"))
        transform = to_dem_transform(source.sourceCrs(), self.dem.crs, context)
        found = [transformed(feature.geometry(), transform) for feature in source.getFeatures()]
        found = [geometry for geometry in found if geometry is not None]
        if not found:
            raise QgsProcessingException(
                tr("The area is empty, or lies outside the region for which the DEM's CRS is valid.")
            )
        return found
