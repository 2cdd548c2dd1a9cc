"""Pins, hooks, workflows, templates and citation: files that nothing else here runs."""

from __future__ import annotations

import os
import re
import subprocess
import threading
from http.server import BaseHTTPRequestHandler, HTTPServer
from importlib.metadata import version
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parent.parent
GITHUB = ROOT / ".github"
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
ALLOWED_COMMANDS = (
    r"make [a-z-]+",
    r'git config --global --add safe\.directory "\$GITHUB_WORKSPACE"',
    r"apt-get update -qq && apt-get install -y -qq --no-install-recommends ca-certificates git make",
)
"""What a step of a workflow may run: targets of the Makefile, and what is needed before make can run."""


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def pins():
    """(name, version, marker) of each requirement of requirements-dev.txt."""
    lines = [line.partition("#")[0].strip() for line in read("requirements-dev.txt").splitlines()]
    found = [re.fullmatch(r"([\w-]+)==([\w.]+)(?:; (.+))?", line) for line in lines if line]
    assert all(found), lines
    return [match.groups() for match in found]


def workflows():
    return {path.name: yaml.safe_load(path.read_text(encoding="utf-8")) for path in (GITHUB / "workflows").iterdir()}


def test_every_yaml_file_can_be_read():
    paths = [*GITHUB.rglob("*.yml"), ROOT / ".pre-commit-config.yaml", ROOT / "CITATION.cff"]
    assert len(paths) >= 7
    assert [path for path in paths if not isinstance(yaml.safe_load(path.read_text(encoding="utf-8")), dict)] == []


def test_the_installed_tools_are_the_pinned_ones():
    """NumPy is not pinned: it must stay the one that QGIS's GDAL was built against."""
    assert "numpy" not in {name.lower() for name, _, _ in pins()}
    wrong = [
        f"{name}: {version(name)} is installed, {pinned} is pinned"
        for name, pinned, marker in pins()
        if not marker and version(name) != pinned
    ]
    assert wrong == []


def test_the_optional_packages_of_users_are_pinned_for_the_tests():
    optional = {line.lower() for line in read("requirements.txt").splitlines() if line and not line.startswith("#")}
    assert optional <= {name.lower() for name, _, _ in pins()}


def test_the_hooks_are_local_and_their_tools_pinned():
    """A hook from a repository would bring a version of its own, and need a network."""
    repositories = yaml.safe_load(read(".pre-commit-config.yaml"))["repos"]
    hooks = [hook for repository in repositories for hook in repository["hooks"]]
    assert {repository["repo"] for repository in repositories} == {"local"}
    assert {"ruff", "ruff-format"} <= {hook["id"] for hook in hooks}
    assert {name for name, _, _ in pins()} >= {"ruff", "pre_commit", "pre_commit_hooks", "mypy"}
    missing = [hook["entry"] for hook in hooks if not (ROOT / hook["entry"].split()[0]).exists()]
    assert missing == []


def test_every_step_of_a_workflow_calls_make():
    offenders = []
    for name, workflow in workflows().items():
        for job in workflow["jobs"].values():
            for step in job["steps"]:
                if "uses" in step:
                    continue
                if not any(re.fullmatch(command, step["run"]) for command in ALLOWED_COMMANDS):
                    offenders.append(f"{name}: {step['run']}")
    assert offenders == []


def test_the_targets_that_workflows_call_exist():
    called = {
        target
        for path in (GITHUB / "workflows").iterdir()
        for target in re.findall(r"run: make ([a-z-]+)$", read(path), re.M)
    }
    assert {"lint", "test", "check-package", "wheel"} <= called
    assert [target for target in sorted(called) if not re.search(rf"^{target}:", MAKEFILE, re.M)] == []


def test_the_release_uploads_what_the_targets_make():
    steps = workflows()["release.yml"]["jobs"]["release"]["steps"]
    (files,) = [step["with"]["files"].split() for step in steps if "files" in step.get("with", {})]
    assert len(files) == 3 and [name for name in files if name not in MAKEFILE] == []


def test_workflows_that_did_not_run_here_say_so():
    assert [
        path.name for path in (GITHUB / "workflows").iterdir() if "not run here" not in read(path).splitlines()[0]
    ] == []


def test_forms_have_what_the_code_site_demands():
    """GitHub ignores a form without these keys, or with an id given twice."""
    for path in (GITHUB / "ISSUE_TEMPLATE").glob("*_*.yml"):
        form = yaml.safe_load(path.read_text(encoding="utf-8"))
        assert form["name"] and form["description"], path.name
        ids = [field["id"] for field in form["body"]]
        assert len(ids) == len(set(ids)), path.name
        assert all(field["type"] in ("input", "textarea") and field["attributes"]["label"] for field in form["body"])
    labels = str(yaml.safe_load(read(".github/ISSUE_TEMPLATE/bug_report.yml")))
    assert all(word in labels for word in ("QGIS version", "Log", "Photo metadata"))


def test_the_citation_agrees_with_the_metadata():
    citation, metadata = yaml.safe_load(read("CITATION.cff")), read("metadata.txt")
    assert citation["cff-version"] == "1.2.0"
    assert {"message", "title", "authors"} <= set(citation)
    assert f"\nversion={citation['version']}\n" in metadata
    assert f"\nrepository={citation['repository-code']}\n" in metadata
    assert citation["references"][0]["authors"][0]["family-names"] == "Twarog"


@pytest.fixture
def plugin_site():
    """A stand-in for the plugin site: its address, and the requests that reached it."""
    requests = []

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self):
            body = self.rfile.read(int(self.headers["Content-Length"]))
            requests.append((self.path, self.headers["Authorization"], body))
            self.send_response(200 if self.headers["Authorization"] == "Bearer right" else 403)
            self.end_headers()

        def log_message(self, *arguments):
            pass

    server = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}", requests
    server.shutdown()
    thread.join()
    server.server_close()


@pytest.mark.parametrize("token, code", [("right", 0), ("wrong", 22), ("", 1)])
def test_publishing_sends_the_zip_with_the_token(plugin_site, tmp_path, token, code):
    site, requests = plugin_site
    archive = tmp_path / "plugin.zip"
    archive.write_bytes(b"PK the whole zip")
    environment = {**os.environ, "QGIS_PLUGIN_SITE": site, "QGIS_PLUGIN_TOKEN": token, "no_proxy": "127.0.0.1"}
    done = subprocess.run([ROOT / "tools" / "publish.sh", archive], env=environment, capture_output=True, text=True)
    assert done.returncode == code, done.stdout + done.stderr
    if token:
        ((path, sent, body),) = requests
        assert (path, sent) == ("/plugins/api/skyline_viewshed/version/add/", f"Bearer {token}")
        assert b"PK the whole zip" in body and b'name="package"' in body
    else:
        assert requests == [] and "QGIS_PLUGIN_TOKEN is not set" in done.stderr
