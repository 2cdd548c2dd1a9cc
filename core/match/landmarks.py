"""Use landmarks given by a person: scale them to the reduced picture, derive starting poses, report the misses.

A landmark is so exact that a fit always meets it, whatever the skyline shows. It is therefore used only if it lies in
the picture, and if the picture does not decide the heading otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.camera import Pose, in_frame, project, unproject
from ..base.messages import Message
from ..base.progress import SILENT, subtask

CONTRADICTION_SHARE = 0.05
"""A landmark contradicts an accepted answer that it misses by more than this share of the picture's diagonal."""


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
    number : int
        What messages call it; 0 means its place in the list, counted from 1.
    """

    x_px: float
    y_px: float
    azimuth_deg: float
    elevation_deg: float
    sigma_px: float = 5.0
    number: int = 0


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


def match_with_landmarks(match, inputs, options, progress=SILENT):
    """Match with the landmarks that lie in the picture and do not contradict it.

    Parameters
    ----------
    match : callable
        `robust.match_robust`.
    inputs : MatchInputs
    options : RobustOptions
    progress : Progress

    Returns
    -------
    Orientation
        Its notes name the landmarks that were not used.
    """
    if not inputs.landmarks:
        return match(inputs, options, progress)
    camera = inputs.camera_prior.camera
    marks = tuple(replace(mark, number=mark.number or number) for number, mark in enumerate(inputs.landmarks, 1))
    framed = [bool(in_frame(camera, np.array(mark.x_px), np.array(mark.y_px))) for mark in marks]
    inside = tuple(mark for mark, good in zip(marks, framed) if good)
    notes = tuple(_outside_note(mark, camera) for mark, good in zip(marks, framed) if not good)
    found = match(replace(inputs, landmarks=inside), options, subtask(progress, 0.0, 0.5 if inside else 1.0))
    if inside:
        alone = match(replace(inputs, landmarks=()), options, subtask(progress, 0.5, 0.8))
        wrong = contradicting(inside, alone, found)
        if wrong:
            rest = tuple(mark for mark in inside if mark not in wrong)
            rematch = subtask(progress, 0.8, 1.0)
            found = match(replace(inputs, landmarks=rest), options, rematch) if rest else alone
            notes += tuple(_contradiction_note(mark, alone.best) for mark in wrong)
        elif len(inside) == 1:
            found = _doubted(found, options.posterior.least_ncc)
    return replace(found, notes=notes + found.notes)


def _doubted(found, least_ncc):
    """Take back the acceptance that rests on one landmark and contradicts the skyline; nothing else checks a slip."""
    if found.status != "accepted" or found.ncc is None or found.ncc >= least_ncc:
        return found
    text = Message(
        "At the landmark's heading the DEM horizon does not follow the skyline that was found in the picture. Check "
        "the landmark and the overlay, or give a second landmark, a sky mask or a drawn skyline."
    )
    return replace(found, status="ambiguous", message=text, p_correct=None, heading_lo_deg=None, heading_hi_deg=None)


def contradicting(landmarks, alone, found):
    """Landmarks that contradict what the picture decides without them.

    Parameters
    ----------
    landmarks : tuple of Landmark
        In pixels of the full picture.
    alone, found : Orientation
        Answers without and with the landmarks. If the skyline agrees with the second at least as well, the landmarks
        have corrected the first.

    Returns
    -------
    tuple of Landmark
    """
    if alone.status != "accepted":
        return ()
    if found.ncc is not None and alone.ncc is not None and found.ncc >= alone.ncc:
        return ()
    camera, pose = alone.best.camera, alone.best.pose
    limit_px = CONTRADICTION_SHARE * np.hypot(camera.width_px, camera.height_px)
    return tuple(mark for mark in landmarks if not _miss_px(mark, camera, pose) <= max(limit_px, 3 * mark.sigma_px))


def _miss_px(mark, camera, pose):
    """Distance of a landmark from its predicted position [pixels]; NaN behind the camera."""
    x, y = project(camera, pose, mark.azimuth_deg, mark.elevation_deg)
    return float(np.hypot(x - mark.x_px, y - mark.y_px))


def _outside_note(mark, camera):
    return Message(
        "Landmark {number} lies outside the picture of {width} x {height} pixels and was not used. Check that its "
        "pixel belongs to this picture, and not to a reduced or turned copy.",
        number=mark.number,
        width=camera.width_px,
        height=camera.height_px,
    )


def _contradiction_note(mark, best):
    return Message(
        "Landmark {number} contradicts the picture, in which the skyline alone decides the heading: its map point lies "
        "{count} degrees in azimuth from its pixel. It was not used. Check the pixel and the map point.",
        number=mark.number,
        count=f"{_turn_deg(mark, best):.0f}",
    )


def _turn_deg(mark, best):
    azimuth, _ = unproject(best.camera, best.pose, mark.x_px, mark.y_px)
    return abs(float(difference(mark.azimuth_deg, azimuth)))


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
    for place, mark in enumerate(landmarks, 1):
        number = mark.number or place
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
