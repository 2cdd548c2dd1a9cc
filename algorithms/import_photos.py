"""Folder of photographs -> point layer with what the files say."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPoint,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsWkbTypes,
)
from qgis.PyQt.QtCore import QDateTime

from ..core.camera import Camera, focal_from_35mm_px
from ..core.errors import PhotoError
from ..core.progress import checkpoint
from . import fields
from . import parameters as shared
from .base import SkylineAlgorithm
from .feedback import FeedbackProgress, announce
from .i18n import tr
from .outputs import write_features
from .styling import style_on_completion

ROTATION_OF_ORIENTATION = {1: 0, 2: 0, 3: 180, 4: 180, 5: 90, 6: 90, 7: 270, 8: 270}


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
        """One line."""
        return tr("Point layer of the photographs in a folder, with field of view and compass reference")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Makes one point per JPEG or HEIC photograph with a position. It writes the same fields as QGIS's "
                "<i>Import geotagged photos</i> and adds what orientation needs: 35 mm equivalent, field of view, "
                "size of the upright picture, reference of the compass (true or magnetic), GPS error, camera."
            ),
            tr(
                "What a file does not say stays NULL. Photographs without a usable position, and files that "
                "cannot be read, go to the optional table of rejected photographs with the reason."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        self.addParameter(
            shared.folder_in("FOLDER", tr("Folder of photographs"), tr("JPEG and HEIC files are read by content."))
        )
        self.addParameter(
            shared.explained(
                QgsProcessingParameterBoolean("RECURSIVE", tr("Folders inside it too"), False),
                tr("Look into all folders below as well."),
            )
        )
        self.addParameter(shared.points_out("OUTPUT", tr("Photos")))
        self.addParameter(
            shared.points_out(
                "REJECTED", tr("Rejected photos"), QgsProcessing.SourceType.TypeVector, optional=True, create=False
            )
        )
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("REJECTED_COUNT", tr("Number of rejected photos")))

    def run(self, parameters, context, feedback):
        """Read each file, then write both layers."""
        folder = self.parameterAsFile(parameters, "FOLDER", context)
        paths = photos_in(folder, self.parameterAsBoolean(parameters, "RECURSIVE", context))
        taken, rejected = read_all(paths, feedback)
        wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
        specs = fields.photo_specs()
        output = write_features(
            self, parameters, "OUTPUT", context, fields.qgis_fields(specs), QgsWkbTypes.Type.PointZ, wgs84, taken
        )
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
        style_on_completion(context, output, "photos", tr("Photos"), specs, self.displayName())
        results = {"OUTPUT": output, "COUNT": len(taken), "REJECTED_COUNT": len(rejected)}
        if refused is not None:
            results["REJECTED"] = refused
        return results


def photos_in(folder, recursive):
    """Paths of the photographs in a folder, or a clear refusal."""
    from ..core.io.photo import list_photos

    if not Path(folder).is_dir():
        raise QgsProcessingException(tr("The folder {folder} does not exist.").format(folder=folder))
    paths = list(list_photos(folder, recursive))
    if not paths:
        raise QgsProcessingException(
            tr(
                "No photograph (JPEG, HEIC) lies in {folder}. Choose another folder, or include the folders inside it."
            ).format(folder=folder)
        )
    return paths


def read_all(paths, feedback):
    """Read the metadata of all paths: rows of photographs with a position, and rows of rejected ones."""
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
            reason = str(error)
        if reason is None:
            taken.append((point_of(metadata), attributes_of(metadata)))
        else:
            feedback.reportError(f"{path.name}: {reason}", False)
            rejected.append((None, [str(path), path.stem, str(path.parent), reason]))
    return taken, rejected


def has_position(metadata):
    """Tell whether the file gives a position; 0/0 is what cameras write that have none."""
    if metadata.latitude_deg is None or metadata.longitude_deg is None:
        return False
    return not (metadata.latitude_deg == 0 and metadata.longitude_deg == 0)


def point_of(metadata):
    """Point in WGS 84; as in QGIS's own import, Z is 0 where the altitude is unknown."""
    return QgsGeometry(QgsPoint(metadata.longitude_deg, metadata.latitude_deg, metadata.altitude_m or 0.0))


def attributes_of(metadata):
    """Attributes in the order of `fields.photo_specs`."""
    path = Path(metadata.path)
    hfov_deg = vfov_deg = None
    if metadata.focal_length_35mm:
        size = metadata.width_px, metadata.height_px
        camera = Camera(*size, focal_from_35mm_px(*size, metadata.focal_length_35mm))
        hfov_deg, vfov_deg = camera.hfov_deg, camera.vfov_deg
    return [
        str(path),
        path.stem,
        str(path.parent),
        metadata.altitude_m,
        metadata.compass_heading_deg,
        ROTATION_OF_ORIENTATION.get(metadata.orientation),
        repr(metadata.longitude_deg),
        repr(metadata.latitude_deg),
        QDateTime(metadata.taken_at) if metadata.taken_at else None,
        metadata.focal_length_35mm,
        hfov_deg,
        vfov_deg,
        metadata.width_px,
        metadata.height_px,
        metadata.compass_reference,
        metadata.position_error_m,
        metadata.camera,
    ]
