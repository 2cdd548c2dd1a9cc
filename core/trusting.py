"""Try the compasses of a run on a sample of its photographs, before all of them use what their devices recorded.

The sample is oriented as all photographs are. A device whose readings contradict the skylines gets a larger share of
worthless readings for the whole run (`joint.trust`); without such a device the answers of the sample stay.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .base.progress import SILENT, subtask
from .io.local_copy import local_copy
from .io.photo import read_metadata
from .joint.trust import FEWEST_READINGS, shares_of
from .match.prior import CompassOptions, compass_prior, log_ratio

SAMPLE = 8
"""Photographs of a device that try its compass."""

MOST_READ = 60
"""Files whose metadata are read to find the devices of a run."""


def sample_of(tasks, options):
    """Choose the photographs that try the compasses of their devices.

    Parameters
    ----------
    tasks : list of (PhotoRequest or None, Photo or None)
    options : OrientOptions

    Returns
    -------
    list of int
        Numbers of the tasks, spread over the run, ascending; none if the compass is not used or was tried before.
    """
    if options.compass != "prior" or options.method == "paper" or options.compass_shares:
        return []
    found: dict = {}
    for number in _spread(len(tasks))[:MOST_READ]:
        device = _device(*tasks[number])
        if device is not None:
            found.setdefault(device, []).append(number)
    enough = (numbers[:SAMPLE] for numbers in found.values() if len(numbers) >= FEWEST_READINGS)
    return sorted(number for numbers in enough for number in numbers)


def with_trust(job, tasks, orient_all, progress=SILENT):
    """Try the compasses on a sample.

    Parameters
    ----------
    job : OrientJob
    tasks : list of (PhotoRequest, Photo or None)
    orient_all : callable
        See `cluster.spread_over`.
    progress : Progress

    Returns
    -------
    job : OrientJob
        The same, or with the shares of devices whose compasses are worse than usual.
    known : dict of int to Outcome
        The sample's, by the number of the task, as far as they still hold.
    """
    return _tried(job, tasks, sample_of(tasks, job.options), orient_all, progress)


def trusting(options, photos):
    """`OrientOptions` with what oriented photographs tell of the compasses of their devices."""
    return replace(options, compass_shares=shares_of(photos, _density, CompassOptions().outlier_share))


def _density(reading_deg, heading_deg):
    """Density of the heading over the uniform one, as a compass counts that was not tried yet."""
    return np.exp(log_ratio(compass_prior(reading_deg), heading_deg))


def trusted_outcomes(job, tasks, orient_all, progress=SILENT):
    """Orient photographs with as much trust in the compass of each device as a sample of them justifies.

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
    share = len(sample) / max(len(tasks), 1)
    job, known = _tried(job, tasks, sample, orient_all, subtask(progress, 0.0, share))
    rest = [task for number, task in enumerate(tasks) if number not in known]
    fresh = orient_all(job, rest, subtask(progress, share if rest else 0.0, 1.0))
    return job, (known[number] if number in known else next(fresh) for number in range(len(tasks)))


def _tried(job, tasks, sample, orient_all, progress):
    if not sample:
        return job, {}
    outcomes = list(orient_all(job, [tasks[number] for number in sample], progress))
    options = trusting(job.options, [outcome.value for outcome in outcomes if outcome.error is None])
    if options == job.options:
        return job, dict(zip(sample, outcomes))
    return replace(job, options=options), {}


def _spread(count):
    """Numbers below `count` in van der Corput's order, whose beginning always covers the whole evenly."""
    digits = max(count - 1, 1).bit_length()
    order = (int(f"{number:0{digits}b}"[::-1], 2) for number in range(1 << digits))
    return [number for number in order if number < count]


def _device(request, photo):
    """Camera of a photograph whose compass would be used; None if there is none."""
    if request is None or request.heading_deg is not None:
        return None
    try:
        if photo is not None:
            metadata = photo.metadata
        else:
            with local_copy(request.path) as path:
                metadata = read_metadata(path)
    except Exception:  # whatever is wrong with it is told when its turn comes
        return None
    return metadata.camera if metadata.compass_heading_deg is not None else None
