"""What the log says of a run that orients photographs: each answer, the time left, and at the end the doubtful ones."""

from __future__ import annotations

import time

from ...core.base.status import RELIABLE
from .feedback import announce, warn
from .i18n import marked, tr

MOST_NAMED = 50


class RunLog:
    """The log of one run.

    Parameters
    ----------
    feedback : QgsProcessingFeedback
    count : int
        Number of photographs.
    clock : callable
        Returns seconds.
    """

    def __init__(self, feedback, count, clock=time.monotonic):
        self.feedback, self.count, self.clock = feedback, count, clock
        self._began, self._done, self._doubtful = clock(), 0, {}

    def start(self, name):
        """Announce the next photograph, with the time left, judged by the photographs done."""
        left = ""
        if self._done:
            seconds = (self.clock() - self._began) / self._done * (self.count - self._done)
            left = time_left(seconds)
        announce(self.feedback, name, self._done, self.count, left)

    def answer(self, name, orientation):
        """Name the photograph with its verdict and heading."""
        from ...core.report.facts import status_word

        self._done += 1
        verdict = status_word(orientation.status, marked)
        if orientation.best is not None:
            heading = orientation.best.pose.heading_deg
            text = tr("{name}: {verdict}, heading {heading}°")
            self.feedback.pushInfo(text.format(name=name, verdict=verdict, heading=f"{round(heading, 1) % 360:.1f}"))
        if orientation.status not in RELIABLE:
            self._doubtful.setdefault(verdict, []).append(name)
        if orientation.status in ("failed", "rejected"):
            warn(self.feedback, name, orientation.message)

    def revise(self, name, before, orientation):
        """Replace the answer of a photograph by a better one; `before` is the `Orientation` that was told first."""
        from ...core.report.facts import status_word

        if before.status not in RELIABLE:
            self._doubtful[status_word(before.status, marked)].remove(name)
        self._done -= 1
        self.answer(name, orientation)

    def end(self):
        """Name the photographs that a person should check, by verdict."""
        for verdict, names in self._doubtful.items():
            if not names:
                continue
            listed = ", ".join(names[:MOST_NAMED])
            if len(names) > MOST_NAMED:
                listed = tr("{names} and {count} more").format(names=listed, count=len(names) - MOST_NAMED)
            self.feedback.pushInfo(tr("Check these photos ({verdict}): {names}").format(verdict=verdict, names=listed))


def time_left(seconds):
    """The time left in words, as coarse as it is known."""
    if seconds < 90:
        return tr("about {seconds} s left").format(seconds=max(round(seconds / 5) * 5, 5))
    if seconds < 5400:
        return tr("about {minutes} min left").format(minutes=round(seconds / 60))
    return tr("about {hours} h left").format(hours=f"{seconds / 3600:.1f}")
