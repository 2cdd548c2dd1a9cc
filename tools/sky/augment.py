"""Training samples: a random window of a labelled picture under another sky, light, weather and camera."""

from __future__ import annotations

import clutter
import cv2
import numpy as np
import skies
from data import GROUND, IGNORE, SKY

SHAPES = ((192, 256), (192, 256), (160, 256), (256, 192), (224, 224))
"""Heights and widths of samples [pixels], multiples of the network's stride."""

SQUEEZED = {"mmp": (0.85, 1.75), "uav": (0.8, 1.4), "pseudo": (0.8, 1.25), "khumbu": (0.8, 1.25)}
"""Range of widening of each set; `mmp` is photographs of about 3:2 squeezed into squares."""

LITTLE_SKY = 0.15
"""Share of windows whose upper edge lies just above the ridge."""

BOUNDARY_WEIGHT, BOUNDARY_PX = 3.0, 5.0
"""How much more pixels at the boundary count, and how far that reaches."""


CLUTTER = {"flags": 0.2, "wires": 0.2, "flare": 0.2, "specks": 0.1, "figures": 0.2, "frame": 0.1}
"""Share of each kind of thing in the way."""


def sample(generator, pictures, chances, patches, shape):
    """One training sample.

    Parameters
    ----------
    generator : numpy.random.Generator
    pictures : list of Picture
    chances : (n,) array
        Probability of each picture.
    patches : list of uint8 (h, w, 3) arrays
        Skies of other pictures.
    shape : (int, int)
        Height and width of the sample [pixels].

    Returns
    -------
    tuple
        RGB uint8 (H, W, 3), is sky uint8 (H, W), weight float16 (H, W).
    """
    for _ in range(20):
        picture = pictures[generator.choice(len(pictures), p=chances)]
        image, label = window(generator, picture, shape)
        if 0.03 < (label == SKY).mean() < 0.97 or generator.random() < 0.1:
            break
    image = image.astype(np.float32)
    if (label == SKY).mean() > 0.02:
        image, label = weather(generator, image, label, patches)
    image = local_contrast(generator, image)
    image, label = disturb(generator, colour(generator, image), label)
    return camera(generator, image), (label == SKY).astype(np.uint8), pixel_weights(label)


def window(generator, picture, shape):
    """A random window of a picture: place, scale, aspect, roll and mirror."""
    height, width = shape
    tall, wide = picture.label.shape
    low, high = SQUEEZED[picture.source]
    widening = np.exp(generator.uniform(np.log(low), np.log(high)))
    fit = max(width / (wide * widening), height / tall)
    zoom = generator.uniform(-0.1, 0.75) if generator.random() < 0.7 else generator.uniform(-0.25, 0.05)
    scale = fit * np.exp(zoom)
    roll = np.deg2rad(generator.uniform(-20, 20) if generator.random() < 0.25 else generator.normal(0, 4))
    turn = np.array([[np.cos(roll), -np.sin(roll)], [np.sin(roll), np.cos(roll)]])
    matrix = turn @ np.diag([scale * widening, scale])
    if generator.random() < 0.5:
        matrix[:, 0] *= -1
    half = width / 2 / (scale * widening), height / 2 / scale
    middle = [
        np.clip(generator.uniform(0, size), min(reach, size / 2), max(size - reach, size / 2))
        for size, reach in zip((wide, tall), half)
    ]
    if generator.random() < LITTLE_SKY:
        ridge = np.argmax((picture.label == GROUND).mean(1) > 0.1)
        lowest = max(tall - half[1], tall / 2)
        middle[1] = min(ridge + half[1] * (1 - 2 * generator.uniform(0.03, 0.2)), lowest)
    affine = np.column_stack([matrix, np.array([width / 2, height / 2]) - matrix @ middle])
    pixels = picture.pixels
    if scale < 0.8:
        pixels = cv2.GaussianBlur(pixels, (0, 0), 0.35 / scale)
    image = cv2.warpAffine(pixels, affine, (width, height), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT_101)
    label = cv2.warpAffine(
        picture.label, affine, (width, height), flags=cv2.INTER_NEAREST, borderMode=cv2.BORDER_CONSTANT,
        borderValue=IGNORE,
    )  # fmt: skip
    return image, label


