"""Progress and lines of text on a stream that may be a terminal, and the wish to stop by Ctrl+C."""

from __future__ import annotations

import time
from types import FrameType
from typing import TextIO


class Bar:
    """Progress on a terminal, and lines of text above it; lines alone where the stream is no terminal.

    Parameters
    ----------
    stream : text stream
    quiet : bool
        Say only what went wrong.
    """

    WIDTH, PAUSE_S = 30, 0.1

    def __init__(self, stream: TextIO, quiet: bool = False) -> None:
        self._stream, self._quiet, self._stop = stream, quiet, False
        self._shown = not quiet and stream.isatty()
        self._drawn, self._last_s, self.label = "", 0.0, ""

    def report(self, fraction: float) -> None:
        """Show how much is done, 0 to 1."""
        if self._shown and time.monotonic() - self._last_s > self.PAUSE_S:
            self._last_s = time.monotonic()
            full = round(self.WIDTH * min(max(fraction, 0.0), 1.0))
            self._draw(f"[{'#' * full}{'.' * (self.WIDTH - full)}] {100 * fraction:3.0f} % {self.label}"[:79])

    def cancelled(self) -> bool:
        """Tell whether the user has pressed Ctrl+C."""
        return self._stop

    def interrupt(self, number: int, frame: FrameType | None) -> None:
        """Stop at the next checkpoint; at once where the user insists."""
        if self._stop:
            raise KeyboardInterrupt
        self._stop = True

    def say(self, text: str, always: bool = False) -> None:
        """Print a line."""
        if always or not self._quiet:
            self.clear()
            self._stream.write(f"{text}\n")
            self._stream.flush()

    def clear(self) -> None:
        """Take the bar away."""
        self._draw("")

    def _draw(self, text: str) -> None:
        if text or self._drawn:
            over = " " * (len(self._drawn) - len(text))
            self._stream.write(f"\r{text}{over}" if text else f"\r{over}\r")
            self._stream.flush()
            self._drawn = text


class Quietly:
    """Passes on the wish to stop, and no progress."""

    def __init__(self, bar: Bar) -> None:
        self.cancelled = bar.cancelled

    def report(self, fraction: float) -> None:
        """Show nothing."""
