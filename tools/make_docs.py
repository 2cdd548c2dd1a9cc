"""Write the parts of the documentation that come from the code: the algorithm reference and the tables of fields.

Usage: make_docs.py [--check]

`docs/algorithms.md` is written whole. In other pages the lines between `<!-- begin: NAME -->` and `<!-- end -->` are
replaced. With --check nothing is written, and the exit code is 1 if a page is out of date. Nothing here depends on the
wording of the running QGIS: the names of types are defined here, and all other texts are the plugin's.
"""

from __future__ import annotations

import html
import os
import re
import sys
from importlib import import_module
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
BLOCK = re.compile(r"(<!-- begin: ([\w.]+) -->\n).*?(<!-- end -->)", re.DOTALL)

INTRODUCTION = """\
# Algorithms

<!-- Written by `make docs` from the provider's registry. Do not edit. -->

Identifiers, parameter names and field names never change once released. On the command line an algorithm is
`skylineviewshed:` and its identifier; [automate.md](automate.md) shows how. Distances are ground metres whatever
the coordinate systems; headings and azimuths count clockwise from true north. *Optional* parameters may be left
out; *advanced* ones are folded away in the dialog. The attributes of vector outputs are in [fields.md](fields.md).
"""

VECTOR_KINDS = {0: "point", 1: "line", 2: "polygon"}
TYPES = {
    "source": "vector layer",
    "vector": "vector layer",
    "sink": "vector output",
    "vectorDestination": "vector output",
    "raster": "raster layer",
    "rasterDestination": "raster output",
    "band": "band number",
    "field": "field name",
    "file": "file",
    "fileDestination": "file output",
    "folderDestination": "folder output",
    "distance": "metres",
    "number": "number",
    "enum": "choice",
    "boolean": "yes or no",
    "string": "text",
    "extent": "extent",
    "point": "point",
    "crs": "coordinate system",
    "multilayer": "layers",
}
OUTPUT_TYPES = {
    "outputNumber": "number",
    "outputString": "text",
    "outputBoolean": "yes or no",
    "outputVector": "vector layer",
    "outputRaster": "raster layer",
    "outputHtml": "file",
    "outputFile": "file",
    "outputFolder": "folder",
}


