"""Writing to the layer: poses and verdicts go through its edit buffer, as any edit in QGIS does."""

from __future__ import annotations

from qgis.core import QgsVectorDataProvider

from ...algorithms.shared.fields import FieldSpec, qgis_field
from ...algorithms.shared.i18n import tr
from ...algorithms.shared.oriented import oriented_specs
from ...core.base.angles import difference, wrap_360
from ...core.base.attributes import oriented_values
from ...core.base.model import Candidate, Orientation, OrientedPhoto
from ...core.base.uncertainty import Z_90
from .photo_layer import REVIEW_FIELD

CONFIRMED = "confirmed"
POSE_NAMES = ("heading", "pitch", "roll", "hfov", "vfov", "heading_lo", "heading_hi", "status", "message")
"""Fields that a layer gets if it has none of them."""

FOLLOWING_NAMES = ("ncc", "ncc_2nd", "sharpness", "p_correct", "compass_df", "horizon_m", "azim_1", "azim_2")
"""Fields that would contradict a new pose if they kept their values."""


class NotEditableError(Exception):
    """The layer does not take the edit; the text says what to do."""


def review_specs():
    """The field of the verdicts."""
    return [FieldSpec(REVIEW_FIELD, "text", tr("Verdict of the review"))]


def pose_values(item, draft, ground, extra_names=()):
    """Values of the fields that a draft changes, by name.

    Parameters
    ----------
    item : PhotoItem
    draft : Draft
    ground : Ground
    extra_names : sequence of str
        Further fields to write: heading_2 and heading_3 after another answer was chosen.
    """
    lo, hi = draft.interval_deg or hand_interval_deg(draft, ground)
    best = Candidate(draft.pose, draft.camera, 0.0)
    answer = Orientation(CONFIRMED, draft.described(), (best,), heading_lo_deg=lo, heading_hi_deg=hi)
    eye = ground.observer
    frame = ground.terrain.frame(eye.longitude_deg, eye.latitude_deg, 1_000.0)
    photo = OrientedPhoto(
        item.path or "",
        answer,
        camera=draft.camera,
        horizon=ground.horizon,
        longitude_deg=eye.longitude_deg,
        latitude_deg=eye.latitude_deg,
        eye_elevation_m=eye.eye_elevation_m,
        convergence_deg=frame.convergence_deg,
        compass_true_deg=item.values["compass"],
    )
    values = oriented_values(photo, item.values["radius"] or 0.0)
    names = (*POSE_NAMES, *FOLLOWING_NAMES, *(("eye_z",) if item.values["HEIGHT_FIELD"] is None else ()))
    found = {name: values[name] for name in names}
    if "heading_2" in extra_names:
        found.update(_other_headings(item, draft))
    return found


def _other_headings(item, draft):
    """The answers that were not chosen, the former best first."""
    known = [item.values[key] for key in ("HEADING_FIELD", "heading_2", "heading_3")]
    others = [h for h in known if h is not None and abs(difference(h, draft.pose.heading_deg)) > 3.0][:2]
    others += [None] * (2 - len(others))
    return {"heading_2": others[0], "heading_3": others[1]}


def hand_interval_deg(draft, ground):
    """90 % interval of a heading that a person set: by the precision of a hand, and the position's error."""
    import numpy as np

    from ...core.base.uncertainty import TYPICAL_POSITION_ERROR_M
    from ...core.mapping.adjust import hand_sigma_deg

    nearest = np.abs(difference(ground.horizon.azimuth_deg, draft.pose.heading_deg)).argmin()
    far = float(np.nan_to_num(ground.horizon.distance_m[nearest], nan=1_000.0))
    sigma = float(np.hypot(hand_sigma_deg(draft.camera), np.degrees(np.arctan2(TYPICAL_POSITION_ERROR_M, far))))
    return tuple(float(wrap_360(draft.pose.heading_deg + sign * Z_90 * sigma)) for sign in (-1, 1))


def write_values(layer, fid, values, specs, title):
    """Change a feature's attributes in the edit buffer, as one step of the layer's undo.

    Parameters
    ----------
    layer : QgsVectorLayer
    fid : int
    values : dict
        By field name; fields that the layer lacks are added if `specs` has them, and left out otherwise.
    specs : list of FieldSpec
    title : str
        Name of the step.

    Raises
    ------
    NotEditableError
    """
    _open(layer)
    layer.beginEditCommand(title)
    try:
        _add_fields(layer, [spec for spec in specs if spec.name in values])
        for name, value in values.items():
            index = layer.fields().lookupField(name)
            if index >= 0 and not layer.changeAttributeValue(fid, index, value):
                raise NotEditableError(
                    tr("The field {field} does not take the value. Check the layer's fields.").format(field=name)
                )
    except NotEditableError:
        layer.destroyEditCommand()
        raise
    layer.endEditCommand()
    layer.triggerRepaint()


def _open(layer):
    able = layer.dataProvider().capabilities() & QgsVectorDataProvider.Capability.ChangeAttributeValues
    if layer.readOnly() or not able or not (layer.isEditable() or layer.startEditing()):
        raise NotEditableError(
            tr("The layer {layer} is read-only. Export it as a GeoPackage, and correct the photographs there.").format(
                layer=layer.name()
            )
        )


def _add_fields(layer, specs):
    missing = [spec for spec in specs if layer.fields().lookupField(spec.name) < 0]
    if not missing:
        return
    able = layer.dataProvider().capabilities() & QgsVectorDataProvider.Capability.AddAttributes
    if not able or not all(layer.addAttribute(qgis_field(spec)) for spec in missing):
        names = ", ".join(spec.name for spec in missing)
        raise NotEditableError(
            tr("The layer takes no new fields ({fields}). Export it as a GeoPackage first.").format(fields=names)
        )


def write_pose(layer, item, draft, ground):
    """Write a draft's pose, interval, status and message; raises `NotEditableError`."""
    extra = ("heading_2",) if "alternative" in draft.means else ()
    values = pose_values(item, draft, ground, extra)
    specs = [spec for spec in oriented_specs() if spec.name in POSE_NAMES]
    write_values(layer, item.fid, values, specs, tr("Correct {photo}").format(photo=item.name))


def write_verdict(layer, item, verdict):
    """Write the verdict of a review; raises `NotEditableError`."""
    title = tr("Review {photo}").format(photo=item.name)
    write_values(layer, item.fid, {REVIEW_FIELD: verdict}, review_specs(), title)
