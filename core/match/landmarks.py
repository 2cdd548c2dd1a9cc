"""Use landmarks given by a person: scale them to the reduced picture, derive starting poses, report the misses."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.camera import Pose, project, unproject
from ..base.messages import Message


@dataclass(frozen=True)
class Landmark:
    """A pixel of the full upright picture whose direction from the eye is known.

    Attributes
    ----------
    x_px, y_px : float
    azimuth_deg, elevation_deg : float
        True azimuth and elevation angle of the map point seen from the eye [degrees].
    sigma_px : float
        Precision of the click [pixels].
    """

    x_px: float
    y_px: float
    azimuth_deg: float
    elevation_deg: float
    sigma_px: float = 5.0


def scale_landmarks(landmarks, full, reduced):
    """Move landmarks from the full picture's pixels to the reduced one's.

    Half a reduced pixel is added to their spread, since the evidence resolves nothing finer.

    Parameters
    ----------
    landmarks : sequence of Landmark
        In pixels of the full picture.
    full, reduced : Camera
        Cameras of the two pictures.

    Returns
    -------
    tuple of Landmark
    """
    factor_x, factor_y = reduced.width_px / full.width_px, reduced.height_px / full.height_px
    return tuple(
        replace(
            mark,
            x_px=(mark.x_px + 0.5) * factor_x - 0.5,
            y_px=(mark.y_px + 0.5) * factor_y - 0.5,
            sigma_px=float(np.hypot(mark.sigma_px * factor_x, 0.5)),
        )
        for mark in landmarks
    )


def starting_pose(camera, landmark):
    """Level pose from which the landmark is seen at its pixel.

    Pitch and heading follow from one direction if the roll is taken as zero. A few corrections of the pitch by the
    remaining difference in elevation suffice, since pitch changes the elevation almost one to one.
    """
    pitch, azimuth = 0.0, 0.0
    for _ in range(12):
        azimuth, elevation = unproject(camera, Pose(0.0, pitch), landmark.x_px, landmark.y_px)
        pitch = float(np.clip(pitch + landmark.elevation_deg - elevation, -85.0, 85.0))
    return Pose(float(wrap_360(landmark.azimuth_deg - azimuth)), pitch)


def landmark_notes(landmarks, camera, pose):
    """Return one message per landmark with its distance from the predicted position [pixels of the full picture].

    Parameters
    ----------
    landmarks : sequence of Landmark
        In pixels of the full picture.
    camera : Camera
        Fitted camera of the full picture.
    pose : Pose
        Fitted pose.
    """
    notes = []
    for number, mark in enumerate(landmarks, 1):
        x, y = project(camera, pose, mark.azimuth_deg, mark.elevation_deg)
        if np.isfinite(x):
            count = f"{np.hypot(x - mark.x_px, y - mark.y_px):.0f}"
            note = Message(
                "Landmark {number} lies {count} pixels from its predicted position.", number=number, count=count
            )
        else:
            count = f"{abs(difference(mark.azimuth_deg, pose.heading_deg)):.0f}"
            note = Message(
                "Landmark {number} lies outside the view, {count} degrees in azimuth from the heading. Check the "
                "landmark and the position.",
                number=number,
                count=count,
            )
        notes.append(note)
    return tuple(notes)
