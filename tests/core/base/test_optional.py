"""A missing package is missed in one sentence that names the remedy."""

import sys

import pytest
from skyline_viewshed.core.base import optional
from skyline_viewshed.core.base.errors import MissingPackageError


@pytest.mark.parametrize("platform, word", [("win32", "OSGeo4W"), ("darwin", "QGIS.app"), ("linux", "python3 -m pip")])
def test_the_hint_suits_the_platform_and_names_the_package(monkeypatch, platform, word):
    monkeypatch.setitem(sys.modules, "qgis", sys)  # any module will do
    monkeypatch.setattr(sys, "platform", platform)
    assert word in optional.install_hint("cv2")
    assert "opencv-python-headless" in optional.install_hint("cv2")


def test_outside_qgis_the_hint_is_plain_pip_which_also_works_in_a_virtual_environment(monkeypatch):
    monkeypatch.delitem(sys.modules, "qgis", raising=False)
    for platform in ("win32", "darwin", "linux"):
        monkeypatch.setattr(sys, "platform", platform)
        hint = optional.install_hint("osgeo.gdal")
        assert 'python -m pip install "skyline-viewshed[gdal]"' in hint
        assert "--user" not in hint and "QGIS" not in hint and "OSGeo4W" not in hint


def test_a_blocked_module_is_reported_with_the_feature(monkeypatch):
    monkeypatch.setitem(sys.modules, "pillow_heif", None)
    assert optional.available("pillow_heif") is None
    with pytest.raises(MissingPackageError, match="Reading HEIC.*pillow_heif.*pillow-heif"):
        optional.require("pillow_heif", "Reading HEIC photos")


def test_a_present_module_is_given():
    assert optional.require("json", "x").dumps({}) == "{}"
