"""All that the matcher asks about the terrain below the horizon, from one set of rays."""

from __future__ import annotations

from dataclasses import dataclass, field

from .ground_rays import RayOptions, cast_ground_rays
from .ground_view import GroundView, ground_view
from .progress import SILENT
from .ridges import RidgeEdges, RidgeOptions, occlusion_edges


@dataclass(frozen=True)
class InnerOptions:
    """Where to sample, and which crests count."""

    rays: RayOptions = field(default_factory=RayOptions)
    ridges: RidgeOptions = field(default_factory=RidgeOptions)


@dataclass(frozen=True, eq=False)
class InnerTerrain:
    """The inside of the view around one observer.

    Attributes
    ----------
    ridges : RidgeEdges
    ground : GroundView or None
        None where the DEM holds no ground that far from the observer.
    """

    ridges: RidgeEdges
    ground: GroundView | None


def inner_terrain(terrain, observer, options=InnerOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Look at the terrain around an observer.

    Raises
    ------
    ObserverOutsideDemError, NoElevationAtObserverError
    """
    rays = cast_ground_rays(terrain, observer, options.rays, progress)
    return InnerTerrain(occlusion_edges(rays, options.ridges), ground_view(rays))
