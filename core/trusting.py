"""Test the compasses of a run on a sample of its photographs before all photographs use them.

The sample is oriented as all photographs are. A camera whose readings contradict the skylines gets a larger share of
worthless readings for the whole run (`joint.trust`). If there is no such camera, the answers of the sample stay.
"""

from __future__ import annotations

import hashlib
from dataclasses import replace
from itertools import islice
from pathlib import Path

import numpy as np

from .base.progress import SILENT, subtask
from .io.compass_shares import read_shares, write_shares
from .io.local_copy import local_copy
from .io.orientation_file import orientation_mark
from .io.photo import read_metadata
from .joint.trust import FEWEST_READINGS, shares_of
from .match.prior import CompassOptions, compass_prior, log_ratio

SAMPLE = 8
"""Largest number of photographs of a camera in the sample."""

MOST_READ = 60
"""Files whose metadata are read to find the cameras of a run."""


def sample_of(tasks, options):
    """Choose the photographs on which the compasses of their cameras are tested.

    Parameters
    ----------
    tasks : list of (PhotoRequest or None, Photo or None)
    options : OrientOptions

    Returns
    -------
    list of int
        Numbers of the tasks, spread over the run, ascending; none if the compass is not used or was tested before.
    """
    if options.compass != "prior" or options.method == "paper" or options.compass_shares:
        return []
    found: dict = {}
    for number in islice(_spread(len(tasks)), MOST_READ):
        camera = _camera(*tasks[number])
        if camera is not None:
            found.setdefault(camera, []).append(number)
    enough = (numbers[:SAMPLE] for numbers in found.values() if len(numbers) >= FEWEST_READINGS)
    return sorted(number for numbers in enough for number in numbers)


def with_trust(job, tasks, orient_all, progress=SILENT, folder=None):
    """Test the compasses on a sample.

    Parameters
    ----------
    job : OrientJob
    tasks : list of (PhotoRequest or None, Photo or None)
    orient_all : callable
        See `cluster.spread_over`.
    progress : Progress
    folder : str, Path or None
        Keeps the result of the test, by the fingerprint of the sample; needs photographs and a DEM in files.

    Returns
    -------
    job : OrientJob
        The same, or with the shares of cameras whose compasses are worse than usual.
    known : dict of int to Outcome
        The sample's, by the number of the task, as far as they still hold.

    Raises
    ------
    OutputError
        The folder cannot be written.
    """
    return _tested(job, tasks, sample_of(tasks, job.options), orient_all, progress, folder)


def trusted_outcomes(job, tasks, orient_all, progress=SILENT):
    """Orient photographs with as much trust in the compass of each camera as a sample of them justifies.

    Parameters
    ----------
    job, tasks, orient_all, progress
        As for `with_trust`.

    Returns
    -------
    job : OrientJob
        As used.
    outcomes : iterator of Outcome
        In order.
    """
    sample = sample_of(tasks, job.options)
    share = len(sample) / max(len(sample) + len(tasks), 1)
    job, known = _tested(job, tasks, sample, orient_all, subtask(progress, 0.0, share))
    rest = [task for number, task in enumerate(tasks) if number not in known]
    fresh = orient_all(job, rest, subtask(progress, share, 1.0))
    return job, (known.pop(number) if number in known else next(fresh) for number in range(len(tasks)))


# parameters: the run, and the sample of it
def _tested(job, tasks, sample, orient_all, progress, folder=None):
    if not sample:
        return job, {}
    path = None if folder is None else _path(folder, [tasks[number][0] for number in sample], job)
    shares, known = None if path is None else read_shares(path), {}
    if shares is None:
        outcomes = list(orient_all(job, [tasks[number] for number in sample], progress))
        photos = [outcome.value for outcome in outcomes if outcome.error is None]
        shares = shares_of(photos, _density, CompassOptions().outlier_share)
        known = {} if shares else dict(zip(sample, outcomes))
        if path is not None:
            write_shares(path, shares)
    return replace(job, options=replace(job.options, compass_shares=shares)), known


def _path(folder, requests, job):
    marks = "".join(orientation_mark(request, job.dem, job.options) for request in requests)
    return Path(folder) / f"compasses-{hashlib.sha256(marks.encode()).hexdigest()[:16]}.json"


def _density(reading_deg, heading_deg):
    """Density of the heading over the uniform one, under the default `CompassOptions`."""
    return np.exp(log_ratio(compass_prior(reading_deg), heading_deg))


def _spread(count):
    """Yield the numbers below `count` in van der Corput's order, whose beginning covers the whole evenly."""
    digits = max(count - 1, 1).bit_length()
    for number in range(1 << digits):
        turned = int(f"{number:0{digits}b}"[::-1], 2)
        if turned < count:
            yield turned


def _camera(request, photo):
    """Camera of a photograph whose compass would be used; None if there is none."""
    if request is None or request.heading_deg is not None:
        return None
    try:
        if photo is not None:
            metadata = photo.metadata
        else:
            with local_copy(request.path) as path:
                metadata = read_metadata(path)
    except Exception:  # the run reports what is wrong with it when it reaches the photograph
        return None
    return metadata.camera if metadata.compass_heading_deg is not None else None
