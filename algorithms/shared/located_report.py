"""Cards of a located photograph in the report: the best places with their overlays, and a map of the scores."""

from __future__ import annotations

from dataclasses import replace

from .i18n import in_users_language, tr

MOST_PLACES = 3


def add_places(report, located, index):
    """Append the best place of a photograph, with the map of the scores, and the next best ones.

    Parameters
    ----------
    report : PhotoReport
    located : Located
    index : HorizonIndex or None
    """
    from ...core.base.model import Orientation, OrientedPhoto

    if not located.places:
        report.add(OrientedPhoto(located.path, Orientation(located.status, in_users_language(located.message))))
        return
    for number, place in enumerate(located.places[:MOST_PLACES]):
        oriented = place.oriented
        if number:
            oriented = replace(oriented, path=f"{located.path} ({number + 1})")
        report.add(oriented, _facts(place, number), None if number or index is None else _map(located, index))


def _facts(place, number):
    facts = {
        tr("Rank"): str(number + 1),
        tr("Latitude"): f"{place.latitude_deg:.6f}°",
        tr("Longitude"): f"{place.longitude_deg:.6f}°",
        tr("Agreement of the skyline with the horizon"): f"{place.score:.2f}",
    }
    if place.ellipse is not None:
        facts[tr("Error ellipse (90 %), longer half axis (m)")] = f"{place.ellipse.major_m:.0f}"
        facts[tr("Error ellipse (90 %), shorter half axis (m)")] = f"{place.ellipse.minor_m:.0f}"
        facts[tr("Correlation of place and focal length")] = f"{place.ellipse.focal_correlation:.2f}"
    return facts


def _map(located, index):
    from ...core.figures.places import score_map

    places = [(place.longitude_deg, place.latitude_deg) for place in located.places]
    return score_map(index.longitude_deg, index.latitude_deg, located.score, index.spacing_m, places)
