"""From light to pixels."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera
from skyline_viewshed.core.simulate.scene import SceneOptions
from skyline_viewshed.core.simulate.sensor import develop


def test_sensor_noise_has_the_level_asked():
    grey = np.full((200, 300, 3), 0.2, np.float32)
    quiet = {"blur_px": 0.0, "sharpening": 0.0, "vignetting": 0.0}
    camera = Camera(300, 200, 300.0)
    clean = develop(grey, camera, SceneOptions(noise=0.0, **quiet))
    assert clean.std() == 0
    level = [develop(grey, camera, SceneOptions(noise=n, **quiet)).astype(float)[..., 1].std() for n in (1.0, 4.0)]
    assert 0.6 < level[0] < 1.6 and 3.0 < level[1] < 5.5


def test_vignetting_darkens_the_corners_and_sharpening_overshoots_edges():
    camera = Camera(300, 200, 300.0)
    grey = np.full((200, 300, 3), 0.2, np.float32)
    dark = develop(grey, camera, SceneOptions(noise=0.0, vignetting=0.4)).astype(int)
    assert dark[0, 0, 0] < dark[100, 150, 0] - 10
    edge = grey.copy()
    edge[100:] = 0.05
    sharp = develop(edge, camera, SceneOptions(noise=0.0, vignetting=0.0, sharpening=1.0)).astype(int)[:, 150, 1]
    assert sharp.max() > sharp[20] + 3 and sharp.min() < sharp[-20] - 3


QUIET = {"noise": 0.0, "sharpening": 0.0, "vignetting": 0.0, "blur_px": 0.0}


def test_brighter_light_never_gives_a_darker_pixel():
    ramp = np.repeat(np.linspace(0.0, 4.0, 300, dtype=np.float32)[None, :, None], 200, axis=0).repeat(3, axis=2)
    row = develop(ramp, Camera(300, 200, 300.0), SceneOptions(**QUIET))[100, :, 1].astype(int)
    assert (np.diff(row) >= 0).all() and row[0] < 5 and row[-1] > 245


@pytest.mark.parametrize("gain", [0.5, 2.0])
def test_automatic_exposure_makes_up_for_the_light(gain):
    light = np.random.default_rng(0).uniform(0.1, 0.4, (200, 300, 3)).astype(np.float32)
    camera, scene = Camera(300, 200, 300.0), SceneOptions(**QUIET)
    plain, other = (develop(picture, camera, scene).mean() for picture in (light, gain * light))
    assert other == pytest.approx(plain, rel=0.05)


def test_over_and_under_exposure_are_stops_apart():
    grey = np.full((200, 300, 3), 0.2, np.float32)
    levels = [develop(grey, Camera(300, 200, 300.0), SceneOptions(exposure_ev=ev, **QUIET)).mean() for ev in (-1, 0, 1)]
    assert levels[0] < levels[1] - 20 and levels[1] < levels[2] - 20


def test_blur_spreads_an_edge_over_its_width():
    edge = np.full((200, 300, 3), 0.05, np.float32)
    edge[:, 150:] = 0.3
    widths = []
    for blur in (0.0, 3.0):
        scene = SceneOptions(**{**QUIET, "blur_px": blur})
        row = develop(edge, Camera(300, 200, 300.0), scene)[100, :, 1].astype(int)
        widths.append(int(((row > row[0] + 3) & (row < row[-1] - 3)).sum()))
    assert widths[0] == 0 and 4 <= widths[1] <= 18
