"""Simple properties in the XMP packet of a picture."""

import pytest
from skyline_viewshed.core.io.xmp import SEARCHED_BYTES, xmp_properties

PACKET = b"""<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF><rdf:Description GPano:ProjectionType="cylindrical"
 GPano:UsePanoramaViewer='True' Other:Name="x"><GPano:FullPanoWidthPixels>2000</GPano:FullPanoWidthPixels>
</rdf:Description></rdf:RDF></x:xmpmeta>"""
FOUND = {"ProjectionType": "cylindrical", "UsePanoramaViewer": "True", "FullPanoWidthPixels": "2000"}


@pytest.mark.parametrize("before, after", [(10, 10), (3 * SEARCHED_BYTES, 100), (100, 3 * SEARCHED_BYTES)])
def test_attributes_and_elements_are_found_at_either_end(tmp_path, before, after):
    (tmp_path / "a").write_bytes(b"\0" * before + PACKET + b"\0" * after)
    assert xmp_properties(tmp_path / "a", ("GPano", "Other", "ther")) == {
        "GPano": FOUND,
        "Other": {"Name": "x"},
        "ther": {},
    }


@pytest.mark.parametrize("content", [b"", b"nothing", b"<x:xmpmeta", b"<x:xmpmeta>\xff\xfe GPano:="])
def test_damaged_packets_give_nothing(tmp_path, content):
    (tmp_path / "a").write_bytes(content)
    assert xmp_properties(tmp_path / "a", ("GPano",)) == {"GPano": {}}


def test_a_missing_file_gives_nothing(tmp_path):
    assert xmp_properties(tmp_path / "missing", ("GPano",)) == {"GPano": {}}
