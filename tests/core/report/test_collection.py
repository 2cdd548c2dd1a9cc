"""The report of many photographs: an index, and pages of cards that it refers to."""

from __future__ import annotations

import base64
import hashlib
import io
import json
import re
import shutil
import subprocess

import numpy as np
import pytest
from documents import MemoryDocument
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto
from skyline_viewshed.core.io.report_file import ReportFile
from skyline_viewshed.core.report import collection
from skyline_viewshed.core.report.collection import CardPages, thumbnail_of
from skyline_viewshed.core.report.report import ReportWriter

Image = pytest.importorskip("PIL.Image")


@pytest.fixture
def small_pages(monkeypatch):
    monkeypatch.setattr(collection, "MOST_ON_ONE_PAGE", 5)
    monkeypatch.setattr(collection, "CARDS_A_PAGE", 3)


def written(photos, document=None):
    with ReportWriter(document := document or MemoryDocument(), "Archive", {"Method": "robust"}) as report:
        for photo in photos:
            report.add(photo)
    return document


def failed(path, message="The photo has no position."):
    return OrientedPhoto(path, Orientation("failed", message))


def data_of(text):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', text).group(1))


@pytest.fixture
def seven(painted):
    return [painted(path=f"/p/{k}.jpg", longitude_deg=8 + k / 10) for k in range(4)] + [
        failed("/p/none.jpg"),
        painted("rejected", "/p/5.jpg"),
        painted("ambiguous", "/p/6.jpg", preview=None, longitude_deg=None, latitude_deg=None),
    ]


def test_up_to_the_limit_everything_is_on_one_page(small_pages, seven):
    document = written(seven[:5])
    assert document.files == {}
    assert document.text.count("<article") == 5


def test_above_the_limit_cards_go_to_pages_and_the_page_becomes_an_index(small_pages, seven):
    document = written(seven)
    assert "<article" not in document.text
    pages = [name for name in document.files if name.endswith(".html")]
    assert pages == ["page-0001.html", "page-0002.html", "page-0003.html"]
    cards = [re.findall(r'<article[^>]*id="(photo-\d+)"', document.files[name].decode()) for name in pages]
    assert cards == [["photo-1", "photo-2", "photo-3"], ["photo-4", "photo-5", "photo-6"], ["photo-7"]]
    rows = [re.findall(r'<a href="#(photo-\d+)"', document.files[name].decode()) for name in pages]
    assert rows == cards


def test_pages_link_to_one_another_and_to_the_index(small_pages, seven):
    document = written(seven)
    links = [
        re.findall(r'<a href="([^"#]+)">', document.files[f"page-{number:04d}.html"].decode()) for number in (1, 2, 3)
    ]
    home, first, second, third = document.home, "page-0001.html", "page-0002.html", "page-0003.html"
    assert links == [[home, second] * 2, [home, first, third] * 2, [home, second] * 2]
    assert re.findall(r'<a href="([^"]+)">', document.text) == [
        f"{document.folder}/{name}" for name in (first, second, third)
    ]


def test_the_index_knows_the_status_place_page_and_thumbnail_of_every_photo(small_pages, seven):
    document = written(seven)
    data = data_of(document.text)
    rows = data["photos"]
    assert [data["statuses"][row[0]][0] for row in rows] == ["accepted"] * 4 + ["failed", "rejected", "ambiguous"]
    assert [row[7][:2] for row in rows] == [[1, 0], [1, 1], [1, 2], [2, 0], [2, 1], [2, 2], [3, 0]]
    assert [row[6] is None for row in rows] == [False] * 4 + [True, False, True]
    east = [row[6][0] for row in rows[:4]]
    np.testing.assert_allclose(np.diff(east), 111_195 * 0.1 * np.cos(np.radians(46.5)), rtol=0.01)
    assert rows[4][3] == "The photo has no position." and rows[0][3] == ""
    assert rows[0][4][0] == "123.4" and rows[4][4] == [""] * 9
    assert "Maker Model" in rows[0][2]
    assert rows[4][7][2:] == rows[6][7][2:] == [0, 0]


def test_thumbnails_lie_where_the_index_says(small_pages, seven, monkeypatch):
    shades = [replace_preview(photo, 30 + 30 * k) for k, photo in enumerate(seven[:6])]
    document = written(shades)
    wide, high, row = data_of(document.text)["place"]
    for k, (sheet, place, width, height) in enumerate(entry[7] for entry in data_of(document.text)["photos"]):
        if width:
            picture = np.asarray(Image.open(io.BytesIO(document.files[f"page-{sheet:04d}.jpg"])))
            top, left = place // row * high, place % row * wide
            assert np.abs(picture[top : top + height, left : left + width].astype(int) - (30 + 30 * k)).mean() < 6


def replace_preview(photo, shade):
    from dataclasses import replace

    return photo if photo.preview is None else replace(photo, preview=np.full((60, 80, 3), shade, np.uint8))


@pytest.mark.parametrize(("shape", "size"), [((600, 800), (90, 120)), ((800, 600), (90, 68)), ((100, 1000), (12, 120))])
def test_a_thumbnail_keeps_its_proportions(painted, shape, size):
    assert thumbnail_of(painted(preview=np.zeros((*shape, 3), np.uint8))).shape == (*size, 3)


