"""The sample of a layer's photographs that tries the compasses of their cameras."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ...core.base.errors import OutputError, TerrainError
from .feedback import StillProgress, announce
from .i18n import tr
from .kept_orientations import KeptOrientations
from .workers import team_for


def compass_tried(requests, job, folder, feedback, workers):
    """Orient a sample of the photographs, if the compass is used, and see how far each camera's can be trusted.

    Parameters
    ----------
    requests : list of PhotoRequest or None
    job : OrientJob
    folder : str
        See `KeptOrientations`.
    feedback : QgsProcessingFeedback
    workers : int

    Returns
    -------
    job : OrientJob
        The same, or one that trusts some compasses less.
    known : dict of int to OrientedPhoto
        Answers of the sample that still hold, by the `id` of the request.
    """
    from ...core.many import station_of
    from ...core.trusting import sample_of, trusting

    numbers = sample_of([(request, None) for request in requests], job.options)
    if not numbers:
        return job, {}
    feedback.pushInfo(tr("{count} photos try the compass of each camera first.").format(count=len(numbers)))
    kept, sample, known = KeptOrientations(folder, feedback), [requests[number] for number in numbers], {}
    progress = StillProgress(feedback)
    absent = {id(r) for r in requests if r is not None and kept.is_missing(r, job.dem, job.options)}
    missing = [request for request in sample if id(request) in absent]
    with team_for(job, workers, len(missing), feedback) as team:
        team.begin([(request, None) for request in missing], progress, [station_of(request) for request in missing])
        for index, request in enumerate(sample):
            announce(feedback, Path(request.path).name, index, len(sample))
            try:
                known[id(request)] = kept.orient(request, team, progress)
            except (TerrainError, OutputError):
                raise
            except Exception:  # told when the photograph's turn comes
                continue
    options = trusting(job.options, known.values())
    if options == job.options:
        return job, known
    for camera, share in options.compass_shares:
        text = tr(
            "The compass of {camera} contradicts the skylines: about {percent} % of its readings count as worthless."
        )
        feedback.pushWarning(text.format(camera=camera, percent=round(100 * share)))
    return replace(job, options=options), {}