def main(arguments):
    """Write or check all generated parts."""
    pages = generated_pages()
    if "--check" in arguments:
        stale = [path for path, text in pages.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
        for path in stale:
            print(f"{path.relative_to(ROOT)} is not current. Run: make docs")
        return 1 if stale else 0
    for path, text in pages.items():
        path.write_text(text, encoding="utf-8")
        print(path.relative_to(ROOT))
    return 0


def generated_pages():
    """Return the text of each page with generated parts, by path."""
    provider, application = start_qgis()
    try:
        pages = {DOCS / "algorithms.md": reference(provider)}
        for path in (DOCS / "fields.md",):
            pages[path] = fill_blocks(path.read_text(encoding="utf-8"), field_blocks())
        return pages
    finally:
        application.processingRegistry().removeProvider(provider)


def start_qgis():
    """Start QGIS without a screen and in English, with Processing's own provider and ours."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from qgis.core import QgsApplication
    from skyline_viewshed.processing_provider.provider import SkylineViewshedProvider

    application = QgsApplication.instance()
    if application is None:
        application = QgsApplication([], False)
        application.initQgis()
        start_qgis.kept = application
    from qgis.analysis import QgsNativeAlgorithms

    registry = application.processingRegistry()
    if registry.providerById("native") is None:
        registry.addProvider(QgsNativeAlgorithms(registry))
    provider = SkylineViewshedProvider()
    registry.addProvider(provider)
    return provider, application


# --- docs/algorithms.md


def reference(provider):
    """Compose the whole algorithm reference."""
    algorithms = {algorithm.name(): algorithm for algorithm in provider.algorithms()}
    ordered = [algorithms[name] for name in code_order() if name in algorithms]
    # A model has its outputs only once the algorithms it consists of are registered, so take new copies.
    models = [algorithms[name].create() for name in sorted(algorithms) if algorithms[name] not in ordered]
    lines = [
        *INTRODUCTION.splitlines(),
        "",
        "| algorithm | | group |",
        "| --- | --- | --- |",
    ]
    for algorithm in [*ordered, *models]:
        group = "Models" if algorithm in models else algorithm.group()
        lines.append(f"| [`{algorithm.name()}`](#{algorithm.name()}) | {cell(algorithm.displayName())} | {group} |")
    for algorithm in ordered:
        lines += chapter(algorithm, [markdown(paragraph) for paragraph in algorithm.help_text()])
    for model in models:
        lines += chapter(model, [model_help(model)])
    return "\n".join(lines).rstrip() + "\n"


def code_order():
    """Identifiers in the order of the workflow, as the provider declares them."""
    from skyline_viewshed.processing_provider.provider import ALGORITHMS

    for module, name in ALGORITHMS:
        yield getattr(import_module(f"skyline_viewshed.algorithms.{module}"), name).ID


def chapter(algorithm, paragraphs):
    """Compose heading, help, inputs and outputs of one algorithm."""
    lines = ["", f'<a id="{algorithm.name()}"></a>', "", f"## {algorithm.displayName()}", ""]
    lines += [f"`skylineviewshed:{algorithm.name()}`", ""]
    for paragraph in filter(None, paragraphs):
        lines += [paragraph, ""]
    inputs = [d for d in algorithm.parameterDefinitions() if not d.isDestination()]
    targets = [d for d in algorithm.parameterDefinitions() if d.isDestination()]
    lines += ["| parameter | | type | default | meaning |", "| --- | --- | --- | --- | --- |"]
    lines += [row(definition) for definition in inputs]
    lines += ["", "| output | | type | |", "| --- | --- | --- | --- |"]
    for definition in targets:
        note = definition.help() or ("optional" if is_optional(definition) else "")
        if definition.help() and is_optional(definition):
            note = f"*optional*; {note}"
        lines.append(
            f"| `{definition.name()}` | {cell(definition.description())} | {kind(definition)} | {cell(note)} |"
        )
    named = {definition.name() for definition in targets}
    for output in algorithm.outputDefinitions():
        if output.name() not in named:
            word = OUTPUT_TYPES.get(output.type(), output.type())
            lines.append(f"| `{output.name()}` | {cell(output.description())} | {word} | result value |")
    return lines


def row(definition):
    """Format one input as a line of the table."""
    marks = [
        word for word, yes in (("*optional*", is_optional(definition)), ("*advanced*", is_advanced(definition))) if yes
    ]
    meaning = "; ".join(
        [", ".join(marks), definition.help()] if marks and definition.help() else [*marks, definition.help()]
    )
    parts = (f"`{definition.name()}`", definition.description(), kind(definition), default(definition), meaning)
    return "| " + " | ".join(cell(part) for part in parts) + " |"


def is_optional(definition):
    """Whether a parameter may be left out."""
    from qgis.core import QgsProcessingParameterDefinition as Definition

    return bool(definition.flags() & Definition.Flag.FlagOptional)


def is_advanced(definition):
    """Whether the dialog hides a parameter among the advanced ones."""
    from qgis.core import QgsProcessingParameterDefinition as Definition

    return bool(definition.flags() & Definition.Flag.FlagAdvanced)


def kind(definition):
    """Type of a parameter in words, with its range or its choices."""
    name = definition.type()
    word = TYPES.get(name, name)
    if name == "enum":
        return "choice: " + ", ".join(f"{i} {option}" for i, option in enumerate(definition.options()))
    if name in ("distance", "number"):
        return word + limits(definition)
    if name == "file":
        return "folder" if int(definition.behavior()) == 1 else "file"
    if name in ("source", "vector"):
        kinds = [VECTOR_KINDS.get(int(value)) for value in definition.dataTypes()]
        return f"{' or '.join(kinds)} layer" if kinds and all(kinds) else "layer or table"
    if name == "field":
        return f"field of `{definition.parentLayerParameterName()}`"
    if name == "band":
        return f"band of `{definition.parentLayerParameterName()}`"
    return word


def limits(definition):
    """Range of a number, if it has one."""
    low, high = definition.minimum(), definition.maximum()
    low, high = (value if abs(value) < 1e15 else None for value in (low, high))
    if low is not None and high is not None:
        return f", {low:g} to {high:g}"
    if low is not None:
        return f", at least {low:g}"
    return "" if high is None else f", at most {high:g}"


def default(definition):
    """Default value as it is written on the command line."""
    value = definition.defaultValue()
    if value is None or value == "" or (hasattr(value, "isNull") and value.isNull()):
        return ""
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"


def model_help(model):
    """Description of a shipped model, as its author wrote it."""
    content = model.helpContent() if hasattr(model, "helpContent") else {}
    return markdown(str(content.get("ALG_DESC", "")))


def markdown(text):
    """Convert the simple HTML of help texts to Markdown."""
    text = re.sub(r"</?b>", "**", text)
    text = re.sub(r"</?i>", "*", text)
    text = re.sub(r"</?(code|tt)>", "`", text)
    text = re.sub(r"<br/?>", " ", text)
    return html.unescape(re.sub(r"<[^>]+>", "", text)).strip()


def cell(text):
    """Make a text safe inside a table."""
    return markdown(str(text)).replace("|", "\\|").replace("\n", " ")


# --- docs/fields.md


def field_blocks():
    """Return the tables of fields, by the `module.function` that defines them."""
    return {path: field_table(specs_of(path)) for path in spec_functions()}


def spec_functions():
    """List `module.function` of each public function under algorithms/ named *_specs that takes no argument."""
    for path in sorted((ROOT / "algorithms").rglob("*.py")):
        for name in re.findall(r"^def (\w+_specs)\(\):", path.read_text(encoding="utf-8"), re.MULTILINE):
            if not name.startswith("_"):
                yield f"{path.stem}.{name}"


def specs_of(path):
    """Return the specifications from `module.function`."""
    module, function = path.split(".")
    folder = "algorithms.shared" if (ROOT / "algorithms" / "shared" / f"{module}.py").exists() else "algorithms"
    return getattr(import_module(f"skyline_viewshed.{folder}.{module}"), function)()


def field_table(specs):
    """Format names, types and aliases as a table."""
    words = {
        "text": "text",
        "real": "decimal number",
        "whole": "whole number",
        "yes": "yes or no",
        "time": "date and time",
    }
    lines = ["| field | type | meaning (unit) |", "| --- | --- | --- |"]
    lines += [f"| `{spec.name}` | {words[spec.kind]} | {cell(spec.alias)} |" for spec in specs]
    return "\n".join(lines) + "\n"


def fill_blocks(text, blocks):
    """Replace the marked blocks of a page."""

    def filled(match):
        if match.group(2) not in blocks:
            raise SystemExit(f"No table is called {match.group(2)}. There are: {', '.join(sorted(blocks))}")
        return match.group(1) + blocks[match.group(2)] + match.group(3)

    return BLOCK.sub(filled, text)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
