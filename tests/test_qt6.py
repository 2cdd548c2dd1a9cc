"""What QGIS 4 (Qt 6) refuses and QGIS 3.22 still takes: found in the source, since neither runs in the other's place.

PyQt6 knows an enumeration's members only through its class: `QgsProcessing.SourceType.TypeVectorPoint`, never
`QgsProcessing.TypeVectorPoint`. Names are looked up in the running QGIS, so each version of the matrix also tells
whether it has everything that the source names.
"""

from __future__ import annotations

import ast
import enum
import importlib
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("algorithms", "panel", "processing_provider", "tools", "tests")
SOURCES = [ROOT / "plugin.py", *(path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.py")))]
SOURCES = [path for path in SOURCES if "qgis" in path.read_text(encoding="utf-8") and path.name != Path(__file__).name]
MOVED = {"exec_", "toTime_t", "setMargin", "MidButton", "Unicode", "pyqtConfigure"}
"""Attributes that Qt 6 dropped or renamed."""
GONE = {"QRegExp", "QDesktopWidget", "QTextCodec", "QStringList", "QPyNullVariant", "QMatrix", "QSignalMapper"}


def imported(tree):
    """What the module imports from QGIS, by the name that it has there."""
    found = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and not node.level and (node.module or "").split(".")[0] == "qgis":
            module = importlib.import_module(node.module)
            for alias in node.names:
                found[alias.asname or alias.name] = getattr(module, alias.name, None)
    return {name: thing for name, thing in found.items() if thing is not None}


def is_enumeration(thing):
    """Whether a class is an enumeration of Python's or of sip's."""
    return isinstance(thing, enum.EnumMeta) or type(thing).__name__ == "enumtype"


def is_flags(thing):
    """Whether a class is a set of flags of sip's, which repeats the members of its enumeration."""
    return isinstance(thing, type) and hasattr(thing, "__and__") and not issubclass(thing, int)


def is_member(thing):
    """Whether a thing is a member of an enumeration."""
    return not isinstance(thing, type) and is_enumeration(type(thing))


def chain_of(node):
    """Names of `a.b.c`, or None where the chain starts with anything but a name."""
    names = []
    while isinstance(node, ast.Attribute):
        names.append(node.attr)
        node = node.value
    return [node.id, *reversed(names)] if isinstance(node, ast.Name) else None


def chains(tree):
    """Each longest chain of attributes, with its line."""
    inner = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and id(node) not in inner and chain_of(node):
            yield node.lineno, chain_of(node)


def members_without_class(tree):
    """Enumeration members reached without their class, as `line: chain`."""
    known = imported(tree)
    members = {
        name
        for owner in known.values()
        if isinstance(owner, type) and not is_enumeration(owner)
        for name in dir(owner)
        if is_member(getattr(owner, name, None))
    }
    found = []
    for line, names in chains(tree):
        owner = known.get(names[0])
        for name in names[1:]:
            scoped = is_enumeration(owner) or is_flags(owner)
            if owner is None and names[-1] in members and not (len(names) > 2 and names[-2][0].isupper()):
                found.append(f"{line}: {'.'.join(names)}")  # a member through an instance, as in self.FlagAdvanced
                break
            thing = getattr(owner, name, None)
            # QVariant's members are the exception: qgis.PyQt puts them back on Qt 6.
            if is_member(thing) and isinstance(owner, type) and not scoped and names[0] != "QVariant":
                found.append(f"{line}: {'.'.join(names)}")
                break
            owner = thing
    return found


def absent_names(tree):
    """Attributes of QGIS's classes that the running QGIS does not have, as `line: chain`."""
    known = imported(tree)
    found = []
    for line, names in chains(tree):
        owner = known.get(names[0])
        for name in names[1:]:
            if not isinstance(owner, type):
                break
            if not hasattr(owner, name):
                found.append(f"{line}: {'.'.join(names)}")
                break
            owner = getattr(owner, name)
    return found


def old_habits(tree):
    """Imports past `qgis.PyQt`, and calls and classes that Qt 6 dropped, as `line: name`."""
    found = []
    for node in ast.walk(tree):
        modules = []
        if isinstance(node, ast.Import):
            modules = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and not node.level:
            modules = [node.module or ""]
            found += [f"{node.lineno}: {alias.name}" for alias in node.names if alias.name in GONE]
        found += [f"{node.lineno}: {name}" for name in modules if name.split(".")[0] in ("PyQt5", "PyQt6", "sip")]
        found += [f"{node.lineno}: {name}" for name in modules if name.split(".")[-1].endswith("resources_rc")]
        if isinstance(node, ast.Attribute):
            names = chain_of(node) or ["", node.attr]
            if node.attr in MOVED or names[:2] == ["QVariant", "Type"]:
                found.append(f"{node.lineno}: {'.'.join(names)}")
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "QVariant":
            found.append(f"{node.lineno}: QVariant() where Python's None is meant")
    return found


@cache
def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))


