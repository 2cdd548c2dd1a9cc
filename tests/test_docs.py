"""What the pages of docs/ promise: current tables, covered messages, links that lead somewhere, examples that run."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from examples import run_block
from fenced import fenced_blocks
from messages import all_texts, sentences

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
PAGES = [ROOT / "README.md", ROOT / "ARCHITECTURE.md", ROOT / "CONTRIBUTING.md", *sorted(DOCS.glob("*.md"))]
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
RUN_PAGES = ("automate.md", "tutorial.md", "photo-to-map.md")


def plain(text):
    """Words without Markdown's signs, for comparison."""
    return re.sub(r"[\s*`|]+", " ", text)


@pytest.mark.qgis
def test_the_reference_and_the_tables_of_fields_are_those_of_the_code():
    pytest.importorskip("qgis.core")
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(ROOT / "build" / "plugins")}
    command = [sys.executable, str(ROOT / "tools" / "make_docs.py"), "--check"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_set_of_fields_has_its_table():
    page = (DOCS / "fields.md").read_text(encoding="utf-8")
    sets = [
        f"{path.stem}.{name}"
        for path in sorted((ROOT / "algorithms").rglob("*.py"))
        for name in re.findall(r"^def ([a-z]\w*_specs)\(\):", path.read_text(encoding="utf-8"), re.MULTILINE)
    ]
    assert len(sets) >= 15, "the sets of fields are no longer found in the source"
    assert [name for name in sets if f"<!-- begin: {name} -->" not in page] == []


def test_every_message_stands_on_the_page_of_troubles():
    page = plain((DOCS / "troubleshooting.md").read_text(encoding="utf-8"))
    found = sentences()
    assert len(found) > 80, "the sentences are no longer found in the source"
    missing = [f"{where}: {sentence}" for where, sentence in found if plain(sentence) not in page]
    assert not missing, "docs/troubleshooting.md does not know:\n" + "\n".join(missing)


def test_no_message_on_that_page_is_out_of_date():
    texts, rows, stale = all_texts(), [], []
    for table in re.split(r"\n\n", (DOCS / "troubleshooting.md").read_text(encoding="utf-8")):
        if table.startswith(("| message", "| reason")):
            rows += [line.split("|")[1].strip() for line in table.splitlines()[2:]]
    assert len(rows) > 80
    for message in rows:
        longest = max(message.split("…"), key=len).strip()
        stale += [message] if re.sub(r"\s+", " ", longest) not in texts else []
    assert stale == []


def test_every_class_of_error_and_every_status_is_explained():
    page = (DOCS / "troubleshooting.md").read_text(encoding="utf-8")
    for name in re.findall(
        r"^class (\w+)\(", (ROOT / "core" / "base" / "errors.py").read_text(encoding="utf-8"), re.MULTILINE
    ):
        assert f"`{name}`" in page, name
    from skyline_viewshed.core.report.facts import STATUSES

    for page in ("troubleshooting.md", "fields.md"):
        text = (DOCS / page).read_text(encoding="utf-8")
        assert all(f"`{status}`" in text for status in STATUSES), page


def test_links_lead_somewhere():
    broken, checked = [], 0
    for page in PAGES:
        for target in LINK.findall(page.read_text(encoding="utf-8")):
            if target.startswith(("http:", "https:", "mailto:")):
                continue
            checked += 1
            path, _, anchor = target.partition("#")
            file = (page.parent / path) if path else page
            if not file.exists() or (anchor and file.suffix == ".md" and anchor not in anchors(file)):
                broken.append(f"{page.name} links to {target}")
    assert checked > 50
    assert broken == []


def anchors(page):
    """Anchors of a page: its headings as code sites make them, and those set by hand."""
    text = page.read_text(encoding="utf-8")
    heads = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    made = {re.sub(r"[^\w\- ]", "", head.lower()).strip().replace(" ", "-") for head in heads}
    return made | set(re.findall(r'<a id="([^"]+)"', text))


def test_pictures_are_small_and_all_are_used():
    pages = "".join(page.read_text(encoding="utf-8") for page in PAGES)
    pictures = sorted((DOCS / "images").glob("*"))
    assert pictures and all(picture.suffix == ".png" for picture in pictures)
    for picture in pictures:
        assert picture.stat().st_size < 200_000, picture.name
        assert f"images/{picture.name}" in pages, f"{picture.name} is on no page"
    assert sum(picture.stat().st_size for picture in pictures) < 2_000_000


EXAMPLES = [block for name in RUN_PAGES if (DOCS / name).exists() for block in fenced_blocks(DOCS / name)]


def test_examples_are_marked_by_their_language():
    assert EXAMPLES
    for block in EXAMPLES:
        assert block.language in ("bash", "python") or not block.run, str(block)


@pytest.mark.qgis
@pytest.mark.parametrize("block", [block for block in EXAMPLES if block.run], ids=str)
def test_the_example_runs(block):
    done = run_block(block)
    assert done.returncode == 0, done.stdout + done.stderr
