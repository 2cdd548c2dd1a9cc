"""The photograph's own skyline as a limit: ground that the foreground hides is not claimed."""

from __future__ import annotations

from dataclasses import replace

from qgis.core import QgsProcessing, QgsProcessingParameterBoolean, QgsProcessingParameterFeatureSource

from ...core.base.photo_names import owners
from . import parameters as shared
from .feedback import warn
from .fields import is_null, number_or_none
from .i18n import tr
from .photo_points import pinhole

COLUMNS = ("photo", "column", "row")
TOLERANCE_DEG = 0.3
"""Angle by which errors of DEM and pose may move a ridge in the picture."""


def add_table_parameters(algorithm):
    """Declare the table of skylines and its tolerance."""
    table = QgsProcessingParameterFeatureSource(
        "SKYLINES", tr("Skylines of the photographs"), [QgsProcessing.SourceType.TypeVector], optional=True
    )
    text = tr(
        "Table of Extract skyline (photo, column, row, confidence). Ground that would appear above its "
        "photo's skyline is hidden by something that is not in the DEM, such as trees or houses, and counts "
        "as not seen. Columns with a confidence below 0.5 exclude nothing. Requires the area photo frame."
    )
    algorithm.addParameter(shared.advanced(shared.explained(table, text)))
    algorithm.addParameter(shared.advanced(tolerance()))


def add_own_parameters(algorithm):
    """Declare the choice to use the skyline found by the orientation."""
    own = QgsProcessingParameterBoolean("OWN_SKYLINE", tr("Foreground hides ground"), False)
    text = tr(
        "Ground that would appear above the photograph's own skyline is hidden by something that is not in "
        "the DEM, such as trees or houses, and counts as not seen. Requires the area photo frame."
    )
    algorithm.addParameter(shared.advanced(shared.explained(own, text)))
    algorithm.addParameter(shared.advanced(tolerance()))


def tolerance():
    """Parameter for how far above the skyline ground may appear."""
    return shared.number(
        "SKYLINE_TOLERANCE",
        tr("Tolerance above the skyline (°)"),
        TOLERANCE_DEG,
        tr(
            "Ground up to this angle above the skyline still counts as seen, which allows for errors of the DEM "
            "and the heading."
        ),
        minimum=0.0,
        maximum=45.0,
    )


def table_fault(algorithm, parameters, context):
    """Sentence on an unusable table of skylines, or None."""
    source = algorithm.parameterAsSource(parameters, "SKYLINES", context)
    if source is None:
        return None
    missing = [name for name in COLUMNS if source.fields().lookupField(name) < 0]
    if not missing:
        return None
    return tr("The table of skylines has no field {field}. Choose the table that Extract skyline has written.").format(
        field=missing[0]
    )


def with_table(algorithm, parameters, context, points, feedback):
    """Give the points their skylines from the table; without a table the points stay unchanged."""
    source = algorithm.parameterAsSource(parameters, "SKYLINES", context)
    if source is None:
        return points
    tolerance_deg = algorithm.parameterAsDouble(parameters, "SKYLINE_TOLERANCE", context)
    lines = lines_of(source)
    keys = {path: photo for photo, path in owners(lines, [p.path for p in points if p.path]).items()}
    limited = []
    for point in points:
        key = keys.get(point.path)
        if key is None:
            warn(
                feedback, point.name, tr("The table of skylines does not contain this photo, so no ground is excluded.")
            )
        limited.append(point if key is None else with_line(point, *lines[key], tolerance_deg))
    return limited


def lines_of(source):
    """(columns, rows, confidences) of each photo in a table [pixels]."""
    lines, sure = {}, source.fields().lookupField("confidence")
    for feature in source.getFeatures():
        if is_null(feature["photo"]):
            continue
        confidence = 1.0 if sure < 0 else number_or_none(feature[sure])
        values = number_or_none(feature["column"]), number_or_none(feature["row"]), confidence
        if None not in values:
            lines.setdefault(str(feature["photo"]), []).append(values)
    return {photo: tuple(zip(*values)) for photo, values in lines.items()}


def with_line(point, columns, rows, confidence, tolerance_deg):
    """Point with a skyline that covers the picture's whole width, which its columns determine.

    Parameters
    ----------
    point : PhotoPoint
    columns, rows, confidence : sequences of float
        The skyline [pixels].
    tolerance_deg : float
        Ground may appear this far above it [degrees].
    """
    from ...core.viewshed.sector import skyline_rows

    width_px = max(round(min(columns) + max(columns) + 1), 1)
    row_px = skyline_rows(columns, rows, confidence, width_px)
    posed = point.posed
    if posed is not None and posed.camera.width_px != width_px:  # its size was unknown
        camera = pinhole(point.hfov_deg, point.vfov_deg, (width_px, None))
        posed = replace(posed, camera=replace(camera, k1=posed.camera.k1, k2=posed.camera.k2))
    return replace(point, posed=posed, skyline_row_px=row_px, skyline_tolerance_deg=tolerance_deg)


def with_own(point, oriented, tolerance_deg):
    """Point with the skyline from which its orientation was found; unchanged if there is none."""
    from ...core.base.overlay_lines import skyline_line

    if oriented.skyline is None or oriented.camera is None:
        return point
    line = skyline_line(oriented.skyline, oriented.camera.width_px, oriented.camera.height_px)
    return with_line(point, line.x_px, line.y_px, oriented.skyline.confidence, tolerance_deg)
