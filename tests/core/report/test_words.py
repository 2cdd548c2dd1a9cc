"""Every fixed word of a report and a figure passes through `say`; foreign words never do."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest
from documents import MemoryDocument
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto
from skyline_viewshed.core.figures import ground as figures_panels
from skyline_viewshed.core.figures import overlay as figures_overlay
from skyline_viewshed.core.figures import raster as draw_raster
from skyline_viewshed.core.figures.map import MapData, MapObserver
from skyline_viewshed.core.figures.profile import horizon_profile_svg, residuals_svg
from skyline_viewshed.core.figures.score import score_curve_svg
from skyline_viewshed.core.figures.text import compass_point
from skyline_viewshed.core.report import collection
from skyline_viewshed.core.report.horizon import HorizonReportWriter
from skyline_viewshed.core.report.report import ReportWriter

pytest.importorskip("PIL")

UNITS = {"px", "km", "m", "mm"}
SPOKEN = ("alt", "aria-label", "title")


def say(text):
    """Another language: each letter outside braces is a lambda."""
    return re.sub(r"(\{\w+\})|[A-Za-z]", lambda match: match.group(1) or "λ", text)


class Words(HTMLParser):
    """What a person reads or hears: text outside style and script, and names of pictures."""

    def __init__(self, html):
        super().__init__()
        self.said, self._skip = [], 0
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        self._skip += tag in ("style", "script")
        self.said += [value for name, value in attributes if name in SPOKEN]

    def handle_endtag(self, tag):
        self._skip -= tag in ("style", "script")

    def handle_data(self, data):
        if not self._skip:
            self.said.append(data)


def latin(html):
    """Words in Latin letters, without units."""
    return {word for said in Words(html).said for word in re.findall(r"[A-Za-z]+", said)} - UNITS


def foreign(photo, words="Ωμέγα"):
    """The photo with every text of its own in Greek."""
    notes = (words, words)
    orientation = replace(photo.orientation, message=words, notes=notes)
    metadata = photo.metadata
    if metadata is not None:
        metadata = replace(metadata, path=words, camera=words)
    return replace(photo, path=words, orientation=orientation, metadata=metadata)


def written(photos, monkeypatch=None):
    document = MemoryDocument()
    with ReportWriter(document, "Ω", {"Ω": 1, "Ψ": {"Ω": 2}}, software="Ω", say=say) as writer:
        for photo in photos:
            writer.add(photo, {"Ω": "Ω"}, np.zeros((20, 60, 3), np.uint8))
    return document.text


def test_no_word_of_a_report_stays_english(painted):
    photos = [foreign(painted(status)) for status in ("accepted", "ambiguous", "rejected")]
    photos.append(OrientedPhoto("Ω", Orientation("failed", "Ω")))
    plain = photos[0].metadata
    for reference, height in ((None, "ellipsoid"), ("M", "below sea level")):
        odd = replace(plain, compass_reference=reference, altitude_reference=height)
        photos.append(replace(photos[0], metadata=odd, evidence=None))
    lens = replace(photos[0].camera, k1=0.01)
    photos.append(replace(photos[0], camera=lens))
    html = written(photos)
    assert "λλλ" in html and '<html lang="λλ">' in html
    assert latin(html) == set()


def test_no_word_of_an_index_and_its_pages_stays_english(painted, monkeypatch):
    monkeypatch.setattr(collection, "MOST_ON_ONE_PAGE", 3)
    monkeypatch.setattr(collection, "CARDS_A_PAGE", 2)
    monkeypatch.setattr(MemoryDocument, "folder", "Ω/Ψ")
    photos = [foreign(painted()) for _ in range(4)] + [OrientedPhoto("Ω", Orientation("failed", "Ω"))]
    turned = [replace(photo, compass_true_deg=215.0) for photo in photos[:3]]
    document = MemoryDocument()
    with ReportWriter(document, "Ω", {"Ω": 1}, software="Ω", say=say) as writer:
        for photo in photos + turned:
            writer.add(photo, {"Ω": "Ω"})
    pages = [content.decode() for name, content in document.files.items() if name.endswith(".html")]
    assert len(pages) == 4 and "λλλ" in document.text
    for html in [document.text, *pages]:
        assert latin(html) == set()
    data = json.loads(re.search(r'id="data">(.*?)</script>', document.text).group(1))
    shown = [data["found"], data["rows"], *(words for _, words in data["statuses"])]
    shown += [words for photo in data["photos"] for words in (*photo[1:4], *photo[5])]
    assert {word for said in shown for word in re.findall(r"[A-Za-z]+", re.sub(r"\{\w+\}", "", said))} <= UNITS


def test_no_word_of_a_horizon_report_stays_english(painted):
    for count in (1, 2):
        document = MemoryDocument()
        with HorizonReportWriter(document, "Ω", {"Ω": 1}, software="Ω", say=say) as writer:
            for _ in range(count):
                writer.add("Ω", painted().horizon, 8.0, 46.5, 0.9, {"Ω": "Ω"})
            writer.add_failed("Ω", "Ω")
        assert latin(document.text) == set()


def test_empty_figures_speak_too(painted):
    nothing = Orientation("failed", "Ω")
    horizon = painted().horizon
    unknown = replace(horizon, elevation_deg=np.full_like(horizon.elevation_deg, np.nan))
    drawn = score_curve_svg(nothing, say=say) + horizon_profile_svg(unknown, say=say)
    drawn += residuals_svg(np.full(9, np.nan), say=say)
    assert drawn.count("λλ") >= 3
    assert latin(drawn) == set()


def test_words_in_pictures_are_said(painted, monkeypatch):
    seen = []
    for module in (figures_panels, figures_overlay):
        monkeypatch.setattr(module, "draw_words", lambda pixels, x, y, words, *rest, **more: seen.append(words))
    data = MapData(np.ones((9, 9)), 30.0, observers=(MapObserver(4, 4, 45.0, 50.0),))
    figures_panels.three_panels(painted().preview, data, 90, say=say)
    figures_panels.three_panels(None, replace(data, observers=(MapObserver(4, 4),)), 90, say=say)
    figures_overlay.overlay_image(painted(), 200, say=say)
    words = {word for said in seen for word in re.findall(r"[A-Za-z]{2,}", said)}
    assert len(seen) >= 8 and words == set()
    assert draw_raster.words_width("λ") > 0


def test_compass_points_come_from_one_translated_row():
    german = "N NNO NO ONO O OSO SO SSO S SSW SW WSW W WNW NW NNW"
    assert [compass_point(at, lambda text: german) for at in (0, 45, 90, 135, 359)] == ["N", "NO", "O", "SO", "N"]
    assert [compass_point(at) for at in (0, 22.5, 90, 337.5)] == ["N", "NNE", "E", "NNW"]


def test_foreign_words_are_never_translated(painted):
    heard = []

    def listening(text):
        heard.append(text)
        return text

    photo = foreign(painted(), "secret words of a photograph")
    document = MemoryDocument()
    with ReportWriter(document, "secret", {"secret": "secret"}, software="secret", say=listening) as writer:
        writer.add(photo, {"secret": "secret"})
    assert heard and not [text for text in heard if "secret" in text]
