"""The answer for each photograph of a walk, from its marginal: pose, p_correct, interval, status and who helped."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..base.angles import difference, wrap_360
from ..base.camera import FOCAL_SIGMA
from ..base.messages import Message
from ..base.model import Candidate
from ..base.status import RELIABLE
from ..base.uncertainty import Z_90, PoseUncertainty
from .adjust import KnownPose, adjusted
from .circle import shortest_arc
from .sideways import sideways_deg
from .together import RIGHT_DEG

MOST_NAMES = 3
USUAL_TILT_DEG = 0.5
"""Standard deviation of a pitch or roll that is not known."""
FEWEST_RIGHT = 0.5
"""Photographs whose answer is less certain take no part in the adjustment of the poses."""


@dataclass(frozen=True)
class Limits:
    """Probabilities at which an answer is accepted, and below which it is rejected."""

    accept_at: float
    reject_below: float


def answers_together(photos, again, beliefs, ties, limits):
    """Give each photograph the answer of its marginal.

    Parameters
    ----------
    photos : list of OrientedPhoto
        Results alone.
    again : dict of int to OrientedPhoto
        Results of another look near the predicted heading.
    beliefs : list of Belief or None
    ties : list of Tie
    limits : Limits

    Returns
    -------
    list of OrientedPhoto
        The same objects where the others say nothing.
    """
    told = [_told(photo, belief, limits) for photo, belief in zip(photos, beliefs)]
    based = [
        _based(photo, again.get(number), beliefs[number]) if told[number] else photo
        for number, photo in enumerate(photos)
    ]
    refined = _refined(based, beliefs, ties)
    return [
        _answer(photo, base, belief, (refined.get(number), limits, photos)) if told[number] else photo
        for number, (photo, base, belief) in enumerate(zip(photos, based, beliefs))
    ]


def _told(photo, belief, limits):
    """Whether others helped a photograph, or contradict an accepted answer."""
    if belief is None:
        return False
    contradicted = photo.status in RELIABLE and belief.probability_of(photo.heading_deg) < limits.accept_at
    return contradicted or bool(belief.tied or belief.by_compass)


def _based(photo, again, belief):
    """The result with the pose nearest to the marginal's heading: of the first look, of another, or by the ties."""
    for found in (photo, again):
        if found is not None and _near(found, belief.heading_deg):
            return found
    if belief.pose is None or photo.camera is None:
        return photo
    best = Candidate(belief.pose, photo.camera, float("nan"), belief.probability)
    orientation = replace(
        photo.orientation, candidates=(best, *photo.orientation.candidates), ncc=None, ncc_second=None,
        residual_px=None, behind=False, eye=0, uncertainty=None, notes=(),
    )  # fmt: skip
    return replace(photo, orientation=orientation)


def _near(photo, heading_deg):
    return photo.heading_deg is not None and abs(difference(photo.heading_deg, heading_deg)) <= RIGHT_DEG


def _refined(based, beliefs, ties):
    """Adjusted poses of the photographs whose answers agree with the ties, by their numbers."""
    known = {
        number: _known(photo, belief)
        for number, (photo, belief) in enumerate(zip(based, beliefs))
        if belief is not None and belief.pose is not None and belief.probability >= FEWEST_RIGHT
        and _near(photo, belief.heading_deg)
    }  # fmt: skip
    used = [tie for tie in ties if tie.one in known and tie.other in known]
    tied = {number for tie in used for number in (tie.one, tie.other)}
    found: dict = {}
    for group in _groups(tied, used):
        inside = [tie for tie in used if tie.one in group]
        found.update(adjusted({number: known[number] for number in group}, inside))
    return found


def _groups(numbers, ties):
    groups = {number: {number} for number in numbers}
    for tie in ties:
        if groups[tie.one] is not groups[tie.other]:
            groups[tie.one] |= groups[tie.other]
            for number in groups[tie.other]:
                groups[number] = groups[tie.one]
    return [group for number, group in sorted(groups.items()) if number == min(group)]


