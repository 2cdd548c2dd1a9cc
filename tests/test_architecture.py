"""The house rules that a machine can check: who imports whom, what QGIS 4 will not accept, and sizes."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
SHELL = ["plugin.py", *(str(path.relative_to(ROOT)) for path in sorted(ROOT.glob("processing_provider/*.py")))]
SHELL += [str(path.relative_to(ROOT)) for path in sorted(ROOT.glob("algorithms/*.py"))]
CORE = sorted(path.relative_to(ROOT) for path in (ROOT / "core").rglob("*.py"))
GROUND = {"angles", "camera", "curvature", "errors", "frame", "horizon_model", "imaging", "model", "optional"}
GROUND |= {"pixel_features", "progress", "terrain"}
MEETING_PLACES = {"batch", "pipeline"}
"""Modules of the core in which stages come together."""


def tree_of(path):
    return ast.parse((ROOT / path).read_text(encoding="utf-8"))


def imports_of(path):
    """Imported modules as dotted names; ours start with 'core.', 'algorithms.' and so on."""
    package = list(Path(path).parent.parts)
    found = set()
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, *(node.module.split(".") if node.module else [])])
            found.add(module)
            found.update(f"{module}.{alias.name}" for alias in node.names)
    return found


def module_name(path):
    return ".".join(Path(path).with_suffix("").parts).removesuffix(".__init__")


MODULES = {module_name(path) for path in CORE}


def core_imports(path):
    """Modules of the core that a module of the core imports."""
    return {name for name in imports_of(path) if name in MODULES and name != module_name(path)}


@pytest.mark.parametrize("path", CORE, ids=str)
def test_the_core_knows_no_qgis(path):
    foreign = {name.split(".")[0] for name in imports_of(path)}
    assert not foreign & {"qgis", "processing", "PyQt5", "PyQt6"}


@pytest.mark.parametrize("path", CORE, ids=str)
def test_only_the_io_folder_imports_readers_of_files(path):
    foreign = {name.split(".")[0] for name in imports_of(path)}
    if path.parts[:2] != ("core", "io"):
        assert not foreign & {"osgeo", "exifread", "pillow_heif"}
    assert "cv2" not in foreign, "cv2 comes through core.optional"


@pytest.mark.parametrize("path", CORE, ids=str)
def test_only_the_meeting_places_import_io(path):
    if path.parts[:2] == ("core", "io") or path.stem in MEETING_PLACES:
        return
    assert not {name for name in core_imports(path) if name.startswith("core.io")}


@pytest.mark.parametrize("path", [path for path in CORE if path.parts[:2] == ("core", "io")], ids=str)
def test_io_stands_on_the_ground_only(path):
    others = {name.split(".")[1] for name in core_imports(path) if not name.startswith("core.io")}
    assert others <= GROUND


@pytest.mark.parametrize("path", [path for path in CORE if path.stem in GROUND], ids=str)
def test_the_ground_stands_on_the_ground(path):
    assert {name.split(".")[1] for name in core_imports(path)} <= GROUND


def test_imports_of_the_core_have_no_circle():
    graph = {module_name(path): core_imports(path) for path in CORE}
    done, path = set(), []

    def visit(name):
        assert name not in path, " -> ".join([*path[path.index(name) :], name])
        if name not in done:
            path.append(name)
            for other in graph[name]:
                visit(other)
            done.add(path.pop())

    for name in graph:
        visit(name)


def test_algorithms_do_not_import_algorithms():
    with_algorithm = {
        Path(path).stem
        for path in SHELL
        if path.startswith("algorithms/")
        and path != "algorithms/base.py"
        and re.search(r"\((Skyline|Dem)Algorithm\):", (ROOT / path).read_text(encoding="utf-8"))
    }
    assert len(with_algorithm) >= 15
    for path in SHELL:
        if Path(path).stem in with_algorithm:
            siblings = {name.split(".")[1] for name in imports_of(path) if name.startswith("algorithms.")}
            assert not siblings & with_algorithm, path


def test_the_core_loads_where_there_is_no_qgis():
    modules = sorted(f"skyline_viewshed.{module_name(path)}" for path in CORE)
    script = "import sys, importlib\nsys.modules['qgis'] = None\n" + "\n".join(
        f"importlib.import_module({name!r})" for name in modules
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={"PYTHONPATH": str(ROOT / "build" / "plugins")},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("path", SHELL)
def test_the_shell_imports_no_optional_package_while_loading(path):
    heavy = {"cv2", "pillow_heif", "exifread", "scipy", "PIL", "osgeo"}
    top_level = [node for node in tree_of(path).body if isinstance(node, (ast.Import, ast.ImportFrom))]
    for node in top_level:
        names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else [node.module or ""]
        assert not {name.split(".")[0] for name in names} & heavy


@pytest.mark.parametrize("path", SHELL)
def test_qt_comes_from_qgis_only(path):
    assert not {name.split(".")[0] for name in imports_of(path)} & {"PyQt5", "PyQt6", "sip"}


@pytest.mark.parametrize("path", SHELL)
def test_methods_of_algorithms_fit_a_screen(path):
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.FunctionDef):
            assert node.end_lineno - node.lineno <= 60, f"{path}: {node.name}"


@pytest.mark.parametrize("path", [*CORE, *SHELL], ids=str)
def test_modules_stay_below_300_lines(path):
    assert len((ROOT / path).read_text(encoding="utf-8").splitlines()) <= 300


@pytest.mark.parametrize("path", [*CORE, *SHELL], ids=str)
def test_nothing_is_swallowed_or_printed(path):
    for node in ast.walk(tree_of(path)):
        assert not (isinstance(node, ast.ExceptHandler) and node.type is None), "bare except"
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            assert node.func.id not in ("print", "eval", "exec")
