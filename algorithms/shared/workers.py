"""Worker processes for photographs: their parameter, and the team that does the work."""

from __future__ import annotations

from contextlib import contextmanager

from . import parameters as shared
from .i18n import in_users_language, tr


def add_workers_parameter(algorithm):
    """Declare the number of worker processes."""
    text = tr(
        "Processes that work on different photographs at the same time, each with up to 700 MB of memory. 0: all cores "
        "but one, as far as memory allows. 1: no further process. The results are the same. If QGIS finds no Python "
        "interpreter to start, a warning says so and one process does the work."
    )
    algorithm.addParameter(
        shared.advanced(
            shared.number(
                "WORKERS", tr("Worker processes"), 0, text, minimum=0, maximum=256, optional=True, integer=True
            )
        )
    )


@contextmanager
def team_for(job, wanted, tasks, feedback):
    """Yield the `Team` for a number of tasks; its processes have ended when the block has.

    Parameters
    ----------
    job : callable
        See `core.workers.pool.Pool`.
    wanted : int
        Value of the parameter.
    tasks : int
    feedback : QgsProcessingFeedback
    """
    from ...core.workers.interpreter import worker_count
    from ...core.workers.team import Team

    with Team(job, worker_count(wanted, tasks)) as team:
        if team.note is not None:
            feedback.pushWarning(in_users_language(team.note))
        elif not team.alone:
            feedback.pushInfo(tr("{count} processes share the work.").format(count=team.count))
        yield team
