"""The catalogues: complete against the source as it is now, faithful in what must not change, and in force in QGIS."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest
from messages import messages
from skyline_viewshed.tools import make_translations as translations

ROOT = Path(__file__).resolve().parent.parent
STRINGS = translations.source_strings()
LANGUAGES = translations.LANGUAGES


def finished():
    """(language, source, translation) of every string that is translated."""
    return [
        (language, *pair)
        for language in LANGUAGES
        for pair in translations.read_catalogue(translations.catalogue_path(language)).items()
    ]


def test_every_string_of_the_source_is_translated():
    """After a change of strings: make translations, then translate what i18n/*.ts marks as unfinished."""
    assert [(language, fault) for language in LANGUAGES for fault in translations.faults(language, STRINGS)] == []


def test_translations_end_as_their_source_does():
    assert [
        (language, source)
        for language, source, translation in finished()
        if translation != translation.strip() or (source[-1] in ".?:" and translation[-1] != source[-1])
    ] == []


def test_languages_are_not_copies_of_english():
    long = {source for source in STRINGS if len(source.split()) >= 4}
    pairs = [entry for entry in finished() if entry[1] in long]
    assert len(long) > 200 and {language for language, _, _ in pairs} == set(LANGUAGES)
    assert [(language, source) for language, source, translation in pairs if translation == source] == []


def test_the_catalogues_say_their_language():
    for language in LANGUAGES:
        root = ElementTree.parse(translations.catalogue_path(language)).getroot()
        assert (root.tag, root.get("language")) == ("TS", language)
        assert [context.findtext("name") for context in root.iter("context")] == [translations.CONTEXT]


def calls_while_loading(tree, name):
    """Lines at which a module calls a function while it is being loaded: outside functions, or in their defaults."""
    pending, lines = list(ast.iter_child_nodes(tree)), []
    while pending:
        node = pending.pop()
        if isinstance(node, ast.Lambda):
            continue
        if isinstance(node, ast.FunctionDef):
            defaults = [default for default in [*node.args.defaults, *node.args.kw_defaults] if default is not None]
            pending += [*defaults, *node.decorator_list]
            continue
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == name:
            lines.append(node.lineno)
        pending += ast.iter_child_nodes(node)
    return sorted(lines)


def test_strings_are_translated_when_used_not_when_loaded():
    """A `tr` at the top level of a module or as a default would run before the translator is there."""
    bad = "A = tr('a')\ndef f(x=tr('b')):\n    return tr('c')\nclass C:\n    d = [tr('d')]\n"
    assert calls_while_loading(ast.parse(bad), "tr") == [1, 2, 5]
    paths = [path for pattern in translations.SHELL for path in sorted(ROOT.glob(pattern))]
    assert len(paths) > 50
    assert [
        f"{path.relative_to(ROOT)}:{line}"
        for path in paths
        for line in calls_while_loading(ast.parse(path.read_text(encoding="utf-8")), "tr")
    ] == []


def test_a_catalogue_survives_writing_and_reading(tmp_path):
    strings = {"A <b>bold</b> & {name}": [("a.py", 1)], 'Said "so" °': [("a.py", 2), ("b.py", 1)], "New": [("b.py", 2)]}
    known = {"A <b>bold</b> & {name}": "Ein <b>fettes</b> & {name}", 'Said "so" °': "Sagte „so“ °"}
    path = tmp_path / "test.ts"
    translations.write_catalogue(path, "de", strings, known)
    assert translations.read_catalogue(path) == known


def test_placeholders_and_tags_are_compared():
    assert translations.placeholders("{b} of {a}: <b>x</b>") == translations.placeholders("<b>y</b> {a}, {b}")
    assert translations.placeholders("{a} x") != translations.placeholders("{b} x")
    assert translations.placeholders("<b>x</b>") != translations.placeholders("<i>x</i>")


@pytest.mark.parametrize("call", ["tr(f'{name} is here')", "Message(TEMPLATE, name=name)", "say('a', 'b')"])
def test_a_string_that_is_no_literal_is_refused(tmp_path, call):
    (tmp_path / "plugin.py").write_text(call)
    with pytest.raises(ValueError, match=r"plugin\.py:1: \w+\(\) takes one literal string"):
        translations.source_strings(tmp_path)


def test_templates_of_messages_are_strings_of_the_source(tmp_path):
    (tmp_path / "plugin.py").write_text("Message('{path} is here', path=path)\nother.Message.restored(a, b)")
    assert translations.source_strings(tmp_path) == {"{path} is here": [("plugin.py", 1)]}


def test_every_message_is_given_the_facts_that_it_names():
    offenders = []
    for where, call in messages():
        named = set(re.findall(r"\{(\w*)\}", call.args[0].value))
        if named != {keyword.arg for keyword in call.keywords}:
            offenders.append(f"{where}:{call.lineno}: {call.args[0].value}")
    assert offenders == []


def test_a_message_and_the_message_inside_are_translated(monkeypatch):
    from skyline_viewshed.algorithms.shared import i18n
    from skyline_viewshed.core.base.errors import UnreadablePhotoError
    from skyline_viewshed.core.base.messages import Message

    reason = Message(
        "its {width} x {height} pixels are more than {limit} megapixels. Reduce its size first.",
        width=9,
        height=8,
        limit=7,
    )
    error = UnreadablePhotoError("/tmp/{a} b.jpg", reason)
    assert i18n.in_users_language(error.message) == str(error)
    german = translations.read_catalogue(translations.catalogue_path("de"))
    monkeypatch.setattr(i18n, "marked", german.__getitem__)
    assert i18n.in_users_language(error.message) == (
        "Das Foto /tmp/{a} b.jpg kann nicht gelesen werden: 9 x 8 Pixel sind mehr als 7 Megapixel. "
        "Verkleinern Sie das Bild zuerst."
    )
    assert i18n.in_users_language("Schon übersetzt, {a}.") == "Schon übersetzt, {a}."


@pytest.mark.parametrize(
    "language, title", [("de", "Fotos orientieren"), ("es", "Orientar fotos"), ("fr", "Orienter des photos")]
)
def test_qgis_shows_the_language(compiled, qgis_app, language, title):
    from qgis.PyQt.QtCore import QCoreApplication, QTranslator
    from skyline_viewshed.algorithms.orient_photos import OrientPhotos

    translator = QTranslator()
    assert translator.load(str(compiled[language]))
    assert OrientPhotos().displayName() == "Orient photos"
    QCoreApplication.installTranslator(translator)
    try:
        algorithm = OrientPhotos().create()
        assert algorithm.displayName() == title
        finished = translations.read_catalogue(translations.catalogue_path(language))
        labels = [parameter.description() for parameter in algorithm.parameterDefinitions()]
        assert finished["Elevation model (DEM)"] in labels
        assert algorithm.name() == "orientphotos"
    finally:
        QCoreApplication.removeTranslator(translator)
    assert OrientPhotos().displayName() == "Orient photos"


def test_the_plugin_loads_the_language_of_the_user(compiled, qgis_app, tmp_path, monkeypatch):
    from skyline_viewshed import plugin as module
    from skyline_viewshed.algorithms.shared.i18n import tr

    shutil.copy(compiled["de"], tmp_path / "skyline_viewshed_de.qm")
    monkeypatch.setattr(module, "TRANSLATIONS", tmp_path)
    monkeypatch.setattr(module, "QgsApplication", SimpleNamespace(locale=lambda: "de_AT"))
    plugin = module.SkylineViewshedPlugin(None)
    plugin._install_translation()
    assert tr("Orient photos") == "Fotos orientieren"
    plugin.unload()
    assert tr("Orient photos") == "Orient photos"


def test_the_zip_carries_the_compiled_catalogues(compiled):
    if not (ROOT / ".git").exists():
        pytest.skip("not a git checkout")
    done = subprocess.run(["make", "zip"], cwd=ROOT, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(ROOT / "build" / "skyline_viewshed.zip") as archive:
        names = archive.namelist()
    assert {f"skyline_viewshed/i18n/skyline_viewshed_{language}.qm" for language in LANGUAGES} <= set(names)
    assert not [name for name in names if name.endswith(".ts")]
