"""Predict from the DEM alone how well a photograph from a place could be oriented, by direction and field of view.

A stretch of the horizon as wide as the field of view is compared with the horizon in every other direction, after the
best shift and the best tilt that a camera's roll allows. The misfit is counted in tolerances that hold what pictures do
to a skyline (clouds, trees, snow) and the errors of DEM and position, which grow as the terrain comes nearer. The less
the most similar of the other directions differ, the more readily a matcher takes one of them. A regression, fitted by
`tools/fit_orientability.py` on photographs and simulated scenes, turns this into the probability that a photograph is
oriented right.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

TABLE_PATH = Path(__file__).with_name("orientability.json")

SAME_DEG = 3.0
"""Directions nearer than this to the true one are the same answer [degrees]."""

LARGEST_ERROR_DEG = 30.0

PICTURE_WIDTH_PX = 512
"""Width of the picture in which `UniqueOptions.picture_px` is counted [pixels]."""

LARGEST_STANDARD = 3.0
"""Quantities farther than this from their mean count as this far [standard deviations]."""

LEAST_SAMPLES = 20
"""Azimuths at which a frame is compared, if the horizon is that fine; more did not sort better."""

SMALLEST_GAP = 0.03
"""Misfits below this count as this large [tolerances]."""

LEAST_KNOWN = 0.8
"""Smallest share of the frame in which the horizon must be known."""


@dataclass(frozen=True)
class UniqueOptions:
    """Errors that are expected.

    Attributes
    ----------
    step_deg : float
        Step of the directions [degrees].
    likeness_deg : float
        Difference of two horizons that a picture may hide (clouds, trees, snow) [degrees].
    likeness_cells : float
        The same for what the DEM may hide, in cells of the DEM.
    largest_tilt_deg : float
        Tilt of one stretch of the horizon against another that the roll of a camera can explain [degrees].
    alike_share : float
        Share of the other directions, the most similar ones, that decide.
    picture_px : float
        Error of the skyline in a picture `PICTURE_WIDTH_PX` wide, and of the lens, for the expected error [pixels].
    terrain_error_cells : float
        Error of the horizon's height in cells of the DEM, for the expected error.
    position_error_m : float
        Standard deviation of the position [m].
    ground_slope : float
        Height by which a metre of position raises or lowers near terrain [1].
    cap : float
        Largest misfit of one azimuth that counts [tolerances].
    effective_columns : float
        Number of independent groups of columns in a picture, for the expected error.
    twin_columns : float
        The same for twins: so large that only directions that hardly differ share a probability. The regression judges
        the others.
    floor_deg : float
        Error of a heading that remains in any case [degrees].
    """

    step_deg: float = 1.0
    likeness_deg: float = 0.4
    likeness_cells: float = 0.1
    largest_tilt_deg: float = 8.0
    alike_share: float = 0.03
    picture_px: float = 2.0
    terrain_error_cells: float = 0.25
    position_error_m: float = 8.0
    ground_slope: float = 0.5
    cap: float = 2.0
    effective_columns: float = 15.0
    twin_columns: float = 4000.0
    floor_deg: float = 0.1


@dataclass(frozen=True, eq=False)
class Traits:
    """What decides whether a photograph can be oriented, for every direction; NaN where the horizon is not known.

    Attributes
    ----------
    heading_deg : (H,) array
        Clockwise from true north [degrees].
    known_share : (H,) array
        Share of the frame in which the horizon is known.
    relief_deg : (H,) array
        Spread of the horizon in the frame about a straight line [degrees].
    gap : (H,) array
        Misfit that the most similar of the other directions stay below, root mean square with a cap [tolerances].
    twins : (H,) array
        Number of other directions that fit as well; one that fits less well counts less.
    error_deg : (H,) array
        Expected error of the heading if it is the right one [degrees].
    """

    heading_deg: np.ndarray
    known_share: np.ndarray
    relief_deg: np.ndarray
    gap: np.ndarray
    twins: np.ndarray
    error_deg: np.ndarray


@dataclass(frozen=True, eq=False)
class Orientability:
    """Prediction for every direction of one place and field of view.

    Attributes
    ----------
    heading_deg : (H,) array
        Clockwise from true north [degrees].
    probability : (H,) array
        That a photograph is oriented right, within `SAME_DEG`; NaN where the horizon is not known.
    error_deg : (H,) array
        Expected error of its heading if it is [degrees].
    relief_deg : (H,) array
        Spread of the horizon in the frame about a straight line [degrees].
    """

    heading_deg: np.ndarray
    probability: np.ndarray
    error_deg: np.ndarray
    relief_deg: np.ndarray

    @property
    def mean(self):
        """Mean probability over the directions that are known."""
        known = np.isfinite(self.probability)
        return float(self.probability[known].mean()) if known.any() else float("nan")

    @property
    def typical_error_deg(self):
        """Median of the expected errors [degrees]."""
        known = np.isfinite(self.error_deg)
        return float(np.median(self.error_deg[known])) if known.any() else float("nan")

    def towards(self, azimuth_deg, width_deg=45.0):
        """Mean probability of the directions within half a width of an azimuth [degrees]."""
        away = np.abs((self.heading_deg - azimuth_deg + 180) % 360 - 180)
        near = (away <= width_deg / 2) & np.isfinite(self.probability)
        return float(self.probability[near].mean()) if near.any() else float("nan")


@lru_cache(maxsize=1)
def table():
    """Read the shipped weights: from the quantities of `features_of` to a probability."""
    return json.loads(TABLE_PATH.read_text(encoding="utf-8"))


def orientability(elevation_deg, distance_m, hfov_deg, cell_m, options=UniqueOptions()):  # noqa: B008 - frozen
    """Predict for all directions of a place how well a photograph could be oriented.

    Parameters
    ----------
    elevation_deg, distance_m : (A,) arrays
        Horizon at regular azimuths from north; NaN where unknown.
    hfov_deg : float
        Horizontal field of view [degrees].
    cell_m : float
        Size of the DEM's cells [m].
    options : UniqueOptions

    Returns
    -------
    Orientability
    """
    traits = traits_of(elevation_deg, distance_m, hfov_deg, cell_m, options)
    return Orientability(traits.heading_deg, probability_of(traits), traits.error_deg, traits.relief_deg)


# parameters: a horizon, a lens, a DEM
def traits_of(elevation_deg, distance_m, hfov_deg, cell_m, options=UniqueOptions(), only=None):  # noqa: B008 - frozen
    """Describe the horizon in every direction of a place; see `Traits`.

    Parameters
    ----------
    elevation_deg, distance_m, hfov_deg, cell_m, options
        As for `orientability`.
    only : (D,) int array or None
        Numbers of the directions that are described, the rest stays NaN; None describes all.

    Returns
    -------
    Traits
    """
    count = int(round(360 / options.step_deg))
    # A narrow frame would otherwise be compared at a handful of azimuths.
    finer = int(np.clip(np.ceil(options.step_deg * LEAST_SAMPLES / hfov_deg), 1, max(len(elevation_deg) // count, 1)))
    fine, step_deg = count * finer, options.step_deg / finer
    at = np.rint(np.arange(fine) * len(elevation_deg) / fine).astype(int) % len(elevation_deg)
    angle, distance = np.asarray(elevation_deg, float)[at], np.asarray(distance_m, float)[at]
    known = np.isfinite(angle) & np.isfinite(distance)
    distance = np.where(known, np.maximum(distance, cell_m), 1e5)
    angle = np.where(known, angle, 0.0)
    reach = max(int(round(hfov_deg / 2 / step_deg)), 2)
    offset = np.arange(-reach, reach + 1)
    around = (np.arange(fine)[:, None] + offset) % fine
    windows = angle[around]
    step_m = options.ground_slope * options.position_error_m
    hidden_deg = np.degrees(np.hypot(options.likeness_cells * cell_m, step_m) / distance)
    alike = np.where(known, 1 / np.hypot(options.likeness_deg, hidden_deg), 0.0)
    wrong_deg = np.degrees(np.hypot(options.terrain_error_cells * cell_m, step_m) / distance)
    exact = np.where(known, 1 / np.hypot(hfov_deg * options.picture_px / PICTURE_WIDTH_PX, wrong_deg), 0.0)
    slope = (np.roll(angle, -1) - np.roll(angle, 1)) / (2 * step_deg)
    found = {name: np.full(count, np.nan) for name in ("relief_deg", "gap", "twins", "error_deg")}
    other_deg = np.abs((np.arange(fine) * step_deg + 180) % 360 - 180)
    share = known[around[::finer]].mean(axis=1)
    wanted = np.arange(count) if only is None else np.asarray(only)
    for number in wanted[share[wanted] > LEAST_KNOWN]:
        first = number * finer
        seen = around[first]
        mean = _misfits(windows, windows[first], alike[seen], offset * step_deg, options)
        # Neighbouring directions fit together; only the best of each group is an answer of its own.
        peak = (mean <= np.roll(mean, 1)) & (mean <= np.roll(mean, -1))
        away = np.roll(other_deg, first) > SAME_DEG
        found["twins"][number] = np.exp(-0.5 * options.twin_columns * mean[peak & away]).sum()
        last = int(options.alike_share * away.sum())
        found["gap"][number] = np.sqrt(np.partition(mean[away], last)[last])
        found["error_deg"][number] = _error_deg(exact[seen], slope[seen], distance[seen], cell_m, options)
        line = np.polyval(np.polyfit(offset, windows[first], 1), offset)
        found["relief_deg"][number] = np.std(windows[first] - line)
    return Traits(np.arange(count) * options.step_deg, known_share=share, **found)


def _misfits(windows, own, weight, offset_deg, options):
    """Mean square misfit of every direction after the best shift and the best tilt that a roll allows, with a cap."""
    square = np.square(weight)
    share = square / square.sum()
    centred = offset_deg - share @ offset_deg
    misfit = windows - own
    misfit = misfit - (misfit @ share)[:, None]
    steepest = np.tan(np.radians(options.largest_tilt_deg))
    tilt = np.clip(misfit @ (share * centred) / (share @ np.square(centred)), -steepest, steepest)
    misfit = weight * (misfit - tilt[:, None] * centred)
    return np.minimum(np.square(misfit), options.cap**2).mean(axis=1)


def _error_deg(weight, slope, distance_m, cell_m, options):
    """Expected error of a heading that is right, from the slope of the horizon and the distance of its terrain."""
    offset = np.arange(len(weight)) - len(weight) // 2
    basis = np.linalg.qr(np.column_stack([weight, weight * offset]))[0]
    steep = weight * slope
    steep = steep - basis @ (basis.T @ steep)
    information = options.effective_columns * np.mean(np.square(steep))
    shift_m = np.hypot(options.position_error_m, options.terrain_error_cells * cell_m)
    shift_deg = np.degrees(shift_m / float(np.median(distance_m)))
    return min(np.sqrt(1 / max(information, 1e-6) + shift_deg**2 + options.floor_deg**2), LARGEST_ERROR_DEG)


def features_of(traits):
    """Return the quantities of the regression, each (H,), in which more is easier; the keys are those of the table."""
    return {"log_gap": np.log(np.maximum(traits.gap, SMALLEST_GAP))}


def probability_of(traits, weights=None):
    """Probability that a photograph is oriented right.

    The regression says whether the terrain differs enough. Directions that hardly differ share what it promises, so
    that the probability on a horizon of four equal peaks is at most a quarter.

    Parameters
    ----------
    traits : Traits
    weights : mapping or None
        None takes the shipped ones.

    Returns
    -------
    (H,) array
    """
    weights = weights or table()
    total = np.full(len(traits.gap), float(weights["bias"]))
    for name, value in features_of(traits).items():
        entry = weights["features"][name]
        standard = np.clip((value - entry["mean"]) / entry["spread"], -LARGEST_STANDARD, LARGEST_STANDARD)
        total = total + entry["weight"] * standard
    return 1 / (1 + np.exp(-total)) / (1 + traits.twins)
