"""Oriented photographs -> a georeferenced colour raster: the picture draped over the terrain."""

from __future__ import annotations

from qgis.core import QgsProcessingOutputNumber

from ..core.base.errors import PhotoError, SkylineNotFoundError
from ..core.base.messages import Message
from ..core.base.progress import subtask
from .base import DemAlgorithm
from .shared import parameters as shared
from .shared.draped_raster import write_draped
from .shared.feedback import warn
from .shared.i18n import tr
from .shared.styling import style_on_completion
from .shared.views import Opening, add_view_parameters, open_views

MOST_SKY = 0.5
"""A larger share of the visible cells at pixels that show sky points to a wrong pose."""


class DrapePhoto(DemAlgorithm):
    """Drape photographs over the elevation model."""

    ID = "drapephoto"
    GROUP_ID = "maps"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Drape photos over the terrain")

    def tags(self):
        """Search words."""
        return tr("orthophoto,drape,rectify,texture,mosaic,photo,rgba,ground sampling distance").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Colour raster on the DEM's grid: each cell as the photo shows it, transparent where hidden")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Each cell that a photograph shows gets the colour of the pixels that show it; all other "
                "cells are transparent. If several photographs show a cell, their colours are blended: the "
                "photograph with the finest resolution there has the greatest weight, and each photograph "
                "fades out towards its edges."
            ),
            tr("Sky is not draped: a cell whose pixel lies above the skyline of the picture stays transparent."),
            tr(
                "The second raster gives the ground sampling distance of the best photo in metres per pixel: "
                "band 1 across the line of sight, band 2 along it on the slope, which is long if the line "
                "of sight grazes the ground. Trees and people in the picture are draped too, because the DEM "
                "does not contain them."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        add_view_parameters(self)
        refine = shared.number(
            "REFINE",
            tr("Cells per side of a DEM cell"),
            1,
            tr("1: the DEM's own grid. 4: sixteen times as many cells, for a photo finer than the DEM."),
            1,
            32,
            integer=True,
        )
        self.addParameter(refine)
        nearest = shared.distance(
            "MIN_DISTANCE", tr("Minimum distance (m)"), 0.0, tr("Ground nearer than this is left out.")
        )
        self.addParameter(shared.advanced(nearest))
        self.addParameter(
            shared.raster_out(
                "OUTPUT",
                tr("Draped photos"),
                text=tr("GeoTIFF of red, green, blue and opacity; transparent where no photo sees the cell."),
            )
        )
        self.addParameter(
            shared.raster_out(
                "GSD",
                tr("Ground sampling distance"),
                optional=True,
                create=False,
                text=tr("Metres per pixel of the best photo: band 1 across the view, band 2 along it."),
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos draped")))
        self.addOutput(QgsProcessingOutputNumber("CELLS", tr("Number of cells with colour")))

    def compute(self, parameters, context, feedback):
        """Drape photo by photo, then write."""
        from ..core.base.terrain import Window
        from ..core.mapping.drape import Mosaic
        from ..core.viewshed.viewshed import ViewshedOptions

        terrain = self.dem.open()
        options = ViewshedOptions(
            min_distance_m=self.parameterAsDouble(parameters, "MIN_DISTANCE", context),
            max_distance_m=self.parameterAsDouble(parameters, "MAX_DISTANCE", context),
            refraction_coefficient=self.parameterAsDouble(parameters, "REFRACTION", context),
        )
        mosaic = Mosaic(Window(0, 0, *terrain.shape), self.parameterAsInt(parameters, "REFINE", context))
        count, reach = 0, options.max_distance_m
        for photo in open_views(self, parameters, context, feedback, terrain, Opening(reach, (0.0, 0.85))):
            try:
                count += drape(mosaic, photo, options, feedback) > 0
            except PhotoError as error:
                warn(feedback, photo.name, error.message)
        results = {"COUNT": count}
        path = self.parameterAsOutputLayer(parameters, "OUTPUT", context)
        gsd_path = self.parameterAsOutputLayer(parameters, "GSD", context) if parameters.get("GSD") else None
        results["CELLS"] = write_draped(path, gsd_path, mosaic, terrain, feedback)
        style_on_completion(context, path, "draped", tr("Draped photos"), (), self.displayName())
        results["OUTPUT"] = path
        if gsd_path:
            style_on_completion(context, gsd_path, "gsd", tr("Ground sampling distance"), (), self.displayName())
            results["GSD"] = gsd_path
        return results


def drape(mosaic, photo, options, feedback):
    """Add one photo and return its number of cells.

    Parameters
    ----------
    mosaic : Mosaic
    photo : OpenedPhoto
    options : ViewshedOptions
    feedback : QgsProcessingFeedback
    """
    from ..core.io.photo import read_photo
    from ..core.mapping.drape import drape_photo
    from ..core.mapping.picture import build_picture_pyramid
    from ..core.viewshed.viewshed import photo_viewshed

    if not photo.path:
        raise PhotoError(Message("The point names no photo."))
    pixels = read_photo(photo.path).pixels
    picture = build_picture_pyramid(pixels, sky=sky_in(pixels))
    seen = photo_viewshed(photo.terrain, photo.view.photo, options, subtask(photo.progress, 0.1, 0.6))
    cells = drape_photo(mosaic, photo.terrain, photo.view, picture, seen, subtask(photo.progress, 0.6, 1.0))
    visible = int(seen.visible.sum()) * mosaic.refine**2
    if visible and picture.sky is not None and 1 - cells / visible > MOST_SKY:
        text = tr(
            "{share} % of the ground in view lies where the picture shows sky, and was not draped. Check the heading, "
            "the pitch and the elevation of the camera."
        )
        warn(feedback, photo.name, text.format(share=f"{100 * (1 - cells / visible):.0f}"))
    return cells


def sky_in(pixels):
    """Pixels of a reduced copy of the picture that show sky; None if no skyline is found."""
    from ..core.mapping.picture import sky_of
    from ..core.skyline.evidence import skyline_evidence

    try:
        return sky_of(skyline_evidence(pixels))
    except SkylineNotFoundError:
        return None
