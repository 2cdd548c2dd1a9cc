"""Predict from the DEM alone how well a photograph from a place could be oriented, by direction and field of view.

A stretch of the horizon as wide as the field of view is compared with the horizon in every other direction, after the
best shift and tilt, since pitch and roll are not known. If some other stretch is alike within the tolerance that the
errors of picture, DEM and position ask for, a matcher cannot tell the two apart. A regression, fitted by
`tools/fit_orientability.py` on photographs and simulated scenes, turns this and the relief in the frame into the
probability that a photograph is oriented right.
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

LEAST_KNOWN = 0.8
"""Smallest share of the frame in which the horizon must be known."""


@dataclass(frozen=True)
class UniqueOptions:
    """Errors that are expected.

    Attributes
    ----------
    step_deg : float
        Step of the directions [degrees].
    picture_px : float
        Error of the skyline in a picture `PICTURE_WIDTH_PX` wide, and of the lens [pixels].
    terrain_error_cells : float
        Error of the horizon's height in cells of the DEM.
    position_error_m : float
        Standard deviation of the position [m].
    ground_slope : float
        Height by which a metre of position raises or lowers near terrain [1].
    cap : float
        Largest misfit of one azimuth that counts [standard deviations].
    effective_columns : float
        Number of independent groups of columns in a picture, for the expected error.
    twin_columns : float
        The same for twins: so large that only directions that hardly differ share a probability. The regression judges
        the others: of photographs whose other directions fit within a tenth of the tolerance, two thirds are right.
    floor_deg : float
        Error of a heading that remains in any case [degrees].
    """

    step_deg: float = 1.0
    picture_px: float = 2.0
    terrain_error_cells: float = 0.25
    position_error_m: float = 8.0
    ground_slope: float = 0.5
    cap: float = 3.0
    effective_columns: float = 15.0
    twin_columns: float = 1000.0
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
        Misfit of the best other direction, root mean square with a cap [tolerances].
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
    at = np.rint(np.arange(count) * len(elevation_deg) / count).astype(int) % len(elevation_deg)
    angle, distance = np.asarray(elevation_deg, float)[at], np.asarray(distance_m, float)[at]
    known = np.isfinite(angle) & np.isfinite(distance)
    distance = np.where(known, np.maximum(distance, cell_m), 1e5)
    angle = np.where(known, angle, 0.0)
    lift_m = np.hypot(options.terrain_error_cells * cell_m, options.ground_slope * options.position_error_m)
    picture_deg = hfov_deg * options.picture_px / PICTURE_WIDTH_PX
    sigma = np.hypot(picture_deg, np.degrees(lift_m / distance))
    reach = max(int(round(hfov_deg / 2 / options.step_deg)), 2)
    offset = np.arange(-reach, reach + 1)
    around = (np.arange(count)[:, None] + offset) % count
    windows, weights = angle[around], np.where(known[around], 1 / sigma[around], 0.0)
    slope = (np.roll(angle, -1) - np.roll(angle, 1)) / (2 * options.step_deg)
    found = {name: np.full(count, np.nan) for name in ("relief_deg", "gap", "twins", "error_deg")}
    other_deg = np.abs((np.arange(count) * options.step_deg + 180) % 360 - 180)
    share = known[around].mean(axis=1)
    wanted = np.arange(count) if only is None else np.asarray(only)
    for first in wanted[share[wanted] > LEAST_KNOWN]:
        weight = weights[first]
        basis = np.linalg.qr(np.column_stack([weight, weight * offset]))[0]
        misfit = weight * (windows - windows[first])
        misfit -= (misfit @ basis) @ basis.T
        mean = np.minimum(np.square(misfit), options.cap**2).mean(axis=1)
        # Neighbouring directions fit together; only the best of each group is an answer of its own.
        peak = (mean <= np.roll(mean, 1)) & (mean <= np.roll(mean, -1))
        away = np.roll(other_deg, first) > SAME_DEG
        found["twins"][first] = np.exp(-0.5 * options.twin_columns * mean[peak & away]).sum()
        found["gap"][first] = np.sqrt(mean[away].min())
        steep = weight * slope[around[first]]
        steep = steep - basis @ (basis.T @ steep)
        information = options.effective_columns * np.mean(np.square(steep))
        far_m = float(np.median(distance[around[first]]))
        shift_deg = np.degrees(np.hypot(options.position_error_m, options.terrain_error_cells * cell_m) / far_m)
        error_deg = np.sqrt(1 / max(information, 1e-6) + shift_deg**2 + options.floor_deg**2)
        found["error_deg"][first] = min(error_deg, LARGEST_ERROR_DEG)
        line = np.polyval(np.polyfit(offset, windows[first], 1), offset)
        found["relief_deg"][first] = np.std(windows[first] - line)
    return Traits(np.arange(count) * options.step_deg, known_share=share, **found)


def features_of(traits):
    """Return the quantities of the regression, each (H,), in which more is easier; the keys are those of the table."""
    return {
        "gap": traits.gap,
        "log_relief": np.log(np.maximum(traits.relief_deg, 0.02)),
    }


def probability_of(traits, weights=None):
    """Probability that a photograph is oriented right.

    The regression says whether the picture shows enough. Directions that fit as well share what it promises, so that
    the probability on a horizon of four equal peaks is at most a quarter.

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
