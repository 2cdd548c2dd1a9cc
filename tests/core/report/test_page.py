"""The frame of a page: parameters, facts, and the one time at which it appears."""

from __future__ import annotations

import base64

import pytest
from documents import MemoryDocument
from skyline_viewshed.core.report.page import Frame, PageWriter, data_url, fact_table, parameter_panel
from skyline_viewshed.core.report.pieces import Html


class Plain(PageWriter):
    """A page with nothing of its own."""

    def _frame(self):
        return Frame(overview=Html("<overview>"))


def test_loose_parameters_form_a_group_and_mappings_their_own():
    panel = parameter_panel({"Method": "robust", "DEM": {"Cell [m]": 92.600001, "Void": None}, "Step": 0.1})
    assert panel.count("<table>") == 2
    assert panel.index("<h3>Run</h3>") < panel.index("robust") < panel.index("0.1") < panel.index("<h3>DEM</h3>")
    assert "<bdi>92.6</bdi>" in panel and "<bdi>–</bdi>" in panel
    assert parameter_panel({}) == ""


def test_facts_are_escaped_and_may_be_long():
    table = fact_table("<i>", [("<b>", "<u>" + "x" * 1500)])
    assert not any(tag in table for tag in ("<i>", "<b>", "<u>"))
    assert table.count("x") == 1500


def test_a_picture_becomes_a_url_that_holds_it():
    head, _, payload = data_url(b"\x89PNG\x00", "png").partition(",")
    assert head == "data:image/png;base64" and base64.b64decode(payload) == b"\x89PNG\x00"


def test_a_page_appears_once_at_its_end():
    finished = []

    class Counting(MemoryDocument):
        def finish(self, head, tail):
            finished.append(head + tail)

    page = Plain(Counting(), "Title <1>", software="Program 2")
    assert finished == []
    page.close()
    page.close()
    page.discard()
    assert len(finished) == 1
    assert "Title &lt;1&gt;" in finished[0] and "Made by Program 2." in finished[0]
    assert finished[0].startswith("<!DOCTYPE html>\n<html lang=") and finished[0].endswith("</body></html>\n")


def test_a_page_that_was_given_up_never_appears():
    document = MemoryDocument()
    with pytest.raises(ValueError), Plain(document, "t") as page:
        page._document.write("card")
        raise ValueError
    page.close()
    assert document.text == ""


def test_the_page_says_its_language():
    document = MemoryDocument()
    with Plain(document, "t", say=lambda words: words.replace("language code: en", "language code: de")):
        pass
    assert '<html lang="de">' in document.text
