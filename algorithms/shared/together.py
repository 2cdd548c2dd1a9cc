"""The photographs of a walk, which help one another: parameter, and the order of the work."""

from __future__ import annotations

from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingParameterBoolean

from ...core.base.errors import Cancelled
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
        "contradict them. A compass never gives a heading by itself. More than 300 photos are solved in blocks of 300, "
        "in the order of the layer; photos of different blocks do not help one another. The paper method ignores this."
    )
    algorithm.addParameter(shared.advanced(shared.explained(parameter, text)))


def help_on_together():
    """Paragraph of the help of an algorithm with `JOINT`."""
    return tr(
        "Photographs taken near one another or with one camera help one another, so a photograph may get a different "
        "answer in a group than alone. To orient each one by itself, turn off <i>Orient the photos of a walk "
        "together</i> (Advanced)."
    )


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
    from ...core.many import JOINT_PART

    count, (start, stop) = len(requests), share
    middle = stop if count > BLOCK else start + JOINT_PART * (stop - start)
    after: Any = subtask(FeedbackProgress(told.feedback), middle, stop)
    if count > BLOCK:  # the orientation has the whole bar
        after = StillProgress(told.feedback)
    found = alone((start, middle, 1.0), workers)
    for first in range(0, count, BLOCK):
        last = first + BLOCK >= count
        # The processes that orient the next block live on.
        again = partial(_solved, job=job, told=told, progress=after, workers=workers if last else 1)
        yield from _block(requests[first : first + BLOCK], found, again, last)


def _block(requests, found, solved, last):
    """Solve the next photographs; none of them stays in memory when the next block begins."""
    photos = list(islice(found, BLOCK))
    if last:
        next(found, None)  # the loop behind it runs to its end, and its processes with it
    yield from solved(requests, photos)


def _solved(requests, photos, job, told, progress, workers):
    from ...core.many import outcomes_of, together_or_alone

    feedback, tasks = told.feedback, [(request, None) for request in requests]
    _tell(photos, feedback)
    orient_all = partial(outcomes_of, job, workers=workers)
    try:
        together, details = together_or_alone(tasks, photos, orient_all, progress, job.options)
    except Cancelled:
        feedback.pushWarning(tr("Cancelled while the photos were solved together."))
        raise
    if details is not None:
        feedback.pushDebugInfo(details)
        feedback.pushWarning(tr("The photos could not be solved together, so each keeps its own answer."))
    helped = [(before, now) for before, now in zip(photos, together) if before is not now]
    if helped:
        feedback.pushInfo(tr("{count} photos gained from their neighbours.").format(count=len(helped)))
    for before, now in helped:
        told.revise(Path(now.path).name, before.orientation, now.orientation)
    return together


def _tell(photos, feedback):
    """Say what happens now, and what is missing for it."""
    from ...core.joint.pairs import near_pairs
    from ...core.joint.ties import has_features

    feedback.setProgressText(tr("Photographs that help one another"))
    if not has_features() and near_pairs(photos):
        feedback.pushInfo(tr("Without OpenCV 4.4 or newer the photos are not compared by common features."))
