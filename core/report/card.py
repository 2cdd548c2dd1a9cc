"""One photograph's card: made so that a person judges the match in five seconds."""

from __future__ import annotations

from ..base.errors import MissingPackageError
from ..base.overlay_lines import full_size, skyline_residuals_px
from ..figures.overlay import evidence_rgba, focus_box, overlay_svg_lines
from ..figures.profile import horizon_profile_svg, residuals_svg
from ..figures.raster import encode_jpeg, encode_png, resized
from ..figures.score import score_curve_svg, score_rose_svg
from ..figures.text import azimuth, compass_point, degrees, escape, is_known, with_unit
from .facts import compass_difference_deg, fact_groups, file_name, interval_words, percent, pixels_per_degree, status_of
from .overview import badge
from .page import data_url, fact_table

SPAN = 1000.0
"""Width of a picture in drawing units of its overlay."""


def photo_card(photo, number, extras=None, picture_px=1200, figures=True, panels=None, say=str):
    """Write a card.

    Parameters
    ----------
    photo : OrientedPhoto
    number : int
        Of the photo in the run, from 1; the card's anchor is 'photo-<number>'.
    extras : mapping or None
        Further labels and values for the numbers.
    picture_px : int
        Width to which the picture is reduced [pixels].
    figures : bool
        Draw; else only words and numbers, for very long runs.
    panels : uint8 (h, w, 3) array or None
        Figure of where it looks and what ground it shows.
    say : callable
        See `draw_text`.

    Returns
    -------
    str
        HTML, every foreign text escaped.
    """
    status = status_of(photo)
    if photo.orientation.best is None:
        body = _body_without_answer(photo, number, picture_px if figures else 0, say)
    else:
        body = _judgement(photo, number, picture_px if figures else 0, say)
        body += _plots(photo, say) if figures else ""
    return (
        f'<article class="card item is-{status}" id="photo-{number}"><header>{badge(status, say)}'
        f"<h2><bdi>{escape(file_name(photo.path))}</bdi></h2>{_origin(photo)}</header>"
        f"{body}{_ground(panels, picture_px, say) if figures else ''}{_more(photo, extras, figures, say)}</article>\n"
    )


def _origin(photo):
    metadata = photo.metadata
    said = []
    if metadata is not None and metadata.taken_at is not None:
        said.append(f"{metadata.taken_at:%Y-%m-%d %H:%M}")
    if metadata is not None and metadata.camera:
        said.append(metadata.camera)
    return f'<span class="quiet"><bdi>{escape(" · ".join(said))}</bdi></span>' if said else ""


def _judgement(photo, number, picture_px, say):
    picture = _overlay(photo, number, picture_px, say) if picture_px else ""
    return f'<div class="judge">{picture or "<div></div>"}{_answer(photo, say)}</div>'


def _body_without_answer(photo, number, picture_px, say):
    advice = f'<p class="advice">{escape(photo.orientation.message, 1000)}</p>'
    notes = _notes(photo)
    if photo.preview is None or not picture_px:
        return f'<div class="failed-body">{advice}{notes}</div>'
    overlay = _overlay(photo, number, picture_px, say)
    return f'<div class="judge">{overlay}<div class="answer">{advice}{notes}</div></div>'


def _answer(photo, say):
    orientation, best = photo.orientation, photo.orientation.best
    heading = best.pose.heading_deg % 360
    interval = interval_words(orientation, say)
    status = status_of(photo)
    doubt = {"rejected": say("best guess"), "ambiguous": say("likeliest of several")}.get(status, "")
    remark = f' <span class="remark">{escape(doubt)}</span>' if doubt else ""
    parts = [
        f'<div class="heading">{azimuth(heading)} <small>{escape(compass_point(heading, say))}</small>{remark}</div>',
        f'<div class="interval-line">90 %: {escape(interval)}</div>' if interval else "",
        _chance(orientation.p_correct, say),
        f'<p class="advice">{escape(orientation.message, 1000)}</p>',
    ]
    compass = compass_difference_deg(photo)
    facts = [
        (say("Pitch"), degrees(best.pose.pitch_deg, 1, signed=True)),
        (say("Roll"), degrees(best.pose.roll_deg, 1, signed=True)),
        (say("HFOV"), degrees(best.camera.hfov_deg)),
        (say("Compass − found"), degrees(compass, 1, signed=True)),
        (say("Eye elevation"), with_unit(photo.eye_elevation_m, "m")),
    ]
    if is_known(orientation.ncc):
        facts.append((say("NCC"), with_unit(orientation.ncc, "", 3)))
    listed = "".join(f"<dt>{escape(label)}</dt><dd>{escape(words)}</dd>" for label, words in facts)
    rose = score_rose_svg(orientation, photo.compass_true_deg, best.camera.hfov_deg, size=176, say=say)
    parts.append(f'<div class="rose-row">{rose}<dl class="facts">{listed}</dl></div>')
    parts += [_alternatives(orientation, say), _notes(photo)]
    return f'<div class="answer">{"".join(parts)}</div>'


