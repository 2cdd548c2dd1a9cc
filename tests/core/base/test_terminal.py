"""The progress bar, the lines above it, and Ctrl+C."""

import io
import signal

import pytest
from skyline_viewshed.core.base.terminal import Bar, Quietly


def test_a_second_ctrl_c_stops_at_once():
    bar = Bar(io.StringIO())
    bar.interrupt(signal.SIGINT, None)
    assert bar.cancelled()
    with pytest.raises(KeyboardInterrupt):
        bar.interrupt(signal.SIGINT, None)


class Terminal(io.StringIO):
    def isatty(self):
        return True


def test_the_bar_is_drawn_on_terminals_only(monkeypatch):
    terminal, file, quiet = Terminal(), io.StringIO(), Terminal()
    monkeypatch.setattr(Bar, "PAUSE_S", -1.0)
    for bar in (Bar(terminal), Bar(file), Bar(quiet, quiet=True)):
        bar.label = "of 2 photos"
        bar.report(0.5)
        bar.say("one")
        bar.say("wrong", always=True)
        bar.clear()
    assert "[###############...............]  50 % of 2 photos" in terminal.getvalue()
    assert terminal.getvalue().endswith("one\nwrong\n")
    assert file.getvalue() == "one\nwrong\n"
    assert quiet.getvalue() == "wrong\n"


def test_a_quiet_part_still_stops():
    bar = Bar(io.StringIO())
    part = Quietly(bar)
    part.report(0.5)
    assert not part.cancelled()
    bar.interrupt(signal.SIGINT, None)
    assert part.cancelled()
