"""Pieces of HTML: filled with escaped values, and each piece is asked for with just the names that it has."""

from __future__ import annotations

import ast
import re
import string
from pathlib import Path

import pytest
from skyline_viewshed.core.report import pieces
from skyline_viewshed.core.report.pieces import Html, fill, joined, long_text

FOLDER = Path(pieces.__file__).parent


def test_text_is_escaped_and_html_is_not():
    assert fill("count", words='<b>"x"&') == "<span>&lt;b&gt;&quot;x&quot;&amp;</span>"
    assert fill("count", words=Html("<b>x</b>")) == "<span><b>x</b></span>"
    assert fill("count", words=7) == "<span>7</span>"
    assert fill("count", words="{newline}{words}") == "<span>{newline}{words}</span>"


def test_what_is_filled_and_joined_is_html_and_what_is_merely_added_is_text_again():
    one = fill("count", words="<")
    assert isinstance(one, Html) and isinstance(joined([one, one]), Html)
    assert fill("panel", title="", body=joined([one, "</span>"])).count("</span>") == 2
    assert "&lt;span&gt;" in fill("panel", title="", body=one + one)


def test_long_texts_are_cut_and_only_where_asked_later():
    assert len(fill("count", words="x" * 5000)) < 500
    assert fill("count", words=long_text("<" + "x" * 5000, 1000)).count("x") == 999


def test_a_name_that_a_piece_does_not_get_is_an_error():
    with pytest.raises(KeyError):
        fill("count")
    with pytest.raises(KeyError):
        fill("no_such_piece")


def names_in(piece):
    return {name for _, name, _, _ in string.Formatter().parse(piece) if name} - {"newline"}


def test_every_piece_is_used_with_its_own_names():
    known = {name: names_in(body) for name, body in pieces._pieces().items()}
    written = re.findall(r"<!-- (\w+) -->", (FOLDER / "report.html").read_text(encoding="utf-8"))
    assert sorted(known) == sorted(written), "two pieces of one name, or one that is not read"
    used, wrong = set(), []
    for path in sorted(FOLDER.glob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        used |= {node.value for node in ast.walk(tree) if isinstance(node, ast.Constant)} & known.keys()
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "fill":
                names = {keyword.arg for keyword in node.keywords}
                asked = [part.value for part in ast.walk(node.args[0]) if isinstance(part, ast.Constant)]
                wrong += [(path.name, name) for name in asked if name in known and known[name] != names]
    assert wrong == []
    assert known.keys() - used == set()