def _chance(p_correct, say):
    if not is_known(p_correct):
        return ""
    name, words = say("probability"), say("{chance} within 3°").format(chance=percent(p_correct))
    return (
        f'<div class="chance"><progress max="1" value="{p_correct:.4f}" aria-label="{escape(name)}"></progress>'
        f"{escape(words)}</div>"
    )


def _alternatives(orientation, say):
    others = []
    for rank, other in enumerate(orientation.candidates[1:3], 2):
        chance = f" ({percent(other.probability)})" if other.probability is not None else ""
        others.append(escape(f"{rank}: {azimuth(other.pose.heading_deg)}{chance}"))
    title = escape(say("Alternatives"))
    return f'<p class="others"><b>{title}</b> {"; ".join(others)}</p>' if others else ""


def _notes(photo):
    notes = "".join(f"<li>{escape(note, 1000)}</li>" for note in photo.orientation.notes)
    return f'<ul class="notes">{notes}</ul>' if notes else ""


def _overlay(photo, number, picture_px, say):
    """The picture once, its lines once, and two views of both: around the skyline, and whole."""
    key = f"p{number}"
    width, height = full_size(photo)
    tall = SPAN * height / width
    try:
        picture = _picture(photo, picture_px, tall)
    except MissingPackageError as error:
        return f'<figure class="overlay"><p class="overlay-missing">{escape(error)}</p></figure>'
    lines = overlay_svg_lines(photo, key, SPAN)
    _, top, _, box = (value * SPAN / width for value in focus_box(photo))
    name = escape(f"{file_name(photo.path)}: {say('picture with extracted skyline and DEM horizons')}")
    store = (
        f'<svg class="store" aria-hidden="true"><defs><g id="{key}-picture">{picture}</g>'
        f'<g id="{key}-lines" class="lines">{lines}</g></defs></svg>'
    )
    views = "".join(
        f'<svg class="{class_}" viewBox="0 {first:.1f} {SPAN:g} {extent:.1f}" role="img" aria-label="{name}">'
        f'<title>{name}</title><use xlink:href="#{key}-picture"/><use xlink:href="#{key}-lines"/></svg>'
        for class_, first, extent in (("focus", top, box), ("whole", 0.0, tall))
    )
    return f'<figure class="overlay">{store}{views}{_legend(photo, say)}</figure>'


def _picture(photo, picture_px, tall):
    parts = []
    if photo.preview is not None:
        pixels = photo.preview[..., :3]
        rows, columns = pixels.shape[:2]
        if columns > picture_px:
            pixels = resized(pixels, picture_px, rows * picture_px / columns)
        parts.append((data_url(encode_jpeg(pixels, 76), "jpeg"), ""))
    if photo.evidence is not None:
        parts.append((data_url(encode_png(evidence_rgba(photo.evidence)), "png"), ' class="evidence"'))
    return "".join(
        f'<image xlink:href="{url}" width="{SPAN:g}" height="{tall:.1f}" preserveAspectRatio="none"{class_}/>'
        for url, class_ in parts
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
    spans = "".join(f'<span><span class="key {key}"></span>{escape(words)}</span>' for key, words in entries)
    return f"<figcaption>{spans}</figcaption>" if spans else ""


def _plots(photo, say):
    orientation = photo.orientation
    score_name = say("NCC") if photo.evidence is None and orientation.ncc is not None else say("Score")
    curve = score_curve_svg(orientation, photo.compass_true_deg, score_name, width=760, height=156, say=say)
    residual_px = skyline_residuals_px(photo)
    if residual_px is None:
        return f'<div class="plots">{curve}</div>'
    scale = full_size(photo)[1], pixels_per_degree(photo)
    residuals = residuals_svg(residual_px, *scale, width=500, height=156, say=say)
    return f'<div class="plots">{curve}{residuals}</div>'


def _ground(panels, picture_px, say):
    """The three panels, reduced like the picture; lazy loading would spare nothing, and leave them out in print."""
    if panels is None:
        return ""
    height, width = panels.shape[:2]
    try:
        small = resized(panels, picture_px, height * picture_px / width) if width > picture_px else panels
        url = data_url(encode_jpeg(small, 80), "jpeg")
    except MissingPackageError:
        return ""  # the overlay's place has said so
    title = escape(say("Where it looks, and the ground it shows"))
    picture = f'<img src="{url}" alt="{title}" width="{width}" height="{height}">'
    return f'<details class="ground" open><summary>{title}</summary>{picture}</details>'


def _more(photo, extras, figures, say):
    tables = "".join(fact_table(title, rows) for title, rows in fact_groups(photo, extras, say))
    best = photo.orientation.best
    profile = ""
    if photo.horizon is not None and figures:
        heading, hfov = (best.pose.heading_deg, best.camera.hfov_deg) if best else (None, None)
        profile = horizon_profile_svg(photo.horizon, heading, hfov, width=1280, height=210, say=say)
    title = escape(say("All numbers, and the DEM's horizon") if profile else say("All numbers"))
    return f'<details class="more"><summary>{title}</summary><div class="numbers">{tables}</div>{profile}</details>'
