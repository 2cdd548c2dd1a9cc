"""The model of the panel: which photograph is shown, and all that is known of it. Views listen to its signals."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import replace
from typing import Any

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...algorithms.shared.i18n import in_users_language, tr
from ...algorithms.shared.photo_points import NOMINAL_WIDTH_PX, is_field_of_view, pinhole
from ...core.base.camera import Camera, focal_from_35mm_px
from ...core.base.errors import SkylineViewshedError
from . import ground as grounds
from . import solving
from .aids import aids_folder, read_aids
from .alternatives import Alternatives
from .draft import Draft, History
from .lanes import Lane
from .pictures import PictureStore

MOST_DRAFTS = 500
STATIONS = 4
"""Eyes whose horizons are kept: the present one and its neighbours, about 4 MB each."""


class DemHolder:
    """An elevation model, opened once in each thread that uses it; GDAL's data sets belong to one thread.

    Parameters
    ----------
    source : DemSource
    """

    def __init__(self, source):
        self.source, self._opened = source, threading.local()

    def dem(self):
        """Open the DEM for this thread; raises `TerrainError`."""
        if not hasattr(self._opened, "dem"):
            self._opened.dem = self.source.open()
        return self._opened.dem

    def here(self, ground):
        """Give what is known of a ground with this thread's own elevation model."""
        return replace(ground, terrain=self.dem())

    def cache(self):
        """Horizons that this thread has computed."""
        from ...core.eyes import HorizonCache

        if not hasattr(self._opened, "cache"):
            self._opened.cache = HorizonCache(STATIONS)
        return self._opened.cache


