"""Places and oriented photographs -> which photos show which place, and how well."""

from __future__ import annotations

from functools import partial

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
from .shared.fields import FieldSpec, is_null, metres_of, qgis_fields
from .shared.i18n import tr
from .shared.map_places import (
    crs_of,
    kind_of,
    local_of_map,
    number,
    of_one_kind,
    places_of,
    straight,
    to_dem_transform,
    transformed,
)
from .shared.outputs import write_features
from .shared.styling import style_on_completion
from .shared.summit_input import PublishedHeights, point_heights, snap_distance
from .shared.views import Opening, add_view_parameters, open_views, sight_options

NET_CELLS = 1.0
"""Areas are sampled on a grid of this many DEM cells."""


class WhichPhotos(DemAlgorithm):
    """Find the photographs that show given places."""

    ID = "whichphotos"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Which photos show these places?")

    def tags(self):
        """Search words."""
        return tr("search,photo,archive,place,visible,inverse,query,resolution,ranking").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Table of places and the photos that show them: share, pixels per metre, angle, pixel, rank")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Finds the photographs that show each point, line or area of the places layer. One row per "
                "place and photo gives the pixels per metre, the angle of incidence and the position in the "
                "picture. The best photo of each place comes first (<b>rank</b> 1)."
            ),
            tr(
                "A point with a height is a summit if the ground at its place is lower. It is then moved to the nearby "
                "top in the DEM, as in <i>Label peaks in photos</i>: published positions and coarse DEMs differ by "
                "hundreds of metres."
            ),
            tr(
                "<b>quality</b> = visible share x pixels per metre x cosine of the angle of incidence: the "
                "pixels per metre of ground in the worse direction. <b>place_id</b> and <b>photo_id</b> are "
                "the features' ids, which you can use for relations to both layers."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        places = QgsProcessingParameterFeatureSource(
            "PLACES", tr("Places"), [QgsProcessing.SourceType.TypeVectorAnyGeometry]
        )
        self.addParameter(shared.explained(places, tr("Points, lines or areas, in any coordinate system.")))
        name = QgsProcessingParameterField("NAME_FIELD", tr("Field with names"), None, "PLACES", optional=True)
        self.addParameter(shared.explained(name, tr("Copied to the table.")))
        text = tr(
            "Points with a height that their ground does not reach are summits. NULL: the point lies on the ground."
        )
        self.addParameter(shared.advanced(point_heights("PLACES", text)))
        add_view_parameters(self)
        self.addParameter(shared.advanced(snap_distance()))
        above = shared.distance(
            "HEIGHT_ABOVE",
            tr("Height above ground (m)"),
            0.0,
            tr("Height of the target above the ground, for example of a tower or a tree top."),
        )
        self.addParameter(shared.advanced(above))
        least = shared.number(
            "MIN_SHARE",
            tr("Minimum visible share (%)"),
            0.0,
            tr("Photos that show less of a place are left out."),
            0,
            100,
        )
        self.addParameter(shared.advanced(least))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Photos of places"),
                QgsProcessing.SourceType.TypeVector,
                text=tr("One row per place and photo that shows it, the best photo of each place first."),
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of rows")))
        self.addOutput(QgsProcessingOutputNumber("UNSEEN", tr("Number of places that no photo shows")))

    def compute(self, parameters, context, feedback):
        """Process photo by photo, rank, then write."""
        from ..core.mapping.sightings import find_sightings

        terrain, options = self.dem.open(), sight_options(self, parameters, context)
        places = self._places(parameters, context)
        above_m = self.parameterAsDouble(parameters, "HEIGHT_ABOVE", context)
        least = self.parameterAsDouble(parameters, "MIN_SHARE", context) / 100
        snap_m, heights = self.parameterAsDouble(parameters, "SNAP", context), PublishedHeights(feedback)
        found, reach = {}, options.max_distance_m
        for photo in open_views(self, parameters, context, feedback, terrain, Opening(reach, (0.0, 0.95))):
            samples = [samples_of(terrain, photo.view.frame, place, heights, snap_m) for place in places]
            sightings = find_sightings(terrain, photo.view, samples, options, above_m, photo.progress)
            for sighting in sightings:
                if sighting.visible_share >= least:
                    found.setdefault(sighting.place, []).append((photo, sighting))
        rows = [row for place, shown in sorted(found.items()) for row in ranked(places[place], shown)]
        specs, nowhere = which_specs(), QgsCoordinateReferenceSystem()
        output = write_features(
            self,
            parameters,
            "OUTPUT",
            context,
            qgis_fields(specs),
            QgsWkbTypes.Type.NoGeometry,
            nowhere,
            rows,
            style="which_photos",
        )
        style_on_completion(context, output, "which_photos", tr("Photos of places"), specs, self.displayName())
        return {"OUTPUT": output, "COUNT": len(rows), "UNSEEN": len(places) - len(found)}

    def _places(self, parameters, context):
        """(id, name, geometry in the DEM's CRS, published height or None) of each place."""
        source = self.parameterAsSource(parameters, "PLACES", context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, "PLACES"))
        transform = to_dem_transform(crs_of(self, parameters, "PLACES", context), self.dem.crs, context)
        field = self.parameterAsString(parameters, "NAME_FIELD", context)
        heights = self.parameterAsString(parameters, "ELEVATION_FIELD", context)
        heights = heights if source.fields().lookupField(heights) >= 0 else None
        places = []
        for feature in source.getFeatures():
            geometry = transformed(feature.geometry(), transform)
            if geometry is not None:
                name = feature[field] if field else None
                height = metres_of(feature[heights]) if heights else None
                places.append((feature.id(), None if is_null(name) else str(name), geometry, height))
        if not places:
            raise QgsProcessingException(
                tr("The places layer is empty, or lies outside the region for which the DEM's CRS is valid.")
            )
        return places


