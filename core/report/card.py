"""The card of one photograph, laid out so that a person can judge the match in five seconds."""

from __future__ import annotations

from ..base.errors import MissingPackageError
from ..base.overlay_lines import full_size, skyline_residuals_px
from ..figures.overlay import evidence_rgba, focus_box, overlay_svg_lines
from ..figures.profile import horizon_profile_svg, residuals_svg
from ..figures.raster import encode_jpeg, encode_png, resized
from ..figures.score import score_curve_svg, score_rose_svg
from ..figures.text import azimuth, compass_point, degrees, is_known, with_unit
from .facts import compass_difference_deg, fact_groups, file_name, interval_words, percent, pixels_per_degree, status_of
from .overview import badge
from .page import data_url, fact_table
from .pieces import Html, fill, joined, long_text

SPAN = 1000.0
"""Width of a picture in drawing units of its overlay."""


def photo_card(photo, number, extras=None, picture_px=1200, panels=None, say=str):
    """Write a card.

    Parameters
    ----------
    photo : OrientedPhoto
    number : int
        Number of the photo in the run, from 1; the card's anchor is 'photo-<number>'.
    extras : mapping or None
        Further labels and values for the numbers.
    picture_px : int
        Width to which the picture is reduced [pixels].
    panels : uint8 (h, w, 3) array or None
        Figure of the direction of view and the ground in view.
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    Html
    """
    status, figures = status_of(photo), picture_px > 0
    found = photo.orientation.best is not None
    parts = [_judgement(photo, number, picture_px, say) if found else _no_answer(photo, number, picture_px, say)]
    if figures:
        parts += [_plots(photo, say) if found else "", _ground(panels, picture_px, say)]
    return fill(
        "card",
        status=status,
        anchor=f"photo-{number}",
        badge=badge(status, say),
        name=file_name(photo.path),
        origin=_origin(photo),
        body=joined([*parts, _more(photo, extras, figures, say)]),
    )


def origin_words(photo):
    """When, and with which camera, the photo was taken; '' if neither is known."""
    metadata = photo.metadata
    said = []
    if metadata is not None and metadata.taken_at is not None:
        said.append(f"{metadata.taken_at:%Y-%m-%d %H:%M}")
    if metadata is not None and metadata.camera:
        said.append(metadata.camera)
    return " · ".join(said)


def _origin(photo):
    words = origin_words(photo)
    return fill("origin", words=words) if words else ""


def _judgement(photo, number, picture_px, say):
    overlay = _overlay(photo, number, picture_px, say) if picture_px else fill("no_overlay")
    return fill("judgement", overlay=overlay, answer=_answer(photo, say))


def _no_answer(photo, number, picture_px, say):
    answer = joined([_advice(photo), _notes(photo)])
    if photo.preview is None or not picture_px:
        return fill("failed_body", answer=answer)
    return fill("judgement", overlay=_overlay(photo, number, picture_px, say), answer=answer)


def _advice(photo):
    return fill("advice", words=long_text(photo.orientation.message))


def _answer(photo, say):
    orientation, best = photo.orientation, photo.orientation.best
    heading, interval = best.pose.heading_deg % 360, interval_words(orientation, say)
    doubt = {"rejected": say("best guess"), "ambiguous": say("most likely of several")}.get(status_of(photo), "")
    remark = fill("remark", words=doubt) if doubt else ""
    facts = [
        (say("Pitch"), degrees(best.pose.pitch_deg, 1, signed=True)),
        (say("Roll"), degrees(best.pose.roll_deg, 1, signed=True)),
        (say("HFOV"), degrees(best.camera.hfov_deg)),
        (say("Compass − found"), degrees(compass_difference_deg(photo), 1, signed=True)),
        (say("Eye elevation"), with_unit(photo.eye_elevation_m, "m")),
    ]
    if is_known(orientation.ncc):
        facts.append((say("NCC"), with_unit(orientation.ncc, "", 3)))
    listed = joined(fill("fact", label=label, words=words) for label, words in facts)
    rose = score_rose_svg(orientation, photo.compass_true_deg, best.camera.hfov_deg, size=176, say=say)
    return joined(
        [
            fill("heading", heading=azimuth(heading), compass=compass_point(heading, say), remark=remark),
            fill("interval", words=interval) if interval else "",
            _chance(orientation.p_correct, say),
            _advice(photo),
            fill("rose_row", rose=Html(rose), facts=listed),
            _alternatives(orientation, say),
            _notes(photo),
        ]
    )


