"""What stands before the mountains: flags, wires, flare (sky stays sky); people, poles, window frames (ground).

Pictures are float32 (H, W, 3) RGB, 0 to 255; `generator` is a NumPy Generator. OpenCV draws, in pixels.
"""

from __future__ import annotations

import cv2
import numpy as np
from data import GROUND

FLAG_COLOURS = ((20, 80, 200), (245, 245, 245), (210, 40, 40), (60, 160, 60), (235, 210, 40))


def add_flags(generator, image):
    """Strings of prayer flags across the picture."""
    height, width = image.shape[:2]
    image = _bytes(image)
    light = generator.uniform(0.4, 1)
    for _ in range(generator.integers(1, 5)):
        ends = generator.uniform(-0.2, 0.9, 2) * height
        left, right = generator.uniform(-0.3, 0.3) * width, generator.uniform(0.6, 1.3) * width
        way = np.linspace(0, 1, generator.integers(8, 40))
        across = left + (right - left) * way
        down = ends[0] + (ends[1] - ends[0]) * way + generator.uniform(0, 0.25) * height * 4 * way * (1 - way)
        cv2.polylines(image, [np.int32(np.stack([across, down], 1))], False, (60, 60, 60), 1, cv2.LINE_AA)
        size = generator.uniform(0.008, 0.06) * width
        for index, (x, y) in enumerate(zip(across, down)):
            if generator.random() < 0.15:
                continue
            slant = generator.uniform(-0.5, 0.5) * size
            corners = [[x - size / 2, y], [x + size / 2, y], [x + size / 2 + slant, y + size * 1.2]]
            corners.append([x - size / 2 + slant, y + size * 1.2])
            colour = tuple(float(v * light) for v in FLAG_COLOURS[index % len(FLAG_COLOURS)])
            cv2.fillConvexPoly(image, np.int32(corners), colour, cv2.LINE_AA)
    return image.astype(np.float32)


def add_wires(generator, image):
    """Straight or sagging wires."""
    height, width = image.shape[:2]
    image = _bytes(image)
    for _ in range(generator.integers(1, 6)):
        ends = generator.uniform(-0.1, 0.9, 2) * height
        way = np.linspace(0, 1, 20)
        down = ends[0] + (ends[1] - ends[0]) * way + generator.uniform(0, 0.1) * height * 4 * way * (1 - way)
        grey = float(generator.uniform(10, 110))
        points = np.int32(np.stack([way * width, down], 1))
        cv2.polylines(image, [points], False, (grey,) * 3, int(generator.integers(1, 3)), cv2.LINE_AA)
    return image.astype(np.float32)


def add_flare(generator, image):
    """A low sun: its glow, ghosts on the line through the middle, streaks."""
    height, width = image.shape[:2]
    x, y = generator.uniform(0, width), generator.uniform(0, 0.6 * height)
    rows, columns = np.mgrid[:height, :width].astype(np.float32)
    distance = np.hypot(columns - x, rows - y)
    light = generator.uniform(60, 220) * np.exp(-distance / (generator.uniform(0.05, 0.4) * width))
    image = image + light[..., None] * np.array([1, 0.95, 0.85], np.float32)
    for _ in range(generator.integers(0, 6)):
        along, radius = generator.uniform(0.3, 2.2), generator.uniform(0.01, 0.09) * width
        ghost = np.hypot(columns - x - along * (width / 2 - x), rows - y - along * (height / 2 - y)) < radius
        ghost = cv2.GaussianBlur(ghost.astype(np.float32), (0, 0), generator.uniform(0.6, 3))
        image = image + (ghost * generator.uniform(10, 60))[..., None] * generator.uniform(0.3, 1, 3)
    for _ in range(generator.integers(0, 3)):
        angle = generator.uniform(0, np.pi)
        off = np.abs((columns - x) * np.sin(angle) - (rows - y) * np.cos(angle))
        streak = generator.uniform(10, 60) * np.exp(-off / generator.uniform(1, 6) - distance / (0.5 * width))
        image = image + streak[..., None]
    return np.clip(image, 0, 255).astype(np.float32)


def add_specks(generator, image):
    """Birds, drops and dust."""
    height, width = image.shape[:2]
    image = _bytes(image)
    for _ in range(generator.integers(1, 10)):
        middle = int(generator.uniform(0, width)), int(generator.uniform(0, height))
        colour = tuple(float(v) for v in generator.uniform(0, 255, 3))
        cv2.circle(image, middle, int(generator.integers(1, 5)), colour, -1, cv2.LINE_AA)
    return image.astype(np.float32)


def add_figures(generator, image, label):
    """People, poles and posts that rise from the lower edge; ground."""
    height, width = label.shape
    shape = np.zeros(label.shape, np.uint8)
    for _ in range(generator.integers(1, 4)):
        x, top = generator.uniform(0, width), generator.uniform(0.05, 0.8) * height
        if generator.random() < 0.5:
            wide = generator.uniform(0.006, 0.04) * width
            lean = generator.normal(0, 0.04) * height
            corners = [[x - wide / 2, top], [x + wide / 2, top], [x + wide + lean, height], [x - wide + lean, height]]
            cv2.fillConvexPoly(shape, np.int32(corners), 255, cv2.LINE_AA)
        else:
            head = generator.uniform(0.02, 0.12) * width
            body = (head * generator.uniform(1.4, 2.2), (height - top) * 0.8)
            cv2.ellipse(shape, (int(x), int(top + head)), (int(head * 0.8), int(head)), 0, 0, 360, 255, -1, cv2.LINE_AA)
            middle = int(x), int(top + 1.7 * head + body[1])
            cv2.ellipse(shape, middle, (int(body[0]), int(body[1])), 0, 0, 360, 255, -1, cv2.LINE_AA)
    return _painted(generator, image, label, shape)


def add_frame(generator, image, label):
    """A window's frame, a car's roof or a dark corner; ground."""
    height, width = label.shape
    inside = np.zeros(label.shape, np.uint8)
    left, right = generator.uniform(-0.1, 0.2, 2) * width
    top, bottom = generator.uniform(-0.1, 0.2, 2) * height
    corners = np.array([[left, top], [width - right, top], [width - right, height - bottom], [left, height - bottom]])
    corners = corners + generator.normal(0, 0.03, (4, 2)) * (width, height)
    cv2.fillConvexPoly(inside, np.int32(corners), 255, cv2.LINE_AA)
    inside = cv2.GaussianBlur(inside, (0, 0), generator.uniform(0.5, 4))
    return _painted(generator, image, label, 255 - inside)


def _painted(generator, image, label, shape):
    """Fill a shape (0 to 255) with one uneven colour and call it ground."""
    colour = generator.uniform(0, 90) + generator.uniform(0, 60, 3)
    if generator.random() < 0.25:
        colour = colour + generator.uniform(0, 130)
    grid = generator.standard_normal((generator.integers(2, 12), generator.integers(2, 12))).astype(np.float32)
    texture = cv2.resize(grid, label.shape[::-1], interpolation=cv2.INTER_LINEAR)[..., None]
    filled = np.clip(colour * (1 + generator.uniform(0.05, 0.35) * texture), 0, 255)
    share = (shape / 255.0)[..., None].astype(np.float32)
    return (image * (1 - share) + filled * share).astype(np.float32), np.where(shape > 127, GROUND, label).astype(
        np.uint8
    )


def _bytes(image):
    return np.ascontiguousarray(np.clip(image, 0, 255).astype(np.uint8))
