"""The paper's figure in three panels."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.figures_map import MapData, MapObserver
from skyline_viewshed.core.figures_panels import GAP_PX, three_panels

pytest.importorskip("PIL")


def panels(painted, seen=True, height_px=180):
    row, col = np.indices((80, 80))
    elevation = 1500 + 400 * np.sin(col / 9) * np.cos(row / 11)
    visible = (np.hypot(col - 20, row - 60) < 50) & (np.abs(np.degrees(np.arctan2(col - 20, 60 - row)) - 45) < 25)
    data = MapData(
        elevation,
        30.0,
        seen=visible if seen else None,
        observers=(MapObserver(20, 60, 45.0, 50.0),),
        track_px=np.array([[2, 78], [10, 70], [20, 60]]),
    )
    return three_panels(painted().preview, data, height_px, captions=False)


def test_the_panels_look_as_they_did(painted, golden_difference):
    mean, worst = golden_difference("panels", panels(painted))
    assert mean < 1
    assert worst < 25


def test_the_viewshed_is_in_the_third_panel_only(painted):
    changed = np.abs(panels(painted).astype(int) - panels(painted, seen=False)).max(axis=(0, 2)) > 20
    photo_px = round(180 * 256 / 192)
    assert not changed[: photo_px + GAP_PX + 180].any()
    assert changed[photo_px + 2 * GAP_PX + 180 :].any()


def test_panels_share_one_height(painted):
    assert panels(painted, height_px=181).shape[0] == 181
