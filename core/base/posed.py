"""A photograph whose pose is known: the one value that matcher, maps, viewsheds and shells exchange."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Callable, ClassVar

from .camera import Camera, Pose
from .terrain import Observer
from .uncertainty import PoseUncertainty


@dataclass(frozen=True)
class PosedPhoto:
    """A camera, where it stands, where it looks, and how well that is known.

    `base.view.open_view` places it on a terrain.

    Attributes
    ----------
    camera : Camera
        Of the full upright picture, with principal point and distortion where they are known.
    pose : Pose
    observer : Observer
        The eye.
    uncertainty : PoseUncertainty
    path : str or None
        Of the picture's file.
    """

    camera: Camera
    pose: Pose
    observer: Observer
    uncertainty: PoseUncertainty = field(default_factory=PoseUncertainty)
    path: str | None = None

    place: ClassVar[Callable[..., Any]]
    """Gives longitude and latitude of pixels. `core.api` supplies the method, since it needs `core.mapping`."""

    def with_heading_interval(self, heading_lo_deg: float, heading_hi_deg: float) -> PosedPhoto:
        """Take the heading's uncertainty from its 90 % interval, clockwise from lo to hi [degrees]."""
        return replace(self, uncertainty=self.uncertainty.with_heading_interval(heading_lo_deg, heading_hi_deg))
