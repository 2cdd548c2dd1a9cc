"""Table of landmark pairs -> angular offsets between extracted and synthetic skyline, per photo and overall."""

from __future__ import annotations

from dataclasses import dataclass

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessing,
    QgsProcessingException,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsWkbTypes,
)

from ..core.base.errors import MissingMetadataError
from ..core.base.messages import Message
from ..core.base.progress import checkpoint
from .base import SkylineAlgorithm
from .shared import parameters as shared
from .shared.feedback import FeedbackProgress
from .shared.fields import FieldSpec, is_null, number_or_none, qgis_fields
from .shared.i18n import tr
from .shared.outputs import write_features
from .shared.styling import style_on_completion

COLUMNS = {
    "PHOTO_FIELD": ("photo", "image", "filename", "name"),
    "X_EXTRACTED": ("x_extracted", "x_extr", "x_ext", "x_image", "x_img", "x1", "x_e"),
    "Y_EXTRACTED": ("y_extracted", "y_extr", "y_ext", "y_image", "y_img", "y1", "y_e"),
    "X_SYNTHETIC": ("x_synthetic", "x_synt", "x_syn", "x_dem", "x2", "x_s"),
    "Y_SYNTHETIC": ("y_synthetic", "y_synt", "y_syn", "y_dem", "y2", "y_s"),
    "WIDTH_FIELD": ("width", "width_px", "w"),
    "HEIGHT_FIELD": ("height", "height_px", "h"),
    "HFOV_FIELD": ("hfov", "hfov_deg"),
    "VFOV_FIELD": ("vfov", "vfov_deg"),
}
"""Field parameters and the field names that are used if none is chosen."""


@dataclass(frozen=True)
class Frame:
    """Size and field of view of one photo, as eq. 10 needs them."""

    width_px: float
    height_px: float
    hfov_deg: float
    vfov_deg: float


