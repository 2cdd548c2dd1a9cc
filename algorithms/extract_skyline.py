"""Photographs -> their skyline as a table of pixels, and drawn over the picture."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessing, QgsProcessingOutputNumber, QgsWkbTypes

from ..core.base.errors import MissingPackageError, PhotoError
from ..core.base.progress import checkpoint, subtask
from .base import SkylineAlgorithm
from .shared import parameters as shared
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import FieldSpec, qgis_fields
from .shared.i18n import marked, tr
from .shared.layers import read_points
from .shared.outputs import write_features, write_whole
from .shared.styling import style_on_completion
from .shared.workers import add_workers_parameter, team_for

PREVIEW_PX = 1600


class ExtractSkyline(SkylineAlgorithm):
    """Find the boundary between sky and terrain in each photograph."""

    ID = "extractskyline"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Extract skyline")

    def tags(self):
        """Search words."""
        return tr("photo,skyline,horizon,sky,segmentation,ridge,overlay").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Boundary between sky and terrain in photographs, with a confidence per column")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Writes one row per picture column. <b>column</b> and <b>row</b> are pixels of the full "
                "upright picture (the first pixel is 0; row is the first terrain pixel). <b>confidence</b> "
                "ranges from 0 (no plausible boundary, interpolated) to 1."
            ),
            tr(
                "If the automatic skyline is wrong, correct the table by hand and use it in <i>Orient "
                "photos</i> as <i>Drawn skylines</i>. The overlays are PNG pictures for checking the "
                "skyline."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        photos = shared.photo_source()
        photos.setDataTypes([QgsProcessing.SourceType.TypeVector])
        self.addParameter(photos)
        self.addParameter(shared.photo_field())
        text = tr(
            "Robust: finds the most likely line as a whole, even with haze, clouds and noise. Paper: uses "
            "the published filters, column by column."
        )
        self.addParameter(shared.method(text=text))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Skylines"),
                QgsProcessing.SourceType.TypeVector,
                text=tr(
                    "One row per picture column: photo, column and row (px of the upright picture), confidence (0 to "
                    "1)."
                ),
            )
        )
        self.addParameter(
            shared.folder_out("OVERLAYS", tr("Folder of overlays"), tr("One PNG per photograph with its skyline."))
        )
        add_workers_parameter(self)
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of skylines")))

    def compute(self, parameters, context, feedback):
        """Extract photo by photo, then write."""
        _, rows = read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", needs_position=False)
        method = shared.METHODS[self.parameterAsEnum(parameters, "METHOD", context)]
        folder = self.parameterAsString(parameters, "OVERLAYS", context)
        workers = self.parameterAsInt(parameters, "WORKERS", context)
        table, count = [], 0
        for row, found in extract_each(rows, method, workers, feedback):
            table += [(None, [row.path, *pixel]) for pixel in pixels_of(found)]
            count += 1
            if folder:
                write_overlay(found, folder)
        specs = skyline_specs()
        output = write_features(
            self,
            parameters,
            "OUTPUT",
            context,
            qgis_fields(specs),
            QgsWkbTypes.Type.NoGeometry,
            QgsCoordinateReferenceSystem(),
            table,
        )
        style_on_completion(context, output, "skylines", tr("Skylines"), specs, self.displayName())
        results = {"OUTPUT": output, "COUNT": count}
        return {**results, "OVERLAYS": folder} if folder else results


def extract_each(rows, method, workers, feedback):
    """Yield (row, skyline) for each photo that has one, in order; warn about the others."""
    from ..core.many import SkylineJob

    progress = subtask(FeedbackProgress(feedback), 0.0, 0.95)
    with team_for(SkylineJob(method, PREVIEW_PX), workers, len(rows), feedback) as team:
        team.begin([row.path for row in rows], progress)
        for index, row in enumerate(rows):
            checkpoint(progress, index / len(rows))
            announce(feedback, row.name, index, len(rows))
            try:
                found = team.take(progress).result()
            except (PhotoError, MissingPackageError) as error:
                warn(feedback, row.name, error.message)
                continue
            yield row, found
    checkpoint(progress, 1.0)


def pixels_of(found):
    """[column, row, confidence] per column, in pixels of the full upright picture."""
    from ..core.base.overlay_lines import skyline_line

    skyline = found.skyline
    line = skyline_line(skyline, found.metadata.width_px, found.metadata.height_px)
    return [list(map(float, pixel)) for pixel in zip(line.x_px, line.y_px, skyline.confidence)]


def write_overlay(found, folder):
    """Draw the skyline over the picture: a PNG named after the photo."""
    from ..core.figures.overlay import overlay_image
    from ..core.figures.raster import encode_png

    target = Path(folder) / f"{Path(found.path).stem}.png"
    write_whole(target, encode_png(overlay_image(found, PREVIEW_PX, say=marked)))


def skyline_specs():
    """Fields of the table."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("column", "real", tr("Column (px, from the left)")),
        FieldSpec("row", "real", tr("Row (px, from the top)")),
        FieldSpec("confidence", "real", tr("Confidence (0 to 1)")),
    ]
