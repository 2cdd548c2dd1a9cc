"""Work in the background: a lane is one thread, and its results arrive in the thread that made it."""

from __future__ import annotations

import heapq
import itertools
import threading

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...core.base.errors import Cancelled
from .faults import sentence_of


class Job:
    """One piece of work; it is also the core's `Progress`, through which outdated work is cancelled."""

    def __init__(self, key, work, done, failed):
        self.key, self.work, self.done, self.failed = key, work, done, failed
        self.stale, self.result, self.fault = False, None, None

    def report(self, fraction):
        """Take the progress; no bar shows it."""

    def cancelled(self):
        """Return whether a newer job has replaced this one."""
        return self.stale

    def run(self):
        """Do the work; what goes wrong becomes a sentence."""
        try:
            self.result = self.work(self)
        except Cancelled:
            self.stale = True
        except Exception as error:
            self.fault = sentence_of(error)

    def deliver(self):
        """Give the result, or the sentence of the fault, to whoever asked for it."""
        if self.fault is None:
            self.fault = _fault_of(self.done, self.result)
        if self.fault is not None and self.failed is not None:
            _fault_of(self.failed, self.fault)


def _fault_of(take, value):
    try:
        take(value)
    except Exception as error:
        return sentence_of(error)
    return None


class Lane(QObject):
    """Does one job after another, the most urgent first; a newer job of the same key replaces an older one."""

    _finished = pyqtSignal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._waiting, self._count, self._latest = [], itertools.count(), {}
        self._changed, self._running, self._stopped = threading.Condition(), None, False
        self._finished.connect(self._deliver)
        self._thread = threading.Thread(target=self._go, daemon=True)
        self._thread.start()

    def submit(self, key, work, done, failed=None, urgency=1):
        """Have `work(progress)` done and its result given to `done`, or the sentence of its fault to `failed`.

        Parameters
        ----------
        key : hashable
            Jobs of one key replace one another.
        work, done, failed : callable
        urgency : int
            0 comes first.
        """
        job = Job(key, work, done, failed)
        with self._changed:
            self._outdate(key)
            self._latest[key] = job
            heapq.heappush(self._waiting, (urgency, next(self._count), job))
            self._changed.notify()

    def cancel(self, key=None):
        """Forget the job of a key, or all jobs."""
        with self._changed:
            for known in [key] if key is not None else list(self._latest):
                self._outdate(known)

    def busy(self):
        """Return whether jobs are waiting, running or not yet delivered."""
        with self._changed:
            return bool(self._latest)

    def stop(self):
        """End the thread once its present job is done."""
        self.cancel()
        with self._changed:
            self._stopped = True
            self._changed.notify()

    def _outdate(self, key):
        job = self._latest.pop(key, None)
        if job is not None:
            job.stale = True

    def _go(self):
        while True:
            with self._changed:
                while not self._waiting and not self._stopped:
                    self._changed.wait()
                if self._stopped:
                    return
                job = heapq.heappop(self._waiting)[2]
            if job.stale:
                continue
            job.run()
            with self._changed:
                if self._stopped:
                    return
            self._finished.emit(job)

    def _deliver(self, job):
        with self._changed:
            if job.stale or id(self._latest.get(job.key)) != id(job):
                return
            del self._latest[job.key]
        job.deliver()
