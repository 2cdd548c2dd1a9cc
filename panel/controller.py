"""The controller: it passes the user's actions to the model, and the model's state to the widgets and the map."""

from __future__ import annotations

from functools import partial

from qgis.core import QgsProject
from qgis.PyQt.QtCore import Qt, QTimer

from ..algorithms.shared.i18n import tr
from .cursors import Cursors
from .figures import Figures
from .layers import Layers
from .model.correcting import Correction
from .model.faults import guarded
from .model.overlays import Overlays
from .model.session import Session
from .model.viewsheds import ViewshedRun, cancel_viewsheds, highlight_viewsheds
from .terrestrials import Terrestrials
from .view.dock import PhotoViewDock
from .view.map_marks import MapMarks
from .words import photo_words

SOON_MS = 4
"""The mouse may move more than once before the next frame is drawn."""

FIRST_SHARE = 0.45
"""Width of the panel when it is first opened, as a share of QGIS's window."""


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
        self.layers = Layers(self)
        self._review = self._opened = False
        self._overlays = Overlays()
        self._soon = QTimer(self.dock)
        self._soon.setSingleShot(True)
        self._soon.setInterval(SOON_MS)
        self._soon.timeout.connect(self.draw)
        self._connect()
        self.layers.choose()

    def _connect(self):
        session, dock = self.session, self.dock
        session.photo_changed.connect(self._show_photo)
        session.picture_changed.connect(self._show_picture)
        session.known_changed.connect(self._show_known)
        session.draft_changed.connect(self._show_draft)
        session.told.connect(dock.say)
        dock.canvas.failed.connect(dock.say)
        dock.strip.chosen.connect(self.select)
        dock.shown_changed.connect(self._show_known)
        dock.visibilityChanged.connect(self._show_marks)
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
            dock.actions[name].triggered.connect(lambda checked=False, step=step: self._do(step))
        dock.actions["review"].toggled.connect(self.review)
        for verdict, action in dock.verdicts.items():
            action.triggered.connect(lambda checked=False, verdict=verdict: self._do(partial(self.judge, verdict)))
        dock.tools.triggered.connect(lambda action: self._do(self.figures.take_tool))

    def say(self, text):
        """Show a sentence below the picture."""
        self.dock.say(text)

    @guarded
    def _do(self, step):
        step()

    @guarded
    def select(self, fid):
        """Show a photograph and select its point."""
        self.layers.select(fid)

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
            self.dock.show_photo_words(*photo_words(self.session))

    @guarded
    def review(self, on):
        """Start or end the review."""
        self._review = on
        self.show_progress()
        self.dock.canvas.setFocus()

    def judge(self, verdict):
        """Write a verdict, if it is one, and go on to the next photograph without one."""
        session = self.session
        if session.photos is None or session.item is None:
            self.dock.say(tr("Choose a layer of oriented photo points."))
            return
        if verdict != "skip" and not self.correction.judge(verdict):
            return
        self.show_progress()
        left = set(session.photos.ids()) - session.photos.reviewed() - {session.item.fid}
        other = session.photos.after(session.item.fid, 1, left)
        if other is None:
            self.dock.say(tr("No photograph without a verdict follows."))
        else:
            self.select(other)

    def show_progress(self):
        """Show how many photographs have a verdict."""
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
        self.dock.say(tr("Computing the viewshed ..."))
        ViewshedRun(session.photos.layer, session.item, values, dem, self.project).start(self.dock.say)

    @guarded
    def _show_photo(self):
        item = self.session.item
        self.terrestrials.forget()
        self.cursors.forget()
        self.figures.forget()
        self.dock.canvas.show_picture((), None)
        self.dock.canvas.notice = "" if item is None else tr("Opening {photo} ...").format(photo=item.name)
        self.dock.say("")
        self.dock.show_photo_words(*photo_words(self.session))
        self.draw()
        if item is not None:
            self.dock.strip.select(item.fid)
            highlight_viewsheds(self.project, self.project.layerTreeRoot(), item)
        self._show_marks()

    @guarded
    def _show_picture(self):
        camera = self.session.draft.camera
        picture = self.session.picture or self.session.preview
        levels = picture.levels if picture else ()
        self.dock.canvas.notice = "" if levels else tr("The photograph cannot be shown.")
        self.dock.canvas.show_picture(levels, (camera.width_px, camera.height_px))
        self._show_draft()

    @guarded
    def _show_known(self):
        self.terrestrials.look()
        self._show_draft()

    @guarded
    def _show_draft(self):
        if not self._soon.isActive():  # begun anew, it would wait until the mouse rests
            self._soon.start()
        if self.session.live is not None:
            return
        if self.session.item is not None:
            history = self.session.history
            self.dock.strip.mark(self.session.item.fid, self.session.item.status, bool(history and history.changed))
        self.dock.show_photo_words(*photo_words(self.session))
        history = self.session.history
        self.dock.actions["undo"].setEnabled(bool(history and history.can_undo))
        self.dock.actions["redo"].setEnabled(bool(history and history.can_redo))
        self._show_marks()
        self.terrestrials.look_again()

    @guarded
    def draw(self):
        """Draw the overlays of the present state."""
        draft = self.session.draft
        drawing = self._overlays.drawn(self.session, self.dock.shown, self.terrestrials.found)
        self.dock.canvas.show_overlays(drawing, draft.brush if draft else ())
        if self.session.live is not None:
            self.dock.show_photo_words(*photo_words(self.session))
            self._show_marks()

    @guarded
    def _show_marks(self, *_):
        if self.dock.isVisible():
            self.cursors.show_camera()
        else:
            self.marks.clear()

    def open(self):
        """Show the panel."""
        window = self.dock.parent()
        if window is not None and not self.dock.isVisible():
            self.iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self.dock)
        self.dock.show()
        if window is not None and not self._opened and not self.dock.isFloating():
            window.resizeDocks([self.dock], [round(FIRST_SHARE * window.width())], Qt.Orientation.Horizontal)
        self._opened = True
        self.dock.canvas.setFocus()

    def remove(self):
        """Take the panel and its marks away."""
        self.figures.stop()
        self.cursors.stop()
        cancel_viewsheds()
        self.layers.stop()
        self.session.stop()
        self.marks.remove()
        self.iface.removeDockWidget(self.dock)
        self.dock.deleteLater()
