"""The clock of a camera from simulated photographs along a simulated walk."""

from __future__ import annotations

from datetime import timezone
from pathlib import Path

import numpy as np
import pytest
from scenes import small_mountains
from skyline_viewshed.core.base.camera import Camera, Pose, focal_from_35mm_px
from skyline_viewshed.core.base.errors import Cancelled
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.base.uncertainty import Z_90
from skyline_viewshed.core.io.photo import read_metadata, read_photo
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.track.clock import ClockOptions
from skyline_viewshed.core.track.track import local_m, place_at, track_of
from skyline_viewshed.core.walk import clock_from_skylines

T0, OFFSET_S = 1_700_000_000.0, 1800.0
OPTIONS = ClockOptions(largest_s=2700.0, kept=(2, 1), photos=6)


@pytest.fixture(scope="module")
def walk(tmp_path_factory):
    """A walk of four hours over the middle of the mountains, and six photographs from it, of which three must agree."""
    terrain, folder = small_mountains(), tmp_path_factory.mktemp("walk")
    time = T0 + np.arange(0, 14_401, 60.0)
    east, north = np.linspace(-6000, 6000, len(time)), 1500 * np.sin((time - T0) / 2500)
    rows, cols = terrain.shape
    places = [terrain.position_of(cols / 2 + e / 90.0, rows / 2 - n / 90.0) for e, n in zip(east, north)]
    track = track_of(time, *np.array(places, float).T)
    size = 640, 480
    camera, paths, times = Camera(*size, focal_from_35mm_px(*size, 26.0)), [], []
    for number, when in enumerate(T0 + np.arange(2000.0, 12_001.0, 2000.0)):
        place = place_at(track, when)
        view = render_view(
            terrain, Observer(place.longitude_deg, place.latitude_deg), camera, Pose(90.0 * number, 4.0, 1.0),
            SceneOptions(number),
        )  # fmt: skip
        paths.append(str(folder / f"{number}.jpg"))
        write_photo(paths[-1], view.pixels, PhotoMetadata(paths[-1], *size, focal_length_35mm=26.0))
        times.append(when + OFFSET_S)
    return terrain, track, paths, times


def apart_m(track, times_s, true_s, found_s):
    """Distances between the places of photographs at two offsets of the clock [m]."""
    found = []
    for time in times_s:
        places = [place_at(track, time - offset) for offset in (true_s, found_s)]
        found.append(np.hypot(*np.subtract(*(local_m(track, p.longitude_deg, p.latitude_deg) for p in places))))
    return np.array(found)


def test_half_an_hour_is_found_to_within_fifty_metres(walk):
    terrain, track, paths, times = walk
    answer = clock_from_skylines(paths, times, track, terrain, OPTIONS)
    assert answer.offset_s is not None, answer.message
    assert apart_m(track, times, OFFSET_S, answer.offset_s).max() < 50


def test_photographs_without_a_skyline_tell_nothing(walk, tmp_path):
    terrain, track, _, times = walk
    paths = []
    for number in range(len(times)):
        pixels = np.random.default_rng(number).integers(60, 120, (480, 640, 3)).astype(np.uint8)
        paths.append(str(tmp_path / f"{number}.jpg"))
        write_photo(paths[-1], pixels, PhotoMetadata(paths[-1], 640, 480, focal_length_35mm=26.0))
    answer = clock_from_skylines([*paths, str(tmp_path / "missing.jpg")], [*times, times[0]], track, terrain, OPTIONS)
    assert answer.offset_s is None and "cannot be determined" in answer.message


def trek_of(folder, offset_s):
    """Photographs of a real trek, the times of a clock that is ahead, and a track made through their positions."""
    paths = sorted(str(path) for path in (folder / "photos").iterdir())
    known = [read_metadata(path) for path in paths]
    true = np.array([(m.taken_at.replace(tzinfo=timezone.utc).timestamp() - m.utc_offset_s) for m in known])
    order = np.argsort(true)
    time = np.arange(true.min() - 3600, true.max() + 3600, 30.0)
    columns = [[getattr(m, name) for m in known] for name in ("longitude_deg", "latitude_deg", "altitude_m")]
    track = track_of(time, *(np.interp(time, true[order], np.array(column, float)[order]) for column in columns))
    return paths, true + offset_s, track


def test_a_real_trek_tells_its_offset_to_within_fifty_metres(shared_data):
    folder = shared_data / "khumbu-trek"
    paths, times, track = trek_of(folder, 1800.0)
    options = ClockOptions(largest_s=2700.0, kept=(2, 1))
    answer = clock_from_skylines(paths, times, track, open_dem(str(folder / "dem" / "dem.tif")), options)
    assert answer.offset_s is not None, answer.message
    assert abs(answer.offset_s - 1800.0) < Z_90 * answer.sigma_s
    assert np.sqrt(np.mean(np.square(apart_m(track, times, 1800.0, answer.offset_s)))) < 50


def test_real_photographs_of_the_ground_alone_tell_nothing(shared_data, tmp_path):
    folder = shared_data / "khumbu-trek"
    paths, times, track = trek_of(folder, 1800.0)
    cut = []
    for path in paths[::4]:
        photo = read_photo(path, 1024)
        pixels = np.clip(np.rint(photo.pixels[int(0.7 * len(photo.pixels)) :]), 0, 255).astype(np.uint8)
        cut.append(str(tmp_path / Path(path).name))
        size = pixels.shape[1], pixels.shape[0]
        write_photo(cut[-1], pixels, PhotoMetadata(cut[-1], *size, focal_length_35mm=photo.metadata.focal_length_35mm))
    options = ClockOptions(largest_s=2700.0, kept=(2, 1), photos=4)
    answer = clock_from_skylines(cut, times[::4], track, open_dem(str(folder / "dem" / "dem.tif")), options)
    assert answer.offset_s is None and "cannot be determined" in answer.message


def test_cancelling_while_photographs_are_read_gives_no_answer(walk):
    """An answer that there are too few photographs would be untrue."""
    terrain, track, paths, times = walk

    class Stops:
        def report(self, fraction):
            self.at = fraction

        def cancelled(self):
            return getattr(self, "at", 0.0) > 0.0

    with pytest.raises(Cancelled):
        clock_from_skylines(paths[:2], times[:2], track, terrain, OPTIONS, progress=Stops())
