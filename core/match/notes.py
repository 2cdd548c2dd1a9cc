"""Sentences that a match gives beside its verdict: refusals, objections and remarks."""

from __future__ import annotations

import numpy as np

from ..base.messages import Message
from .finding import explained
from .geometry import horizon_rows
from .likelihood import EvidenceStack

HINT_MESSAGE = Message(
    "The skyline does not decide the heading, so the approximate heading is given back. Check the overlay, or give a "
    "landmark, a drawn skyline or a sky mask."
)

MIRROR_MESSAGE = Message(
    "The mirror image of the photo fits the DEM better than the photo itself. If it was flipped (a slide scanned from "
    "the wrong side), flip it back and run again; else check the overlay."
)

BEHIND_NOTE = Message(
    "According to the DEM, the most distinct line in the picture is a nearby crest; the fainter line "
    "behind it was used as the skyline."
)

LEAST_COLUMNS_SHARE = 0.05
"""Smallest share of columns with evidence for which a search is made."""


def refusal(evidence, horizon, landmarks):
    """Message with the reason why no match is possible, or None.

    Parameters
    ----------
    evidence : SkylineEvidence
    horizon : HorizonProfile
    landmarks : tuple of Landmark
        With them a picture without a skyline may be matched.
    """
    width = evidence.probability.shape[1]
    telling = len(EvidenceStack.informative_columns(evidence.probability))
    if telling < LEAST_COLUMNS_SHARE * width and not landmarks:
        return Message(
            "Hardly any column of the picture shows a boundary between sky and terrain. Use a photo with a skyline, "
            "or supply a sky mask or a drawn skyline."
        )
    if not np.isfinite(horizon.elevation_deg).any():
        return Message("The DEM has no terrain around this position. Use a DEM that reaches farther.")
    return None


def edge_notes(answers, status):
    """Note for a frame in which much of the horizon is only a lower bound.

    If the answer is accepted, columns in which the picture agrees with that horizon do not count: higher terrain beyond
    the DEM's edge would stand above it in the picture.
    """
    objective, trial = answers.objective, answers.trials[:1]
    columns = objective.columns(4)
    _, azimuth, _ = horizon_rows(objective.curve, objective.camera, trial, columns)
    open_ended = objective.curve.clipped[objective.curve.nearest(azimuth[0])]
    if status == "accepted":
        open_ended = open_ended & ~explained(objective, trial, columns)
    share = float(open_ended.mean())
    if share < 0.2:
        return ()
    note = Message(
        "In {share} % of the frame the DEM ends or has voids before higher terrain can be ruled out. Use "
        "a larger DEM to make the heading more certain.",
        share=f"{100 * share:.0f}",
    )
    return (note,)


def compass_note(status, objection, recorded_heading_deg):
    """Note that a compass heading might decide what the picture leaves open, unless the message says so already.

    Parameters
    ----------
    status : str
    objection : Message or None
        Why an acceptance was taken back.
    recorded_heading_deg : float or None
        Compass heading that took no part [degrees].
    """
    if status == "accepted" or objection or recorded_heading_deg is None:
        return ()
    note = Message(
        "The photo's compass says {heading} degrees and took no part. If you trust it, use it as a hint (COMPASS).",
        heading=f"{recorded_heading_deg:.0f}",
    )
    return (note,)
