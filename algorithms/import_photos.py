"""Folder of photographs -> point layer with the contents of their metadata."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsWkbTypes,
)

from ..core.base.attributes import has_position
from ..core.base.errors import PhotoError
from ..core.base.progress import checkpoint
from .base import SkylineAlgorithm
from .shared import fields
from .shared import parameters as shared
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.i18n import in_users_language, tr
from .shared.outputs import write_features
from .shared.photo_attributes import attributes_of, photos_in, point_of
from .shared.previews import Previews, preview_specs
from .shared.styling import style_on_completion


class ImportPhotos(SkylineAlgorithm):
    """Read position, time, lens and compass of each photograph in a folder."""

    ID = "importphotos"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Import mountain photos")

    def tags(self):
        """Search words."""
        return tr("photo,exif,heic,jpeg,geotag,gps,import,focal length,compass").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Point layer of the photographs in a folder, with field of view and compass reference")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Makes one point per photograph with a position. It writes the same fields as QGIS's "
                "<i>Import geotagged photos</i> and adds what orientation needs: 35 mm equivalent, "
                "field of view, size of the upright picture, reference of the compass (true or "
                "magnetic), GPS error, camera."
            ),
            tr(
                "Values that a file does not contain are NULL. The optional table of rejected photographs "
                "lists photographs without a usable position and files that cannot be read, with the reason."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        self.addParameter(
            shared.folder_in(
                "FOLDER",
                tr("Folder of photographs"),
                tr("JPEG and HEIC files, and PNG, TIFF and WebP files that record a position."),
            )
        )
        self.addParameter(
            shared.explained(
                QgsProcessingParameterBoolean("RECURSIVE", tr("Include subfolders"), False),
                tr("Also searches all subfolders."),
            )
        )
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Photos"),
                text=tr("One point per photograph at the recorded position, with the recorded altitude as Z."),
            )
        )
        self.addParameter(
            shared.points_out(
                "REJECTED",
                tr("Rejected photos"),
                QgsProcessing.SourceType.TypeVector,
                optional=True,
                create=False,
                text=tr("Table of the files that produced no point, with the reason."),
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("REJECTED_COUNT", tr("Number of rejected photos")))

    def compute(self, parameters, context, feedback):
        """Read each file, then write both layers."""
        folder = self.parameterAsFile(parameters, "FOLDER", context)
        paths = photos_in(folder, self.parameterAsBoolean(parameters, "RECURSIVE", context), feedback)
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        specs = fields.photo_specs()
        with Previews(parameters, context) as previews:
            taken, rejected = read_all(paths, feedback, previews)
            count, kind = len(taken), (QgsWkbTypes.Type.PointZ, wgs84)
            columns, taken = previews.column(fields.qgis_fields(specs), taken)
            output = write_features(self, parameters, "OUTPUT", context, columns, *kind, taken, style="photos")
        refused = write_features(
            self,
            parameters,
            "REJECTED",
            context,
            fields.qgis_fields(fields.rejected_specs()),
            QgsWkbTypes.Type.NoGeometry,
            QgsCoordinateReferenceSystem(),
            rejected,
        )
        style_on_completion(context, output, "photos", tr("Photos"), specs + preview_specs(), self.displayName())
        results = {"OUTPUT": output, "COUNT": count, "REJECTED_COUNT": len(rejected)}
        if refused is not None:
            results["REJECTED"] = refused
        return results


def read_all(paths, feedback, previews):
    """Read the metadata of all paths: rows of photographs with a position, and rows of rejected ones.

    `previews` takes the photographs with a position.
    """
    from ..core.io.photo import read_metadata

    progress = FeedbackProgress(feedback)
    taken, rejected = [], []
    for index, path in enumerate(map(Path, paths)):
        checkpoint(progress, index / len(paths))
        announce(feedback, path.name, index, len(paths))
        try:
            metadata = read_metadata(path)
            reason = None if has_position(metadata) else tr("The photo has no GPS position.")
        except PhotoError as error:
            reason = in_users_language(error.message)
        if reason is None:
            for note in metadata.notes:
                warn(feedback, path.name, note)
            taken.append((point_of(metadata), attributes_of(metadata)))
            previews.add(path)
        else:
            feedback.reportError(f"{path.name}: {reason}", False)
            rejected.append((None, [str(path), path.stem, str(path.parent), reason]))
    checkpoint(progress, 0.95)
    return taken, rejected
