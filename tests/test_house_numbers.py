"""The house rules on functions that can be counted: parameters, and docstrings that explain them."""

from __future__ import annotations

import ast
import inspect
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FILES = [path for folder in ("core", "demo") for path in sorted((ROOT / folder).rglob("*.py"))]
MOST_PARAMETERS = 6
MOST_EXCEPTIONS = 10
"""Functions with more than `MOST_PARAMETERS`; each gives its reason in a comment above, '# parameters: ...'."""
EXPLAINED_FROM = 3
"""Public functions with so many arguments have a Parameters section."""
EXPLAINED = re.compile(r"^Parameters\n----------\n|\ASee `[\w.]+`", re.MULTILINE)
"""The section, or for a method that implements another one, where that section is."""
REASON = "# parameters: "


def arguments_of(function):
    """Names of a function's arguments, without self, cls and the * and ** ones."""
    spec = function.args
    names = [argument.arg for argument in (*spec.posonlyargs, *spec.args, *spec.kwonlyargs)]
    return [name for name in names if name not in ("self", "cls")]


def functions_of(source):
    return [node for node in ast.walk(ast.parse(source)) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]


def reason_of(function, lines):
    """Reason in the block of comments directly above a function and its decorators; '' without one."""
    above = min(node.lineno for node in (function, *function.decorator_list)) - 2
    while above >= 0 and lines[above].strip().startswith("#"):
        if lines[above].strip().startswith(REASON):
            return lines[above].strip()[len(REASON) :]
        above -= 1
    return ""


def long_lists(source):
    """(name, number of arguments, reason) of the functions with more than `MOST_PARAMETERS`."""
    lines = source.splitlines()
    return [
        (function.name, len(arguments_of(function)), reason_of(function, lines))
        for function in functions_of(source)
        if len(arguments_of(function)) > MOST_PARAMETERS
    ]


def unexplained(source):
    """Names of the public functions with `EXPLAINED_FROM` arguments or more and no Parameters section."""
    functions = functions_of(source)
    inner = {node for function in functions for node in ast.walk(function) if node is not function}
    return [
        function.name
        for function in functions
        if function not in inner
        and not function.name.startswith("_")
        and len(arguments_of(function)) >= EXPLAINED_FROM
        and not EXPLAINED.search(ast.get_docstring(function) or "")
    ]


def in_every_file(measure):
    return [(path.relative_to(ROOT), found) for path in FILES for found in measure(path.read_text(encoding="utf-8"))]


def test_few_functions_take_many_parameters_and_each_says_why():
    found = in_every_file(long_lists)
    offenders = [f"{path}: {name} takes {count}: {reason}" for path, (name, count, reason) in found]
    assert len(offenders) <= MOST_EXCEPTIONS, "\n".join(offenders)
    silent = [f"{path}: {name}" for path, (name, _, reason) in found if not reason]
    assert not silent, "\n".join(silent)


def test_public_functions_with_three_arguments_explain_them():
    offenders = [f"{path}: {name}" for path, name in in_every_file(unexplained)]
    assert not offenders, "\n".join([f"{len(offenders)} functions", *offenders])


EXAMPLE = inspect.cleandoc('''
    # parameters: a reason
    # that goes on
    @decorated
    def reasoned(a, b, c, d, e, f, g):
        pass

    def bare(self, a, b, c, d, e, *, f, g):
        """Do it.

        Parameters
        ----------
        a : int
        """

    class Kind:
        def six(self, a, b, c, d, e, f): pass

        def two(self, a, b): pass

        def like(self, a, b, c):
            """See `Other.like`."""

    def _private(a, b, c):
        def inside(a, b, c): pass
''')


@pytest.mark.parametrize(
    "measure, expected",
    [
        (long_lists, [("reasoned", 7, "a reason"), ("bare", 7, "")]),
        (unexplained, ["reasoned", "six"]),
    ],
)
def test_the_measures_find_what_they_are_for(measure, expected):
    assert measure(EXAMPLE) == expected