def test_large_cards_end_pages_before_they_grow_too_large(monkeypatch):
    monkeypatch.setattr(collection, "BYTES_A_PAGE", 100)
    monkeypatch.setattr(collection, "MOST_BYTES_ON_ONE_PAGE", 150)
    pages = CardPages()
    for size in (40, 40, 40):
        pages.add("x" * size, None)
    assert not pages.many
    for size in (10, 300, 5, 5):
        pages.add("x" * size, None)
    assert pages.many
    while pages.take(last=True):
        pass
    assert [(page.first, page.last) for page in pages.pages] == [(1, 2), (3, 4), (5, 5), (6, 7)]


def test_hostile_names_do_not_end_the_data(small_pages):
    names = [
        "</script><script>alert(1)</script>.jpg",
        "evil\u202egpj.exe",
        b"\xff.jpg".decode("utf-8", "surrogateescape"),
    ]
    document = written([failed(name, name) for name in names * 2])
    document.text.encode("utf-8")
    assert document.text.count("<script") == 2
    assert len(data_of(document.text)["photos"]) == 6
    assert not re.search("[\u202a-\u202e\ud800-\udfff]", document.text)


def test_the_index_may_run_its_own_script_only_and_load_pictures_only(small_pages, seven):
    text = written(seven).text
    (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)
    for tag in ("style", "script"):
        content = re.findall(rf"<{tag}>(.*?)</{tag}>", text, re.DOTALL)
        assert len(content) == 1
        digest = base64.b64encode(hashlib.sha256(content[0].encode()).digest()).decode()
        assert f"{tag}-src 'sha256-{digest}'" in policy.replace("&#x27;", "'")
    assert "default-src" in policy and "unsafe" not in policy and "http" not in policy
    assert " style=" not in text


def test_an_error_after_the_first_pages_leaves_nothing(small_pages, seven, tmp_path):
    (tmp_path / "report.html").write_text("older")
    with pytest.raises(KeyboardInterrupt), ReportWriter(ReportFile(tmp_path / "report.html"), "t") as report:
        for photo in seven:
            report.add(photo)
        raise KeyboardInterrupt
    assert [path.name for path in tmp_path.iterdir()] == ["report.html"]
    assert (tmp_path / "report.html").read_text() == "older"


def test_an_error_while_the_last_page_is_written_leaves_nothing(small_pages, seven, tmp_path, monkeypatch):
    with pytest.raises(OSError), ReportWriter(ReportFile(tmp_path / "report.html"), "t") as report:
        for photo in seven:
            report.add(photo)

        def full(*_):
            raise OSError

        monkeypatch.setattr(report._document, "add", full)
    assert list(tmp_path.iterdir()) == []


def test_names_with_signs_of_urls_are_quoted(small_pages, seven, tmp_path):
    written(seven, ReportFile(tmp_path / "50 % #1 ärger.html"))
    text = (tmp_path / "50 % #1 ärger.html").read_text(encoding="utf-8")
    assert '<a href="50%20%25%20%231%20%C3%A4rger_files/cards-' in text
    (page,) = tmp_path.rglob("page-0002.html")
    assert '<a href="../../50%20%25%20%231%20%C3%A4rger.html">' in page.read_text(encoding="utf-8")


STEPS = """
var box=document.querySelector(".status[value=accepted]");
function rows(){return document.querySelectorAll("#table tbody tr").length}
var seen=[rows()];
box.checked=false;box.dispatchEvent(new Event("change"));seen.push(rows());
box.checked=true;box.dispatchEvent(new Event("change"));
var search=document.getElementById("search");
search.value="NO Position";search.dispatchEvent(new Event("input"));seen.push(rows());
search.value="";search.dispatchEvent(new Event("input"));
document.querySelectorAll("#table th button")[2].click();
document.querySelectorAll("#table th button")[2].click();
seen.push(document.querySelector("#table tbody bdi").textContent);
seen.push(document.querySelector("#table tbody a.thumb").getAttribute("href"));
document.title="SEEN "+seen.join("|");
"""


def test_a_browser_filters_searches_and_sorts_the_index(small_pages, seven, tmp_path):
    browser = shutil.which("chromium")
    if browser is None:
        pytest.skip("no chromium to look at the page with")
    path = tmp_path / "report.html"
    from dataclasses import replace

    best = seven[3].orientation.best
    turned = replace(best, pose=replace(best.pose, heading_deg=300.0))
    seven[3] = replace(seven[3], orientation=replace(seven[3].orientation, candidates=(turned,)))
    written(seven, ReportFile(path))
    text = path.read_text(encoding="utf-8")
    assert "<title>Archive</title>" in dom_of(browser, path, tmp_path)
    path.write_text(
        re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text).replace(
            "</body>", f"<script>{STEPS}</script></body>"
        ),
        encoding="utf-8",
    )
    seen = re.search("<title>SEEN ([^<]*)", dom_of(browser, path, tmp_path)).group(1).split("|")
    assert seen[:4] == ["7", "3", "1", "3.jpg"]
    assert seen[4].endswith("page-0002.html#photo-4")


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
