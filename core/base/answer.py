"""Short names for the facts of an oriented photograph that callers use most."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Callable, ClassVar

from .angles import wrap_360
from .posed import PosedPhoto
from .terrain import Observer


class PhotoAnswer:
    """Short names and a short text for `core.base.model.OrientedPhoto`, whose only base class this is."""

    if TYPE_CHECKING:
        path: str
        orientation: Any
        camera: Any
        longitude_deg: float | None
        latitude_deg: float | None
        eye_elevation_m: float | None

    _repr_html_: ClassVar[Callable[..., str] | None] = None
    """HTML that a notebook shows. `core.api` sets it, because drawing needs `core.figures`."""

    def __repr__(self) -> str:
        name = re.split(r"[\\/]", self.path)[-1] or "array"
        if self.heading_deg is None:
            return f"<OrientedPhoto {name}: {self.status}. {self.message}>"
        facts = [f"{self.status}, heading {self.heading_deg:.2f}°"]
        if self.heading_interval_deg is not None:
            facts.append("90 % interval {:.2f}° to {:.2f}°".format(*self.heading_interval_deg))
        if self.p_correct is not None:
            facts.append(f"p_correct {self.p_correct:.3f}")
        facts.append(f"pitch {self.pitch_deg:.1f}°, roll {self.roll_deg:.1f}°, hfov {self.hfov_deg:.1f}°")
        return f"<OrientedPhoto {name}: {', '.join(facts)}>"

    @property
    def status(self) -> str:
        """'accepted', 'ambiguous', 'rejected' or 'failed'."""
        return self.orientation.status

    @property
    def message(self) -> str:
        """The reason for the status, and what the user can do, in a plain sentence."""
        return self.orientation.message

    @property
    def heading_deg(self) -> float | None:
        """Direction of the optical axis, clockwise from true north, in [0, 360) [degrees]; None without an answer."""
        best = self.orientation.best
        return None if best is None else float(wrap_360(best.pose.heading_deg))

    @property
    def pitch_deg(self) -> float | None:
        """Angle of the optical axis above the horizontal, up positive [degrees]; None without an answer."""
        best = self.orientation.best
        return None if best is None else float(best.pose.pitch_deg)

    @property
    def roll_deg(self) -> float | None:
        """Rotation about the optical axis, positive with the right side down [degrees]; None without an answer."""
        best = self.orientation.best
        return None if best is None else float(best.pose.roll_deg)

    @property
    def hfov_deg(self) -> float | None:
        """Horizontal field of view of the upright picture [degrees]: fitted, or as recorded if there is no answer."""
        return None if self.camera is None else self.camera.hfov_deg

    @property
    def heading_interval_deg(self) -> tuple[float, float] | None:
        """90 % interval of the heading, clockwise from the first to the second [degrees]."""
        low, high = self.orientation.heading_lo_deg, self.orientation.heading_hi_deg
        return None if low is None or high is None else (float(low), float(high))

    @property
    def p_correct(self) -> float | None:
        """Probability that the heading lies within 3 degrees of the truth; None if the method gives none."""
        return self.orientation.p_correct

    @property
    def observer(self) -> Observer | None:
        """Position of the camera, with the elevation of the eye; None if the position is not known."""
        if self.longitude_deg is None or self.latitude_deg is None:
            return None
        return Observer(self.longitude_deg, self.latitude_deg, eye_elevation_m=self.eye_elevation_m)

    @property
    def view(self) -> PosedPhoto | None:
        """The photograph with its best pose, heading in [0, 360); None if no heading was found."""
        best, observer = self.orientation.best, self.observer
        if best is None or observer is None:
            return None
        pose = replace(best.pose, heading_deg=float(wrap_360(best.pose.heading_deg)))
        posed = PosedPhoto(best.camera, pose, observer, path=self.path or None)
        if self.orientation.uncertainty is not None:
            posed = replace(posed, uncertainty=posed.uncertainty.with_pose_of(self.orientation.uncertainty))
        interval = self.heading_interval_deg
        return posed if interval is None else posed.with_heading_interval(*interval)
