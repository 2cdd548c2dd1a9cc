"""Worker processes that share the photographs of a run, inside QGIS and outside, on Linux, Windows and macOS.

Python's own pools import the main program again in each worker, which is QGIS or a script without a guard, and end as a
whole, or wait for ever, if one process dies. Here a worker is a plain Python process that is started like any other
program. It ends when its pipe does, so that none outlives the run, however the run ends; and if one dies, only the
photograph that it worked on is lost.
"""

from __future__ import annotations

import queue
from collections import deque
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from ..base.errors import Cancelled, PhotoError
from ..base.messages import Message
from .interpreter import interpreters
from .process import Worker, end
from .wire import send

START_S = 60.0
"""A process that has not answered by then does not become a worker; a cold start from a slow disk takes 20 s."""

PATIENCE_S = 0.1
"""How often a waiting pool looks whether the user has cancelled."""

IN_HAND = 2
"""Tasks that a worker holds: one that it computes and the next, so that it need not wait for the pool."""

AHEAD = 4
"""Results per worker that may wait for an earlier photograph, so that memory is bounded."""

MOST_FAILED_STARTS = 3
"""Processes that may die before they are ready; then no more are started."""

LOST = Message(
    "The process that worked on this photo ended unexpectedly, perhaps because memory ran out. Run this photo again by "
    "itself, or set a smaller number of worker processes."
)


class NoWorkersError(Exception):
    """No worker could be started; the work can be done in this process."""


class WorkerLostError(PhotoError):
    """The process that had the task ended without an answer."""


@dataclass(frozen=True)
class Outcome:
    """What became of one task: its result, or the exception that it raised, with the text of its traceback."""

    value: Any = None
    error: BaseException | None = None
    details: str = ""

    def result(self):
        """Return the result or raise the exception."""
        if self.error is not None:
            raise self.error
        return self.value


class Pool:
    """Processes that do tasks in any order and give the results in the tasks' order; a context manager.

    Parameters
    ----------
    job : callable
        Picklable; called once in each worker without arguments, and gives the function of (argument, progress) that
        does a task there.
    count : int
        Number of processes.

    Raises
    ------
    NoWorkersError
        By `__enter__`: no Python was found, or the job cannot be prepared in another process.
    """

    def __init__(self, job, count):
        self.job, self.count, self.command = job, count, None
        self._inbox: Any = queue.Queue()
        self._workers: list = []

    def __enter__(self):
        reason = "no Python interpreter was found"
        for command in interpreters():
            worker = None
            try:
                worker = self._started(command)
                kind, _, error, _ = worker.first(START_S)
            except (OSError, EOFError, queue.Empty):
                reason = f"{command} cannot load the program"
                end([worker])
                continue
            if kind == "ready":
                self.command = command
                self._workers = [worker, *(self._started(command) for _ in range(self.count - 1))]
                return self
            end([worker])
            raise NoWorkersError(str(error))
        raise NoWorkersError(reason)

    def __exit__(self, *failure):
        end(self._workers)
        self._workers = []

    def map(self, arguments, progress, keys=None):
        """Yield an `Outcome` for each argument, in order.

        Parameters
        ----------
        arguments : sequence
            Picklable.
        progress : Progress
            Of all tasks together.
        keys : sequence or None
            Tasks of equal keys go to one worker where that costs nothing, because they share what it has computed.
            None in a task's place means that it shares nothing.

        Raises
        ------
        Cancelled
            The user has cancelled; the workers have ended.
        """
        run = _Run(self, arguments, keys or [None] * len(arguments))
        try:
            for index in range(len(arguments)):
                run.take_in(0.0)
                while index not in run.found:
                    if progress.cancelled():
                        raise Cancelled
                    run.hand_out(index)
                    run.take_in(PATIENCE_S)
                    progress.report(run.fraction())
                run.hand_out(index + 1)
                yield run.found.pop(index)
        except BaseException:
            self.__exit__()
            raise

    def _started(self, command):
        return Worker(command, self.job, self._inbox)


class _Run:
    """The tasks of one call of `Pool.map`, and who has them."""

    def __init__(self, pool, arguments, keys):
        self.pool, self.arguments, self.keys = pool, arguments, keys
        self.waiting, self.found, self.finished = deque(range(len(arguments))), {}, 0
        self.partly, self.failed_starts = {}, 0

    def fraction(self):
        """Part of the whole that is done."""
        return (self.finished + sum(self.partly.values())) / max(len(self.arguments), 1)

    def hand_out(self, wanted):
        """Give tasks to workers that have room, but none far ahead of the one that the caller waits for."""
        last = wanted + AHEAD * self.pool.count
        for held in range(IN_HAND):
            for worker in self.pool._workers:
                if len(worker.tasks) == held and self.waiting and self.waiting[0] < last:
                    self._give(worker, self._choice(worker, last))

    def _choice(self, worker, last):
        """Index of a worker's next task: of its own station, else of one that no other works on, else the first."""
        near = [index for index in self.waiting if index < last]
        others = {other.key for other in self.pool._workers if other is not worker and other.key is not None}
        own = [index for index in near if self.keys[index] is not None and self.keys[index] == worker.key]
        free = [index for index in near if self.keys[index] not in others]
        return (own or free or near)[0]

    def _give(self, worker, index):
        self.waiting.remove(index)
        worker.tasks.append(index)
        worker.key = self.keys[index]
        with suppress(OSError):  # its end is reported by its reader
            send(worker.process.stdin, (index, self.arguments[index]))

    def take_in(self, patience_s):
        """Handle the messages that have come, waiting up to `patience_s` for the first one."""
        with suppress(queue.Empty):
            self._hear(*self.pool._inbox.get(timeout=patience_s) if patience_s else self.pool._inbox.get_nowait())
            while True:
                self._hear(*self.pool._inbox.get_nowait())

    def _hear(self, worker, message):
        if message is None:
            self._bury(worker)
        elif message[0] == "progress":
            self.partly[message[1]] = message[2]
        elif message[0] == "done":
            self._note(worker.tasks.popleft(), Outcome(message[2]))
        else:
            error = message[2]
            self._note(worker.tasks.popleft(), Outcome(error=error, details=getattr(error, "details", "")))

    def _note(self, index, outcome):
        self.found[index] = outcome
        self.finished += 1
        self.partly.pop(index, None)

    def _bury(self, worker):
        """Replace a worker that has died: the task in its hands is lost, the one behind it goes back."""
        if worker not in self.pool._workers:
            return
        end([worker])
        self.pool._workers.remove(worker)
        if worker.started and worker.tasks:
            self._note(worker.tasks.popleft(), _lost(worker))
        self.waiting.extendleft(reversed(worker.tasks))
        self.failed_starts += not worker.started
        if self.failed_starts < MOST_FAILED_STARTS:
            with suppress(OSError):
                self.pool._workers.append(self.pool._started(self.pool.command))
        if not self.pool._workers:  # no process can be started any more
            while self.waiting:
                self._note(self.waiting.popleft(), _lost(worker))


def _lost(worker):
    return Outcome(error=WorkerLostError(LOST), details=f"exit code {worker.process.returncode}")
