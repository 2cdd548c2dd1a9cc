"""From light to a phone's pixels: blur, vignetting, exposure, tone curve, noise, noise reduction, sharpening."""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter

from ..base.camera import Camera


def develop(radiance, camera: Camera, scene):
    """Turn a linear picture into 8-bit pixels as a small camera does.

    Parameters
    ----------
    radiance : (H, W, 3) float32 array
        Linear red, green, blue, 0 or more.
    camera : Camera
        Camera, which determines the vignetting.
    scene : SceneOptions

    Returns
    -------
    (H, W, 3) uint8 array
    """
    generator = np.random.Generator(np.random.PCG64([scene.seed, 23]))
    picture = _blur(radiance, scene.blur_px) * _vignette(camera, scene.vignetting)[..., None]
    picture = picture * _exposure(picture) * 2.0**scene.exposure_ev
    encoded = _tone(picture)
    encoded = encoded + _noise(encoded, scene.noise, generator)
    if scene.sharpening > 0:
        soft = _blur(encoded, 1.1)
        edges = encoded - soft
        # Phones sharpen edges and leave flat areas alone.
        encoded = encoded + scene.sharpening * np.sign(edges) * np.maximum(np.abs(edges) - 0.006, 0) * 1.4
    return np.clip(np.rint(encoded * 255), 0, 255).astype(np.uint8)


def _blur(picture, sigma_px):
    if sigma_px <= 0:
        return picture
    return gaussian_filter(picture, (sigma_px, sigma_px, 0), mode="nearest", truncate=3.0)


def _vignette(camera, strength):
    """Natural fall-off with the fourth power of the cosine, scaled to lose `strength` in the corners."""
    centre_x, centre_y = camera.centre_px
    x = (np.arange(camera.width_px) - centre_x)[None, :]
    y = (np.arange(camera.height_px) - centre_y)[:, None]
    r2 = (x * x + y * y) / (centre_x**2 + centre_y**2 + 1)
    return (1 - strength * r2**1.3).astype(np.float32)


def _exposure(picture):
    """Gain that brings the bright parts of the picture close to white and its middle to grey."""
    light = picture[::4, ::4].mean(axis=-1)
    bright, middle = np.percentile(light, 97), np.exp(np.log(light + 1e-3).mean())
    return float(np.clip(0.5 * (0.85 / max(bright, 1e-3)) + 0.5 * (0.22 / middle), 0.3, 6.0))


def _tone(linear):
    """Apply sRGB encoding with a shoulder for highlights and slightly raised contrast."""
    shoulder = np.where(linear > 0.6, 0.6 + 0.4 * np.tanh((linear - 0.6) / 0.4), linear)
    encoded = np.clip(shoulder, 0, 1) ** (1 / 2.2)
    return (encoded + 0.10 * (encoded - 0.5) * (1 - (2 * encoded - 1) ** 2)).astype(np.float32)


def _noise(encoded, level, generator):
    """Photon and read noise left after a camera's noise reduction: slightly blurred grain and blotchy colour."""
    if level <= 0:
        return np.float32(0.0)
    shape = encoded.shape[:2]
    luma = generator.standard_normal(shape, dtype=np.float32)
    luma = 0.6 * luma + 0.7 * _unit(gaussian_filter(luma, 0.8))
    chroma = generator.standard_normal(shape + (3,), dtype=np.float32)
    chroma = _unit(gaussian_filter(chroma, (1.6, 1.6, 0)))
    dark = 1.35 - 0.7 * encoded.mean(axis=-1, keepdims=True)
    return level / 255 * dark * (0.85 * luma[..., None] + 0.5 * chroma)


def _unit(field):
    return field / max(float(field.std()), 1e-9)
