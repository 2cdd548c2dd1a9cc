"""What the plugin site asks of the zip, and what the metadata promise."""

from __future__ import annotations

import re
import subprocess
import zipfile
from configparser import ConfigParser
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
SHIPPED = {
    *("__init__.py", "plugin.py", "metadata.txt", "requirements.txt", "LICENSE", "README.md", "CHANGELOG.md"),
    *("algorithms", "core", "i18n", "icons", "models", "panel", "processing_provider", "styles"),
}
"""What lies directly in the plugin's folder; all else in the repository is for those who develop it."""


@pytest.fixture(scope="module")
def metadata():
    parser = ConfigParser(interpolation=None)
    parser.read(ROOT / "metadata.txt", encoding="utf-8")
    return parser["general"]


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """The zip of the committed state, as `make zip` makes it."""
    if not (ROOT / ".git").exists():
        pytest.skip("the zip is made from a git checkout")
    target = tmp_path_factory.mktemp("zip") / "skyline_viewshed.zip"
    command = ["git", "archive", "--format=zip", "--prefix=skyline_viewshed/", "-o", target, "HEAD"]
    subprocess.run(command, cwd=ROOT, check=True)
    return zipfile.ZipFile(target)


def test_metadata_have_all_that_the_site_requires(metadata):
    for key in ("name", "description", "about", "version", "author", "email", "homepage", "tracker", "repository"):
        assert metadata[key].strip(), key
    assert metadata["qgisMinimumVersion"] == "3.22" and metadata["qgisMaximumVersion"] == "4.99"
    assert metadata["hasProcessingProvider"] == "yes"
    assert "plugin" not in metadata["name"].lower() and "/" not in metadata["author"]
    assert re.fullmatch(r"\d+\.\d+\.\d+", metadata["version"])
    assert (ROOT / metadata["icon"]).exists()
    assert "supportsQt6" not in metadata
    for package_name in ("opencv-python-headless", "pillow-heif", "exifread"):
        assert package_name in metadata["about"]


def test_the_changelog_knows_this_version(metadata):
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert f"[{metadata['version']}]" in changelog or "Unreleased" in changelog


def test_the_zip_holds_the_plugin_and_nothing_else(package):
    names = package.namelist()
    assert {name.split("/")[0] for name in names} == {"skyline_viewshed"}
    inside = {name.split("/", 1)[1] for name in names}
    wanted = (
        "LICENSE",
        "metadata.txt",
        "__init__.py",
        "plugin.py",
        "icons/provider.svg",
        "models/geotaggedphotos.model3",
    )
    for path in (*wanted, "styles/oriented.qml", "core/base/errors.py", "requirements.txt"):
        assert path in inside, path
    assert {path.split("/")[0] for path in inside if path} <= SHIPPED
    assert [path for path in inside if re.search(r"(^|/)(\.|__pycache__|__MACOSX)|\.pyc$", path)] == []
    assert sum(info.compress_size for info in package.infolist()) < 25e6


def test_no_binary_and_no_secret_lies_in_the_zip(package):
    for info in package.infolist():
        content = package.read(info)
        if info.filename.endswith((".py", ".txt", ".svg", ".qml", ".model3", ".css", ".js", ".json", ".md")):
            content.decode("utf-8")
            assert b"\r\n" not in content
        assert not info.filename.endswith((".so", ".dll", ".exe", ".dylib", ".whl"))


def test_requirements_are_loose_and_leave_numpy_to_qgis():
    lines = [line for line in (ROOT / "requirements.txt").read_text().splitlines() if line and not line.startswith("#")]
    assert lines == ["opencv-python-headless", "pillow-heif", "exifread"]
