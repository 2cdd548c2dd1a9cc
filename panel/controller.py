"""The controller: it passes the user's actions to the model, and the model's state to the widgets and the map."""

from __future__ import annotations

from qgis.core import QgsProject
from qgis.PyQt.QtCore import Qt, QTimer

from ..algorithms.shared.elevation import DemSource, assigned_crs, layer_fault
from ..algorithms.shared.i18n import tr
from .cursors import Cursors
from .figures import Figures
from .model import photo_layer
from .model.correcting import Correction
from .model.overlays import drawn
from .model.session import DemHolder, Session
from .model.viewsheds import ViewshedRun, highlight_viewsheds
from .terrestrials import Terrestrials
from .view.dock import PhotoViewDock
from .view.map_marks import MapMarks
from .words import photo_words

SOON_MS = 15


class PhotoView:
    """The panel with its model and its marks on the map.

    Parameters
    ----------
    iface : QgisInterface
    """

    def __init__(self, iface):  # noqa: QGS105 (the plugin passes it on)
        self.iface, self.project = iface, QgsProject.instance()
        self.session = Session()
        self.correction = Correction(self.session)
        self.dock = PhotoViewDock(self.session.pictures, iface.mainWindow())
        self.marks = MapMarks(iface.mapCanvas())
        self.terrestrials = Terrestrials(self)
        self.cursors = Cursors(self)
        self.figures = Figures(self)
        self._layer, self._run, self._review = None, None, False
        self._soon = QTimer(self.dock)
        self._soon.setSingleShot(True)
        self._soon.setInterval(SOON_MS)
        self._soon.timeout.connect(self.draw)
        self._connect()
        self._choose_layers()

    def _connect(self):
        session, dock = self.session, self.dock
        session.photo_changed.connect(self._show_photo)
        session.picture_changed.connect(self._show_picture)
        session.known_changed.connect(self._show_known)
        session.draft_changed.connect(self._show_draft)
        session.told.connect(dock.say)
        dock.layer_box.layerChanged.connect(self.set_layer)
        dock.dem_box.layerChanged.connect(self.set_dem)
        dock.strip.chosen.connect(self.select)
        dock.shown_changed.connect(self._show_known)
        dock.visibilityChanged.connect(self._show_marks)
        dock.visibilityChanged.connect(self._follow_selection)
        steps = {
            "previous": lambda: self.go(-1),
            "next": lambda: self.go(1),
            "doubtful": lambda: self.go(1, doubtful=True),
            "snap": self.correction.snap,
            "second": lambda: self.correction.use_alternative(2),
            "third": lambda: self.correction.use_alternative(3),
            "undo": self.correction.undo,
            "redo": self.correction.redo,
            "keep": self.keep,
            "viewshed": self.viewshed,
            "remove_landmarks": self.correction.remove_landmarks,
            "forget_drawing": self.correction.forget_drawing,
            "folder": self.figures.choose_folder,
            "fit": dock.canvas.fit,
            "face": self.figures.ask_for_face,
        }
        for name, step in steps.items():
            dock.actions[name].triggered.connect(lambda checked=False, step=step: step())
        dock.actions["review"].toggled.connect(self.review)
        for verdict, action in dock.verdicts.items():
            action.triggered.connect(lambda checked=False, verdict=verdict: self.judge(verdict))
        dock.tools.triggered.connect(lambda action: self.figures.take_tool())

    def _choose_layers(self):
        """Start with the active layer and the first raster of heights, if they fit."""
        active = self.iface.activeLayer()
        layers = [active, *self.project.mapLayers().values()]
        points = next((layer for layer in layers if photo_layer.is_photo_layer(layer)), None)
        self.dock.layer_box.setLayer(points)
        dem = next((layer for layer in self.project.mapLayers().values() if photo_layer.may_be_dem(layer)), None)
        self.dock.dem_box.setLayer(dem)
        self.set_dem(dem)
        self.set_layer(points)

    def set_layer(self, layer):
        """Show the photographs of a layer; one that cannot be shown gets a sentence."""
        if layer is self._layer and layer is not None:
            return
        self._let_go()
        fault = photo_layer.layer_fault(layer)
        if fault:
            self.session.set_layer(None)
            self.dock.strip.show_photos({}, {})
            self.dock.say(fault)
            return
        self._layer = layer
        layer.selectionChanged.connect(self._follow_selection)
        layer.willBeDeleted.connect(self._layer_goes)
        layer.afterRollBack.connect(self._start_over)
        self.session.set_layer(photo_layer.PhotoLayer(layer, self.project))
        self.dock.strip.show_photos(self.session.photos.paths(), self.session.photos.column("status"))
        self._mark_all()
        chosen = layer.selectedFeatureIds() or self.session.photos.ids()
        if chosen:
            self.select(chosen[0])
        else:
            self.dock.say(tr("The layer has no photographs."))

    def _let_go(self):
        if self._layer is not None:
            self._layer.selectionChanged.disconnect(self._follow_selection)
            self._layer.willBeDeleted.disconnect(self._layer_goes)
            self._layer.afterRollBack.disconnect(self._start_over)
        self._layer = None

    def _layer_goes(self):
        self._layer = None
        self.session.set_layer(None)
        self.dock.strip.show_photos({}, {})
        self.dock.say(tr("The layer was removed. Choose another."))

    def set_dem(self, layer):
        """Use an elevation model; one that cannot be used gets a sentence."""
        self.terrestrials.forget()
        if layer is None:
            self.session.set_dem(None)
            return
        fault = layer_fault(layer)
        if fault:
            self.session.set_dem(None)
            self.dock.say(fault)
            return
        source = DemSource(layer.source(), 1, layer.crs(), assigned_crs(layer))
        self.session.set_dem(DemHolder(source))

    def select(self, fid):
        """Show a photograph and select its point."""
        if self._layer is not None:
            self._layer.selectByIds([fid])
            if self.session.item is None or self.session.item.fid != fid:
                self.session.show(fid)

    def _start_over(self):
        """Show what the layer has after its edits were thrown away."""
        self.session.start_over()
        self._mark_all()

    def _follow_selection(self, *_):
        if self._layer is None or not self.dock.isVisible():
            return
        chosen = self._layer.selectedFeatureIds()
        if len(chosen) == 1 and (self.session.item is None or self.session.item.fid != chosen[0]):
            self.session.show(chosen[0])

    def go(self, step, doubtful=False):
        """Show the next or previous photograph; True if there is one."""
        photos = self.session.photos
        if photos is None:
            self.dock.say(tr("Choose a layer of oriented photo points."))
            return False
        fid = None if self.session.item is None else self.session.item.fid
        other = photos.after(fid, step, photos.doubtful() if doubtful else None)
        if other is None:
            self.dock.say(tr("There is no further photograph in this direction."))
            return False
        self.select(other)
        return True

    def keep(self):
        """Write the correction to the layer."""
        if self.correction.keep():
            self.dock.photo_label.setText(photo_words(self.session))

    def review(self, on):
        """Start or end the review."""
        self._review = on
        self._show_progress()
        self.dock.canvas.setFocus()

    def judge(self, verdict):
        """Write a verdict, if it is one, and go on to the next photograph without one."""
        session = self.session
        if session.photos is None or session.item is None:
            self.dock.say(tr("Choose a layer of oriented photo points."))
            return
        if verdict != "skip" and not self.correction.judge(verdict):
            return
        self._show_progress()
        left = set(session.photos.ids()) - session.photos.reviewed() - {session.item.fid}
        other = session.photos.after(session.item.fid, 1, left)
        if other is None:
            self.dock.say(tr("No photograph without a verdict follows."))
        else:
            self.select(other)

    def _show_progress(self):
        photos = self.session.photos
        done, count = (len(photos.reviewed()), len(photos.ids())) if photos else (0, 0)
        self.dock.show_review(self._review, done, count)

    def viewshed(self):
        """Compute the viewshed of the photograph, as it is corrected, in the background."""
        from .model.edits import pose_values

        session, dem = self.session, self.dock.dem_box.currentLayer()
        if session.posed is None or dem is None:
            self.dock.say(tr("No viewshed yet: the photograph has no heading, or the elevation model is missing."))
            return
        values = pose_values(session.item, session.draft, session.ground)
        self._run = ViewshedRun(session.photos.layer, session.item, values, dem, self.project)
        self.dock.say(tr("Computing the viewshed ..."))
        self._run.start(self.dock.say)

    def _show_photo(self):
        item = self.session.item
        self.terrestrials.forget()
        self.cursors.forget()
        self.figures.forget()
        self.dock.canvas.show_picture((), None)
        self.dock.canvas.notice = "" if item is None else tr("Opening {photo} ...").format(photo=item.name)
        self.dock.say("")
        self.dock.photo_label.setText(photo_words(self.session))
        self.draw()
        if item is not None:
            self.dock.strip.select(item.fid)
            highlight_viewsheds(self.project, self.project.layerTreeRoot(), item)
        self._show_marks()

    def _show_picture(self):
        camera = self.session.draft.camera
        levels = self.session.picture.levels if self.session.picture else ()
        self.dock.canvas.notice = "" if levels else tr("The photograph cannot be shown.")
        self.dock.canvas.show_picture(levels, (camera.width_px, camera.height_px))
        self._show_draft()

    def _show_known(self):
        self.terrestrials.look()
        self._show_draft()

    def _show_draft(self):
        if self.session.item is not None:
            history = self.session.history
            self.dock.strip.mark(self.session.item.fid, self.session.item.status, bool(history and history.changed))
        self.dock.photo_label.setText(photo_words(self.session))
        history = self.session.history
        self.dock.actions["undo"].setEnabled(bool(history and history.can_undo))
        self.dock.actions["redo"].setEnabled(bool(history and history.can_redo))
        self._soon.start()
        self._show_marks()

    def draw(self):
        """Draw the overlays of the present state."""
        draft = self.session.draft
        brush = draft.brush if draft else ()
        lines, labels = drawn(self.session, self.dock.shown, self.terrestrials.found)
        self.dock.canvas.show_overlays(lines, labels, brush)

    def _show_marks(self, *_):
        if self.dock.isVisible():
            self.cursors.show_camera()
        else:
            self.marks.clear()

    def _mark_all(self):
        for fid, status in self.session.photos.column("status").items():
            self.dock.strip.mark(fid, status, False)

    def open(self):
        """Show the panel."""
        if self.dock.parent() is not None and not self.dock.isVisible():
            self.iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.dock)
        self.dock.show()
        self.dock.canvas.setFocus()

    def remove(self):
        """Take the panel and its marks away."""
        self.figures.stop()
        self.cursors.stop()
        if self._run is not None:
            self._run.cancel()
        self._let_go()
        self.session.stop()
        self.marks.remove()
        self.iface.removeDockWidget(self.dock)
        self.dock.deleteLater()
