"""Sentences about the photograph and the place under the mouse."""

from __future__ import annotations

from ..algorithms.shared.i18n import marked, tr
from ..core.base.status import known_status


def photo_words(session):
    """What is known of the photograph that is shown, and the message of its answer while that counts."""
    item, draft = session.item, session.draft
    if item is None:
        return tr("No photograph. Click a point on the map with the selection tool, or a thumbnail below."), ""
    parts = [item.name]
    if draft is not None and draft.pose is not None:
        pose = draft.pose
        parts.append(
            tr("heading {heading}°, pitch {pitch}°, roll {roll}°, field of view {hfov}°").format(
                heading=f"{pose.heading_deg % 360:.1f}", pitch=f"{pose.pitch_deg:+.1f}", roll=f"{pose.roll_deg:+.1f}",
                hfov=f"{draft.camera.hfov_deg:.1f}",
            )
        )  # fmt: skip
    elif draft is not None:
        parts.append(tr("no heading yet: press Snap, drag the horizon, or set a landmark"))
    if draft is not None and not draft.lens_known:
        parts.append(tr("the field of view is assumed"))
    changed = session.history is not None and session.history.changed
    if changed:
        parts.append(tr("changed, not kept"))
    elif item.status:
        parts.append(status_words(item.status))
    return ", ".join(parts) + ".", "" if changed else item.message


def status_words(status):
    """A status in the user's language; a text that is none stays as it is."""
    from ..core.report.facts import status_word

    known = known_status(status)
    return status if known is None else status_word(known, marked)


def place_words(place):
    """What is at the pixel under the mouse.

    Parameters
    ----------
    place : Place
    """
    direction = tr("azimuth {azimuth}°, elevation angle {angle}°").format(
        azimuth=f"{place.azimuth_deg:.1f}", angle=f"{place.elevation_deg:+.1f}"
    )
    if place.on_ground:
        return tr("{elevation} m high, {distance} km away (90 %: {near} to {far} km), {direction}").format(
            elevation=f"{place.elevation_m:.0f}", distance=f"{place.distance_m / 1000:.2f}",
            near=f"{place.near_m / 1000:.2f}", far=f"{place.far_m / 1000:.2f}", direction=direction,
        )  # fmt: skip
    if place.state == "sky":
        return tr("Sky, {direction}").format(direction=direction)
    return tr("Beyond the elevation model or in a hole of it, {direction}").format(direction=direction)


def body_words(body, azimuth_deg, elevation_deg):
    """Where the sun or the moon, which was clicked in the picture, stood.

    Parameters
    ----------
    body : str
        'sun' or 'moon'.
    azimuth_deg, elevation_deg : float
    """
    text = {
        "sun": tr("The sun stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep."),
        "moon": tr("The moon stood at azimuth {azimuth}°, elevation angle {angle}°. Press Snap, or press Keep."),
    }[body]
    return text.format(azimuth=f"{azimuth_deg:.1f}", angle=f"{elevation_deg:+.1f}")
