"""Oriented points -> XMP sidecars, KML or KMZ with the pictures in place, and a CSV table."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from urllib.parse import quote

import numpy as np
from qgis.core import (
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFileDestination,
)

from ..core.base.errors import MissingPackageError, PhotoError
from ..core.base.messages import Message
from ..core.base.progress import checkpoint
from ..core.base.status import RELIABLE, known_status
from ..core.io.whole_file import unused_name
from .base import SkylineAlgorithm
from .shared import parameters as shared
from .shared.feedback import FeedbackProgress, announce, warn
from .shared.fields import is_null
from .shared.i18n import tr
from .shared.layers import points_fault, read_points
from .shared.outputs import write_together
from .shared.photo_points import value_of

PICTURE_PX = 1200
FIELDS = {
    "elevation_m": "eye_z",
    "pitch_deg": "pitch",
    "roll_deg": "roll",
    "hfov_deg": "hfov",
    "vfov_deg": "vfov",
    "heading_lo_deg": "heading_lo",
    "heading_hi_deg": "heading_hi",
    "p_correct": "p_correct",
}
"""Attributes of `PhotoHeading`, and the fields that hold them."""


class ExportHeadings(SkylineAlgorithm):
    """Take headings to the programs that show photographs; the photographs stay untouched."""

    ID = "exportheadings"
    GROUP_ID = "photographs"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Export headings")

    def tags(self):
        """Search words."""
        return tr("photo,heading,export,xmp,sidecar,kml,kmz,photooverlay,csv,google earth,lightroom,digikam").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Headings as XMP sidecars, KML or KMZ with the pictures, and a CSV table")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Writes the headings of oriented photographs for other programs. The photographs themselves are never "
                "changed."
            ),
            tr(
                "<b>Sidecars</b> are named IMG_1.jpg.xmp, as digiKam, darktable and ExifTool read them, with "
                "GPSImgDirection against true north. The folders below the photographs' common folder are kept, so "
                "choose that common folder to have each sidecar beside its photograph. Sidecars of other programs "
                "are left alone. <b>KMZ</b> contains reduced pictures; <b>KML</b> points to the originals. Google "
                "Earth shows each picture in its place."
            ),
            tr(
                "Only photographs with the status <i>accepted</i> or <i>confirmed</i>, or without a status, are "
                "exported, unless you request the doubtful ones too."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        self.addParameter(shared.photo_source())
        self.addParameter(shared.photo_field())
        heading = shared.number_field(
            "HEADING_FIELD", tr("Field with the heading (°)"), tr("Clockwise from true north."), "heading"
        )
        self.addParameter(shared.advanced(heading))
        doubtful = QgsProcessingParameterBoolean("DOUBTFUL", tr("Doubtful photos too"), False, True)
        self.addParameter(shared.explained(doubtful, tr("Exports photos whose heading is not reliable as well.")))
        text = tr("One XMP file per photo. Choose the photos' common folder to have each beside its photo.")
        self.addParameter(shared.folder_out("SIDECARS", tr("Folder for XMP sidecars"), text))
        self._add_file(
            "KML",
            tr("KML or KMZ"),
            tr("KMZ files (*.kmz);;KML files (*.kml)"),
            tr("For Google Earth; a KMZ file contains the pictures."),
        )
        self._add_file("TABLE", tr("Table"), tr("CSV files (*.csv)"), tr("One line per photo, for spreadsheets."))
        self.addOutput(QgsProcessingOutputNumber("COUNT", tr("Number of photos")))
        self.addOutput(QgsProcessingOutputNumber("LEFT_OUT", tr("Number of photos left out")))

    def _add_file(self, name, label, kinds, text):
        parameter = QgsProcessingParameterFileDestination(name, label, kinds, optional=True, createByDefault=False)
        self.addParameter(shared.explained(parameter, text))

    def input_fault(self, parameters, context):
        """Check the layer, and that something is to be written."""
        fault = points_fault(self, parameters, context, "INPUT", "PHOTO_FIELD", ("HEADING_FIELD",))
        if fault:
            return fault
        if all(is_null(parameters.get(name)) for name in ("SIDECARS", "KML", "TABLE")):
            return tr("Choose at least one output: the folder for sidecars, the KML file or the table.")
        return None

    def compute(self, parameters, context, feedback):
        """Collect the headings, make all texts, then write."""
        _, rows = read_points(self, parameters, context, "INPUT", "PHOTO_FIELD", ("HEADING_FIELD",))
        doubtful = self.parameterAsBoolean(parameters, "DOUBTFUL", context)
        shots = self._shots(rows, doubtful, feedback)
        if not shots:
            raise QgsProcessingException(
                tr("No photo of the layer has a heading that can be exported. Orient the photos first.")
            )
        table = self.parameterAsFileOutput(parameters, "TABLE", context)
        kml = self.parameterAsFileOutput(parameters, "KML", context)
        folder = self.parameterAsString(parameters, "SIDECARS", context)
        contents: dict = {}
        if table:
            from ..core.io.heading_files import csv_text

            contents[table] = csv_text(shots)
        if kml:
            contents[kml] = self._earth(shots, Path(kml), feedback)
        if folder:
            contents.update(self._sidecars(shots, Path(folder), feedback))
        write_together(contents)
        feedback.pushInfo(tr("{count} headings exported.").format(count=len(shots)))
        written = {"TABLE": table, "KML": kml, "SIDECARS": folder}
        counts = {"COUNT": len(shots), "LEFT_OUT": len(rows) - len(shots)}
        return {**counts, **{name: path for name, path in written.items() if path}}

    def _shots(self, rows, doubtful, feedback):
        """Headings of the photographs to export; the log names those that are left out, with the reason."""
        from ..core.io.heading_files import PhotoHeading

        shots = []
        for row in rows:
            heading, status = row.numbers["HEADING_FIELD"], _text_of(row.feature, "status")
            if row.path is None:
                warn(feedback, row.name, Message("The point names no photo. Fill its path field."))
            elif heading is None:
                warn(feedback, row.name, tr("left out, because it has no heading."))
            elif known_status(status) not in (None, *RELIABLE) and not doubtful:
                warn(feedback, row.name, tr("left out, because its status is {status}.").format(status=status))
            else:
                known = {name: value_of(row.feature, field) for name, field in FIELDS.items()}
                place = {"longitude": row.longitude_deg, "latitude": row.latitude_deg}
                shots.append(PhotoHeading(row.path, heading, status=status, **place, **known))
        return shots

    def _earth(self, shots, path, feedback):
        """Text of the KML file, or bytes of the KMZ file with its pictures; photos without a position are left out."""
        from ..core.io.heading_files import kml_text, kmz_bytes

        for shot in shots:
            if shot.longitude is None:
                text = tr("left out of the KML file, because its point has no position.")
                warn(feedback, Path(shot.photo).name, text)
        shots = [shot for shot in shots if shot.longitude is not None]
        if path.suffix.lower() != ".kmz":
            return kml_text(shots, [_address(shot.photo, path.absolute().parent) for shot in shots], path.stem)
        taken: set = set()
        progress, pictures = FeedbackProgress(feedback), []
        for index, shot in enumerate(shots):
            checkpoint(progress, index / len(shots))
            name = f"files/{unused_name(Path(shot.photo).stem, taken)}.jpg"
            announce(feedback, Path(shot.photo).name, index, len(shots))
            try:
                pictures.append((name, _reduced(shot.photo)))
            except (PhotoError, MissingPackageError) as error:
                pictures.append((name, b""))
                warn(feedback, Path(shot.photo).name, error.message)
        kml = kml_text(shots, [quote(name) for name, _ in pictures], path.stem)
        return kmz_bytes(kml, [picture for picture in pictures if picture[1]])

    def _sidecars(self, shots, folder, feedback):
        """Text of each sidecar by its path, without those that other programs wrote."""
        from ..core.io.heading_files import is_ours, xmp_text

        common, texts = _common_folder([shot.photo for shot in shots]), {}
        for shot in shots:
            place = Path(os.path.relpath(Path(shot.photo).absolute().parent, common)) if common else Path()
            target = folder / place / f"{Path(shot.photo).name}.xmp"
            if is_ours(target):
                texts[target] = xmp_text(shot)
            else:
                text = tr("left as it is, because another program wrote {path}.").format(path=target)
                warn(feedback, Path(shot.photo).name, text)
        return texts


def _common_folder(paths):
    """Deepest folder that holds all photographs; None if they lie on several drives."""
    with suppress(ValueError):
        return os.path.commonpath([str(Path(path).absolute().parent) for path in paths])
    return None


def _text_of(feature, name):
    index = feature.fields().lookupField(name)
    return None if index < 0 or is_null(feature[index]) else str(feature[index])


def _address(photo, folder):
    """Address of a photograph as a KML file in `folder` sees it: relative where that is possible."""
    with suppress(ValueError):  # another drive
        return quote(Path(os.path.relpath(Path(photo).absolute(), folder)).as_posix())
    return Path(photo).absolute().as_uri()


def _reduced(photo):
    """JPEG of a photograph, upright and small enough for Google Earth."""
    from ..core.base.imaging import shrink_to
    from ..core.figures.raster import encode_jpeg
    from ..core.io.photo import read_photo

    pixels = shrink_to(read_photo(photo, PICTURE_PX).pixels[..., :3], PICTURE_PX)
    return encode_jpeg(np.rint(pixels).astype(np.uint8))
