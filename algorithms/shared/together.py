"""The photographs of a walk, which help one another: parameter, and the order of the work."""

from __future__ import annotations

from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingParameterBoolean

from ...core.base.progress import subtask
from . import parameters as shared
from .feedback import FeedbackProgress, StillProgress
from .i18n import tr

BLOCK = 300
"""Photographs that are in memory at a time, about 3 MB each; those of different blocks do not help one another."""


def add_joint_parameter(algorithm):
    """Declare whether the photographs of a walk are oriented together."""
    parameter = QgsProcessingParameterBoolean("JOINT", tr("Orient the photos of a walk together"), True, optional=True)
    text = tr(
        "The photos help one another: by features in common within 200 m (needs OpenCV), by the error of the "
        "compass, which one device shares for an hour, and by the focal length of their lens. Probability, "
        "interval and status then hold for all photos together. Accepted answers stay unless the others "
        "contradict them. No compass gives a heading by itself. More than 300 photos are solved in blocks of 300."
    )
    algorithm.addParameter(shared.advanced(shared.explained(parameter, text)))


def are_together(joint, count, method):
    """Whether photographs are solved together; the published method gives no probabilities to do it with."""
    return joint and count > 1 and method != "paper"


def oriented_together(requests, job, alone, told, share, workers):
    """Orient photographs alone, then solve them together, block by block.

    Parameters
    ----------
    requests : list of PhotoRequest or None
    job : OrientJob
    alone : callable
        Share of the progress bar, workers -> iterator over the `OrientedPhoto` of each request.
    told : RunLog
    share : (float, float)
        Share of the progress bar.
    workers : int

    Yields
    ------
    OrientedPhoto
    """
    from ...core.many import JOINT_PART, look_again, outcomes_of

    feedback, (start, stop) = told.feedback, share
    middle = stop if len(requests) > BLOCK else start + JOINT_PART * (stop - start)
    after: Any = subtask(FeedbackProgress(feedback), middle, stop)
    if len(requests) > BLOCK:  # worker processes orient the next block meanwhile
        after = StillProgress(feedback)
    found = alone((start, middle, 1.0), workers)
    for first in range(0, len(requests), BLOCK):
        photos = list(islice(found, BLOCK))
        _tell(photos, feedback)
        tasks = [(request, None) for request in requests[first : first + BLOCK]]
        together = look_again(tasks, photos, partial(outcomes_of, job, workers=workers), after, job.options)
        helped = [(before, now) for before, now in zip(photos, together) if before is not now]
        if helped:
            feedback.pushInfo(tr("{count} photos gained from their neighbours.").format(count=len(helped)))
        for before, now in helped:
            told.revise(Path(now.path).name, before.orientation, now.orientation)
        yield from together
    next(found, None)  # the loop behind it runs to its end


def _tell(photos, feedback):
    """Say what happens now, and what is missing for it."""
    from ...core.joint.pairs import near_pairs
    from ...core.joint.ties import has_features

    feedback.setProgressText(tr("Photographs that help one another"))
    if not has_features() and near_pairs(photos):
        feedback.pushInfo(tr("Without OpenCV 4.4 or newer the photos are not compared by common features."))
