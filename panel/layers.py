"""The layers that the panel shows: which points and elevation model, their selection, and edits made elsewhere."""

from __future__ import annotations

from qgis.PyQt.QtCore import QTimer

from ..algorithms.shared.elevation import DemSource, assigned_crs, layer_fault
from ..algorithms.shared.i18n import tr
from ..algorithms.shared.lost_crs import raster_definition
from .model import photo_layer
from .model.faults import guarded
from .model.session import DemHolder


class Layers:
    """Follows the chosen layers.

    Parameters
    ----------
    view : PhotoView
    """

    def __init__(self, view):
        self.view, self.session, self.dock, self.say = view, view.session, view.dock, view.say
        self._layer = None
        self._edited = QTimer(view.dock)
        self._edited.setSingleShot(True)
        self._edited.timeout.connect(self._follow_edits)
        view.dock.layer_box.layerChanged.connect(self.set_layer)
        view.dock.dem_box.layerChanged.connect(self.set_dem)
        view.dock.visibilityChanged.connect(self._follow_selection)

    def choose(self):
        """Start with the active layer and the first raster of heights, if they fit."""
        layers = list(self.view.project.mapLayers().values())
        active = self.view.iface.activeLayer()
        points = next((layer for layer in (active, *layers) if photo_layer.is_photo_layer(layer)), None)
        dem = next((layer for layer in layers if photo_layer.may_be_dem(layer)), None)
        self.dock.layer_box.setLayer(points)
        self.dock.dem_box.setLayer(dem)
        self.set_dem(dem)
        self.set_layer(points)

    @guarded
    def set_layer(self, layer):
        """Show the photographs of a layer; one that cannot be shown gets a sentence."""
        if layer is self._layer and layer is not None:
            return
        self.let_go()
        fault = photo_layer.layer_fault(layer)
        if fault:
            self._show_none(fault)
            return
        self._layer = layer
        layer.selectionChanged.connect(self._follow_selection)
        layer.willBeDeleted.connect(self._layer_goes)
        layer.afterRollBack.connect(self._start_over)
        layer.undoStack().indexChanged.connect(self._note_edit)
        layer.subsetStringChanged.connect(self._note_edit)
        self._begin(layer)

    def _begin(self, layer):
        self.session.set_layer(photo_layer.PhotoLayer(layer, self.view.project))
        self._mark_all()
        chosen = layer.selectedFeatureIds() or self.session.photos.ids()
        if chosen:
            self.select(chosen[0])
        else:
            self.say(tr("The layer has no photographs."))

    def stop(self):
        """Follow nothing more; the panel goes."""
        self.let_go()
        self._edited.stop()
        self.dock.layer_box.layerChanged.disconnect(self.set_layer)
        self.dock.dem_box.layerChanged.disconnect(self.set_dem)

    def let_go(self):
        """Follow the layer no more."""
        if self._layer is not None:
            self._layer.selectionChanged.disconnect(self._follow_selection)
            self._layer.willBeDeleted.disconnect(self._layer_goes)
            self._layer.afterRollBack.disconnect(self._start_over)
            self._layer.undoStack().indexChanged.disconnect(self._note_edit)
            self._layer.subsetStringChanged.disconnect(self._note_edit)
        self._layer = None

    @guarded
    def _layer_goes(self):
        self._layer = None
        self._show_none(tr("The layer was removed. Choose another."))

    def _show_none(self, sentence):
        self.session.set_layer(None)
        self.dock.strip.show_photos({}, {})
        self.say(sentence)

    @guarded
    def set_dem(self, layer):
        """Use an elevation model; one that cannot be used gets a sentence."""
        self.view.terrestrials.forget()
        fault = None if layer is None else layer_fault(layer)
        if layer is None or fault:
            self.session.set_dem(None)
            if fault:
                self.say(fault)
            return
        source = DemSource(layer.source(), 1, raster_definition(layer), assigned_crs(layer))
        self.session.set_dem(DemHolder(source))

    def select(self, fid):
        """Show a photograph and select its point."""
        if self._layer is not None:
            self._layer.selectByIds([fid])
            if self.session.item is None or self.session.item.fid != fid:
                self.session.show(fid)

    @guarded
    def _follow_selection(self, *_):
        if self._layer is None or not self.dock.isVisible():
            return
        chosen = self._layer.selectedFeatureIds()
        if len(chosen) == 1 and (self.session.item is None or self.session.item.fid != chosen[0]):
            self.session.show(chosen[0])

    @guarded
    def _start_over(self):
        """Show what the layer has after its edits were thrown away."""
        if self.session.photos is None:
            self._note_edit()
            return
        self.session.start_over()
        self._mark_all()

    def _note_edit(self, *_):
        self._edited.start()

    @guarded
    def _follow_edits(self):
        """Show what the layer has after an edit, an undo or a redo, whoever made it, or with another filter."""
        if self._layer is None:
            return
        fault, photos = photo_layer.layer_fault(self._layer), self.session.photos
        if fault:
            self._show_none(fault)
        elif photos is None or photos.path_field != photo_layer.path_field(self._layer):
            self._begin(self._layer)
        else:
            self.session.look_again()
            self._mark_all()
        self.view.show_progress()

    def _mark_all(self):
        """Let the strip show the photographs that there are, and mark those with an unkept correction."""
        files = self.session.photos.files()
        if files != self.dock.strip.files:
            self.dock.strip.show_photos(files, self.session.photos.column("status"))
            if self.session.item is not None:
                self.dock.strip.select(self.session.item.fid)
        unkept = self.session.unkept()
        for fid, status in self.session.photos.column("status").items():
            self.dock.strip.mark(fid, status, fid in unkept)
