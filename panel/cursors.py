"""Linked cursors: the place under the mouse shows on the map, the spot under the map's mouse in the picture."""

from __future__ import annotations

import numpy as np
from qgis.PyQt.QtCore import QTimer

from .model import ground as grounds
from .model.faults import guarded
from .model.viewsheds import ground_in_view
from .view.spots import SpotMark, spot_words
from .words import place_words

PAUSE_MS = 40
"""The mouse is followed this often."""

LONGEST_WEDGE_M, SHORTEST_WEDGE_M = 30_000.0, 500.0


class Cursors:
    """Follows both mice; the work is done in the lane of the terrain.

    Parameters
    ----------
    view : PhotoView
    """

    def __init__(self, view):
        self.view, self.say = view, view.say
        self._pixel = self._point = None
        self._timer = QTimer(view.dock)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE_MS)
        self._timer.timeout.connect(self._ask)
        view.dock.canvas.hovered.connect(self.hover)
        view.dock.canvas.left.connect(self.leave)
        self.map_canvas = view.iface.mapCanvas()
        self.map_canvas.xyCoordinates.connect(self.hover_map)

    @guarded
    def hover(self, x_px, y_px):
        """The mouse is at a pixel of the picture; while it drags the horizon, no place belongs to the pixel."""
        if self.view.session.live is not None:
            return
        self._pixel, self._point = (x_px, y_px), None
        self._set_spot(None)
        if not self._timer.isActive():
            self._timer.start()

    @guarded
    def leave(self):
        """The mouse has left the picture."""
        if self._pixel is not None:
            self._pixel = None
            self.view.session.terrain_lane.cancel("hover")
            self.view.dock.place_label.setText("")
        self.view.marks.hide_place()

    @guarded
    def hover_map(self, point):
        """The mouse is at a point of the map."""
        if self.view.session.posed is None or not self.view.dock.isVisible():
            return
        if self._pixel is not None or self._point is None:
            self.leave()
        self._pixel, self._point = None, point
        if not self._timer.isActive():
            self._timer.start()

    @guarded
    def _ask(self):
        session, posed = self.view.session, self.view.session.posed
        if posed is None:
            return
        ground, dem = session.ground, session.dem
        if self._pixel is not None:
            pixel = self._pixel
            session.terrain_lane.submit(
                "hover", lambda job: grounds.place_of(dem.here(ground), posed, *pixel), self._show_place, urgency=0
            )
        elif self._point is not None:
            position = self.view.marks.position_of(self._point)
            if position is not None:
                session.terrain_lane.submit(
                    "hover", lambda job: grounds.spot_of(dem.here(ground), posed, *position), self._show_spot, urgency=0
                )

    def _show_place(self, place):
        if self._pixel is None:
            return
        self.view.dock.place_label.setText(place_words(place))
        if place.on_ground:
            self.view.marks.show_place(place.longitude_deg, place.latitude_deg, place.ellipse)
        else:
            self.view.marks.hide_place()

    def _show_spot(self, spot):
        draft = self.view.session.draft
        if self._point is not None and draft is not None:
            self._set_spot(SpotMark(spot, draft.camera))
            self.view.dock.place_label.setText(spot_words(spot))

    def _set_spot(self, mark):
        if self.view.dock.canvas.spot is not mark:
            self.view.dock.canvas.spot = mark
            self.view.dock.canvas.update()

    def show_camera(self):
        """Show the camera's wedge, as long as its view is, and the ground that it shows, if a layer has it."""
        session, marks = self.view.session, self.view.marks
        posed = session.posed
        if posed is None:
            marks.show_wedge(None)
            marks.show_ground(None, None)
            return
        horizon = session.ground.horizon
        off = np.abs(np.mod(horizon.azimuth_deg - posed.pose.heading_deg + 180, 360) - 180)
        ahead = horizon.distance_m[off < posed.camera.hfov_deg / 2]
        far = float(np.nanmax(ahead)) if np.isfinite(ahead).any() else SHORTEST_WEDGE_M
        length = float(np.clip(far, SHORTEST_WEDGE_M, LONGEST_WEDGE_M))
        marks.show_wedge(grounds.wedge_of(session.ground, posed, length))
        if session.live is None:
            marks.show_ground(*ground_in_view(self.view.project, session.item))

    def forget(self):
        """Another photograph follows."""
        self._pixel = self._point = None
        self._set_spot(None)
        self.view.marks.hide_place()
        self.view.dock.place_label.setText("")

    def stop(self):
        """Follow no more."""
        self._timer.stop()
        self.map_canvas.xyCoordinates.disconnect(self.hover_map)
