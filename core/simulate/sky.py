"""Sky, sunlight, haze and clouds of a simulated photograph, in linear red, green, blue."""

from __future__ import annotations

import numpy as np

from .noise import noise_tile, smoothstep

HAZE_SCALE_M = 2200.0
"""Height over which haze thins to 1/e [m]."""
MOLECULAR_PER_M = np.array([5.8e-6, 13.5e-6, 33.1e-6])
"""Rayleigh scattering at sea level for red, green, blue [1/m] (Bucholtz 1995, doi:10.1364/AO.34.002765)."""
MOLECULAR_SCALE_M = 8000.0


def sun_light(sun_elevation_deg):
    """Irradiance of the sun after its path through the air (3,); red and weak if the sun is low."""
    elevation = max(sun_elevation_deg, 0.2)
    air_mass = 1 / (np.sin(np.radians(elevation)) + 0.50572 * (elevation + 6.07995) ** -1.6364)  # Kasten, Young 1989
    # The white balance of a photograph removes half of the reddening.
    risen = smoothstep(-1.5, 1.5, sun_elevation_deg)
    return risen * np.array([1.0, 0.97, 0.92]) * 2.6 * np.exp(-air_mass * np.array([0.035, 0.06, 0.105]))


def sky_light(sun_elevation_deg):
    """Irradiance of the whole sky on level ground (3,)."""
    strength = 0.25 + 0.75 * smoothstep(-4.0, 25.0, sun_elevation_deg)
    return np.array([0.30, 0.42, 0.62]) * strength


def daylight(scene):
    """Irradiance of the sun perpendicular to its rays and of the sky on level ground, two (3,) arrays.

    Both are grey under cloud.
    """
    sun, sky = sun_light(scene.sun_elevation_deg), sky_light(scene.sun_elevation_deg)
    if scene.clouds not in ("behind", "lid", "fog"):
        return sun, sky
    overcast = float(smoothstep(0.45, 0.75, scene.cloud_share))
    grey = 0.75 * sky.mean() + 0.10 * sun
    return sun * (1 - 0.9 * overcast), sky + overcast * (grey - sky)


def sky_radiance(turn_deg, tangent, scene, heading_deg):
    """Compute the radiance of the clear sky at every pixel.

    Parameters
    ----------
    turn_deg, tangent : (...) arrays
        Azimuth from the heading [degrees] and tangent of the elevation angle.
    scene : SceneOptions
    heading_deg : float

    Returns
    -------
    (..., 3) float32 array
    """
    elevation = np.arctan(tangent)
    low = np.clip(np.exp(-np.maximum(np.degrees(elevation), -2.0) / 11.0), 0, 1.2)[..., None]
    haze = np.clip(35_000.0 / scene.visibility_m, 0.1, 1.0)
    strength = 0.35 + 0.65 * smoothstep(-4.0, 25.0, scene.sun_elevation_deg)
    zenith = np.array([0.035, 0.150, 0.52]) * (1 - 0.45 * haze) + np.array([0.32, 0.36, 0.42]) * 0.45 * haze
    horizon = np.array([0.30, 0.53, 0.88]) * (1 - 0.5 * haze) + np.array([0.68, 0.70, 0.73]) * 0.5 * haze
    colour = zenith + (horizon - zenith) * low
    to_sun = _cosine_to_sun(turn_deg, elevation, scene, heading_deg)[..., None]
    glow = 0.30 * np.exp((to_sun - 1) * 12) + 0.9 * np.exp((to_sun - 1) * 250)
    warm = smoothstep(22.0, 2.0, scene.sun_elevation_deg)
    tint = np.array([1.0, 0.95, 0.85]) * (1 - warm) + np.array([1.0, 0.72, 0.42]) * warm
    # Opposite a low sun the horizon turns rosy, towards it golden.
    dusk = warm * low * (0.10 + 0.18 * np.clip(to_sun, 0, 1))
    colour = colour * strength + glow * tint + dusk * (tint - colour * strength)
    return colour.astype(np.float32)


def air_light(turn_deg, scene, heading_deg):
    """Radiance of an infinitely thick layer of hazy air along the horizontal.

    Parameters
    ----------
    turn_deg : array
        Azimuths relative to the heading [degrees].
    scene : Scene
    heading_deg : float

    Returns
    -------
    (..., 3) array
    """
    level = sky_radiance(turn_deg, np.zeros_like(turn_deg), scene, heading_deg)
    return level * np.array([0.86, 0.93, 1.0], np.float32)


def transmission(distance_m, eye_m, target_m, visibility_m):
    """Compute the share of light that passes through the air, per colour.

    Parameters
    ----------
    distance_m : (N,) array
        Ground distance [m].
    eye_m : float
    target_m : (N,) array
        Elevations of both ends [m]; air thins exponentially upwards.
    visibility_m : float
        Visual range at sea level, at which contrast falls to 2 % (Koschmieder 1924) [m].

    Returns
    -------
    (N, 3) float32 array
    """
    haze = 3.912 / visibility_m * np.array([0.85, 1.0, 1.25]) * 0.8
    depth = np.multiply.outer(distance_m * _mean_density(eye_m, target_m, HAZE_SCALE_M), haze)
    depth = depth + np.multiply.outer(distance_m * _mean_density(eye_m, target_m, MOLECULAR_SCALE_M), MOLECULAR_PER_M)
    return np.exp(-depth).astype(np.float32)


def _mean_density(low_m, high_m, scale_m):
    """Mean of exp(-z / scale) along a straight line between two elevations."""
    difference = (np.asarray(high_m, float) - low_m) / scale_m
    safe = np.where(np.abs(difference) < 1e-4, 1e-4, difference)
    return np.exp(-low_m / scale_m) * (1 - np.exp(-safe)) / safe


