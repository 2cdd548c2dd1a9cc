"""Looks for map layers and summits in the background, when their overlays are switched on."""

from __future__ import annotations

from .model import map_layers
from .model.overlays import MAP, SUMMITS, Terrestrial


class Terrestrials:
    """What the terrain around the present eye holds beside its horizon.

    Parameters
    ----------
    view : PhotoView
    """

    def __init__(self, view):
        self.view, self.found = view, Terrestrial()
        self._asked, self._readings, self._projected = set(), (), None

    def forget(self):
        """Another eye or elevation model follows."""
        self.found, self._asked, self._projected = Terrestrial(), set(), None
        for kind in (MAP, SUMMITS):
            self.view.session.terrain_lane.cancel(kind)

    def look(self):
        """Look for what is switched on and not yet known."""
        session, dock = self.view.session, self.view.dock
        if session.posed is None:
            return
        self._asked &= dock.shown  # what was switched off is looked for anew
        for kind, ask in ((MAP, self._ask_map), (SUMMITS, self._ask_summits)):
            if kind in dock.shown and kind not in self._asked:
                self._asked.add(kind)
                ask(session, session.ground, session.draft)

    def look_again(self):
        """Project the map layers anew if the pose has changed: other parts of them may have come into the frame."""
        session = self.view.session
        if MAP in self._asked and session.posed is not None and session.live is None:
            self._project_map(session, session.ground, session.draft)

    def _crs(self):
        return self.view.session.dem.source.crs

    def _ask_map(self, session, ground, draft):
        layers = map_layers.shown_layers(self.view.iface.mapCanvas().layers(), session.photos.layer)
        self._readings, self._projected = map_layers.read_layers(layers, self._crs(), self.view.project), None
        self._project_map(session, ground, draft)

    def _project_map(self, session, ground, draft):
        if self._projected == (draft.camera, draft.pose):
            return
        self._projected = draft.camera, draft.pose
        readings, item, dem = self._readings, session.item, session.dem
        session.terrain_lane.submit(
            MAP, lambda job: map_layers.traces_of(readings, item, dem.here(ground), draft.camera, draft.pose),
            self._take_map, session.told.emit, urgency=2,
        )  # fmt: skip

    def _take_map(self, traces_and_names):
        self.found.traces, self.found.names = traces_and_names
        self.view.draw()

    def _ask_summits(self, session, ground, draft):
        layer = map_layers.summit_layer(self.view.project, session.photos.layer)
        dem = session.dem
        given = map_layers.read_summit_layer(layer, self._crs(), self.view.project)
        session.terrain_lane.submit(
            SUMMITS, lambda job: map_layers.visible_summits(dem.here(ground), draft.camera, draft.pose, given),
            self._take_summits, session.told.emit, urgency=2,
        )  # fmt: skip

    def _take_summits(self, summits):
        self.found.summits = summits
        self.view.draw()
