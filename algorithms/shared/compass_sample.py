"""The sample of a layer's photographs on which the compasses of their cameras are tested."""

from __future__ import annotations

from pathlib import Path

from ...core.base.errors import Cancelled
from .feedback import StillProgress, announce
from .i18n import tr
from .workers import team_for


def compass_tested(requests, job, folder, feedback, workers):
    """Orient a sample of the photographs, if the compass is used, and find how far each camera's can be trusted.

    Parameters
    ----------
    requests : list of PhotoRequest or None
    job : OrientJob
    folder : str
        Keeps the result of the test; see `KeptOrientations`. Empty if not requested.
    feedback : QgsProcessingFeedback
    workers : int

    Returns
    -------
    job : OrientJob
        The same, or one that trusts some compasses less.
    known : dict of int to OrientedPhoto
        Answers of the sample that still hold, by the number of the request.
    """
    from ...core.many import station_of
    from ...core.trusting import with_trust

    def orient_all(job, tasks, progress):
        text = tr("{count} photos are oriented first to test the compasses of the cameras.")
        feedback.pushInfo(text.format(count=len(tasks)))
        with team_for(job, workers, len(tasks), feedback) as team:
            team.begin(tasks, progress, [station_of(request) for request, _ in tasks])
            for index, (request, _) in enumerate(tasks):
                announce(feedback, Path(request.path).name, index, len(tasks))
                yield team.take(progress)

    tasks = [(request, None) for request in requests]
    try:
        job, known = with_trust(job, tasks, orient_all, StillProgress(feedback), folder or None)
    except Cancelled:
        feedback.pushWarning(tr("Cancelled after {done} of {count} photos.").format(done=0, count=len(requests)))
        raise
    for camera, share in job.options.compass_shares:
        text = tr(
            "{camera}: about {percent} % of the compass readings are treated as worthless, because they contradict "
            "the skylines."
        )
        feedback.pushWarning(text.format(camera=camera, percent=round(100 * share)))
    # The run itself tells what is wrong with the others.
    return job, {number: outcome.value for number, outcome in known.items() if outcome.error is None}
