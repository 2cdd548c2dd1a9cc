"""Update the catalogues `i18n/skyline_viewshed_*.ts` from the source and compile them.

Usage: make_translations.py [--compile-only | --check]

The strings of the source are the literals inside `tr(...)` and `mark(...)` of the shell, inside the `say(...)` of the
report and figures, and the templates of every `Message(...)`, whose facts are keywords. Existing translations are kept;
new strings are added as unfinished, and strings that are no longer in the source are removed. A translator edits the
.ts files with Qt Linguist or by hand. The compiled .qm files are not kept in the repository; `make zip` adds them to
the package.
"""

from __future__ import annotations

import argparse
import ast
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
CATALOGUES = ROOT / "i18n"
LANGUAGES = ("de", "es", "fr")
CONTEXT = "SkylineViewshed"
SHELL = ("plugin.py", "processing_provider/*.py", "algorithms/**/*.py", "panel/**/*.py")
SOURCES = (*SHELL, "core/**/*.py")
MARKERS = ("tr", "mark", "say", "Message")


def source_strings(root=ROOT):
    """Collect the strings of the source in the order of files and lines.

    Returns
    -------
    dict of str to list of (str, int)
        String to the places (file, line) that use it.

    Raises
    ------
    ValueError
        One of these calls has an argument that is not a literal, which no catalogue could contain.
    """
    found = {}
    for path in (path for pattern in SOURCES for path in sorted(root.glob(pattern))):
        name = path.relative_to(root).as_posix()
        calls = [
            node
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in MARKERS
        ]
        for node in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
            argument = node.args[0] if len(node.args) == 1 else None
            if not (isinstance(argument, ast.Constant) and isinstance(argument.value, str)):
                raise ValueError(f"{name}:{node.lineno}: {node.func.id}() takes one literal string")
            found.setdefault(argument.value, []).append((name, node.lineno))
    return found


def catalogue_path(language):
    """Path of the catalogue of a language."""
    return CATALOGUES / f"skyline_viewshed_{language}.ts"


def read_catalogue(path):
    """Read the finished translations of a catalogue, by source string; empty if there is no file."""
    if not path.exists():
        return {}
    messages = ElementTree.parse(path).getroot().iter("message")
    pairs = ((message.findtext("source"), message.find("translation")) for message in messages)
    return {source: entry.text for source, entry in pairs if entry.text and entry.get("type") is None}


def write_catalogue(path, language, strings, translations):
    """Write a catalogue in the format of Qt Linguist, whole or not at all."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>"]
    lines += [f'<TS version="2.1" language="{language}" sourcelanguage="en">', "<context>"]
    lines += [f"    <name>{CONTEXT}</name>"]
    for source, places in strings.items():
        lines.append("    <message>")
        lines += [f'        <location filename="../{name}"/>' for name in dict.fromkeys(name for name, _ in places)]
        lines.append(f"        <source>{escape(source)}</source>")
        if translations.get(source):
            lines.append(f"        <translation>{escape(translations[source])}</translation>")
        else:
            lines.append('        <translation type="unfinished"></translation>')
        lines.append("    </message>")
    lines += ["</context>", "</TS>", ""]
    temporary = path.with_suffix(".part")
    temporary.write_text("\n".join(lines), encoding="utf-8")
    temporary.replace(path)


def compile_catalogue(path, compiled=None):
    """Compile a catalogue to .qm; return its path."""
    program = shutil.which("lrelease") or shutil.which("lrelease-qt6")
    if program is None:
        raise SystemExit("lrelease is missing. On Debian or Ubuntu: apt-get install qttools5-dev-tools")
    compiled = compiled or path.with_suffix(".qm")
    subprocess.run([program, "-silent", str(path), "-qm", str(compiled)], check=True)
    return compiled


def placeholders(text):
    """List names in braces, numbers after a percent sign and HTML tags, sorted; a translation must keep them."""
    return sorted(re.findall(r"\{[^{}]*\}|%\d|</?[a-z]+[^<>]*>", text))


def faults(language, strings):
    """Describe the errors in a catalogue, one sentence each: missing, obsolete, or different placeholders."""
    translations = read_catalogue(catalogue_path(language))
    found = [f"{language}: not translated: {source}" for source in strings if source not in translations]
    found += [f"{language}: no longer in the source: {source}" for source in translations if source not in strings]
    found += [
        f"{language}: placeholders or tags differ: {source}"
        for source in strings
        if source in translations and placeholders(source) != placeholders(translations[source])
    ]
    return found


def main():
    """Update, compile or check the catalogues."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--compile-only", action="store_true", help="leave the .ts files as they are")
    arguments.add_argument("--check", action="store_true", help="say what is missing and change nothing")
    given = arguments.parse_args()
    strings = source_strings()
    found = []
    for language in LANGUAGES:
        path = catalogue_path(language)
        if not (given.compile_only or given.check):
            write_catalogue(path, language, strings, read_catalogue(path))
        if not given.check:
            compile_catalogue(path)
        found += faults(language, strings)
    for sentence in found:
        print(sentence)
    print(f"{len(strings)} strings, {len(LANGUAGES)} languages, {len(found)} faults")
    return 1 if given.check and found else 0


if __name__ == "__main__":
    sys.exit(main())
