"""A correction in the making: pose, lens, landmarks, skyline and mask of one photograph, with undo and redo."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from ...algorithms.shared.i18n import tr
from ...core.base.camera import Camera, Pose

MOST_STEPS = 200


@dataclass(frozen=True)
class Draft:
    """One state of a correction; every change makes a new one.

    Attributes
    ----------
    camera : Camera
    pose : Pose or None
        None while no heading is known.
    landmarks : tuple of LandmarkHint
    strokes : tuple of tuples of (x_px, y_px)
        Drawn skyline.
    anew : bool
        The strokes are the whole skyline; otherwise they repair the extracted one.
    brush : tuple of BrushStroke
        Parts of the picture that hold no skyline.
    lens_known : bool
        The field of view is from the file, the layer or a person, and no assumption.
    lens_changed : bool
        A person changed the field of view.
    means : tuple of str
        How the pose came about, in order: 'moved', 'snapped', 'alternative', 'landmarks'.
    interval_deg : (lo, hi) or None
        90 % interval of the heading from the matcher [degrees].
    """

    camera: Camera
    pose: Pose | None
    landmarks: tuple = ()
    strokes: tuple = ()
    anew: bool = False
    brush: tuple = ()
    lens_known: bool = True
    lens_changed: bool = False
    means: tuple = ()
    interval_deg: Any = None

    def placed(self, pose, means, camera=None, interval_deg=None):
        """Give the draft with another pose.

        Parameters
        ----------
        pose : Pose
        means : str
        camera : Camera or None
            None keeps the lens.
        interval_deg : (lo, hi) or None
        """
        kept = tuple(word for word in self.means if word != means)
        camera = camera or self.camera
        changed = self.lens_changed or (means == "moved" and camera != self.camera)
        known = self.lens_known or camera != self.camera
        return replace(
            self, camera=camera, pose=pose, means=(*kept, means), interval_deg=interval_deg, lens_changed=changed,
            lens_known=known,
        )  # fmt: skip

    @property
    def aids(self):
        """Landmarks, strokes and brush: what goes into tables and files."""
        return self.landmarks, self.strokes, self.anew, self.brush

    def described(self):
        """Sentence for the layer's message field."""
        words = {
            "moved": tr("horizon moved"),
            "snapped": tr("snapped to the skyline"),
            "alternative": tr("another answer chosen"),
            "landmarks": tr("placed by landmarks"),
        }
        parts = [words[word] for word in self.means]
        if self.landmarks and "landmarks" not in self.means:
            parts.append(tr("landmarks given"))
        if self.strokes:
            parts.append(tr("skyline drawn"))
        if self.brush:
            parts.append(tr("parts of the picture left out"))
        if not parts:
            return tr("confirmed by hand: the answer was right")
        return tr("corrected by hand: {how}").format(how=", ".join(parts))


class History:
    """The states of one draft, with undo and redo.

    Parameters
    ----------
    first : Draft
    """

    def __init__(self, first):
        self._states, self._at, self.kept = [first], 0, first

    @property
    def now(self):
        """Present state."""
        return self._states[self._at]

    @property
    def changed(self):
        """Whether the present state has not been written to the layer."""
        return self.now != self.kept

    @property
    def can_undo(self):
        """Whether there is an earlier state."""
        return self._at > 0

    @property
    def can_redo(self):
        """Whether there is a later state."""
        return self._at < len(self._states) - 1

    def add(self, draft):
        """Make a new state the present one; what had been undone is gone."""
        if draft != self.now:
            self._states = [*self._states[: self._at + 1], draft][-MOST_STEPS:]
            self._at = len(self._states) - 1

    def undo(self):
        """Go back by one state."""
        self._at = max(self._at - 1, 0)

    def redo(self):
        """Go forward by one state."""
        self._at = min(self._at + 1, len(self._states) - 1)

    def keep(self):
        """Remember that the present state was written."""
        self.kept = self.now
