"""Reports of progress and requests to cancel, independent of the user interface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Protocol, Union, cast

from .errors import Cancelled


class Progress(Protocol):
    """Object to which a long computation reports, and from which it learns that the user cancels."""

    def report(self, fraction: float) -> None:
        """Report the fraction done, 0 to 1."""

    def cancelled(self) -> bool:
        """Tell whether the user has asked to stop."""


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
    """Convert what a caller has given to a `Progress`."""
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
    """Make a `Progress` for a part of the work.

    Parameters
    ----------
    progress : Progress
        Progress of the whole work.
    start, stop : float
        Fractions of the whole at which the part begins and ends, 0 to 1.
    """
    return _Subtask(progress, start, stop)


def checkpoint(progress: Progress, fraction: float) -> None:
    """Report `fraction` and raise `Cancelled` if the user has asked to stop."""
    if progress.cancelled():
        raise Cancelled
    progress.report(fraction)