def weather(generator, image, label, patches):
    """Another sky, snow, haze and clouds, each at times."""
    ground = label == GROUND
    line = np.where(ground.any(0), ground.argmax(0), len(label)).astype(np.float32)
    if generator.random() < 0.55:
        image = skies.replace_sky(generator, image, label, patches)
    if ground.any() and generator.random() < 0.15:
        image = skies.add_snow(generator, image, label, line)
    if generator.random() < 0.35:
        image = skies.add_haze(generator, image, label, line)
    if generator.random() < 0.4:
        image, label = skies.add_cloud(generator, image, label, line)
    return image, label


def disturb(generator, image, label):
    """One or two things in the way, in a third of the pictures."""
    while generator.random() < 0.3:
        kind = generator.choice(list(CLUTTER), p=list(CLUTTER.values()))
        if kind in ("figures", "frame"):
            image, label = getattr(clutter, f"add_{kind}")(generator, image, label)
        else:
            image = getattr(clutter, f"add_{kind}")(generator, image)
    return image, label


def local_contrast(generator, image):
    """The local tone mapping of telephones, in a quarter of the pictures: relief lifted, the mean evened out."""
    if generator.random() < 0.75:
        return image
    side = min(image.shape[:2])
    light = np.clip(image, 0, 255).mean(2)
    smooth = cv2.GaussianBlur(light, (0, 0), generator.uniform(0.04, 0.25) * side)
    even = smooth.mean() + (smooth - smooth.mean()) * generator.uniform(0.4, 1)
    new = even + (light - smooth) * generator.uniform(1, 2.2)
    return image * (np.clip(new, 0, 255) / np.maximum(light, 1))[..., None]


def colour(generator, image):
    """Other exposure, gamma, white balance, saturation, contrast and vignetting."""
    value = (np.clip(image, 0, 255) / 255) ** generator.uniform(0.6, 1.6)
    value = value * (1 + generator.normal(0, 0.055, 3))
    grey = value.mean(2, keepdims=True)
    saturation = generator.uniform(0, 0.5) if generator.random() < 0.12 else generator.uniform(0.5, 1.5)
    value = grey + (value - grey) * saturation
    value = (value - 0.5) * generator.uniform(0.7, 1.3) + 0.5 + generator.normal(0, 0.07)
    if generator.random() < 0.2:
        height, width = value.shape[:2]
        rows, columns = np.mgrid[:height, :width]
        corner = ((columns / width - 0.5) ** 2 + (rows / height - 0.5) ** 2) / 0.5
        value = value * (1 - generator.uniform(0, 0.6) * corner)[..., None]
    return np.clip(value * 255, 0, 255).astype(np.float32)


def camera(generator, image):
    """Blur, grain and JPEG; uint8."""
    if generator.random() < 0.3:
        image = cv2.GaussianBlur(image, (0, 0), generator.uniform(0.3, 1.3))
    if generator.random() < 0.4:
        image = image + generator.normal(0, generator.uniform(1, 9), image.shape)
    image = np.clip(image, 0, 255).astype(np.uint8)
    if generator.random() < 0.5:
        quality = int(generator.integers(25, 90))
        image = cv2.imdecode(cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, quality])[1], cv2.IMREAD_COLOR)
    return image


def pixel_weights(label):
    """Weight of each pixel in the loss, float16: none where ignored, more at the boundary."""
    ground = (label == GROUND).astype(np.uint8)
    away = cv2.distanceTransform(ground, cv2.DIST_L2, 3) + cv2.distanceTransform(1 - ground, cv2.DIST_L2, 3)
    return ((label != IGNORE) * (1 + BOUNDARY_WEIGHT * np.exp(-away / BOUNDARY_PX))).astype(np.float16)
