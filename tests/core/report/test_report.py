"""The report as a whole: complete, safe against hostile texts, quiet towards the network, sortable."""

from __future__ import annotations

import base64
import hashlib
import re
import shutil
import subprocess
from dataclasses import replace
from datetime import datetime
from html.parser import HTMLParser

import pytest
from documents import MemoryDocument, report_html
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto
from skyline_viewshed.core.report.report import ReportWriter, picture_width_px

pytest.importorskip("PIL")

HOSTILE = (
    '"><script>alert(1)</script>.jpg',
    "'onmouseover='alert(1)",
    "</title></style></script></svg></bdi><img src=x onerror=alert(1)>",
    "--><!--]]>&lt;&#60;",
    "javascript:alert(1)",
    "evil\u202egpj.exe\u2066",
    "nul\x00 escape\x1b bell\x07\r\n\x85\u2028",
    b"raw \xff\xfe bytes".decode("utf-8", "surrogateescape"),
    "https://example.org/pixel.gif",
    "é" + "\u0301" * 300,
    "x" * 5000,
    "",
)


class Page(HTMLParser):
    """Tags with attributes, and text outside style and script."""

    def __init__(self, html):
        super().__init__()
        self.tags, self.text, self._open = [], [], []
        self.feed(html)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self._open.append(tag)

    def handle_endtag(self, tag):
        while self._open and self._open.pop() != tag:
            pass

    def handle_data(self, data):
        if not set(self._open) & {"style", "script"}:
            self.text.append(data)

    def count(self, tag):
        return sum(name == tag for name, _ in self.tags)


def failed(path="/photos/IMG_0002.HEIC", message="The photo has no position. Add coordinates."):
    return OrientedPhoto(path, Orientation("failed", message))


@pytest.fixture(scope="module")
def html(painted):
    photos = [painted(), painted("ambiguous", "C:\\photos\\b.jpg"), painted("rejected", "/c.jpg"), failed()]
    parameters = {"Method": "robust", "DEM": {"File": "khumbu.tif", "Cell [m]": 92.6}}
    return report_html(
        photos, "A run", parameters, software="Skyline Viewshed 1.2.3", created=datetime(2026, 1, 2, 3, 4)
    )


@pytest.fixture(scope="module")
def page(html):
    return Page(html)


def test_every_photo_has_a_card_a_row_and_a_link_between_them(page):
    anchors = [attributes.get("id") for tag, attributes in page.tags if tag == "article"]
    links = [attributes["href"] for tag, attributes in page.tags if tag == "a" and "href" in attributes]
    assert anchors == ["photo-1", "photo-2", "photo-3", "photo-4"]
    assert links == [f"#{anchor}" for anchor in anchors]
    on_plan = [attributes["xlink:href"] for tag, attributes in page.tags if tag == "a" and "xlink:href" in attributes]
    assert on_plan == links[:3]  # the fourth has no position


def test_a_card_shows_overlay_curve_rose_residuals_and_horizon(page):
    cards = [index for index, (tag, _) in enumerate(page.tags) if tag == "article"]
    names = [attributes.get("aria-label") for _, attributes in page.tags[cards[0] : cards[1]]]
    for figure in ("Score over all headings", "Score by direction, north up", "Image skyline against DEM horizon"):
        assert figure in names
    assert "Horizon of the DEM over all azimuths" in names
    assert sum(bool(name) and "picture with extracted skyline" in name for name in names) == 2


def test_names_numbers_advice_and_run_are_written(page):
    text = " ".join(" ".join(page.text).split())
    for words in (
        "123.4°",
        "ESE",
        "123.00° to 123.80°",
        "97.0 % within 3°",
        "2: 240.4°",
        "The eye lies 12 m above the DEM.",
    ):
        assert words in text
    for words in (
        "b.jpg",
        "The photo has no position. Add coordinates.",
        "khumbu.tif",
        "92.6",
        "Skyline Viewshed 1.2.3",
    ):
        assert words in text
    assert "2026-01-02 03:04" in text
    assert "C:\\photos\\b.jpg" in text


def test_a_failed_photo_gets_a_card_with_its_reason_and_no_empty_figures(html):
    card = html[html.index('id="photo-4"') :]
    card = card[: card.index("</article>")]
    assert "Add coordinates" in card
    assert "<svg" not in card


def test_the_table_can_be_sorted_and_reads_well_without_a_script(page):
    tables = [
        attributes for tag, attributes in page.tags if tag == "table" and "sortable" in attributes.get("class", "")
    ]
    heads = [attributes for tag, attributes in page.tags if tag == "th"]
    cells = [attributes for tag, attributes in page.tags if tag == "td" and "data-sort" in attributes]
    assert len(tables) == 1
    assert len(cells) == 4 * len(heads)
    for index, cell in enumerate(cells):
        if "data-numeric" in heads[index % len(heads)] and cell["data-sort"]:
            float(cell["data-sort"])
    statuses = [cell["data-sort"] for cell in cells[:: len(heads)]]
    assert statuses == ["0", "2", "3", "4"]  # by trust; nothing here is confirmed


def test_every_label_of_the_bar_steers_an_input_that_stands_before_it(page):
    inputs = [attributes["id"] for tag, attributes in page.tags if tag == "input"]
    labels = [attributes["for"] for tag, attributes in page.tags if tag == "label"]
    assert set(labels) <= set(inputs)
    order = [tag for tag, _ in page.tags if tag in ("input", "article")]
    assert order.index("article") > max(index for index, tag in enumerate(order) if tag == "input")


