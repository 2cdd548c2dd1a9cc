"""Nothing that ships waits for a caller: what only tests, tools and the demo call lives with them."""

from __future__ import annotations

import ast
import re
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHIPPED = [
    path
    for pattern in ("*.py", "core/**/*.py", "algorithms/**/*.py", "processing_provider/*.py", "panel/**/*.py")
    for path in sorted(ROOT.glob(pattern))
]
CALLED_BY_QGIS = {"classFactory"}


def unused(sources):
    """Functions, classes and methods whose name occurs nowhere but in its own definition, as `path: name`.

    Parameters
    ----------
    sources : mapping
        Path to text of each module. Names of the core are looked for in all of them, methods of QGIS's classes,
        which QGIS calls, not at all.
    """
    words = Counter(word for text in sources.values() for word in re.findall(r"\w+", text))
    found = []
    for path, text in sources.items():
        tree = ast.parse(text)
        nodes = list(tree.body)
        if path.startswith("core"):
            nodes += [inner for node in tree.body if isinstance(node, ast.ClassDef) for inner in node.body]
        for node in nodes:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("__"):
                own = "\n".join(text.splitlines()[node.lineno - 1 : node.end_lineno])
                if words[node.name] == len(re.findall(rf"\b{node.name}\b", own)):
                    found.append(f"{path}: {node.name}")
    return found


def test_the_check_sees_what_it_should():
    sources = {
        "core/a.py": "def used():\n    pass\n\ndef dead():\n    return dead()\n",
        "core/b.py": "from .a import used\nclass B:\n    def quiet(self):\n        pass\nused(B)\n",
        "algorithms/c.py": "class C:\n    def icon(self):\n        pass\nC\n",
    }
    assert unused(sources) == ["core/a.py: dead", "core/b.py: quiet"]


def test_all_that_ships_is_called_by_something_that_ships():
    sources = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in SHIPPED}
    assert len(sources) > 150
    assert [entry for entry in unused(sources) if entry.split(": ")[1] not in CALLED_BY_QGIS] == []
