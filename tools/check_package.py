"""Check the plugin's zip against the rules of the QGIS plugin site, then run it from an empty profile.

Usage: check_package.py ZIP [--no-run]

The rules are those of the site's upload check (validator.py) and of its security scan (bandit, detect-secrets,
suspicious files), as found in qgis/QGIS-Plugins-Website in 2026. One check needs a network and is left to a person: the
three addresses in metadata.txt must be reachable. The run uses the system's Python and QGIS alone, without the packages
of .venv.
"""

from __future__ import annotations

import argparse
import ast
import codecs
import configparser
import json
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path, PurePosixPath
from urllib.parse import urlparse

ROOT = Path(__file__).resolve().parent.parent
MAX_BYTES = 25_000_000
REQUIRED = ("name", "description", "version", "qgisMinimumVersion", "author", "email", "about", "tracker", "repository")
ADDRESSES = ("tracker", "repository", "homepage")
FORBIDDEN_FOLDERS = {"__MACOSX", ".git", "__pycache__"}
SUSPICIOUS = {".exe", ".dll", ".so", ".dylib", ".bat", ".sh", ".ps1", ".cmd", ".pyd", ".whl", ".jar", ".zip"}
BLOCKING_BANDIT = "B102,B105,B106,B107,B202,B301,B302,B306,B307,B506,B602,B604,B605,B701"
DEVELOPMENT_FOLDERS = {".ci", ".github", "benchmarks", "demo", "docs", "tests", "tools"}
DEVELOPMENT_FILES = {"CITATION.cff", "Makefile", "SECURITY.md", "pyproject.toml", "requirements-dev.txt"}
NEEDED = ("LICENSE", "__init__.py", "plugin.py", "metadata.txt", "requirements.txt", "core/base/igrf14.txt")


def problems_of_names(archive):
    """Check the contents and names of the zip; return one sentence per violation."""
    names = archive.namelist()
    found = []
    tops = {name.split("/")[0] for name in names}
    if len(tops) != 1:
        return [f"The zip has {len(tops)} top folders instead of one: {sorted(tops)}."]
    top = tops.pop()
    if not top.isidentifier() or not top.isascii() or "plugin" in top.lower():
        found.append(f"The top folder {top!r} must be a Python identifier in ASCII without the word 'plugin'.")
    for info in archive.infolist():
        path = PurePosixPath(info.filename)
        if ".." in info.filename or info.filename.startswith("/") or "\\" in info.filename:
            found.append(f"{path} leads out of the folder.")
        if ".pyc" in info.filename or FORBIDDEN_FOLDERS & set(path.parts):
            found.append(f"{path} is nothing to ship.")
        if path.suffix.lower() in SUSPICIOUS or (path.name.startswith(".") and not info.is_dir()):
            found.append(f"{path} is hidden, a binary or a script of a shell.")
        if path.suffix == ".py" and (info.external_attr >> 16) & 0o111:
            found.append(f"{path} is executable.")
        if len(path.parts) > 1 and path.parts[1] in DEVELOPMENT_FOLDERS | DEVELOPMENT_FILES:
            found.append(f"{path} serves development only: mark it export-ignore in .gitattributes.")
    found += [f"{name} is missing." for name in NEEDED if f"{top}/{name}" not in names]
    return found


def problems_of_metadata(archive, top):
    """Check metadata.txt; return one sentence per violation."""
    if f"{top}/metadata.txt" not in archive.namelist():
        return []
    parser = configparser.ConfigParser()  # with interpolation, as on the site, where a lone % is an error
    parser.optionxform = str
    try:
        parser.read_string(codecs.decode(archive.read(f"{top}/metadata.txt"), "utf8"))
        metadata = dict(parser.items("general"))
    except (configparser.Error, UnicodeDecodeError) as error:
        return [f"metadata.txt cannot be read: {error}"]
    found = [f"metadata.txt lacks {key}." for key in REQUIRED if not metadata.get(key, "").strip()]
    for key in ADDRESSES:
        parts = urlparse(metadata.get(key, ""))
        if not (parts.scheme and parts.netloc):
            found.append(f"metadata.txt: {key} is no address.")
    if "/" in metadata.get("author", ""):
        found.append("metadata.txt: the author's name has a slash.")
    if "plugin" in metadata.get("name", "").lower():
        found.append("metadata.txt: the name has the word 'plugin'.")
    if metadata.get("qgisMaximumVersion", "3.99") < "4":
        found.append("metadata.txt: without qgisMaximumVersion=4.99 QGIS 4 does not offer the package.")
    if "supportsQt6" in metadata:
        found.append("metadata.txt: supportsQt6 is no longer used; leave it out.")
    if metadata.get("hasProcessingProvider") != "yes":
        found.append("metadata.txt: without hasProcessingProvider=yes qgis_process does not load the provider.")
    if "icon" in metadata and f"{top}/{metadata['icon']}" not in archive.namelist():
        found.append("metadata.txt: the icon is not in the zip.")
    return found


