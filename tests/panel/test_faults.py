"""An unforeseen error in a slot or in the background becomes a sentence, and the log has the traceback."""

from __future__ import annotations

import pytest
from qgis.PyQt.QtTest import QTest


def broken(*_):
    raise ZeroDivisionError("made by the test")


def by_action(panel, monkeypatch):
    monkeypatch.setattr(panel.view, "go", broken)
    panel.hand.press("next")


def by_mouse(panel, monkeypatch):
    monkeypatch.setattr(panel.view.dock.canvas.tool, "move", broken)
    panel.hand.hover(400, 300)


def by_signal(panel, monkeypatch):
    monkeypatch.setattr("skyline_viewshed.panel.controller.photo_words", broken)
    panel.session.draft_changed.emit()


def by_timer(panel, monkeypatch):
    monkeypatch.setattr(panel.session, "look_again", broken)
    panel.layer.startEditing()
    panel.hand.press("review")
    panel.hand.press("accepted")
    panel.hand.settle()


def by_layer(panel, monkeypatch):
    monkeypatch.setattr(panel.session, "show", broken)
    panel.layer.selectByIds([fid for fid in panel.session.photos.ids() if fid != panel.session.item.fid])


def by_work(panel, monkeypatch):
    monkeypatch.setattr("skyline_viewshed.panel.model.solving.snapped", broken)
    panel.hand.press("snap")
    panel.hand.settle()


def by_result(panel, monkeypatch):
    monkeypatch.setattr(panel.view.correction, "_take_answer", broken)
    panel.hand.press("snap")
    panel.hand.settle()


@pytest.mark.parametrize("fault", [by_action, by_mouse, by_signal, by_timer, by_layer, by_work, by_result])
def test_an_unforeseen_error_becomes_a_sentence(panel, monkeypatch, fault):
    panel.view.say("")
    fault(panel, monkeypatch)
    QTest.qWait(50)
    monkeypatch.undo()
    assert panel.hand.said == "An unexpected error occurred. Please report it and attach the log."
    assert panel.faults and all("ZeroDivisionError" in text for text in panel.faults)
    panel.faults.clear()
    panel.layer.rollBack()
    panel.hand.settle()