def _chance(p_correct, say):
    if not is_known(p_correct):
        return ""
    name, words = say("probability"), say("{chance} within 3°").format(chance=percent(p_correct))
    return fill("chance", value=f"{p_correct:.4f}", name=name, words=words)


def _alternatives(orientation, say):
    others = []
    for rank, other in enumerate(orientation.candidates[1:3], 2):
        chance = f" ({percent(other.probability)})" if other.probability is not None else ""
        others.append(f"{rank}: {azimuth(other.pose.heading_deg)}{chance}")
    return fill("alternatives", title=say("Alternatives"), others="; ".join(others)) if others else ""


def _notes(photo):
    notes = joined(fill("note", words=long_text(note)) for note in photo.orientation.notes)
    return fill("notes", notes=notes) if notes else ""


def _overlay(photo, number, picture_px, say):
    """Draw the picture once, its lines once, and two views of both: around the skyline, and whole."""
    key = f"p{number}"
    width, height = full_size(photo)
    tall = SPAN * height / width
    try:
        picture = _picture(photo, picture_px, tall)
    except MissingPackageError as error:
        return fill("overlay_missing", words=error)
    _, top, _, box = (value * SPAN / width for value in focus_box(photo))
    name = f"{file_name(photo.path)}: {say('picture with extracted skyline and DEM horizons')}"
    views = joined(
        fill("overlay_view", view=view, top=f"{first:.1f}", width=f"{SPAN:g}", height=f"{rows:.1f}", name=name, key=key)
        for view, first, rows in (("focus", top, box), ("whole", 0.0, tall))
    )
    lines = Html(overlay_svg_lines(photo, key, SPAN))
    return fill("overlay", key=key, picture=picture, lines=lines, views=views, legend=_legend(photo, say))


def _picture(photo, picture_px, tall):
    parts = []
    if photo.preview is not None:
        pixels = photo.preview[..., :3]
        rows, columns = pixels.shape[:2]
        if columns > picture_px:
            pixels = resized(pixels, picture_px, rows * picture_px / columns)
        parts.append((data_url(encode_jpeg(pixels, 76), "jpeg"), Html()))
    if photo.evidence is not None:
        parts.append((data_url(encode_png(evidence_rgba(photo.evidence)), "png"), Html(' class="evidence"')))
    return joined(
        fill("overlay_image", url=url, width=f"{SPAN:g}", height=f"{tall:.1f}", kind=kind) for url, kind in parts
    )


def _legend(photo, say):
    entries = []
    if photo.skyline is not None:
        entries.append(("key-extracted", say("extracted")))
    if photo.horizon is not None and photo.orientation.best is not None:
        heading = azimuth(photo.orientation.best.pose.heading_deg)
        entries.append(("key-best", say("DEM at {heading}").format(heading=heading)))
        if photo.orientation.candidates[1:]:
            entries.append(("key-alternative", say("alternatives")))
    spans = joined(fill("legend_entry", key=key, words=words) for key, words in entries)
    return fill("legend", entries=spans) if spans else ""


def _plots(photo, say):
    orientation = photo.orientation
    score_name = say("NCC") if photo.evidence is None and orientation.ncc is not None else say("Score")
    plots = [score_curve_svg(orientation, photo.compass_true_deg, score_name, width=760, height=156, say=say)]
    residual_px = skyline_residuals_px(photo)
    if residual_px is not None:
        scale = full_size(photo)[1], pixels_per_degree(photo)
        plots.append(residuals_svg(residual_px, *scale, width=500, height=156, say=say))
    return fill("plots", plots=joined(plots))


def _ground(panels, picture_px, say):
    """Draw the three panels, reduced like the picture; lazy loading would save nothing, and omit them in print."""
    if panels is None:
        return ""
    height, width = panels.shape[:2]
    try:
        small = resized(panels, picture_px, height * picture_px / width) if width > picture_px else panels
        url = data_url(encode_jpeg(small, 80), "jpeg")
    except MissingPackageError:
        return ""  # the overlay's place has said so
    return fill("ground", title=say("Camera heading and visible ground"), url=url, width=width, height=height)


def _more(photo, extras, figures, say):
    tables = joined(fact_table(title, rows) for title, rows in fact_groups(photo, extras, say))
    best = photo.orientation.best
    profile = ""
    if photo.horizon is not None and figures:
        heading, hfov = (best.pose.heading_deg, best.camera.hfov_deg) if best else (None, None)
        profile = horizon_profile_svg(photo.horizon, heading, hfov, width=1280, height=210, say=say)
    title = say("All numbers and the DEM horizon") if profile else say("All numbers")
    return fill("more", title=title, tables=tables, profile=Html(profile))
