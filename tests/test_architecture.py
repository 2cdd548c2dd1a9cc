"""The house rules that a machine can check. One test per rule; each lists its offenders."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CORE = sorted(path.relative_to(ROOT) for path in (ROOT / "core").rglob("*.py"))
SHELL = [
    path.relative_to(ROOT)
    for pattern in ("plugin.py", "processing_provider/*.py", "algorithms/**/*.py", "panel/**/*.py")
    for path in sorted(ROOT.glob(pattern))
]
ROOF = (
    "cli", "api", "planning", "checking", "walk", "locating", "searching", "trusting", "cluster", "many", "batch",
    "pipeline", "eyes",
)  # fmt: skip
"""Modules directly under `core/`, highest first: each may import those to its right, and every room."""
NEVER = {"pipeline": {"io"}, "eyes": {"io"}}
"""The exceptions to "and every room": these two work on arrays only."""
MAY_ALSO_USE = {"report": {"figures"}}
"""The exceptions to "a room knows base and itself"."""
OPEN_ENDED = {"base", "io"}
"""Rooms that may hold more than `MOST_FILES` modules."""
FACE = Path("core/api.py")
"""The public face: its docstrings, whose examples are run, do not count as lines."""
MOST_ROOMS, MOST_FILES, MOST_LINES, MOST_LINES_OF_A_METHOD = 16, 16, 300, 60


@cache
def tree_of(path):
    return ast.parse((ROOT / path).read_text(encoding="utf-8"))


@cache
def imports_of(path):
    """Imported modules and names as dotted names; ours start with 'core.', 'algorithms.' and so on."""
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


def packages_of(path):
    return {name.split(".")[0] for name in imports_of(path)}


def module_name(path):
    return ".".join(Path(path).with_suffix("").parts).removesuffix(".__init__")


MODULES = {module_name(path): path for path in CORE}
ROOMS = sorted({path.parts[1] for path in CORE if len(path.parts) == 3})


def room_of(name):
    """Room of a module of the core, or the module itself where it stands on the roof."""
    return name.split(".")[1] if "." in name else ""


def arrows(path):
    """Modules of the core that a module of the core imports; packages only where nothing inside is named."""
    names = {name for name in imports_of(path) if name in MODULES and name != module_name(path)}
    return {name for name in names if not any(other.startswith(f"{name}.") for other in names)}


def test_rooms_know_only_base_and_themselves():
    """`cli -> api -> batch -> pipeline -> eyes -> rooms -> base`, and `report -> figures`."""
    offenders = []
    for path in CORE:
        room = room_of(module_name(path))
        if room in ROOF:
            allowed = {*ROOMS, *ROOF[ROOF.index(room) :]} - NEVER.get(room, set())
        else:
            allowed = {"base", room, *MAY_ALSO_USE.get(room, ())}
        offenders += [f"{path} -> {name}" for name in arrows(path) if room_of(name) not in allowed]
    assert offenders == []


def test_imports_of_the_core_have_no_circle():
    graph = {name: arrows(path) for name, path in MODULES.items()}
    done, way, circles = set(), [], []

    def visit(name):
        if name in way:
            circles.append(" -> ".join([*way[way.index(name) :], name]))
            return
        if name not in done:
            way.append(name)
            for other in sorted(graph[name]):
                visit(other)
            done.add(way.pop())

    for name in graph:
        visit(name)
    assert circles == []


def test_the_house_stays_small_enough_to_draw():
    files = {room: sum(path.parts[1] == room and path.stem != "__init__" for path in CORE) for room in ROOMS}
    assert len(ROOMS) <= MOST_ROOMS, ROOMS
    assert {room: count for room, count in files.items() if count > MOST_FILES and room not in OPEN_ENDED} == {}
    assert {path.stem for path in CORE if len(path.parts) == 2} <= {"__init__", *ROOF}


def test_each_package_is_imported_only_where_it_belongs():
    """No QGIS or Qt in the core; files through core.io; OpenCV through core.base.optional; Qt through qgis.PyQt."""
    offenders = [f"{path}: {name}" for path in CORE for name in packages_of(path) & {"qgis", "processing"}]
    offenders += [f"{path}: {name}" for path in (*CORE, *SHELL) for name in packages_of(path) & {"PyQt5", "PyQt6"}]
    readers = {"osgeo", "exifread", "pillow_heif"}
    outside = [path for path in CORE if path.parts[:2] != ("core", "io")]
    offenders += [f"{path}: {name}" for path in outside for name in packages_of(path) & readers]
    offenders += [f"{path}: cv2" for path in CORE if "cv2" in packages_of(path)]
    assert offenders == []


def test_the_shell_imports_no_optional_package_while_loading():
    heavy = {"cv2", "pillow_heif", "exifread", "scipy", "PIL", "osgeo"}
    offenders = []
    for path in SHELL:
        for node in tree_of(path).body:
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else [node.module or ""]
                offenders += [f"{path}: {name}" for name in names if name.split(".")[0] in heavy]
    assert offenders == []


def test_algorithms_do_not_import_algorithms():
    """One file per algorithm directly under `algorithms/`; what they share is in `algorithms/shared/`."""
    files = {path for path in SHELL if path.parent == Path("algorithms") and path.stem not in ("__init__", "base")}
    assert len(files) >= 15
    names = {module_name(path) for path in files}
    shared = [path for path in SHELL if path.parent == Path("algorithms/shared")]
    assert [f"{path} -> {name}" for path in (*files, *shared) for name in imports_of(path) & names] == []


def test_modules_and_methods_fit_a_screen():
    lines = {path: len((ROOT / path).read_text(encoding="utf-8").splitlines()) for path in (*CORE, *SHELL)}
    functions = [node for node in tree_of(FACE).body if isinstance(node, ast.FunctionDef) and ast.get_docstring(node)]
    lines[FACE] -= sum(node.body[0].end_lineno - node.body[0].lineno + 1 for node in functions)
    assert {str(path): count for path, count in lines.items() if count > MOST_LINES} == {}
    methods = [(path, node) for path in SHELL for node in ast.walk(tree_of(path)) if isinstance(node, ast.FunctionDef)]
    long = [f"{path}: {node.name}" for path, node in methods if node.end_lineno - node.lineno > MOST_LINES_OF_A_METHOD]
    assert long == []


def test_nothing_is_swallowed_or_printed():
    """The command line alone prints; it is a shell of its own."""
    offenders = []
    for path in (*CORE, *SHELL):
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.ExceptHandler) and node.type is None:
                offenders.append(f"{path}:{node.lineno}: bare except")
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                forbidden = ("eval", "exec") if path.stem == "cli" else ("print", "eval", "exec")
                offenders += [f"{path}:{node.lineno}: {node.func.id}"] if node.func.id in forbidden else []
    assert offenders == []


def test_the_core_loads_where_there_is_no_qgis():
    script = "import sys, importlib\nsys.modules['qgis'] = None\n" + "\n".join(
        f"importlib.import_module('skyline_viewshed.{name}')" for name in sorted(MODULES)
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={"PYTHONPATH": str(ROOT / "build" / "plugins")},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
