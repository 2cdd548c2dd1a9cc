"""An adapter from QGIS's feedback to the core's Progress."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .i18n import in_users_language, tr


@dataclass(frozen=True)
class FeedbackProgress:
    """Pass progress on to a `QgsProcessingFeedback`, and cancellation back to the core."""

    feedback: Any

    def report(self, fraction):
        """Move the bar; `fraction` is 0 to 1."""
        self.feedback.setProgress(100.0 * fraction)

    def cancelled(self):
        """Return whether the user pressed Cancel."""
        return self.feedback.isCanceled()


@dataclass(frozen=True)
class StillProgress:
    """Progress of work that has no share of the bar: it moves nothing, but can be cancelled."""

    feedback: Any

    def report(self, fraction):
        """Leave the bar where it is."""

    def cancelled(self):
        """Return whether the user pressed Cancel."""
        return self.feedback.isCanceled()


def announce(feedback, name, index, count, left=""):
    """Report which photo or point is being processed, and the time left if it is known."""
    place = tr("{name} ({number}/{count})").format(name=name, number=index + 1, count=count)
    feedback.setProgressText(f"{place}, {left}" if left else place)


def warn(feedback, name, message):
    """Warn that one photo or point has a fault while the batch continues.

    `message` is translated if it is a `Message`.
    """
    feedback.pushWarning(f"{name}: {in_users_language(message)}")
