"""Progress bar and lines of text on a stream that may be a terminal, and cancelling by Ctrl+C."""

from __future__ import annotations

import time
from types import FrameType
from typing import TextIO


class Bar:
    """Progress bar on a terminal, with lines of text above it; only the lines if the stream is not a terminal.

    Parameters
    ----------
    stream : text stream
    quiet : bool
        Print errors only.
    """

    WIDTH, PAUSE_S = 30, 0.1

    def __init__(self, stream: TextIO, quiet: bool = False) -> None:
        self._stream, self._quiet, self._stop = stream, quiet, False
        self._shown = not quiet and stream.isatty()
        self._drawn, self._last_s, self.label = "", 0.0, ""

    def report(self, fraction: float) -> None:
        """Show the fraction done, 0 to 1."""
        if self._shown and time.monotonic() - self._last_s > self.PAUSE_S:
            self._last_s = time.monotonic()
            full = round(self.WIDTH * min(max(fraction, 0.0), 1.0))
            self._draw(f"[{'#' * full}{'.' * (self.WIDTH - full)}] {100 * fraction:3.0f} % {self.label}"[:79])

    def cancelled(self) -> bool:
        """Tell whether the user has pressed Ctrl+C."""
        return self._stop

    def interrupt(self, number: int, frame: FrameType | None) -> None:
        """Handle SIGINT: stop at the next checkpoint, or at once if it is sent again."""
        if self._stop:
            raise KeyboardInterrupt
        self._stop = True

    def say(self, text: str, always: bool = False) -> None:
        """Print a line above the bar."""
        if always or not self._quiet:
            self.clear()
            self._stream.write(f"{text}\n")
            self._stream.flush()

    def clear(self) -> None:
        """Erase the bar."""
        self._draw("")

    def _draw(self, text: str) -> None:
        if text or self._drawn:
            over = " " * (len(self._drawn) - len(text))
            self._stream.write(f"\r{text}{over}" if text else f"\r{over}\r")
            self._stream.flush()
            self._drawn = text


class Quietly:
    """Progress that passes on cancelling and shows nothing."""

    def __init__(self, bar: Bar) -> None:
        self.cancelled = bar.cancelled

    def report(self, fraction: float) -> None:
        """Show nothing."""