def _cosine_to_sun(turn_deg, elevation, scene, heading_deg):
    turn = np.radians(heading_deg + turn_deg - scene.sun_azimuth_deg)
    sun = np.radians(scene.sun_elevation_deg)
    return np.cos(elevation) * np.cos(sun) * np.cos(turn) + np.sin(elevation) * np.sin(sun)


def cloud_colour(scene):
    """Radiance of sunlit and of shaded cloud, two (3,) arrays."""
    warm = smoothstep(18.0, 2.0, scene.sun_elevation_deg)
    lit = np.array([0.92, 0.92, 0.93]) * (1 - warm) + np.array([0.95, 0.66, 0.50]) * warm
    strength = 0.45 + 0.55 * smoothstep(-4.0, 25.0, scene.sun_elevation_deg)
    return lit * strength, np.array([0.46, 0.49, 0.55]) * strength


def clouds_behind(turn_deg, tangent, scene):
    """Clouds in the sky behind everything: wisps high up, heaps low down.

    Parameters
    ----------
    turn_deg : array
        Azimuths relative to the heading [degrees].
    tangent : array
        Tangents of the elevation angles.
    scene : Scene

    Returns
    -------
    opacity : float32 array
    radiance : (..., 3) float32 array
    """
    elevation = np.degrees(np.arctan(tangent))
    tile = noise_tile(7300 + scene.seed, 1.5)
    # Clouds are flat: seen at a low angle, they crowd together and stretch sideways.
    depth = 28.0 / (np.maximum(elevation, 0.0) + 7.0)
    wisps = tile.sample(turn_deg * 1.6 * depth / 3 + 40, 45 * depth)[..., 0]
    heaps = tile.sample(turn_deg * 2.2, elevation * 5.5)[..., 0]
    wide = tile.sample(turn_deg * 0.4 + 77, elevation * 0.9)[..., 0]
    cut = 1.5 - 2.6 * scene.cloud_share
    thin = 0.75 * smoothstep(cut, cut + 1.6, wisps + 0.5 * wide)
    thick = smoothstep(cut + 0.3, cut + 0.9, heaps + 0.8 * wide) * smoothstep(26.0, 8.0, elevation)
    opacity = np.clip(thin + thick, 0, 0.97)
    lit, shaded = cloud_colour(scene)
    top = tile.sample(turn_deg * 2.2, elevation * 5.5 + 2.2)[..., 0]
    bright = np.clip(0.75 + 0.5 * (heaps - top), 0, 1)[..., None]
    return opacity.astype(np.float32), (shaded + (lit - shaded) * bright).astype(np.float32)


def clouds_before(turn_deg, tangent, ridge_tangent, distance_m, elevation_m, scene):
    """Compute the opacity of cloud between the eye and the terrain.

    Parameters
    ----------
    turn_deg, tangent : (H, W) arrays
        Directions of the pixels.
    ridge_tangent : (H, W) array
        Tangent of the skyline above or below each pixel.
    distance_m, elevation_m : (H, W) arrays
        Distance and elevation of the ground seen; inf and NaN for sky.
    scene : SceneOptions

    Returns
    -------
    opacity : (H, W) float32 array
    bright : (H, W) float32 array
        From 0, shaded, to 1, sunlit.
    """
    tile = noise_tile(8300 + scene.seed, 1.45)
    rough = tile.sample(turn_deg * 3.1, np.degrees(tangent) * 6.0)[..., 0]
    wide = tile.sample(turn_deg * 0.55 + 31, np.degrees(tangent) * 1.1)[..., 0]
    above = np.degrees(np.arctan(tangent)) - np.degrees(np.arctan(ridge_tangent))
    span = float(turn_deg.max() - turn_deg.min())
    scale = max(span / 40.0, 0.12)  # a lid covers the ridge whatever the field of view
    if scene.clouds == "fog":
        near = smoothstep(300.0, 2500.0, np.where(np.isfinite(distance_m), distance_m, 1e6))
        return (near * np.clip(0.985 + 0.01 * rough, 0, 0.995)).astype(np.float32), np.full_like(rough, 0.8)
    if scene.clouds == "valley":
        top = np.nanpercentile(elevation_m, 45) if np.isfinite(elevation_m).any() else 0.0
        level = np.where(np.isfinite(elevation_m), elevation_m, 1e5) + 90 * rough
        far = smoothstep(2500.0, 5000.0, np.where(np.isfinite(distance_m), distance_m, 0.0))
        return (0.96 * far * smoothstep(top + 80, top - 40, level)).astype(np.float32), 0.6 + 0.25 * rough
    if scene.clouds != "lid":
        return np.zeros(turn_deg.shape, np.float32), np.zeros(turn_deg.shape, np.float32)
    # A cap hangs about the ridge over a random part of the width, ragged on all sides.
    course = tile.sample(turn_deg / span * 40 + 0.9 * above / scale + 11, np.full_like(turn_deg, 9.0), 4.0)[..., 0]
    cut = np.quantile(course, 1 - scene.cloud_share)
    body = 1.1 - ((above - 0.9 * scale) / (1.5 * scale)) ** 2
    density = np.minimum(body, 2.2 * (course - cut) + 0.25) + 0.40 * rough + 0.25 * wide
    opacity = smoothstep(-0.10, 0.55, density)
    return np.clip(opacity * 1.05, 0, 0.99).astype(np.float32), np.clip(0.5 + 0.3 * rough, 0, 1).astype(np.float32)
