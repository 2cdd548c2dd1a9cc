"""The tools of the picture: which one is in use, and what is done with clicks and drawings."""

from __future__ import annotations

from functools import partial

from qgis.PyQt.QtWidgets import QFileDialog

from ..algorithms.shared.i18n import tr
from ..core.base.landmark_hint import LandmarkHint
from .model import drawing
from .model import ground as grounds
from .model.aids import FOLDER_PROPERTY, aids_folder
from .model.edits import NotEditableError
from .model.faults import guarded
from .model.overlays import Line
from .view.map_marks import PlaceTool
from .view.tools import BrushTool, ChainTool, ClickTool, CorrectTool, StrokeTool, Tool
from .words import body_words


class Figures:
    """Makes the tools and takes their results.

    Parameters
    ----------
    view : PhotoView
    """

    def __init__(self, view):
        self.view, self.say, self._map_tool, self._pixel = view, view.say, None, None
        canvas, correction = view.dock.canvas, view.correction
        self.tools = {
            "look": Tool(canvas),
            "correct": CorrectTool(canvas, correction),
            "landmark": ClickTool(canvas, self._take_landmark_pixel),
            "sun": ClickTool(canvas, partial(self._take_body, "sun")),
            "moon": ClickTool(canvas, partial(self._take_body, "moon")),
            "draw": StrokeTool(canvas, partial(self._take_stroke, True)),
            "repair": StrokeTool(canvas, partial(self._take_stroke, False)),
            "brush": BrushTool(canvas, self._take_brush),
            "distance": ChainTool(canvas, "line", self._measure, self._measure),
            "area": ChainTool(canvas, "polygon", self._measure, self._measure),
            "point": ChainTool(canvas, "point", self._ignore, self._digitise),
            "line": ChainTool(canvas, "line", self._ignore, self._digitise),
            "polygon": ChainTool(canvas, "polygon", self._ignore, self._digitise),
        }
        self.take_tool()

    def take_tool(self):
        """Use the tool whose action is checked."""
        canvas = self.view.dock.canvas
        if canvas.tool is not None:
            canvas.tool.stop()
        name = next(name for name in self.tools if self.view.dock.actions[name].isChecked())
        canvas.tool = self.tools[name]
        self._give_map_back()
        self.view.marks.show_figure(None)
        canvas.setFocus()

    def ask_for_face(self):
        """Let the person click on the map where the camera looks."""
        if not self.view.correction.possible:
            self.say(tr("Nothing to turn yet: the picture or the elevation model is missing."))
            return
        self.say(tr("Click a place on the map that the middle of the picture shows."))
        self._ask_map(self.view.correction.face)

    def _take_landmark_pixel(self, pixel):
        if not self.view.correction.possible:
            self.say(tr("No landmark yet: the picture or the elevation model is missing."))
            return
        self._pixel = pixel
        self.view.dock.canvas.sketch = [_dot(pixel)]
        self.view.dock.canvas.update()
        self.say(tr("Now click the same point on the map."))
        self._ask_map(self._take_landmark_place)

    def _take_landmark_place(self, longitude_deg, latitude_deg):
        pixel, self._pixel = self._pixel, None
        self.view.dock.canvas.sketch = []
        if pixel is None or not self.view.correction.possible:
            return
        if self.view.correction.add_landmark(LandmarkHint(pixel[0], pixel[1], longitude_deg, latitude_deg)):
            count = len(self.view.session.draft.landmarks)
            one = tr("One landmark. Set another, press Snap, or press Keep.")
            several = tr("{count} landmarks. Set another, press Snap, or press Keep.")
            self._say_placed(one if count == 1 else several.format(count=count))

    def _take_body(self, body, pixel):
        if not self.view.correction.possible:
            self.say(tr("No landmark yet: the picture or the elevation model is missing."))
            return
        direction = self.view.correction.add_body(body, pixel)
        if direction is not None:
            self._say_placed(body_words(body, *direction))

    def _say_placed(self, sentence):
        if self.view.correction.contradictory:
            sentence = tr(
                "The landmarks contradict one another. Undo the last one, or check the pixels, the places on the map "
                "and the clock of the camera."
            )
        self.say(sentence)

    def _ask_map(self, take):
        self._give_map_back()
        canvas = self.view.iface.mapCanvas()
        self._map_tool = PlaceTool(canvas, partial(self._take_map_click, take))
        canvas.setMapTool(self._map_tool)

    @guarded
    def _take_map_click(self, take, point):
        position = self.view.marks.position_of(point)
        if position is None:
            self.say(tr("The map's coordinate system does not reach there."))
        else:
            take(*position)
        # Otherwise the map keeps the keys, and Ctrl+Z takes back a kept correction instead of this click.
        canvas = self.view.dock.canvas
        canvas.window().activateWindow()
        canvas.setFocus()

    def _give_map_back(self):
        if self._map_tool is not None:
            self._map_tool.give_back()
            self._map_tool = None

    def _take_stroke(self, anew, points):
        if self.view.session.history is None:
            return
        self.view.correction.add_stroke(points, anew)
        self.say(tr("Skyline drawn. Press Snap to fit the horizon to it."))

    def _take_brush(self, stroke):
        if self.view.session.history is None:
            return
        self.view.correction.add_brush(stroke)
        self.say(tr("Masked. Press Snap to fit the horizon without it."))

    def _ignore(self, kind, points):
        """Nothing is placed before a figure is finished."""

    def _ready(self):
        if self.view.session.posed is None:
            self.say(tr("This needs a heading and an elevation model."))
            return False
        return True

    def _measure(self, kind, points):
        if not self._ready():
            return
        session = self.view.session
        dem, ground, posed = session.dem, session.ground, session.posed
        session.terrain_lane.submit(
            "measure", lambda job: grounds.places_of(dem.here(ground), posed, points),
            partial(self._show_measured, kind), session.told.emit, urgency=0,
        )  # fmt: skip

    def _show_measured(self, kind, places):
        self.say(drawing.measured(kind, places, self.view.project))
        known = [place for place in places if place.on_ground]
        ring = known + known[:1] if kind == "polygon" else known
        self.view.marks.show_figure(([p.longitude_deg for p in ring], [p.latitude_deg for p in ring]))

    def _digitise(self, kind, points):
        if not self._ready():
            return
        session = self.view.session
        item, dem, ground, posed = session.item, session.dem, session.ground, session.posed
        session.terrain_lane.submit(
            ("draw", points), lambda job: drawing.placed(item, dem.here(ground), posed, kind, points, job),
            partial(self._add, kind), session.told.emit,
        )  # fmt: skip

    def _add(self, kind, row):
        view = self.view
        crs = view.session.dem.source.crs
        layer = drawing.target_layer(kind, view.iface.activeLayer(), view.project, crs)
        try:
            drawing.add_figure(layer, kind, row[0], row[1], crs)
        except NotEditableError as error:
            view.dock.say(str(error))
            return
        view.dock.say(tr("Drawn into the layer {layer}. Save its edits to keep it.").format(layer=layer.name()))

    def choose_folder(self):
        """Let the person choose where landmarks, skylines and masks are kept."""
        session, dock = self.view.session, self.view.dock
        if session.photos is None:
            dock.say(tr("Choose a layer of oriented photo points."))
            return
        folder = aids_folder(session.photos.layer, self.view.project, session.item.path if session.item else None)
        text = tr("Folder of landmarks, skylines and masks")
        chosen = QFileDialog.getExistingDirectory(dock, text, str(folder or ""))
        if chosen:
            session.photos.layer.setCustomProperty(FOLDER_PROPERTY, chosen)

    def forget(self):
        """Another photograph follows."""
        self._pixel = None
        self._give_map_back()
        self.view.dock.canvas.tool.stop()
        self.view.marks.show_figure(None)

    def stop(self):
        """The panel goes."""
        self._give_map_back()


def _dot(pixel):
    return Line("landmark", [pixel[0]], [pixel[1]], dots=True)
