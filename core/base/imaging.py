"""Picture operations, by OpenCV if it is installed and by SciPy otherwise.

This is the only module outside `core.io` that uses OpenCV. Every operation has a SciPy or NumPy implementation with
the same result up to rounding (`tests/core/base/test_imaging.py`); OpenCV is only faster. Borders are mirrored about
the edge pixel's centre unless stated otherwise.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from scipy import ndimage, sparse

from . import imaging
from .optional import available

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

GREY_WEIGHTS = (9798, 19235, 3735)
"""BT.601 luma weights in units of 2^-15, the fixed-point form in which OpenCV rounds."""

SRGB_TO_XYZ = np.array(
    [[0.412453, 0.357580, 0.180423], [0.212671, 0.715160, 0.072169], [0.019334, 0.119193, 0.950227]], np.float32
)
"""Linear sRGB to CIE XYZ, white point D65 (IEC 61966-2-1)."""

MEDIAN_TILE_PX = 128
LARGE = 90_000_000
"""Number of values (30 megapixels in colour) above which a picture is shrunk in strips to save memory."""

STRIP_PX = 32
REMAP_LIMIT_PX = 32_767  # cv2.remap refuses a longer side


def _cv2() -> Any:
    """Give OpenCV or None; tests replace this function to remove OpenCV."""
    return available("cv2")


def to_grey(pixels: np.ndarray) -> np.ndarray:
    """Convert a uint8 (H, W, 3) RGB picture to BT.601 luma, uint8 (H, W), rounded as OpenCV does."""
    cv2 = _cv2()
    if cv2:
        return cv2.cvtColor(np.ascontiguousarray(pixels), cv2.COLOR_RGB2GRAY)
    total = np.full(pixels.shape[:2], 1 << 14, np.int32)
    for channel, weight in enumerate(GREY_WEIGHTS):
        total += pixels[..., channel].astype(np.int32) * weight
    return (total >> 15).astype(np.uint8)


def rgb_to_lab(rgb: ArrayLike) -> np.ndarray:
    """Convert an sRGB picture to CIE L*a*b* (D65).

    Parameters
    ----------
    rgb : (..., 3) array
        sRGB, 0 to 255, integer or float.

    Returns
    -------
    (..., 3) float32 array
        L* from 0 to 100, a* and b*.
    """
    value = np.asarray(rgb, np.float32) / np.float32(255)
    linear = np.where(value <= 0.04045, value / 12.92, ((np.maximum(value, 0) + 0.055) / 1.055) ** 2.4)
    xyz = linear.astype(np.float32) @ (SRGB_TO_XYZ / SRGB_TO_XYZ.sum(1, keepdims=True)).T
    root = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    x, y, z = root[..., 0], root[..., 1], root[..., 2]
    lightness = np.where(xyz[..., 1] > 0.008856, 116 * y - 16, 903.3 * xyz[..., 1])
    return np.stack([lightness, 500 * (x - y), 200 * (y - z)], -1).astype(np.float32)


def shrink(image: np.ndarray, width_px: int, height_px: int) -> np.ndarray:
    """Reduce a picture by exact area averaging to a float32 one.

    Parameters
    ----------
    image : (H, W) or (H, W, C) array, uint8 or float32
    width_px, height_px : int
        Size of the result, neither side larger than the picture's own [pixels].
    """
    height, width = image.shape[:2]
    if not (1 <= width_px <= width and 1 <= height_px <= height):
        raise ValueError(f"cannot shrink {width} x {height} to {width_px} x {height_px} pixels")
    if (height_px, width_px) == (height, width):
        return image.astype(np.float32)
    cv2 = _cv2()
    if cv2 and image.size <= LARGE:
        # Bytes are averaged as floats: rounding to whole grey levels would remove the edges of faint distant ridges.
        return cv2.resize(image.astype(np.float32), (width_px, height_px), interpolation=cv2.INTER_AREA)
    # Pillow's box filter is not used, because it weights whole pixels by their centres: on a photograph of 3872 x 2592
    # pixels reduced to 1024 x 685 it differs from OpenCV's area averages by up to 17 levels of 255 (0.7 on average),
    # this code by 0.0001.
    down, across = _area_weights(height, height_px), _area_weights(width, width_px)
    out = np.empty((height_px, width_px) + image.shape[2:], np.float32)
    for top in range(0, height_px, STRIP_PX):
        # Work in strips, so that a hundred megapixels are never held as floats at once.
        weights = down[top : top + STRIP_PX]
        first, last = weights.indices.min(), weights.indices.max() + 1
        rows = weights[:, first:last] @ image[first:last].reshape(last - first, -1).astype(np.float32)
        columns = rows.reshape(len(rows), width, -1).transpose(1, 0, 2).reshape(width, -1)
        strip = (across @ columns).reshape(width_px, len(rows), -1).transpose(1, 0, 2)
        out[top : top + STRIP_PX] = strip.reshape((len(rows), width_px) + image.shape[2:])
    return out


def shrink_to(image: np.ndarray, long_side_px: float) -> np.ndarray:
    """Reduce a picture by `shrink` to a long side [pixels]; a smaller picture keeps its size."""
    height, width = image.shape[:2]
    factor = min(1.0, long_side_px / max(height, width))
    return shrink(image, max(1, round(width * factor)), max(1, round(height * factor)))


def _area_weights(size: int, size_out: int) -> sparse.csr_matrix:
    """Make the sparse (size_out, size) matrix that averages the old pixels within each new pixel."""
    edges = np.arange(size_out + 1) * (size / size_out)
    cuts = np.unique(np.concatenate([edges, np.arange(size + 1)]))
    middle, length = (cuts[1:] + cuts[:-1]) / 2, np.diff(cuts)
    target = np.minimum((middle * size_out / size).astype(int), size_out - 1)
    weights = sparse.coo_matrix(
        (length * (size_out / size), (target, np.minimum(middle.astype(int), size - 1))), shape=(size_out, size)
    )
    return weights.tocsr().astype(np.float32)


def gaussian_blur(image: np.ndarray, sigma_px: float | tuple[float, float]) -> np.ndarray:
    """Blur a float32 (H, W) or (H, W, C) picture by a Gaussian truncated at four sigmas.

    `sigma_px` is one number or (down, across) [pixels]; 0 does not blur in that direction.
    """
    down, across = np.broadcast_to(np.asarray(sigma_px, float), 2)
    cv2 = _cv2()
    if cv2:
        size = (2 * int(4 * across + 0.5) + 1, 2 * int(4 * down + 0.5) + 1)
        kernels = [cv2.getGaussianKernel(n, max(s, 1e-3), cv2.CV_32F) for n, s in zip(size, (across, down))]
        return cv2.sepFilter2D(np.ascontiguousarray(image, np.float32), cv2.CV_32F, *kernels)
    sigmas = (down, across) + (0,) * (image.ndim - 2)
    return ndimage.gaussian_filter(image.astype(np.float32), sigmas, mode="mirror", truncate=4.0)


def box_mean(image: np.ndarray, width_px: int, height_px: int) -> np.ndarray:
    """Average over a centred rectangle.

    Parameters
    ----------
    image : (H, W) or (H, W, C) array
    width_px, height_px : int
        Sides of the rectangle, both odd [pixels].

    Returns
    -------
    array
        Averages in the picture's shape: uint8, rounded, for a uint8 picture, otherwise float32.
    """
    cv2 = _cv2()
    if cv2:
        image = image if image.dtype == np.uint8 else image.astype(np.float32)
        return cv2.blur(np.ascontiguousarray(image), (width_px, height_px))
    size = (height_px, width_px) + (1,) * (image.ndim - 2)
    mean = ndimage.uniform_filter(image.astype(np.float64), size, mode="mirror")
    return np.rint(mean).astype(np.uint8) if image.dtype == np.uint8 else mean.astype(np.float32)


def median(image: np.ndarray, size_px: int) -> np.ndarray:
    """Take the median over a centred odd square of a uint8 (H, W) picture, with replicated borders."""
    cv2 = _cv2()
    if cv2:
        return cv2.medianBlur(np.ascontiguousarray(image), size_px)
    half = size_px // 2
    padded = np.pad(image, half, mode="edge")
    out = np.empty_like(image)
    for top in range(0, image.shape[0], MEDIAN_TILE_PX):
        for left in range(0, image.shape[1], MEDIAN_TILE_PX):
            reach = MEDIAN_TILE_PX + 2 * half
            tile = padded[top : top + reach, left : left + reach]
            out[top : top + MEDIAN_TILE_PX, left : left + MEDIAN_TILE_PX] = _median_by_levels(tile, size_px)
    return out


def _median_by_levels(tile: np.ndarray, size_px: int) -> np.ndarray:
    """Take the median of every full window of a tile by counting the pixels at or below each grey level."""
    low, high = int(tile.min()), int(tile.max())
    result = np.full((tile.shape[0] - size_px + 1, tile.shape[1] - size_px + 1), low, np.uint8)
    for level in range(low, high):
        count = np.zeros((tile.shape[0] + 1, tile.shape[1] + 1), np.int32)
        count[1:, 1:] = (tile <= level).cumsum(0).cumsum(1)
        inside = count[size_px:, size_px:] - count[:-size_px, size_px:] - count[size_px:, :-size_px]
        result += (inside + count[:-size_px, :-size_px]) * 2 < size_px * size_px
    return result


def laplacian(image: np.ndarray) -> np.ndarray:
    """Apply the 4-neighbour Laplacian to a uint8 or float (H, W) picture; the result is signed float32."""
    cv2 = _cv2()
    if cv2:
        return cv2.Laplacian(np.ascontiguousarray(image), cv2.CV_32F, ksize=1)
    return ndimage.laplace(image.astype(np.float32), mode="mirror")


def erode(mask: np.ndarray, width_px: int, height_px: int) -> np.ndarray:
    """Shrink the true part of a mask by a centred rectangle; the picture's border does not erode it.

    Parameters
    ----------
    mask : (H, W) bool array
    width_px, height_px : int
        Sides of the rectangle, both odd [pixels].
    """
    cv2 = _cv2()
    if cv2:
        return cv2.erode(mask.astype(np.uint8), np.ones((height_px, width_px), np.uint8)) > 0
    return ndimage.minimum_filter(mask.astype(np.uint8), (height_px, width_px), mode="constant", cval=1) > 0


def maximum_down(image: np.ndarray, size_px: int) -> np.ndarray:
    """Take the maximum in a centred odd window along each column of a float32 (H, W) picture."""
    cv2 = _cv2()
    if cv2:
        return cv2.dilate(np.ascontiguousarray(image, np.float32), np.ones((size_px, 1), np.uint8))
    return ndimage.maximum_filter1d(image.astype(np.float32), size_px, axis=0, mode="nearest")


def accumulate_down(step: np.ufunc, values: np.ndarray) -> np.ndarray:
    """Running sum or maximum of each column: `step.accumulate(values, 0)` to the last digit, but row by row.

    NumPy goes down one column after the other, against the order in memory; whole rows take a sixth of the time.
    """
    total = np.array(values)
    for row in range(1, len(total)):
        step(total[row - 1], total[row], out=total[row])
    return total


def sample_bilinear(image: np.ndarray, x_px: np.ndarray, y_px: np.ndarray, outside: float = 0.0) -> np.ndarray:
    """Interpolate a picture at points.

    This function is separate from `base.terrain.bilinear`, because OpenCV interpolates many times faster but in steps
    of 1/32 pixel, which is fine enough for pictures and too coarse for terrain.

    Parameters
    ----------
    image : (H, W) array
    x_px, y_px : array
        Points, of any common shape [pixels].
    outside : float
        Result for points beyond the border and for NaN coordinates.

    Returns
    -------
    float32 array
        Values in the points' shape.
    """
    finite = np.isfinite(x_px) & np.isfinite(y_px)
    x = np.where(finite, x_px, -9.0).astype(np.float32)
    y = np.where(finite, y_px, -9.0).astype(np.float32)
    cv2 = _cv2()
    if cv2 and x.ndim == 2 and max(image.shape + x.shape) < REMAP_LIMIT_PX:
        image = np.ascontiguousarray(image, np.float32)
        return cv2.remap(image, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=float(outside))
    image = image.astype(np.float32)
    return ndimage.map_coordinates(image, [y, x], order=1, mode="grid-constant", cval=float(outside))


THUMBNAIL_PX = 64
"""Long side of a thumbnail [pixels]: too coarse for trees and gullies, fine enough for the faces of mountains."""


def thumbnail(pixels: np.ndarray, crop: tuple[int, int, int, int] = (0, 0, 0, 0)) -> np.ndarray:
    """Reduce a picture to a thumbnail.

    Parameters
    ----------
    pixels : (H, W, 3) array
        Upright RGB, 0 to 255.
    crop : (top, bottom, left, right) ints
        Rows and columns of `pixels` that are border or caption.

    Returns
    -------
    (h, w, 3) float32 array
        Thumbnail whose long side is `THUMBNAIL_PX` or the picture's own, whichever is smaller; NaN if any part of a
        pixel is cropped.
    """
    height, width = pixels.shape[:2]
    top, bottom, left, right = crop
    if any(crop):
        shown = np.full(pixels.shape, np.nan, np.float32)
        inside = slice(top, height - bottom), slice(left, width - right)
        shown[inside] = pixels[inside]
        pixels = shown
    return imaging.shrink_to(pixels[..., :3], THUMBNAIL_PX)
