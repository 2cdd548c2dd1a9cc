"""All sentences that the program says when something is wrong, read from its source.

Variable parts are an ellipsis. Sentences that are built elsewhere than where they are raised are not seen.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SILENT = {
    "ValueError",
    "TypeError",
    "KeyError",
    "RuntimeError",
    "NotImplementedError",
    "SystemExit",
    "OSError",
    "FileNotFoundError",
}
"""Faults of a programmer, or caught and said again in other words."""
SPEAKING = {"verdict", "judge", "_too_little"}
"""Functions that return a sentence, or a status and its sentence."""
ENDINGS = ("_fault", "_refusal", "_notes")
"""Of the names of others that return sentences."""


def sentences():
    """(where, sentence) of every message: raised, returned by a check of inputs, warned of, or a verdict."""
    found = []
    for path in [*sorted((ROOT / "core").rglob("*.py")), *sorted((ROOT / "algorithms").rglob("*.py"))]:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        where = str(path.relative_to(ROOT))
        for node in ast.walk(tree):
            found += [(where, text) for text in _of_raise(node) + _of_check(node) + _of_answer(node)]
    return list(dict.fromkeys((where, text) for where, text in found if " " in text and not text.startswith("… (")))


def all_texts():
    """Every text of the program, variable parts as an ellipsis, in one string with single spaces."""
    texts = []
    for path in [*(ROOT / "core").rglob("*.py"), *(ROOT / "algorithms").rglob("*.py")]:
        if path.name == "core_sentences.py":  # copies of the core's sentences, for translators
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        texts += [text for text in map(template, ast.walk(tree)) if text]
    return re.sub(r"\s+", " ", "\n".join(texts))


def _of_raise(node):
    if not (isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call)):
        return []
    if _name(node.exc.func) in SILENT:
        return []
    return [text for text in map(template, node.exc.args) if text]


def _of_check(node):
    if not isinstance(node, ast.FunctionDef) or not (node.name.endswith(ENDINGS) or node.name in SPEAKING):
        return []
    texts = []
    for inner in ast.walk(node):
        if isinstance(inner, ast.Return) and inner.value is not None:
            values = inner.value.elts if isinstance(inner.value, ast.Tuple) else [inner.value]
            texts += [text for text in map(template, values) if text and text != "…"]
    return texts


def _of_answer(node):
    """Warnings, verdicts made on the spot, remarks, and the wording of the error classes."""
    if not (
        isinstance(node, ast.Call) and _name(node.func) in ("warn", "pushWarning", "Orientation", "append", "__init__")
    ):
        return []
    if _name(node.func) == "append" and getattr(node.func.value, "id", "") != "notes":
        return []
    return [text for text in map(template, node.args) if text and re.search(r"[a-z] [a-z]", text)]


def _name(function):
    return getattr(function, "id", getattr(function, "attr", ""))


def template(node):
    """Text of an expression with an ellipsis for what varies, or None where it is no text."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return re.sub(r"\{\w*\}", "…", node.value)
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "…" for part in node.values)
    if isinstance(node, ast.Call):
        if _name(node.func) == "tr" and node.args:
            return template(node.args[0])
        if isinstance(node.func, ast.Attribute) and node.func.attr == "format":
            return template(node.func.value)
    return None