def samples_of(terrain, frame, place, heights, snap_m=0.0):
    """Local sample places of a place: its points, its line in steps of a cell, a grid over its area.

    Parameters
    ----------
    terrain : core.io.raster.Dem
    frame : LocalFrame
    place : tuple
        Id, name, geometry in the DEM's CRS, and the published height of a point or None [m].
    heights : PublishedHeights
    snap_m : float
        Search radius around a summit [m].

    Returns
    -------
    Places or (east_m, north_m)
    """
    import numpy as np

    from ..core.mapping.projecting import sample_area
    from ..core.mapping.sightings import place_of_height

    identifier, name, geometry, height_m = place
    shapes = of_one_kind(geometry)
    if len(shapes) > 1:
        samples = [samples_of(terrain, frame, (identifier, name, shape, None), heights) for shape in shapes]
        return tuple(np.concatenate(axis) for axis in zip(*samples))
    geometry = straight(shapes[0])
    kind = kind_of(geometry)
    if kind == "line":
        pixel = abs(terrain.geotransform[1])
        geometry = geometry.densifyByDistance(NET_CELLS * pixel)
    parts = [local_of_map(terrain, frame, x, y) for x, y, _ in places_of(geometry, kind)]
    if kind == "polygon":
        east, north = sample_area(parts, NET_CELLS * frame.cell_m)
        if east.size:
            return east, north
    east, north = (np.concatenate(axis) for axis in zip(*parts))
    if kind == "point" and height_m is not None and east.size == 1:
        doubted = partial(heights.doubted, name or str(identifier))
        return place_of_height(terrain, frame, (float(east[0]), float(north[0])), height_m, snap_m, doubted)
    return east, north


def ranked(place, shown):
    """Rows of one place, best photo first."""
    identifier, name = place[:2]
    shown = sorted(shown, key=lambda item: -item[1].quality)
    rows = []
    for rank, (photo, seen) in enumerate(shown, start=1):
        values = [identifier, name, photo.feature.id(), photo.path or photo.name, rank, seen.visible_share]
        values += [seen.framed_share, seen.x_px, seen.y_px, seen.distance_m, seen.azimuth_deg, seen.elevation_deg]
        values += [seen.pixels_per_metre, seen.incidence_deg, seen.quality]
        rows.append((None, [v if isinstance(v, (int, str, type(None))) else number(v) for v in values]))
    return rows


def which_specs():
    """Fields of the table."""
    return [
        FieldSpec("place_id", "whole", tr("Place")),
        FieldSpec("place", "text", tr("Name of the place")),
        FieldSpec("photo_id", "whole", tr("Photo point")),
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("rank", "whole", tr("Rank among the photos of the place")),
        FieldSpec("vis_share", "real", tr("Visible share of the place")),
        FieldSpec("in_frame", "real", tr("Share of the place within the frame")),
        FieldSpec("x_px", "real", tr("Column of its middle (px)")),
        FieldSpec("y_px", "real", tr("Row of its middle (px)")),
        FieldSpec("dist_m", "real", tr("Distance (m)")),
        FieldSpec("azimuth", "real", tr("Azimuth from the camera (° from true north)")),
        FieldSpec("elev_deg", "real", tr("Elevation angle from the camera (°)")),
        FieldSpec("px_per_m", "real", tr("Pixels per metre")),
        FieldSpec("incidence", "real", tr("Angle of incidence (°, 0 head-on)")),
        FieldSpec("quality", "real", tr("Quality: pixels per metre of ground in the worse direction")),
    ]
