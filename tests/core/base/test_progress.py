"""Progress passes through subtasks; cancelling is not an error that a handler could swallow."""

import pytest
from skyline_viewshed.core.base.errors import Cancelled, SkylineViewshedError
from skyline_viewshed.core.base.progress import SILENT, checkpoint, subtask


class Recorder:
    def __init__(self, stop=False):
        self.fractions, self.stop = [], stop

    def report(self, fraction):
        self.fractions.append(fraction)

    def cancelled(self):
        return self.stop


def test_nested_subtasks_share_the_bar():
    recorder = Recorder()
    inner = subtask(subtask(recorder, 0.5, 1.0), 0.0, 0.5)
    for fraction in (0.0, 0.5, 1.0):
        checkpoint(inner, fraction)
    assert recorder.fractions == [0.5, 0.625, 0.75]


def test_a_checkpoint_stops_a_cancelled_task_through_its_subtasks():
    with pytest.raises(Cancelled):
        checkpoint(subtask(Recorder(stop=True), 0, 1), 0.5)
    assert not issubclass(Cancelled, (SkylineViewshedError, Exception))


def test_silence_never_cancels():
    checkpoint(SILENT, 0.3)