BAD = """
from qgis.core import Qgis, QgsProcessing, QgsProcessingAlgorithm, QgsWkbTypes
from qgis.PyQt.QtCore import Qt, QVariant
class A(QgsProcessingAlgorithm):
    def flags(self):
        return super().flags() | self.FlagNoThreading
kinds = [QgsProcessing.TypeVectorPoint, Qgis.Warning, QgsWkbTypes.PointZ, Qt.AlignLeft]
"""
GOOD = """
from qgis.core import Qgis, QgsProcessing, QgsProcessingAlgorithm, QgsWkbTypes
from qgis.PyQt.QtCore import Qt
class A(QgsProcessingAlgorithm):
    def flags(self):
        return super().flags() | QgsProcessingAlgorithm.Flag.FlagNoThreading
kinds = [QgsProcessing.SourceType.TypeVectorPoint, Qgis.MessageLevel.Warning, QgsWkbTypes.Type.PointZ]
kinds += [Qt.AlignmentFlag.AlignLeft, Qgis.QGIS_VERSION_INT, QgsProcessing.TEMPORARY_OUTPUT]
"""


def test_the_check_of_enumerations_sees_what_it_should():
    pytest.importorskip("qgis.core")
    found = [entry.split(": ")[1] for entry in members_without_class(ast.parse(BAD))]
    assert sorted(found) == sorted(
        ["self.FlagNoThreading", "QgsProcessing.TypeVectorPoint", "Qgis.Warning", "QgsWkbTypes.PointZ", "Qt.AlignLeft"]
    )
    assert members_without_class(ast.parse(GOOD)) == []
    assert absent_names(ast.parse(GOOD)) == []
    assert absent_names(ast.parse("from qgis.core import Qgis\nQgis.NoSuchThing.Member")) == [
        "2: Qgis.NoSuchThing.Member"
    ]


def test_the_check_of_habits_sees_what_it_should():
    text = "from PyQt5.QtCore import Qt\nfrom qgis.PyQt.QtCore import QRegExp\nd.exec_()\nQVariant.Type\nQVariant()"
    assert len(old_habits(ast.parse(text))) == 5
    assert old_habits(ast.parse(GOOD)) == []


def offenders(check):
    """What a check finds in all sources, as `path:line: name`."""
    assert len(SOURCES) > 60
    return [f"{path.relative_to(ROOT)}:{entry}" for path in SOURCES for entry in check(parsed(path))]


def test_members_of_enumerations_are_named_through_their_class():
    pytest.importorskip("qgis.core")
    assert offenders(members_without_class) == []


def test_this_qgis_has_every_name_that_the_source_uses():
    pytest.importorskip("qgis.core")
    assert offenders(absent_names) == []


def test_nothing_that_qt_6_dropped_is_used():
    assert offenders(old_habits) == []
