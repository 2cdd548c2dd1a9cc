"""Progress and cancelling, without knowing who listens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Protocol, Union, cast

from .errors import Cancelled


class Progress(Protocol):
    """What a long computation talks to."""

    def report(self, fraction: float) -> None:
        """Say how much is done, 0 to 1."""

    def cancelled(self) -> bool:
        """Tell whether the user wants to stop."""


class _Silent:
    def report(self, fraction: float) -> None:
        pass

    def cancelled(self) -> bool:
        return False


SILENT: Progress = _Silent()


ProgressLike = Union[Progress, Callable[[float], Any], None]
"""An object with `report` and `cancelled`, a function of the fraction done, or nothing."""


@dataclass(frozen=True)
class _Function:
    function: Callable[[float], Any]

    def report(self, fraction: float) -> None:
        self.function(fraction)

    def cancelled(self) -> bool:
        return False


def as_progress(progress: ProgressLike) -> Progress:
    """Make a `Progress` of whatever a caller has given."""
    if progress is None:
        return SILENT
    return cast(Progress, progress) if hasattr(progress, "report") else _Function(progress)


@dataclass(frozen=True)
class _Subtask:
    parent: Progress
    start: float
    stop: float

    def report(self, fraction: float) -> None:
        self.parent.report(self.start + (self.stop - self.start) * fraction)

    def cancelled(self) -> bool:
        return self.parent.cancelled()


def subtask(progress: Progress, start: float, stop: float) -> Progress:
    """Give a part of the work its share of the bar.

    Parameters
    ----------
    progress : Progress
        Of the whole work.
    start, stop : float
        Where the part begins and ends, 0 to 1.
    """
    return _Subtask(progress, start, stop)


def checkpoint(progress: Progress, fraction: float) -> None:
    """Report `fraction` and raise `Cancelled` when the user has asked to stop."""
    if progress.cancelled():
        raise Cancelled
    progress.report(fraction)
