"""Densities over the circle of headings on a fine grid: mixtures, turns, probabilities and arcs.

A density is given relative to the uniform one, so that its mean is 1 and a density of ones says nothing.
"""

from __future__ import annotations

import numpy as np

from ..base.angles import difference, wrap_360

STEP_DEG = 0.1
CELLS = 3600
GRID_DEG = STEP_DEG * np.arange(CELLS)
"""Headings of the cells [degrees]."""


def mixture(heading_deg, sigma_deg, probability):
    """Density of Gaussians and a uniform remainder.

    Parameters
    ----------
    heading_deg, sigma_deg, probability : (K,) arrays
        Centres and standard deviations of the Gaussians [degrees], and the probability of each; what is missing to 1
        is uniform.

    Returns
    -------
    (CELLS,) array
    """
    density = np.full(CELLS, max(1.0 - float(np.sum(probability)), 0.0))
    for centre, sigma, share in zip(heading_deg, sigma_deg, probability):
        density += share * _bell(centre, sigma)
    return density


def moved(density, turn_deg, error):
    """Density of a heading that differs by a known turn and a random error from one with a given density.

    Parameters
    ----------
    density : (CELLS,) array
    turn_deg : float
        [degrees].
    error : (CELLS,) array
        Density of the error, at 0 degrees in the first cell.

    Returns
    -------
    (CELLS,) array
    """
    waves = np.fft.rfftfreq(CELLS, 1.0 / CELLS)
    turned = np.exp(-2j * np.pi * waves * turn_deg / 360.0)
    # The last wave of an even number of cells has no phase of its own.
    turned[-1] = turned[-1].real
    found = np.fft.irfft(np.fft.rfft(density) * np.fft.rfft(error) * turned, CELLS) / CELLS
    return np.maximum(found, 1e-12)


def mirrored(density):
    """Density of the negative angle."""
    return np.roll(density[::-1], 1)


def probability_near(density, heading_deg, reach_deg):
    """Probability of a distance of at most `reach_deg` from each heading.

    Parameters
    ----------
    density : (CELLS,) array
    heading_deg : float or array
    reach_deg : float
        [degrees].
    """
    total = np.concatenate([[0.0], np.cumsum(np.tile(density, 3))])
    centre = CELLS + wrap_360(heading_deg) / STEP_DEG + 0.5
    reach = reach_deg / STEP_DEG
    cells = np.arange(len(total))
    return (np.interp(centre + reach, cells, total) - np.interp(centre - reach, cells, total)) / total[CELLS]


def best_heading(density, reach_deg):
    """Heading whose surroundings hold the largest probability, moved to their mean [degrees].

    Parameters
    ----------
    density : (CELLS,) array
    reach_deg : float
    """
    centre = GRID_DEG[probability_near(density, GRID_DEG, reach_deg).argmax()]
    away = difference(GRID_DEG, centre)
    weight = np.where(np.abs(away) <= reach_deg, density, 0.0)
    return float(wrap_360(centre + (weight * away).sum() / weight.sum()))


def shortest_arc(density, heading_deg, mass=0.9):
    """Shortest arc that holds a probability; among equally short ones that around a heading.

    Parameters
    ----------
    density : (CELLS,) array
    heading_deg : float
    mass : float

    Returns
    -------
    lo_deg, hi_deg : float
        Clockwise from lo to hi [degrees].
    """
    total = np.concatenate([[0.0], np.cumsum(np.tile(density, 2))])
    start = np.arange(CELLS)
    stop = np.searchsorted(total, total[start] + mass * total[CELLS])
    length = np.minimum(stop - start, CELLS)
    away = np.abs(difference((start + length / 2 - 0.5) * STEP_DEG, heading_deg))
    first = int(np.lexsort((away, length))[0])
    low = (first - 0.5) * STEP_DEG
    return float(wrap_360(low)), float(wrap_360(low + length[first] * STEP_DEG))


def _bell(centre_deg, sigma_deg):
    away = difference(GRID_DEG, centre_deg)
    bell = np.exp(-0.5 * np.square(away / max(sigma_deg, STEP_DEG)))
    return bell / bell.mean()
