"""Tasks done by a pool of processes, or by this process where one suffices or none can be started."""

from __future__ import annotations

from typing import Any

from ..base.errors import Cancelled
from ..base.messages import Message
from .pool import NoWorkersError, Outcome, Pool


class Team:
    """Does a list of tasks in order; a context manager.

    Parameters
    ----------
    job : callable
        See `Pool`. In this process it may hold what cannot be pickled.
    count : int
        Number of processes; 1 means this one.

    Attributes
    ----------
    note : Message or None
        Why this process does the work although others were asked for.
    alone : bool
        Whether this process does the work.
    """

    def __init__(self, job, count):
        self.job, self.count, self.note = job, count, None
        self._pool: Any = None
        self._results: Any = None
        self.alone = count <= 1

    def __enter__(self):
        if not self.alone:
            try:
                self._pool = Pool(self.job, self.count).__enter__()
            except NoWorkersError as error:
                self.alone = True
                self.note = Message(
                    "No worker processes could be started ({reason}), so one process does all the work.", reason=error
                )
        return self

    def __exit__(self, *failure):
        if self._pool is not None:
            self._pool.__exit__(*failure)

    def begin(self, arguments, progress, keys=None):
        """Hand over the tasks, whose outcomes `take` then gives one by one.

        Parameters
        ----------
        arguments, progress, keys
            As for `Pool.map`.
        """
        self._results = self._here(arguments) if self.alone else self._pool.map(arguments, progress, keys)

    def take(self, part):
        """Give the `Outcome` of the next task; `part` is its `Progress` where this process does it.

        Raises
        ------
        Cancelled
        """
        self._part = part
        return next(self._results)

    def _here(self, arguments):
        work = self.job()
        for argument in arguments:
            if self._part.cancelled():
                raise Cancelled
            try:
                outcome = Outcome(work(argument, self._part))
            except Exception as error:
                outcome = Outcome(error=error)
            yield outcome
