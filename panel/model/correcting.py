"""What a person does to the pose: drag, turn, zoom, snap, choose, click landmarks, draw, brush, undo, keep."""

from __future__ import annotations

from dataclasses import replace

from ...algorithms.shared.i18n import in_users_language, tr
from ...core.base.angles import difference
from ...core.base.camera import Pose
from ...core.base.errors import SkylineViewshedError
from ...core.base.landmark_hint import LandmarkHint
from ...core.base.model import PhotoMetadata
from ...core.mapping import adjust
from . import solving
from .aids import aids_folder, write_aids
from .edits import NotEditableError, write_pose, write_verdict

ZOOM_STEP = 1.02
"""Factor of the focal length for one notch of the wheel."""

NUDGE_PX = 0.002
"""Share of the picture's width by which an arrow key moves the horizon."""


class Correction:
    """Operations on the session's draft.

    Parameters
    ----------
    session : Session
    """

    def __init__(self, session):
        self.session = session
        self._start = None

    @property
    def possible(self):
        """Whether there is something to correct."""
        return self.session.draft is not None and self.session.ground is not None

    def begin(self):
        """Remember the state before a drag; a photograph without a heading gets its compass's, or north."""
        session = self.session
        if not self.possible:
            self._start = None
            return
        draft = session.history.now
        if draft.pose is None:
            draft = replace(draft, pose=Pose(session.item.values["compass"] or 0.0))
            draft = solving.levelled_draft(draft, session.ground, session.evidence)
        self._start = draft
        session.live = draft

    def drag(self, from_px, to_px):
        """Let what was at one pixel at `begin` appear at another."""
        self._live(lambda draft: draft.placed(adjust.dragged(draft.camera, draft.pose, from_px, to_px), "moved"))

    def turn(self, pivot_px, from_px, to_px):
        """Turn the horizon about a pixel."""
        angle = adjust.turn_between_deg(pivot_px, from_px, to_px)
        self._live(lambda draft: draft.placed(adjust.rolled(draft.camera, draft.pose, pivot_px, angle), "moved"))

    def _live(self, change):
        if self._start is not None:
            self.session.live = change(self._start)
            self.session.draft_changed.emit()

    def end(self):
        """Make the drag a step of the history."""
        live, self.session.live = self.session.live, None
        if self._start is not None and live is not None:
            self._add(live)
        self._start = None

    def zoom(self, notches, pivot_px):
        """Change the focal length by notches of the wheel, about a pixel."""
        self.begin()
        if self._start is not None:
            draft = self._start
            camera, pose = adjust.zoomed(draft.camera, draft.pose, ZOOM_STEP**notches, pivot_px)
            self.session.live = draft.placed(pose, "moved", camera)
        self.end()

    def nudge(self, right, up, turn_deg=0.0):
        """Move the horizon by steps of an arrow key, or turn it."""
        self.begin()
        if self._start is not None:
            camera = self._start.camera
            middle = camera.width_px / 2, camera.height_px / 2
            step = NUDGE_PX * camera.width_px
            pose = adjust.dragged(camera, self._start.pose, middle, (middle[0] + right * step, middle[1] - up * step))
            self.session.live = self._start.placed(adjust.rolled(camera, pose, middle, turn_deg), "moved")
        self.end()

    def face(self, longitude_deg, latitude_deg):
        """Turn to a place of the map, level with the skyline. An answer that looks elsewhere gives no roll either."""
        self.begin()
        if self._start is None:
            return
        session = self.session
        try:
            place, ground = LandmarkHint(0.0, 0.0, longitude_deg, latitude_deg, 0.0), session.ground
            azimuth, _ = place.direction_deg(ground.terrain, ground.observer, self._metadata)
        except SkylineViewshedError as error:
            session.told.emit(in_users_language(error.message))
            self.end()
            return
        pose = self._start.pose
        elsewhere = abs(difference(azimuth, pose.heading_deg)) > solving.FAR_DEG
        pose = replace(pose, heading_deg=azimuth, roll_deg=0.0 if elsewhere else pose.roll_deg)
        draft = self._start.placed(pose, "moved")
        session.live = solving.levelled_draft(draft, session.ground, session.evidence)
        self.end()

    def use_alternative(self, number):
        """Take a further heading of the table, and snap from there."""
        pose = dict(self.session.alternatives).get(number)
        if pose is None:
            self.session.told.emit(tr("This photograph has no answer {number}.").format(number=number))
            return
        self._add(self.session.history.now.placed(pose, "alternative"))
        self.snap(free=True)

    def snap(self, free=False):
        """Fit from here with the robust matcher, in the background."""
        session = self.session
        if not self.possible or session.picture is None:
            session.told.emit(tr("Nothing to fit yet: the picture or the elevation model is missing."))
            return
        item, draft, ground, dem = session.item, session.history.now, session.ground, session.dem
        evidence = session.evidence
        session.told.emit(tr("Fitting ..."))
        session.solving_lane.submit(
            "snap",
            lambda job: solving.snapped(item, draft, dem.here(ground), dem.dem(), evidence, free, job),
            lambda answer: self._take_answer(item, *answer),
            session.told.emit,
        )

    def _take_answer(self, item, draft, message):
        if self.session.item is not item:
            return
        text = in_users_language(message) if message else ""
        if draft != self.session.history.now:
            text = text or tr("Fitted: heading {heading}°. Press Keep to write it to the layer.").format(
                heading=f"{draft.pose.heading_deg:.1f}"
            )
        self.session.told.emit(text)
        self._add(draft)

    def add_landmark(self, landmark):
        """Add a pixel and what it shows, and fit the pose to all landmarks; True if that worked.

        There is one sun and one moon, so that another click on them takes the place of an earlier one.
        """
        known = self.session.history.now.landmarks
        return self._with_landmarks((*(m for m in known if m.body is None or m.body != landmark.body), landmark))

    def add_body(self, body, pixel):
        """Add the sun or the moon at a pixel: its azimuth and elevation angle [degrees], or None if that failed."""
        eye = self.session.ground.observer
        # It needs no place, but tables of points in QGIS do: the camera's.
        mark = LandmarkHint(pixel[0], pixel[1], eye.longitude_deg, eye.latitude_deg, body=body)
        if not self.add_landmark(mark):
            return None
        return mark.direction_deg(self.session.ground.terrain, eye, self._metadata)

    @property
    def contradictory(self):
        """Whether no pose fits all landmarks."""
        session = self.session
        return bool(solving.missed_landmarks(session.history.now, session.ground, self._metadata))

    @property
    def _metadata(self):
        """What the photograph's file says; nothing without the file."""
        picture = self.session.picture
        return PhotoMetadata("", 0, 0) if picture is None else picture.metadata

    def remove_landmarks(self):
        """Forget the landmarks; the pose stays."""
        if self.possible:
            self._add(replace(self.session.history.now, landmarks=()))

    def _with_landmarks(self, landmarks):
        draft = replace(self.session.history.now, landmarks=landmarks)
        try:
            self._add(solving.placed_by_landmarks(draft, self.session.ground, self._metadata))
        except SkylineViewshedError as error:
            self.session.told.emit(in_users_language(error.message))
            return False
        return True

    def add_stroke(self, stroke, anew):
        """Draw a stretch of the skyline; `anew` draws it without the extracted one."""
        draft = self.session.history.now
        before = draft.strokes if draft.anew == anew else ()
        self._add(replace(draft, strokes=(*before, tuple(stroke)), anew=anew))

    def add_brush(self, stroke):
        """Leave a part of the picture out of the skyline."""
        draft = self.session.history.now
        self._add(replace(draft, brush=(*draft.brush, stroke)))

    def forget_drawing(self):
        """Forget what was drawn and brushed."""
        if self.session.history:
            self._add(replace(self.session.history.now, strokes=(), anew=False, brush=()))

    def undo(self):
        """Go back by one step."""
        if self.session.history:
            self.session.history.undo()
            self.session.told.emit("")
            self.session.draft_changed.emit()

    def redo(self):
        """Go forward by one step."""
        if self.session.history:
            self.session.history.redo()
            self.session.told.emit("")
            self.session.draft_changed.emit()

    def _add(self, draft):
        self.session.history.add(draft)
        self.session.draft_changed.emit()

    def keep(self):
        """Write the correction to the layer's edit buffer and to the files of Orient photos; True if that worked."""
        session = self.session
        if not self.possible or session.history.now.pose is None:
            session.told.emit(tr("Nothing to keep yet: the photograph has no heading."))
            return False
        item, draft, layer = session.item, session.history.now, session.photos.layer
        folder = aids_folder(layer, session.photos.project, item.path)
        try:
            write_pose(layer, item, draft, session.ground)
            if item.path and folder is not None and draft.aids != session.history.kept.aids:
                write_aids(folder, item.path, draft, session.evidence)
        except NotEditableError as error:
            session.told.emit(str(error))
            return False
        except SkylineViewshedError as error:
            session.told.emit(in_users_language(error.message))
            return False
        session.history.keep()
        session.reread()
        session.told.emit(tr("Kept in the layer's edit buffer. Save the layer's edits to make it permanent."))
        session.draft_changed.emit()
        return True

    def judge(self, verdict):
        """Write a verdict of the review; True if that worked."""
        session = self.session
        try:
            write_verdict(session.photos.layer, session.item, verdict)
        except NotEditableError as error:
            session.told.emit(str(error))
            return False
        session.reread()
        return True
