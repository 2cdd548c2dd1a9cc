"""Threads for work on large arrays, during which NumPy and GDAL release Python's lock.

A worker process uses one thread, because the workers already use all cores.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from typing import Any, Callable

from .progress import SILENT, Progress, checkpoint, subtask

MOST_THREADS = 4
"""Most threads at once: each needs memory, and memory is what more of them would wait for."""

INTERVAL_S = 0.1
"""How often the caller's progress is reported and asked for a cancel."""

_limit = [0]


def use_one_thread() -> None:
    """Let this process work in one thread from now on."""
    _limit[0] = 1


def thread_count() -> int:
    """Number of threads that this process may use: that of its cores, but at most `MOST_THREADS`."""
    if _limit[0]:
        return _limit[0]
    try:
        cores = len(os.sched_getaffinity(0))
    except AttributeError:  # Windows and macOS
        cores = os.cpu_count() or 1
    return min(cores, MOST_THREADS)


def side_by_side(tasks: Sequence[Callable[[Progress], Any]], progress: Progress = SILENT, threads: int = 0) -> None:
    """Run tasks in several threads, and return when all are done.

    Parameters
    ----------
    tasks : sequence of callables
        Each takes a `Progress`. They must not depend on one another's order.
    progress : Progress
        Only the calling thread reports to it.
    threads : int
        Number of threads; 0 takes `thread_count`, and 1 runs the tasks one after the other in the calling thread.

    Raises
    ------
    Cancelled
        When the user cancels; the threads have ended by then.
    Exception
        The first error of a task, when the threads have ended.
    """
    threads = min(threads or thread_count(), len(tasks))
    if threads <= 1:
        for done, task in enumerate(tasks):
            task(subtask(progress, done / len(tasks), (done + 1) / len(tasks)))
        return
    shares = [_Share() for _ in tasks]
    waiting = list(zip(tasks, shares))[::-1]
    errors: list[BaseException] = []

    def work() -> None:
        while waiting and not errors:
            try:
                task, share = waiting.pop()
            except IndexError:  # another thread was faster
                return
            try:
                task(share)
            except BaseException as error:  # the calling thread raises it
                errors.append(error)

    # Plain threads: the import of `concurrent.futures` takes longer than all else that this function does itself.
    crew = [threading.Thread(target=work) for _ in range(threads)]
    for thread in crew:
        thread.start()
    try:
        for thread in crew:
            while thread.is_alive() and not errors:
                thread.join(INTERVAL_S)
                checkpoint(progress, sum(share.fraction for share in shares) / len(shares))
        if not errors:
            checkpoint(progress, sum(share.fraction for share in shares) / len(shares))
    finally:
        waiting.clear()
        for share in shares:
            share.stop.set()
        for thread in crew:
            thread.join()
    if errors:
        raise errors[0]


class _Share:
    """The `Progress` of one task, read by the calling thread."""

    def __init__(self) -> None:
        self.fraction, self.stop = 0.0, threading.Event()

    def report(self, fraction: float) -> None:
        self.fraction = fraction

    def cancelled(self) -> bool:
        return self.stop.is_set()
