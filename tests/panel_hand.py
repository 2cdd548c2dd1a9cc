"""A person's hand on the panel, and the layer that it works on: `from panel_hand import Hand, write_photos`."""

from __future__ import annotations

import math
from pathlib import Path

from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QMouseEvent, QWheelEvent
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication

OFF_DEG = 5.0
"""The layer's headings are wrong by so much."""

LONGEST_S = 60
MISS_SHARE = 0.008
"""A person misses a place of the picture by so much of its width."""

LARGE_ROLL_DEG = 1.5
"""A roll that is wrong by more is corrected first."""


def write_photos(path, scene, off_deg=OFF_DEG, folder=None):
    """Write the scene's photographs as oriented points, with headings that are off."""
    from skyline_viewshed.core.io.vector import PointRow, point_fields, write_points

    rows = []
    for number, (name, pose) in enumerate(scene.truth.items()):
        photo = str(Path(folder or scene.folder) / f"{name}.jpg")
        heading = (pose.heading_deg + off_deg) % 360
        values = {
            "photo": photo, "filename": name, "width": 800, "height": 600, "heading": heading, "pitch": pose.pitch_deg,
            "roll": pose.roll_deg, "hfov": scene.hfov_deg, "vfov": 50.5, "heading_2": (pose.heading_deg + 0.7) % 360,
            "heading_lo": (heading - 1) % 360, "heading_hi": (heading + 1) % 360, "p_correct": 0.4,
            "status": ("ambiguous", "accepted")[number % 2], "message": "It may be elsewhere.",
        }  # fmt: skip
        rows.append(PointRow((*scene.positions[name], 0.0), values))
    write_points(path, point_fields(), rows)


def wait(*lanes):
    """Let the background finish, and its results arrive."""
    for _ in range(LONGEST_S * 50):
        QTest.qWait(20)
        if not any(lane.busy() for lane in lanes):
            QTest.qWait(60)
            if not any(lane.busy() for lane in lanes):
                return
    raise AssertionError("the background does not come to an end")


class Hand:
    """A person's mouse and keys on the picture; counts what it does."""

    def __init__(self, view):
        self.view, self.canvas, self.steps = view, view.dock.canvas, 0

    def settle(self):
        session = self.view.session
        wait(session.picture_lane, session.terrain_lane, session.solving_lane)

    def at(self, x_px, y_px):
        x, y = self.canvas.to_widget(x_px, y_px)
        return QPoint(round(x), round(y))

    def send(self, kind, place, button, buttons, modifiers=Qt.KeyboardModifier.NoModifier):
        event = QMouseEvent(kind, QPointF(place), button, buttons, modifiers)
        QApplication.sendEvent(self.canvas, event)

    def hover(self, x_px, y_px):
        none = Qt.MouseButton.NoButton
        self.send(QEvent.Type.MouseMove, self.at(x_px, y_px), none, none)

    def drag(self, *places, button=Qt.MouseButton.LeftButton, modifiers=Qt.KeyboardModifier.NoModifier):
        self.steps += 1
        start, *rest = [self.at(*place) for place in places]
        self.send(QEvent.Type.MouseButtonPress, start, button, button, modifiers)
        for place in rest:
            self.send(QEvent.Type.MouseMove, place, Qt.MouseButton.NoButton, button, modifiers)
        none = Qt.MouseButton.NoButton
        self.send(QEvent.Type.MouseButtonRelease, (rest or [start])[-1], button, none, modifiers)

    def click(self, x_px, y_px, button=Qt.MouseButton.LeftButton):
        self.drag((x_px, y_px), button=button)

    def wheel(self, notches, x_px, y_px, modifiers=Qt.KeyboardModifier.NoModifier):
        self.steps += 1
        place = QPointF(self.at(x_px, y_px))
        event = QWheelEvent(place, place, QPoint(0, 0), QPoint(0, 120 * notches), Qt.MouseButton.NoButton, modifiers,
                            Qt.ScrollPhase.NoScrollPhase, False)  # fmt: skip
        QApplication.sendEvent(self.canvas, event)

    def press(self, name):
        """Trigger an action by its button."""
        self.steps += 1
        {**self.view.dock.actions, **self.view.dock.verdicts}[name].trigger()

    def key(self, key, modifier=Qt.KeyboardModifier.NoModifier):
        self.steps += 1
        QTest.keyClick(self.canvas, key, modifier)

    def hold(self, pose):
        """Where a person takes hold of the drawn horizon, and to where they drag it for a pose, with a small error."""
        from skyline_viewshed.core.base.camera import project, unproject

        camera = self.draft.camera
        grip = camera.width_px / 2, camera.height_px / 2
        x, y = map(float, project(camera, pose, *unproject(camera, self.draft.pose, *grip)))
        return grip, (x + MISS_SHARE * camera.width_px, y - MISS_SHARE * camera.width_px)

    def drag_to(self, pose):
        """Drag the drawn horizon to where a pose has it; a large roll is turned away first."""
        roll_deg, width = pose.roll_deg - self.draft.pose.roll_deg, self.draft.camera.width_px
        if abs(roll_deg) > LARGE_ROLL_DEG:
            (x, y), turn, radius = self.hold(pose)[0], math.radians(roll_deg + 0.7), 0.4 * width
            end = (x + radius * math.cos(turn), y - radius * math.sin(turn))
            self.drag((x + radius, y), end, button=Qt.MouseButton.RightButton)
        grip, goal = self.hold(pose)
        self.drag(grip, tuple((a + b) / 2 for a, b in zip(grip, goal)), goal)

    def click_map(self, longitude_deg, latitude_deg):
        """Click on the map, through the tool that waits for it."""
        self.steps += 1
        canvas = self.view.iface.mapCanvas()
        point = self.view.marks._to_map([longitude_deg], [latitude_deg])[0]
        canvas.mapTool().clicked(point)
        canvas.mapTool().give_back() if hasattr(canvas.mapTool(), "give_back") else None

    @property
    def said(self):
        return self.view.dock.told_label.text()

    @property
    def draft(self):
        return self.view.session.draft
