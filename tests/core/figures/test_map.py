"""Maps: places, wedges, viewsheds, scale and north."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.figures.map import SEEN, VOID, WEDGE, MapData, MapObserver, legend, map_image, scale_bar

pytest.importorskip("PIL")


def hills(rows=80, cols=100):
    row, col = np.indices((rows, cols))
    return 1500 + 400 * np.sin(col / 9) * np.cos(row / 11) + 5.0 * row


def data(**changes):
    row, col = np.indices((80, 100))
    seen = (col > 50) & (row < 40) & (np.hypot(col - 50, row - 40) < 35)
    observers = (MapObserver(50, 40, 45.0, 60.0), MapObserver(20, 60, 200.0, 30.0))
    contents = {"seen": seen, "observers": observers, "track_px": np.array([[10, 70], [20, 60], [50, 40]])}
    return MapData(hills(), 30.0, **{**contents, **changes})


def test_the_map_looks_as_it_did(golden_difference):
    mean, worst = golden_difference("map", map_image(data(), 300))
    assert mean < 1
    assert worst < 25


def test_a_map_without_its_viewshed_does_not_look_like_it(golden_difference):
    mean, _ = golden_difference("map", map_image(data(seen=None), 300))
    assert mean > 1


def test_the_map_is_as_high_as_the_ground_is_long():
    assert map_image(MapData(hills(), (30.0, 60.0)), 200).shape == (320, 200, 3)


def test_seen_cells_are_tinted_and_others_are_not():
    bare, tinted = (map_image(data(seen=seen, observers=(), track_px=None), 300) for seen in (None, data().seen))
    changed = np.abs(bare.astype(int) - tinted).max(axis=2)
    row, col = np.indices(changed.shape) // 3
    seen = data().seen[row, col]
    assert changed[~seen].mean() < 2
    assert changed[seen].mean() > 30
    towards = np.abs(tinted[seen] - np.array(SEEN, float)).mean() < np.abs(bare[seen] - np.array(SEEN, float)).mean()
    assert towards


def test_unknown_cells_are_grey():
    elevation = hills()
    elevation[20:40, 20:40] = np.nan
    assert np.abs(map_image(MapData(elevation, 30.0), 100)[30, 30].astype(int) - VOID).max() < 3
    map_image(MapData(np.full((5, 5), np.nan), 30.0), 100)


@pytest.mark.parametrize(("heading", "convergence"), [(90.0, 0.0), (0.0, -90.0)])
def test_wedges_open_towards_the_grid_bearing_of_the_heading(heading, convergence):
    """Where grid north bears 90 degrees west of true north, true north lies to the right on the sheet."""
    flat = MapData(np.zeros((100, 100)), 10.0, convergence, observers=(MapObserver(50, 50, heading, 40.0),))
    bare = MapData(np.zeros((100, 100)), 10.0, convergence)
    changed = np.abs(map_image(flat, 300).astype(int) - map_image(bare, 300)).max(axis=2) > 10
    assert changed[142:158, 180:205].mean() > 0.95
    assert changed[130:170, 60:135].mean() < 0.02


def test_observers_lie_on_their_cells():
    flat = MapData(np.zeros((50, 50)), 10.0, observers=(MapObserver(10.0, 40.0),))
    pixels = map_image(flat, 500).astype(int)
    white = np.argwhere((pixels.min(axis=2) > 250)[350:450, 50:150])
    assert np.allclose(white.mean(axis=0) + [350, 50], [404.5, 104.5], atol=1)


@pytest.mark.parametrize("metres_per_px", [0.37, 4.0, 120.0])
def test_the_scale_bar_has_a_round_length(metres_per_px):
    pixels = np.zeros((200, 800, 3), np.uint8)
    scale_bar(pixels, metres_per_px)
    columns = np.flatnonzero(pixels[181:183].min(axis=(0, 2)) > 200)
    length = (columns.max() - columns.min()) * metres_per_px
    rounds = np.array([1, 2, 5])[:, None] * 10.0 ** np.arange(0, 6)
    assert np.abs(rounds / length - 1).min() < 0.02


def test_names_are_written_where_they_cover_no_other():
    crowd = tuple(MapObserver(50 + index / 10, 40, label="Station") for index in range(6))
    few, many = (map_image(data(observers=crowd[:count]), 300).astype(int) for count in (4, 6))
    assert np.abs(few - many)[:, :100].max() < 5
    with pytest.raises(ValueError, match="relief"):
        map_image(data(), 100, relief="contours")


def test_a_legend_is_written_at_the_lower_right():
    pixels = np.full((200, 300, 3), 90, np.uint8)
    legend(pixels, [(SEEN, "seen"), (WEDGE, "view")])
    changed = np.argwhere((pixels != 90).any(axis=2))
    assert changed[:, 1].min() > 150
    assert changed[:, 0].min() > 100
