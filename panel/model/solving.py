"""Answers of the matcher for a draft: from what a person set, drew and clicked. Runs in a lane."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...core.base.angles import difference
from ...core.base.messages import Message

TOLERANCE_DEG = 4.0
"""How far the matcher looks around the heading that a person set [degrees]."""

ANCHOR_SHARE = 60.0
"""Standard deviation of the drawn horizon as a landmark: the long side of the picture divided by this [pixels]. It is
five times that of a hand (`adjust.HAND_SHARE`), so that the skyline decides within it."""

FAR_DEG = 8.0
"""An answer farther than this from the heading that a person set is another one, and is not taken [degrees]."""

CONTRADICTED = Message(
    "The skyline contradicts the landmarks, so the horizon stays where they put it. Check the landmarks, or mask what "
    "hides the skyline."
)

UNDECIDED = Message(
    "The skyline does not decide more exactly here, so the horizon stays where you put it. Set a landmark, draw the "
    "skyline, or mask what hides it."
)


def snapped(item, draft, ground, dem, evidence, free=False, progress=None):
    """Fit a draft with the robust matcher, from where it is.

    Parameters
    ----------
    item : PhotoItem
    draft : Draft
        Without a pose the whole circle is searched.
    ground : Ground
    dem : core.io.raster.Dem
    evidence : SkylineEvidence or None
        Extracted skyline, which strokes and brush change.
    free : bool
        The pose says only the heading (an alternative of the table); otherwise the drawn horizon is kept to.
    progress : Progress or None

    Returns
    -------
    draft : Draft
    message : Message or str
        For the person.
    """
    from ...core.batch import orient_request
    from ...core.eyes import HorizonCache
    from ...core.pipeline import OrientOptions

    with tempfile.TemporaryDirectory() as folder:
        request = _request(item, draft, ground, evidence, free, folder)
        options = (request, dem, OrientOptions(), HorizonCache(), *([progress] if progress is not None else []))
        oriented = orient_request(*options)
    answer, best = oriented.orientation, oriented.orientation.best
    if best is None:
        return draft, answer.message
    if draft.pose is not None:
        away = abs(difference(best.pose.heading_deg, draft.pose.heading_deg))
        # If the skyline decides nothing, the same heading comes back.
        if away < 1e-9 or away > FAR_DEG:
            return draft, UNDECIDED
    interval = (answer.heading_lo_deg, answer.heading_hi_deg)
    found = draft.placed(best.pose, "snapped", best.camera, None if None in interval else interval)
    known = ground, oriented.metadata
    if draft.pose is not None and missed_landmarks(found, *known) - missed_landmarks(draft, *known):
        return draft, CONTRADICTED
    return found, answer.message if draft.pose is None else ""


def _request(item, draft, ground, evidence, free, folder):
    from ...core.base.landmark_hint import LandmarkHint
    from ...core.batch import PhotoRequest

    eye, aids = ground.observer, {}
    landmarks = list(draft.landmarks)
    if draft.pose is not None:
        aids = {"heading_deg": draft.pose.heading_deg, "heading_tolerance_deg": TOLERANCE_DEG}
        if not free:
            sigma = max(draft.camera.width_px, draft.camera.height_px) / ANCHOR_SHARE
            landmarks += [LandmarkHint(x, y, lon, lat, z, sigma) for x, y, lon, lat, z in anchors(draft, ground)]
    line, rows = skyline_of(draft, evidence)
    if line is not None:
        aids["drawn_skyline"] = line
    elif rows is not None:
        aids["sky_mask_path"] = str(Path(folder) / "mask.png")
        write_mask(aids["sky_mask_path"], rows, evidence)
    lens = draft.camera.hfov_deg if draft.lens_changed or item.values["HFOV_FIELD"] is not None else None
    if lens is None and not _has_lens(item.path):
        lens = draft.camera.hfov_deg
    return PhotoRequest(
        item.path,
        longitude_deg=eye.longitude_deg,
        latitude_deg=eye.latitude_deg,
        eye_elevation_m=eye.eye_elevation_m,
        hfov_deg=lens,
        landmarks=tuple(landmarks),
        **aids,
    )


def _has_lens(path):
    from ...core.io.photo import read_metadata

    return read_metadata(path).focal_length_35mm is not None


def anchors(draft, ground):
    """Points of the drawn horizon as landmarks, so that the matcher starts from the whole pose."""
    from ...core.mapping.adjust import horizon_marks

    eye, horizon = ground.observer, ground.horizon
    reach = 1.01 * float(np.nanmax(horizon.distance_m))
    frame = ground.terrain.frame(eye.longitude_deg, eye.latitude_deg, reach)
    return horizon_marks(ground.terrain, horizon, frame, draft.camera, draft.pose)


def skyline_of(draft, evidence):
    """What a person made of the skyline: (line of vertices, None), (None, rows of the evidence), or (None, None).

    Parameters
    ----------
    draft : Draft
    evidence : SkylineEvidence or None
    """
    from ...core.skyline.repair import edited_rows, joined

    if draft.strokes and (draft.anew or evidence is None):
        return joined(draft.strokes), None
    if evidence is not None and (draft.strokes or draft.brush):
        return None, edited_rows(evidence, draft.strokes, draft.brush)
    return None, None


def write_mask(path, rows, evidence):
    """Write a sky mask as PNG, whole or not at all; raises `OutputError`."""
    from qgis.PyQt.QtGui import QImage

    from ...core.io.whole_file import staged
    from ...core.skyline.repair import sky_mask

    mask = sky_mask(rows, evidence.probability.shape[0])
    height, width = mask.shape
    image = QImage(mask.tobytes(), width, height, width, QImage.Format.Format_Grayscale8)
    with staged(path) as folder:
        if not image.save(str(folder / Path(path).name), "PNG"):
            raise OSError(path)


def extracted(picture):
    """Skyline evidence of a picture; raises `PhotoError`."""
    from ...core.skyline.evidence import SkylineOptions, skyline_evidence

    metadata = picture.metadata
    return skyline_evidence(picture.preview, SkylineOptions(), metadata.width_px, metadata.height_px)


def levelled_draft(draft, ground, evidence):
    """Put the horizon of a draft onto the extracted skyline by the pitch alone, if both are known."""
    from ...core.mapping.adjust import levelled

    if draft.pose is None or evidence is None:
        return draft
    return replace(draft, pose=levelled(draft.camera, draft.pose, ground.horizon, evidence.best))


def missed_landmarks(draft, ground, metadata):
    """Landmarks of a draft that its pose misses by more than a person's click could.

    Parameters
    ----------
    draft : Draft
    ground : Ground
    metadata : PhotoMetadata

    Returns
    -------
    set of LandmarkHint

    Raises
    ------
    PhotoError
        As `placed_by_landmarks`.
    """
    from ...core.base.camera import project
    from ...core.match.landmarks import CONTRADICTION_SHARE

    camera, missed = draft.camera, set()
    limit_px = CONTRADICTION_SHARE * np.hypot(camera.width_px, camera.height_px)
    for mark in draft.landmarks:
        x, y = project(camera, draft.pose, *mark.direction_deg(ground.terrain, ground.observer, metadata))
        if not np.hypot(x - mark.x_px, y - mark.y_px) <= limit_px:  # NaN behind the camera
            missed.add(mark)
    return missed


def placed_by_landmarks(draft, ground, metadata):
    """Fit a draft to its landmarks.

    Parameters
    ----------
    draft : Draft
    ground : Ground
    metadata : PhotoMetadata
        For the time, from which the place of the sun and the moon follows.

    Raises
    ------
    PhotoError
        A landmark has no elevation; the time is unknown; or the sun or the moon was below the horizon.
    """
    from ...core.base.camera import FOCAL_SIGMA, Pose
    from ...core.mapping.adjust import fitted_to_landmarks

    marks = [
        (mark.x_px, mark.y_px, *mark.direction_deg(ground.terrain, ground.observer, metadata))
        for mark in draft.landmarks
    ]
    sigma = FOCAL_SIGMA if draft.lens_known else 0.5
    camera, pose = fitted_to_landmarks(draft.camera, draft.pose or Pose(0.0), marks, sigma)
    found = draft.placed(pose, "landmarks", camera)
    # With one landmark the lens only follows its prior, and stays as unknown as it was.
    return replace(found, lens_known=draft.lens_known or len(marks) > 1, lens_changed=found.lens_changed or (
        len(marks) > 1 and not draft.lens_known))  # fmt: skip
