"""A photograph with a known pose, the value that matcher, maps, viewsheds and shells exchange."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Callable, ClassVar

from .camera import Camera, Pose
from .terrain import Observer
from .uncertainty import PoseUncertainty


@dataclass(frozen=True)
class PosedPhoto:
    """A camera with its pose, its position, and their uncertainty.

    `base.view.open_view` places it on a terrain.

    Attributes
    ----------
    camera : Camera
        Camera of the full upright picture, with principal point and distortion if they are known.
    pose : Pose
    observer : Observer
        Position of the eye.
    uncertainty : PoseUncertainty
    path : str or None
        Path of the picture's file.
    """

    camera: Camera
    pose: Pose
    observer: Observer
    uncertainty: PoseUncertainty = field(default_factory=PoseUncertainty)
    path: str | None = None

    place: ClassVar[Callable[..., Any]]
    """Gives the longitude and latitude of pixels. `core.api` sets this method, because it needs `core.mapping`."""

    def with_heading_interval(self, heading_lo_deg: float, heading_hi_deg: float) -> PosedPhoto:
        """Derive the heading's uncertainty from its 90 % interval, clockwise from lo to hi [degrees]."""
        return replace(self, uncertainty=self.uncertainty.with_heading_interval(heading_lo_deg, heading_hi_deg))