def problems_of_zip(path):
    """Check all rules that need only the zip.

    Parameters
    ----------
    path : path
        Path of the zip.

    Returns
    -------
    list of str
        One sentence per violation; empty if the site would accept the zip.
    """
    found = []
    if os.path.getsize(path) > MAX_BYTES:
        found.append(f"The zip has {os.path.getsize(path) / 1e6:.1f} MB; {MAX_BYTES / 1e6:.0f} MB are allowed.")
    with zipfile.ZipFile(path) as archive:
        damaged = archive.testzip()
        if damaged:
            return [*found, f"{damaged} is damaged."]
        found += problems_of_names(archive)
        found += problems_of_metadata(archive, archive.namelist()[0].split("/")[0])
        for name in archive.namelist():
            if name.endswith(".py"):
                try:
                    ast.parse(archive.read(name), feature_version=(3, 9))
                except SyntaxError as error:
                    found.append(f"{name} is not Python 3.9: {error}")
    return found


def scan(folder):
    """Run the site's security scan over the unpacked zip; return one sentence per finding."""
    module = [sys.executable, "-m"]
    found = []
    for options in (["-t", BLOCKING_BANDIT], ["-ll"]):
        done = subprocess.run(
            [*module, "bandit", "-r", str(folder), "-f", "json", "--quiet", *options], capture_output=True, text=True
        )
        report = json.loads(done.stdout)
        found += [f"bandit: {error['filename']}: {error['reason']}" for error in report["errors"]]
        found += [
            f"bandit {entry['test_id']}: {entry['filename']}:{entry['line_number']}: {entry['issue_text']}"
            for entry in report["results"]
        ]
    command = [*module, "detect_secrets", "scan", "--all-files", "--exclude-files", r"metadata\.txt", "."]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    for name, secrets in json.loads(done.stdout)["results"].items():
        found += [f"detect-secrets: {name}:{secret['line_number']}: {secret['type']}" for secret in secrets]
    return list(dict.fromkeys(found))


def run_from_empty_profile(zip_path, scratch):
    """Install the zip into an empty profile and run the demo there; return a sentence if it fails."""
    plugins = scratch / "profile" / "profiles" / "default" / "python" / "plugins"
    plugins.mkdir(parents=True)
    with zipfile.ZipFile(zip_path) as archive:
        archive.extractall(plugins)
    before = {path: path.stat().st_mtime_ns for path in plugins.rglob("*") if path.is_file()}
    (scratch / "run").mkdir(mode=0o700)
    environment = {
        "PATH": "/usr/local/bin:/usr/bin:/bin",
        "HOME": str(scratch),
        "LANG": "C.UTF-8",
        "PYTHONPATH": str(plugins),
        "PYTHONDONTWRITEBYTECODE": "1",
        "QGIS_CUSTOM_CONFIG_PATH": str(scratch / "profile"),
        "QT_QPA_PLATFORM": "offscreen",
        "XDG_RUNTIME_DIR": str(scratch / "run"),
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
    }
    # Debian's wrapper of 3.22 passes qgis_process an option that it does not accept.
    program = shutil.which("qgis_process.bin") or shutil.which("qgis_process")
    if program is None:
        return ["qgis_process is not installed: the zip could not be run."]
    python = shutil.which("python3", path=environment["PATH"])
    steps = [
        [program, "plugins", "enable", "skyline_viewshed"],
        [program, "list"],
        [python, str(ROOT / "tools" / "demo.py"), str(scratch / "demo")],
    ]
    for command in steps:
        done = subprocess.run(
            command,
            env=environment,
            cwd=scratch,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=3000,
        )
        said = done.stdout + done.stderr
        if done.returncode != 0 or "Traceback" in said:
            return [f"{' '.join(command)} failed in an empty profile ({done.returncode}):\n{said[-3000:]}"]
        if command[1:] == ["list"] and "skylineviewshed:photoviewshed" not in said:
            return [f"The algorithms do not appear in an empty profile:\n{said[-3000:]}"]
    print(done.stdout)
    after = {path: path.stat().st_mtime_ns for path in plugins.rglob("*") if path.is_file()}
    return [f"Running wrote into the installed folder: {path}" for path in after if after[path] != before.get(path)]


def main():
    """Check, print what is wrong, and return an exit code."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("zip", type=Path)
    arguments.add_argument("--no-run", action="store_true", help="leave out the run from an empty profile")
    given = arguments.parse_args()
    found = problems_of_zip(given.zip)
    with tempfile.TemporaryDirectory() as scratch:
        unpacked = Path(scratch) / "unpacked"
        with zipfile.ZipFile(given.zip) as archive:
            count = len(archive.namelist())
            archive.extractall(unpacked)
        found += scan(unpacked)
        if not given.no_run and not found:
            found += run_from_empty_profile(given.zip.resolve(), Path(scratch))
    for sentence in found:
        print(sentence)
    if not found:
        print(f"{given.zip}: {count} entries, {given.zip.stat().st_size / 1e6:.2f} MB, nothing to object")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
