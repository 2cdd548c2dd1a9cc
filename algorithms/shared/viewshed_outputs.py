"""Count raster, polygons and per-photo rasters of viewsheds, collected photo by photo and written at the end."""

from __future__ import annotations

from qgis.core import QgsGeometry, QgsProcessingException, QgsWkbTypes

from ...core.base.progress import checkpoint
from .feedback import FeedbackProgress
from .fields import FieldSpec, qgis_fields
from .i18n import tr
from .outputs import make_folder_of, write_features
from .styling import style_on_completion
from .viewshed_extras import extra_fields

COUNT_NODATA = 65535
STRIP_ROWS = 256


class ViewshedOutputs:
    """The outputs made from a run's viewsheds.

    Parameters
    ----------
    dem : core.io.raster.Dem
    smallest_m2 : float
        Smaller parts of polygons are dropped [m2].
    """

    def __init__(self, dem, smallest_m2=0.0):
        from ...core.viewshed.sinks import SeenCount

        self.dem, self.smallest_m2 = dem, smallest_m2
        self.count, self.rows, self._keys = SeenCount(dem.shape), [], []

    def add(self, point, viewshed, extras=None):
        """Add one photo's viewshed and values of `extra_fields`; return its facts in words, for the report."""
        from ...core.io.polygons import viewshed_polygons

        ground = viewshed_polygons(viewshed, self.dem, self.smallest_m2)
        self.count.add(viewshed.window, viewshed.values)
        self.rows.append(polygon_row(point, ground, extras or {}))
        self._keys.append(point.key)
        far = tr("none") if ground.farthest_m is None else f"{ground.farthest_m / 1e3:.1f} km"
        return {tr("Ground in view"): f"{ground.area_m2 / 1e6:.2f} km²", tr("Farthest ground in view"): far}

    def arrange(self, points):
        """Sort the polygons into the order of these points."""
        place = {point.key: index for index, point in enumerate(points)}
        order = sorted(range(len(self.rows)), key=lambda row: place[self._keys[row]])
        self.rows, self._keys = [self.rows[row] for row in order], [self._keys[row] for row in order]

    def write_count(self, algorithm, parameters, name, context, feedback):
        """Write the raster of counts and return its path, or None if it is not requested."""
        from ...core.io.write_raster import RasterLayout, new_raster

        path = algorithm.parameterAsOutputLayer(parameters, name, context)
        if not path:
            return None
        make_folder_of(path)
        facts = {"CONTENT": "number of photographs that see the cell", "PHOTOS": self.count.photos}
        description = [tr("photographs that see the cell")]
        layout = RasterLayout("uint16", nodata=COUNT_NODATA, descriptions=description, metadata=facts)
        with new_raster(path, self.dem, layout=layout) as file:
            for row, values in self._strips(feedback):
                file.write(values, row)
        style_on_completion(context, path, "viewshed", tr("Viewshed"), (), algorithm.displayName())
        return path

    def _strips(self, feedback):
        """Yield (first row, counts) from north to south; cells that no photo sees but one might see are nodata.

        The viewsheds record the DEM's voids in their areas, so the DEM is not read again.
        """
        progress, rows = FeedbackProgress(feedback), self.dem.shape[0]
        for row in range(0, rows, STRIP_ROWS):
            checkpoint(progress, 0.95 + 0.05 * row / rows)
            seen, unknown = self.count.strip(row, min(STRIP_ROWS, rows - row))
            seen[unknown] = COUNT_NODATA
            yield row, seen

    def write_polygons(self, algorithm, parameters, name, context, crs):
        """Write the polygons and return the layer's id, or None if it is not requested."""
        specs = polygon_specs()
        output = write_features(
            algorithm,
            parameters,
            name,
            context,
            qgis_fields(specs),
            QgsWkbTypes.Type.MultiPolygon,
            crs,
            self.rows,
            style="polygons",
        )
        style_on_completion(context, output, "polygons", tr("Ground in view"), specs, algorithm.displayName())
        return output


def polygon_row(point, ground, extras):
    """Geometry and attributes of one photo's ground."""
    geometry = QgsGeometry()
    if ground.wkb is not None:
        geometry.fromWkb(ground.wkb)
        if geometry.isNull():
            raise QgsProcessingException(tr("The polygon of {name} could not be built.").format(name=point.name))
    values = [point.path, point.source_id, point.heading_deg, point.hfov_deg, ground.area_m2, ground.farthest_m]
    return geometry, values + [extras.get(spec.name) for spec in extra_fields()]


def polygon_specs():
    """Fields of the polygons."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("source_id", "whole", tr("Source point")),
        FieldSpec("heading", "real", tr("Heading (° from true north)")),
        FieldSpec("hfov", "real", tr("Horizontal field of view (°)")),
        FieldSpec("area_m2", "real", tr("Ground in view (m²)")),
        FieldSpec("farthest_m", "real", tr("Farthest ground in view (m)")),
        *extra_fields(),
    ]