def test_nothing_is_fetched(html, page):
    without_pictures = re.sub(r"data:image/(png|jpeg);base64,[A-Za-z0-9+/=]+", "", html)
    assert "http" not in without_pictures.replace("http-equiv", "")
    for _, attributes in page.tags:
        for name in ("src", "href", "action", "data", "xlink:href"):
            assert attributes.get(name, "#").startswith(("#", "data:image/"))


def test_the_policy_names_exactly_our_style_and_script(html, page):
    (policy,) = [attributes["content"] for _, attributes in page.tags if attributes.get("http-equiv")]
    for tag in ("style", "script"):
        (content,) = re.findall(rf"<{tag}>(.*?)</{tag}>", html, re.DOTALL)
        digest = base64.b64encode(hashlib.sha256(content.encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in policy
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert not [attributes for _, attributes in page.tags if "style" in attributes]


def hostile_photo(painted, words):
    photo = painted(path=words)
    metadata = replace(photo.metadata, path=words, camera=words, altitude_reference=words, compass_reference=words)
    orientation = replace(photo.orientation, message=words, notes=(words, words))
    return replace(photo, metadata=metadata, orientation=orientation)


def skeleton(page):
    """Tags with the names of their attributes: what a hostile text must not change."""
    return [(tag, sorted(attributes)) for tag, attributes in page.tags]


def hostile_report(painted, words):
    writer = ReportWriter(document := MemoryDocument(), words, {words: words, "DEM": {words: words}}, software=words)
    writer.add(hostile_photo(painted, words), {words: words})
    writer.add(failed(words, words))
    writer.close()
    return document.text


@pytest.mark.parametrize("words", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_texts_change_no_tag_and_no_attribute(painted, words):
    text = hostile_report(painted, words)
    text.encode("utf-8")
    assert skeleton(Page(text)) == skeleton(Page(hostile_report(painted, "harmless")))
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]", text)


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(words=st.text(st.characters(codec=None, categories=None), min_size=1, max_size=80))
def test_no_text_at_all_changes_the_page(painted, words):
    assert skeleton(Page(hostile_report(painted, words))) == skeleton(Page(hostile_report(painted, "harmless")))


def test_an_unheard_of_status_becomes_no_class_of_the_page(painted):
    text = report_html([painted('x" onload="alert(1)')], "t")
    assert "onload" not in text
    assert "is-failed" in text


@pytest.mark.parametrize(
    "changes",
    [
        {"preview": None},
        {"evidence": None},
        {"horizon": None},
        {"skyline": None, "evidence": None},
        {"metadata": None, "compass_true_deg": None},
        {"longitude_deg": None, "latitude_deg": None, "eye_elevation_m": None, "ground_elevation_m": None},
        {"convergence_deg": None},
    ],
    ids=str,
)
def test_whatever_is_unknown_is_left_out(painted, changes):
    page = Page(report_html([painted(**changes)], "t"))
    assert page.count("article") == 1
    assert "None" not in "".join(page.text)
    assert "nan" not in "".join(page.text)


def test_without_pillow_the_card_says_so_and_the_rest_stands(painted, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "PIL", None)
    text = report_html([painted()], "t")
    assert "needs the Python package PIL" in text
    assert "Score over all headings" in text


def test_an_error_inside_the_run_leaves_nothing(painted):
    class Watched(MemoryDocument):
        discarded = False

        def discard(self):
            self.discarded = True

    document = Watched()
    with pytest.raises(KeyboardInterrupt), ReportWriter(document, "t") as writer:
        writer.add(painted())
        raise KeyboardInterrupt
    assert document.discarded
    assert document.text == ""


def test_pictures_are_smaller_the_more_there_are():
    assert picture_width_px(10) > picture_width_px(400) > picture_width_px(10_000)


def test_a_browser_runs_the_script_and_sorts(html, tmp_path):
    browser = shutil.which("chromium")
    if browser is None:
        pytest.skip("no chromium to look at the page with")
    click = (
        '<script>document.querySelectorAll("table.sortable th button")[0].click();'
        'document.querySelectorAll("table.sortable th button")[0].click();'
        'document.title="ORDER "+[].map.call(document.querySelectorAll(".overview tbody tr"),'
        "function(row){return row.className}).join()</script></body>"
    )
    whole = tmp_path / "report.html"
    whole.write_text(html, encoding="utf-8")
    clicked = tmp_path / "clicked.html"
    opened = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", html)
    clicked.write_text(opened.replace("</body>", click), encoding="utf-8")
    seen = [dom_of(browser, path, tmp_path) for path in (whole, clicked)]
    assert seen[0].count('<button type="button">') == 11  # our script ran under our policy
    (order,) = re.findall(r"<title>ORDER ([^<]*)", seen[1])
    assert [name.split("-")[-1] for name in order.split(",")] == ["failed", "rejected", "ambiguous", "accepted"]


def dom_of(browser, path, folder):
    flags = "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    flags += "--disable-component-update --disable-sync --virtual-time-budget=2000 --dump-dom"
    done = subprocess.run(
        [browser, *flags.split(), f"--user-data-dir={folder / 'profile'}", path.as_uri()],
        capture_output=True,
        text=True,
        timeout=120,
    )
    return done.stdout