def _known(photo, belief):
    """What the photograph's own skyline says of the pose; what others show too has less weight."""
    best = photo.orientation.best
    if not np.isfinite(best.score):
        return KnownPose(best.pose, (np.inf,) * 3)
    tilt = photo.orientation.uncertainty or PoseUncertainty(pitch_deg=USUAL_TILT_DEG, roll_deg=USUAL_TILT_DEG)
    sigma = np.array([_own_sigma_deg(photo) or USUAL_TILT_DEG, tilt.pitch_deg, tilt.roll_deg])
    return KnownPose(best.pose, tuple(sigma / np.sqrt(belief.weight)))


def _own_sigma_deg(photo):
    """Standard deviation of a heading by the photograph's own skyline, errors of DEM and place included, or None.

    An answer that is accepted alone has a skyline that decides by itself; one that others decide may lean on a ridge
    so near that the DEM's error turns it by degrees.
    """
    sigma = photo.orientation.best.heading_sigma_deg
    return None if sigma is None else float(np.hypot(sigma, sideways_deg(photo)))


def _answer(photo, base, belief, around):
    refined, limits, photos = around
    heading = base.heading_deg
    if heading is None:
        return photo
    best, sigma = base.orientation.best, _own_sigma_deg(base)
    if refined is not None:
        best, sigma = replace(best, pose=refined.pose), refined.sigma_deg[0]
        best = replace(best, pose=replace(best.pose, heading_deg=float(wrap_360(best.pose.heading_deg))))
    right = belief.probability_of(best.pose.heading_deg)
    status = "accepted" if right >= limits.accept_at else "rejected" if right < limits.reject_below else "ambiguous"
    if photo.status in RELIABLE and status == "accepted" and _near(photo, belief.heading_deg):
        return photo
    best = replace(best, probability=right, heading_sigma_deg=sigma)
    lo, hi = shortest_arc(belief.density, best.pose.heading_deg)
    if status == "accepted" and sigma is not None:
        lo, hi = (float(wrap_360(best.pose.heading_deg + side * Z_90 * sigma)) for side in (-1, 1))
    orientation = replace(
        base.orientation,
        status=status,
        message=_message(photo, base, status),
        candidates=(best, *base.orientation.candidates[1:]),
        heading_lo_deg=lo,
        heading_hi_deg=hi,
        p_correct=right,
        notes=(*base.orientation.notes, *_notes(belief, photos)),
        uncertainty=_uncertainty(base, refined),
    )
    return replace(base, orientation=orientation, camera=best.camera)


def _uncertainty(base, refined):
    before = base.orientation.uncertainty
    if refined is None:
        return before
    tilt = {"pitch_deg": min(refined.sigma_deg[1], 30.0), "roll_deg": min(refined.sigma_deg[2], 30.0)}
    focal_sigma = FOCAL_SIGMA if base.metadata is None else base.metadata.focal_sigma
    return replace(before or PoseUncertainty(focal_relative=focal_sigma), **tilt)


def _message(photo, base, status):
    if status == "accepted":
        return Message("The photos taken nearby decide the heading: no other heading fits all of them.")
    if photo.status in RELIABLE:
        return Message(
            "Photos taken nearby contradict this heading. Compare the overlays, or give an approximate heading or a "
            "landmark."
        )
    return base.message if base is photo else Message(
        "The photos taken nearby suggest this heading but do not decide it. Check the overlay, or give an approximate "
        "heading or a landmark."
    )  # fmt: skip


def _notes(belief, photos):
    notes = []
    if belief.tied:
        names = ", ".join(_name(photos[number]) for number in belief.tied[:MOST_NAMES])
        notes.append(Message("Features that it shares with {photos} helped to find the heading.", photos=names))
    if belief.by_compass:
        notes.append(
            Message(
                "The error of the compass that it shares with {count} photos of the same hour (such as {photo}) helped "
                "to find the heading.",
                count=len(belief.by_compass),
                photo=_name(photos[belief.by_compass[0]]),
            )
        )
    return tuple(notes)


def _name(photo):
    return photo.path.replace("\\", "/").rsplit("/", 1)[-1]
