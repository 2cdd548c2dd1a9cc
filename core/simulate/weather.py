"""The weather of a season: scenes whose light, clouds, foreground and camera faults are drawn at random."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .scene import CLOUDS, FOREGROUNDS, SceneOptions


def hard_scene(seed, **changes):
    """Draw weather, light, foreground and camera faults at random, as they vary over a season of photographs."""
    generator = np.random.Generator(np.random.PCG64([seed, 77]))
    pick = generator.random
    clouds = str(np.array(CLOUDS)[np.searchsorted(np.cumsum([0.42, 0.26, 0.16, 0.04]), pick())])
    foreground = str(np.array(FOREGROUNDS)[np.searchsorted(np.cumsum([0.6, 0.3]), pick())])
    scene = SceneOptions(
        seed=seed,
        sun_azimuth_deg=360 * pick(),
        sun_elevation_deg=4 + 56 * pick() ** 1.3,
        visibility_m=float(np.exp(np.log(2.5e4) + np.log(10) * pick())),
        clouds=clouds,
        snow_share=-0.1 + 1.2 * pick(),
        tree_share=-0.1 + 0.8 * pick(),
        cloud_share=0.1 + 0.7 * pick(),
        foreground=foreground,
        foreground_share=0.1 + 0.5 * pick(),
        exposure_ev=-0.8 + 1.4 * pick(),
        noise=0.8 + 6 * pick() ** 2,
        sharpening=1.2 * pick(),
        blur_px=0.4 + 0.9 * pick() ** 2,
        vignetting=0.4 * pick(),
        texture=0.6 + 0.8 * pick(),
    )
    return replace(scene, **changes)
