"""The sentences that the program shows to a user, read from its source.

Variable parts become an ellipsis. A sentence is a `Message` or, in the shell, a `tr(...)` that is raised, returned by a
`..._fault` function or shown as a warning.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ("core", "algorithms", "panel")
WARNING = {"warn", "pushWarning", "reportError"}


def sentences():
    """(where, sentence) of every sentence, including reasons inside others; names and the like are left out."""
    found = messages()
    for where, tree in (*_trees("algorithms"), *_trees("panel")):
        for node in ast.walk(tree):
            refusal = isinstance(node, ast.FunctionDef) and node.name.endswith("_fault")
            if refusal or isinstance(node, ast.Raise) or (isinstance(node, ast.Call) and _name(node) in WARNING):
                found += [(where, call) for call in ast.walk(node) if _name(call) == "tr"]
    texts = [(where, elided(node.args[0].value)) for where, node in found]
    return list(dict.fromkeys((where, text) for where, text in texts if re.search(r" .*(\.|…)$", text)))


def messages():
    """(where, call) of every `Message(...)` in the source, as syntax trees."""
    pairs = [(where, tree) for room in ROOMS for where, tree in _trees(room)]
    return [(where, node) for where, tree in pairs for node in ast.walk(tree) if _name(node) == "Message"]


def all_texts():
    """Every literal of the program, variable parts as an ellipsis, in one string with single spaces."""
    texts = [
        elided(node.value)
        for room in ROOMS
        for _, tree in _trees(room)
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]
    return re.sub(r"\s+", " ", "\n".join(texts))


def elided(text):
    """A template with an ellipsis for each name in braces."""
    return re.sub(r"\{\w*\}", "…", text)


def _trees(folder):
    for path in sorted((ROOT / folder).rglob("*.py")):
        yield str(path.relative_to(ROOT)), ast.parse(path.read_text(encoding="utf-8"))


def _name(node):
    """Name of the function that a call calls, or an empty string."""
    function = getattr(node, "func", None) if isinstance(node, ast.Call) else None
    return getattr(function, "id", getattr(function, "attr", ""))
