"""Direction of a drone's camera, which its maker records in XMP instead of EXIF.

References
----------
.. [1] Pix4D, Specifications of XMP camera tags: yaw from north, and a pitch of 0 if the camera looks straight down.
.. [2] DJI, photo metadata: gimbal angles against north and the horizontal, and a pitch of -90 straight down. Parrot's
       CameraPitchDegree counts likewise.
"""

from __future__ import annotations

from math import isfinite

SCHEMES = (
    ("drone-dji", "Gimbal{}Degree", 0.0),
    ("drone-parrot", "Camera{}Degree", 0.0),
    ("Camera", "{}", -90.0),
)
"""Prefix of the namespace, form of the names, and what to add to the pitch so that 0 is horizontal [degrees]."""

PREFIXES = tuple(prefix for prefix, _, _ in SCHEMES)


def gimbal_tags(properties):
    """Give the angles of a drone's camera.

    Parameters
    ----------
    properties : dict
        Properties of each of `PREFIXES`, as `xmp.xmp_properties` gives them.

    Returns
    -------
    dict
        `GimbalYaw` (clockwise from true north), `GimbalPitch` (up positive) and `GimbalRoll` (right side down positive)
        [degrees], each as a tuple of one float; only those that are recorded. Empty without a yaw, and if all are
        exactly 0, as programs write them if nothing measured them.
    """
    for prefix, form, pitch_shift_deg in SCHEMES:
        angles = {name: _angle(properties[prefix].get(form.format(name))) for name in ("Yaw", "Pitch", "Roll")}
        if angles["Yaw"] is None or not any(angles.values()):
            continue
        if angles["Pitch"] is not None:
            angles["Pitch"] += pitch_shift_deg
        return {f"Gimbal{name}": (angle,) for name, angle in angles.items() if angle is not None}
    return {}


def _angle(text):
    """Read an angle, also one written as a fraction; None if it is missing or impossible."""
    over, _, under = (text or "").partition("/")
    try:
        angle = float(over) / float(under or 1)
    except (ValueError, ZeroDivisionError):
        return None
    return angle if isfinite(angle) and abs(angle) <= 360 else None
