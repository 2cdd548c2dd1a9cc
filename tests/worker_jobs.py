"""Jobs that tests give to worker processes; each is found there by its name."""

from __future__ import annotations

import os
import signal
import time
from dataclasses import dataclass

import numpy as np
from skyline_viewshed.core.base.errors import UnreadablePhotoError
from skyline_viewshed.core.base.threads import thread_count


@dataclass(frozen=True)
class Squares:
    """Squares numbers, and does what strings ask for."""

    scale: float = 1.0

    def __call__(self):
        """Return the function of one task."""
        return self.work

    def work(self, task, progress):
        """Square a number or obey a word."""
        if not isinstance(task, str):
            return self.scale * np.square(task)
        if task == "die":
            os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))
        if task == "raise":
            raise UnreadablePhotoError("a.jpg", "why not")
        if task == "sleep":
            time.sleep(600)
        if task == "print":
            os.write(1, b"noise of a library\n")
            print("more of it", flush=True)
            return os.getpid()
        if task == "report":
            progress.report(0.5)
            time.sleep(0.5)
            return progress.cancelled()
        if task == "threads":
            return thread_count()
        if task == "pid":
            time.sleep(0.05)
            return os.getpid()
        return None


@dataclass(frozen=True)
class Refused:
    """A job that cannot be prepared anywhere but here."""

    pid: int

    def __call__(self):
        """Fail in another process."""
        if os.getpid() != self.pid:
            raise ValueError("only here")
        return lambda task, progress: task


@dataclass(frozen=True, eq=False)
class Deadly:
    """`core.many.OrientJob`, but one photograph kills the process that opens it."""

    dem: object
    options: object

    def __call__(self):
        """Return the function of one photograph."""
        from skyline_viewshed.core.many import OrientJob

        orient = OrientJob(self.dem, self.options)()

        def work(task, progress):
            if "deadly" in task[0].path:
                os.kill(os.getpid(), signal.SIGKILL)
            return orient(task, progress)

        return work


COUNTED = [0]


@dataclass(frozen=True, eq=False)
class Quick:
    """`core.many.OrientJob` without work: the heading is the number in the file's name."""

    dem: object
    options: object
    seconds: float = 0.0

    @staticmethod
    def done():
        """Photographs that this process has oriented."""
        return COUNTED[0]

    def __call__(self):
        """Return the function of one photograph."""
        return self.work

    def work(self, task, progress):
        """Give an accepted photograph, or die."""
        from skyline_viewshed.core.base.camera import Camera, Pose
        from skyline_viewshed.core.base.model import Candidate, Orientation, OrientedPhoto

        path = task[0].path
        if "deadly" in path:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(self.seconds)
        COUNTED[0] += 1
        camera = Camera(800, 600, 700.0)
        best = Candidate(Pose(float(os.path.basename(path).split(".")[0]), 0.0, 0.0), camera, 1.0)
        return OrientedPhoto(path, Orientation("accepted", "", (best,)), camera=camera)


@dataclass(frozen=True, eq=False)
class Hinted:
    """`core.many.OrientJob` without work: a photograph is accepted if its request gives a heading."""

    dem: object
    options: object

    @staticmethod
    def answer(path, heading_deg):
        """Give a photograph: accepted at a heading, with a second candidate beside it, or ambiguous at 200 degrees."""
        from skyline_viewshed.core.base.camera import Camera, Pose
        from skyline_viewshed.core.base.model import Candidate, Orientation, OrientedPhoto

        camera, status, certainty = Camera(800, 600, 700.0), "accepted", 0.98
        if heading_deg is None:
            heading_deg, status, certainty = 200.0, "ambiguous", 0.3
        found = tuple(
            Candidate(Pose(heading_deg + turn, 0.0, 0.0), camera, 1.0, share, 0.3)
            for turn, share in ((0.0, certainty), (0.2, 0.01))
        )
        return OrientedPhoto(path, Orientation(status, "", found, p_correct=certainty), camera=camera)

    def __call__(self):
        """Return the function of one photograph."""
        return self.work

    def work(self, task, progress):
        """Answer and report."""
        progress.report(0.5)
        return self.answer(task[0].path, task[0].heading_deg)


@dataclass(frozen=True)
class First:
    """A job that only the process that comes first accepts."""

    marker: str

    def __call__(self):
        """Return the function of one task, which passes it on slowly."""
        os.close(os.open(self.marker, os.O_CREAT | os.O_EXCL))

        def work(task, progress):
            time.sleep(0.3)
            return task

        return work


class Silence:
    """A progress that says nothing and goes on."""

    def report(self, fraction):
        """Say nothing."""

    def cancelled(self):
        """Go on."""
        return False