class Session(QObject):
    """The photograph that is shown.

    Attributes
    ----------
    photos : PhotoLayer or None
    dem : DemHolder or None
    item : PhotoItem or None
    picture : Picture or None
    preview : Picture or None
        What is shown in place of a photograph whose file is missing.
    ground : Ground or None
    evidence : SkylineEvidence or None
    live : Draft or None
        State during a drag, which no step of the history has yet.
    """

    photos: Any
    dem: Any
    item: Any
    picture: Any
    preview: Any
    ground: Any
    evidence: Any
    live: Any
    history: Any

    photo_changed = pyqtSignal()
    picture_changed = pyqtSignal()
    known_changed = pyqtSignal()  # ground or evidence
    draft_changed = pyqtSignal()
    told = pyqtSignal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.picture_lane, self.terrain_lane, self.solving_lane = Lane(self), Lane(self), Lane(self)
        self.pictures = PictureStore(self.picture_lane)
        self.photos = self.dem = None
        self._histories, self._alternatives = OrderedDict(), Alternatives()
        self._forget()

    def _forget(self):
        self.item = self.picture = self.preview = self.ground = self.evidence = self.live = self.history = None

    @property
    def draft(self):
        """Present state of the correction, or None before the picture is known."""
        return self.live or (self.history.now if self.history else None)

    @property
    def posed(self):
        """The photograph with its pose at its eye, or None."""
        if self.ground is None or self.draft is None or self.draft.pose is None:
            return None
        return grounds.posed_photo(self.ground, self.draft.camera, self.draft.pose, self._uncertainty())

    def _uncertainty(self):
        from ...core.base.uncertainty import PoseUncertainty
        from ...core.mapping.adjust import hand_sigma_deg

        known = self.item.point.posed
        if known is not None and not self.draft.means:
            return known.uncertainty
        usual = known.uncertainty if known is not None else PoseUncertainty()
        if self.draft.interval_deg is not None:
            return usual.with_heading_interval(*self.draft.interval_deg)
        sigma = hand_sigma_deg(self.draft.camera)
        return replace(usual, heading_deg=sigma, pitch_deg=sigma)

    @property
    def alternatives(self):
        """Further headings of the point: ((number, Pose), ...), put onto the extracted skyline."""
        return self._alternatives.of(self)

    def unkept(self):
        """Identifiers of the photographs with a correction that the layer does not have."""
        return {fid for fid, history in self._histories.items() if history.changed}

    def set_layer(self, photos):
        """Show another layer, or none."""
        self.photos = photos
        self._histories.clear()
        self.clear()

    def set_dem(self, dem):
        """Use another elevation model, or none."""
        self.dem, self.ground = dem, None
        for lane in (self.terrain_lane, self.solving_lane):
            lane.cancel()
        self.known_changed.emit()
        if self.item is not None:
            self._look_around()

    def clear(self):
        """Show no photograph."""
        self._cancel()
        self._forget()
        self.photo_changed.emit()

    def _cancel(self):
        """Cancel what is only wanted for the present photograph."""
        for key in ("picture", "evidence"):
            self.picture_lane.cancel(key)
        for lane in (self.terrain_lane, self.solving_lane):
            lane.cancel()

    def stop(self):
        """End the threads."""
        self.clear()
        self.pictures.clear()
        for lane in (self.picture_lane, self.terrain_lane, self.solving_lane):
            lane.stop()

    def show(self, fid):
        """Show a photograph of the layer."""
        if self.photos is None:
            return
        item = self.photos.item(fid)
        if item is None:
            self.clear()
            self.told.emit(tr("The photograph is no longer in the layer."))
            return
        self._cancel()
        self._forget()
        self.item = item
        self.photo_changed.emit()
        if item.path:
            self.pictures.request(item.path, self._take_picture, self._lack_picture)
        else:
            self._lack_picture(tr("The point names no photo. Fill its path field."))
        self._look_around()

    def look_again(self):
        """Show what the layer holds now, after an edit that was not made here; an unkept correction stays."""
        if self.item is None or self.photos is None:
            return
        item = self.photos.item(self.item.fid)
        if item is not None and item.known == self.item.known:
            return
        if item is not None and self.history is not None and self.history.changed:
            self.item = item
            self._look_around()
            self.draft_changed.emit()
        else:
            self._histories.pop(self.item.fid, None)
            self.show(self.item.fid)

    def start_over(self):
        """Forget all corrections, and show the photograph as the layer has it."""
        fid = None if self.item is None else self.item.fid
        self._histories.clear()
        if fid is not None:
            self.show(fid)

    def reread(self):
        """Read the point again after an edit."""
        if self.item is not None and self.photos is not None:
            self.item = self.photos.item(self.item.fid) or self.item

    def _take_picture(self, picture):
        self.picture = picture
        metadata = picture.metadata
        self._begin((metadata.width_px, metadata.height_px), metadata.focal_length_35mm)
        self.picture_changed.emit()
        self.picture_lane.submit(
            "evidence", lambda job: solving.extracted(picture), self._take_evidence, self.told.emit
        )
        following = self.photos.after(self.item.fid, 1) if self.photos else None
        if following is not None:
            self.pictures.ahead(self.photos.item(following).path)

    def _lack_picture(self, sentence):
        self.told.emit(sentence)
        values = self.item.values
        self._begin((int(values["width"] or NOMINAL_WIDTH_PX), int(values["height"] or 0.75 * NOMINAL_WIDTH_PX)), None)
        self.picture_changed.emit()
        if self.item.preview:
            self.pictures.request(self.item.preview, self._take_preview, self.told.emit)

    def _take_preview(self, picture):
        self.preview = picture
        self.picture_changed.emit()

    def _take_evidence(self, evidence):
        self.evidence = evidence
        self.known_changed.emit()

    def _look_around(self):
        if self.dem is None:
            self.told.emit(tr("Choose an elevation model to see the horizon."))
            return
        if self.item.point.observer is None:
            self.told.emit(tr("The point has no usable position."))
            return
        dem, observer = self.dem, self.item.point.observer
        self.terrain_lane.submit(
            "ground", lambda job: grounds.ground_of(dem.dem(), observer, dem.cache(), job), self._take_ground,
            self.told.emit, urgency=0,
        )  # fmt: skip

    def _take_ground(self, ground):
        self.ground = self.dem.here(ground)
        self.known_changed.emit()

    def _begin(self, size_px, focal_length_35mm):
        """Start the correction, or take up an earlier one of this photograph."""
        fid = self.item.fid
        known = self._histories.get(fid)
        if known is not None and known.changed:
            self.history = known
            return
        camera, lens_known = self._camera(size_px, focal_length_35mm)
        try:
            folder = aids_folder(self.photos.layer, self.photos.project, self.item.path)
            aids = read_aids(folder, self.item.path)
        except SkylineViewshedError as error:
            self.told.emit(in_users_language(error.message))
            aids = ((), (), False, ())
        marks, strokes, anew, brush = aids
        first = Draft(camera, self.item.pose, marks, strokes, anew, brush, lens_known=lens_known)
        self.history = History(first)
        self._histories[fid] = self.history
        if len(self._histories) > MOST_DRAFTS:
            oldest = next((key for key, history in self._histories.items() if not history.changed), None)
            self._histories.pop(oldest, None)

    def _camera(self, size_px, focal_length_35mm):
        from ...core.mapping.adjust import assumed_camera

        hfov = self.item.values["HFOV_FIELD"]
        if is_field_of_view(hfov):
            return pinhole(hfov, self.item.values["VFOV_FIELD"], size_px), True
        if focal_length_35mm:
            width, height = size_px
            return Camera(width, height, focal_from_35mm_px(width, height, focal_length_35mm)), True
        return assumed_camera(*size_px), False
