"""A scene for the look behind the striking line: a plain's edge before a range of mountains."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
from skyline_viewshed.core.base.model import SkylineEvidence
from skyline_viewshed.core.horizon.ridges import RidgeEdges


@dataclass(frozen=True)
class PlainBeforeRange:
    """What is photographed, and evidence whose striking line is the plain's edge and whose rival is the range."""

    scene: object
    evidence: SkylineEvidence
    edge_deg: float

    def crests(self, elevation_deg=None, azimuth_deg=None):
        """Crests that the DEM shows at one elevation, by default the plain's edge, all around or at some azimuths."""
        azimuth = np.arange(0, 360, 0.1) if azimuth_deg is None else azimuth_deg
        same = np.ones(len(azimuth))
        elevation = self.edge_deg if elevation_deg is None else elevation_deg
        return RidgeEdges(azimuth, elevation * same, 2000.0 * same, 5.0 * same)


@pytest.fixture(scope="session")
def plain_before_range(match_scenes):
    """The plain's edge lies at 0.5 degrees, the horizon behind at 2 and more."""
    scene, edge_deg = match_scenes.scene(11, 200.0, 3.0, 1.0), 0.5
    edge = replace(scene.horizon, elevation_deg=np.full(len(scene.horizon.azimuth_deg), edge_deg))
    rows = match_scenes.seen_rows(edge, scene.small_camera, scene.pose)
    striking = match_scenes.evidence_of_rows(rows, 256, 192, (scene.camera.width_px, scene.camera.height_px))
    return PlainBeforeRange(scene, replace(striking, rival=scene.evidence), edge_deg)
