"""The optional table of a run that judges the compasses of its photographs, one row for each device."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessing, QgsWkbTypes

from . import parameters as shared
from .fields import FieldSpec, qgis_fields
from .i18n import tr
from .outputs import write_features
from .styling import style_on_completion

NAME = "COMPASS_AUDIT"


def add_compass_audit(algorithm):
    """Declare the table."""
    text = tr(
        "One row per device, from accepted and confirmed photos: bias of the compass with its 90 % interval, spread, "
        "worthless and turned readings, and drift over the day."
    )
    kind = QgsProcessing.SourceType.TypeVector
    table = shared.points_out(NAME, tr("Compass audit"), kind, optional=True, create=False, text=text)
    algorithm.addParameter(shared.advanced(table))


def compass_audit_specs():
    """Fields of the table."""
    return [
        FieldSpec("device", "text", tr("Maker, model and software")),
        FieldSpec("readings", "whole", tr("Readings")),
        FieldSpec("bias", "real", tr("Recorded minus found heading, median (°)")),
        FieldSpec("bias_lo", "real", tr("Lower limit of the bias, 90 % (°)")),
        FieldSpec("bias_hi", "real", tr("Upper limit of the bias, 90 % (°)")),
        FieldSpec("spread", "real", tr("Robust standard deviation (°)")),
        FieldSpec("worthless", "whole", tr("Readings off by more than 30°")),
        FieldSpec("plus_90", "whole", tr("Readings near bias + 90°")),
        FieldSpec("minus_90", "whole", tr("Readings near bias − 90°")),
        FieldSpec("opposite", "whole", tr("Readings near bias + 180°")),
        FieldSpec("turned", "yes", tr("Too many of these for chance")),
        FieldSpec("drift", "real", tr("Change of the bias during a day (° per hour)")),
        FieldSpec("drift_lo", "real", tr("Lower limit of the change, 90 % (° per hour)")),
        FieldSpec("drift_hi", "real", tr("Upper limit of the change, 90 % (° per hour)")),
    ]


class CompassReadings:
    """Readings of a run, photo by photo, and their table at its end."""

    def __init__(self):
        self._readings = []

    def add(self, oriented):
        """Keep the reading of a photo that has a reliable heading and a compass."""
        from ...core.report.audit import reading_of

        self._readings += filter(None, [reading_of(oriented)])

    def write(self, algorithm, parameters, context):
        """Write the table, if it is requested, and return the output's name and identifier."""
        from ...core.report.audit import audit

        if not parameters.get(NAME):
            return {}
        specs, rows = compass_audit_specs(), [(None, values_of(one)) for one in audit(self._readings)]
        kind = QgsWkbTypes.Type.NoGeometry, QgsCoordinateReferenceSystem()
        output = write_features(algorithm, parameters, NAME, context, qgis_fields(specs), *kind, rows)
        style_on_completion(context, output, "compass_audit", tr("Compass audit"), specs, algorithm.displayName())
        return {NAME: output}


def values_of(one):
    """Attributes of a `DeviceAudit`, in the order of `compass_audit_specs`."""
    return [
        one.device,
        one.count,
        one.bias_deg,
        one.bias_lo_deg,
        one.bias_hi_deg,
        one.spread_deg,
        one.worthless,
        *one.turned,
        one.turned_fault,
        one.drift_deg_per_h,
        one.drift_lo_deg_per_h,
        one.drift_hi_deg_per_h,
    ]
