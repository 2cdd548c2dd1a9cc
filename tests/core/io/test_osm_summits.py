"""Summits of an OpenStreetMap extract."""

from __future__ import annotations

import pytest
from skyline_viewshed.core.base.errors import SkylineViewshedError
from skyline_viewshed.core.io.osm_summits import is_extract, read_summits

EXTRACT = """<?xml version='1.0'?><osm version="0.6">
<node id="1" lat="46.5" lon="7.7" version="1"><tag k="natural" v="peak"/><tag k="name" v="Zahn &quot;A&quot;"/>
<tag k="ele" v="7513 ft"/></node>
<node id="2" lat="46.6" lon="7.8" version="1"><tag k="natural" v="volcano"/><tag k="name" v="富士山"/></node>
<node id="3" lat="46.6" lon="7.8" version="1"><tag k="natural" v="peak"/><tag k="ele" v="1000"/></node>
<node id="4" lat="46.6" lon="7.8" version="1"><tag k="amenity" v="cafe"/><tag k="name" v="Gipfel"/></node>
</osm>"""


def test_named_summits_with_their_tagged_heights(tmp_path):
    path = tmp_path / "é x.osm"
    path.write_text(EXTRACT, encoding="utf-8")
    assert read_summits(str(path)) == [('Zahn "A"', 7.7, 46.5, "7513 ft"), ("富士山", 7.8, 46.6, None)]


@pytest.mark.parametrize("content", [b"", b"not xml", EXTRACT[:200].encode()])
def test_a_file_that_is_no_extract_or_ends_too_early_is_refused(tmp_path, content):
    path = tmp_path / "x.osm"
    path.write_bytes(content)
    with pytest.raises(SkylineViewshedError, match="Download it again"):
        read_summits(str(path))


def test_extracts_are_known_by_their_suffix():
    assert is_extract("a/B.OSM.PBF") and is_extract("a.osm") and not is_extract("osm.gpkg")