class MeasureOffsets(SkylineAlgorithm):
    """Apply equation 10 of the paper to hand-picked landmark pairs."""

    ID = "measureoffsets"
    GROUP_ID = "checks"

    def displayName(self):
        """Title in the toolbox."""
        return tr("Measure angular offsets")

    def tags(self):
        """Search words."""
        return tr("accuracy,landmark,offset,skyline,evaluation,table").split(",")

    def shortDescription(self):
        """One-line description."""
        return tr("Angular offsets between extracted and synthetic skyline from landmark pairs")

    def help_text(self):
        """Paragraphs of the help."""
        return [
            tr(
                "Each row of the table is one feature, a summit or a notch, clicked on the skyline of the photograph "
                "(extracted) and on the projected horizon (synthetic), in pixels of the upright picture. Offsets are "
                "synthetic minus extracted: azimuth positive to the right, elevation positive upwards."
            ),
            tr(
                "The table needs the fields photo, x_extracted, y_extracted, x_synthetic, y_synthetic (or "
                "x1, y1, x2, y2). Picture size and fields of view are read from the fields width, height, "
                "hfov and vfov if they exist, otherwise from the photo file by the published rule. The "
                "output contains the means of the absolute offsets per photograph; the means over all pairs "
                "are returned as results."
            ),
        ]

    def initAlgorithm(self, config=None):
        """Declare parameters and outputs."""
        source = QgsProcessingParameterFeatureSource(
            "INPUT", tr("Table of landmark pairs"), [QgsProcessing.SourceType.TypeVector]
        )
        self.addParameter(shared.explained(source, tr("One row per pair; pixels of the upright picture.")))
        for name, candidates in COLUMNS.items():
            field = QgsProcessingParameterField(
                name, tr("Field {name}").format(name=candidates[0]), None, "INPUT", optional=True
            )
            text = tr("If this is empty, the first of {names} that the table contains is used.").format(
                names=", ".join(candidates)
            )
            self.addParameter(shared.explained(shared.advanced(field), text))
        self.addParameter(
            shared.points_out(
                "OUTPUT",
                tr("Offsets per photo"),
                QgsProcessing.SourceType.TypeVector,
                text=tr(
                    "One row per photograph: number of pairs and mean offsets in azimuth, elevation and in total (°)."
                ),
            )
        )
        for name, label in (
            ("PAIRS", tr("Number of pairs")),
            ("MEAN_AZIMUTH", tr("Mean azimuth offset over all pairs (°)")),
            ("MEAN_ELEVATION", tr("Mean elevation offset over all pairs (°)")),
            ("MEAN_TOTAL", tr("Mean total offset over all pairs (°)")),
        ):
            self.addOutput(QgsProcessingOutputNumber(name, label))

    def compute(self, parameters, context, feedback):
        """Read the pairs, apply eq. 10, write the means."""
        import numpy as np

        from ..core.paper.offsets import angular_offsets, offset_table

        names, pairs, frames = self._pairs(parameters, context, FeedbackProgress(feedback))
        pairs = np.array(pairs, float)
        frame = np.array([[f.width_px, f.height_px, f.hfov_deg, f.vfov_deg] for f in frames], float)
        offsets = angular_offsets(pairs[:, :2], pairs[:, 2:], *frame.T)
        table = offset_table(names, offsets)
        for line in (*table.photos, table.over_pairs):
            feedback.pushInfo(
                f"{line.name}: {line.pairs}  d_az {line.azimuth_deg:.2f}°  d_el {line.elevation_deg:.2f}°  "
                f"total {line.total_deg:.2f}°"
            )
        specs = offset_specs()
        rows = [(None, values_of(line)) for line in table.photos]
        crs = QgsCoordinateReferenceSystem()
        fields = qgis_fields(specs)
        output = write_features(self, parameters, "OUTPUT", context, fields, QgsWkbTypes.Type.NoGeometry, crs, rows)
        style_on_completion(context, output, "offsets", tr("Offsets per photo"), specs, self.displayName())
        over = table.over_pairs
        return {
            "OUTPUT": output,
            "PAIRS": over.pairs,
            "MEAN_AZIMUTH": over.azimuth_deg,
            "MEAN_ELEVATION": over.elevation_deg,
            "MEAN_TOTAL": over.total_deg,
        }

    def _pairs(self, parameters, context, progress):
        source = self.parameterAsSource(parameters, "INPUT", context)
        if source is None:
            raise QgsProcessingException(self.invalidSourceError(parameters, "INPUT"))
        columns = {name: self._column(source, name, parameters, context) for name in COLUMNS}
        names, pairs, frames, known = [], [], [], {}
        for index, feature in enumerate(source.getFeatures()):
            checkpoint(progress, index / max(source.featureCount(), 1))
            cells = {name: None if column is None else feature[column] for name, column in columns.items()}
            pair = [number_or_none(cells[name]) for name in list(COLUMNS)[1:5]]
            if is_null(cells["PHOTO_FIELD"]) or None in pair:
                continue
            photo = str(cells["PHOTO_FIELD"])
            if photo not in known:
                known[photo] = frame_of(photo, [number_or_none(cells[name]) for name in list(COLUMNS)[5:]])
            names.append(photo)
            pairs.append(pair)
            frames.append(known[photo])
        if not pairs:
            raise QgsProcessingException(tr("The table has no complete pair. Fill photo and all four coordinates."))
        return names, pairs, frames

    def _column(self, source, name, parameters, context):
        chosen = self.parameterAsString(parameters, name, context)
        if chosen:
            return chosen
        names = {field.name().lower(): field.name() for field in source.fields()}
        found = next((names[candidate] for candidate in COLUMNS[name] if candidate in names), None)
        if found is None and name in list(COLUMNS)[:5]:
            raise QgsProcessingException(
                tr("The table has no field {field}. It has {fields}; choose the right one under Advanced.").format(
                    field=COLUMNS[name][0], fields=", ".join(names.values())
                )
            )
        return found


def frame_of(photo, given):
    """Size and field of view as given; missing values come from the photo file by the published rule."""
    if None not in given:
        return Frame(*given)
    from ..core.io.photo import read_metadata
    from ..core.paper.method import paper_fov_deg

    metadata = read_metadata(photo)
    size = metadata.width_px, metadata.height_px
    if None in given[2:] and metadata.focal_length_35mm is None:
        raise MissingMetadataError(
            Message("The photo has no focal length (35 mm equivalent). Give its fields of view in HFOV_FIELD.")
        )
    view = given[2:] if None not in given[2:] else paper_fov_deg(*size, metadata.focal_length_35mm)
    return Frame(*[known or read for known, read in zip(given, (*size, *view))])


def offset_specs():
    """Fields of the table."""
    return [
        FieldSpec("photo", "text", tr("Photo")),
        FieldSpec("pairs", "whole", tr("Pairs")),
        FieldSpec("d_az", "real", tr("Mean azimuth offset (°)")),
        FieldSpec("d_el", "real", tr("Mean elevation offset (°)")),
        FieldSpec("d_total", "real", tr("Mean total offset (°)")),
        FieldSpec("bias_az", "real", tr("Mean signed azimuth offset (°)")),
        FieldSpec("bias_el", "real", tr("Mean signed elevation offset (°)")),
    ]


def values_of(line):
    """Attributes in the order of `offset_specs`."""
    return [
        line.name,
        line.pairs,
        line.azimuth_deg,
        line.elevation_deg,
        line.total_deg,
        line.bias_azimuth_deg,
        line.bias_elevation_deg,
    ]
