"""The frame of a report: one HTML file that needs nothing else, and forbids itself to load anything.

A Content-Security-Policy names the hashes of our own style sheet and script and allows pictures from data URLs: even
if a hostile text got past the escaping, a browser would neither run nor fetch it.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Protocol

from ..figures.svg import STYLE
from ..figures.text import escape

_HERE = Path(__file__).parent


def page_head(title, class_="report", say=str):
    """Begin a page: everything up to and including the opening body tag."""
    language = escape(say("language code: en").split()[-1])  # each catalogue names its own
    style, script = _assets()
    policy = (
        f"default-src 'none'; img-src data:; style-src 'sha256-{_hash(style)}'; script-src 'sha256-{_hash(script)}'; "
        "base-uri 'none'; form-action 'none'"
    )
    return (
        f'<!DOCTYPE html>\n<html lang="{language}"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        '<meta name="color-scheme" content="light dark"><meta name="referrer" content="no-referrer">'
        f"<title>{escape(title)}</title><style>{style}</style></head>\n<body class={class_!r} id='top'>\n"
    )


def page_tail(software="", say=str):
    """End a page with the program's name, the script, and the closing tags."""
    made_by = say("Made by {software}.").format(software=software) + " " if software else ""
    quiet = say("This page is complete in itself and loads nothing from a network. Keys: j next photo, k previous.")
    return (
        f'<footer class="page quiet">{escape(made_by + quiet, 2000)}</footer>\n'
        f"<script>{_assets()[1]}</script>\n</body></html>\n"
    )


def parameter_panel(parameters, say=str):
    """Fold-out list of a run's parameters; a mapping inside the mapping becomes a group of its own."""
    if not parameters:
        return ""
    loose = {label: value for label, value in parameters.items() if not isinstance(value, Mapping)}
    groups = [(say("Run"), loose)] if loose else []
    groups += [(label, value) for label, value in parameters.items() if isinstance(value, Mapping)]
    tables = "".join(fact_table(title, [(str(a), _words(b)) for a, b in group.items()]) for title, group in groups)
    return (
        f'<details class="panel"><summary>{escape(say("Parameters, DEM and software"))}</summary>'
        f'<div class="numbers">{tables}</div></details>'
    )


def fact_table(title, rows):
    """A titled two-column table of plain words, escaped here."""
    body = "".join(
        f"<tr><td>{escape(label)}</td><td><bdi>{escape(words, 2000)}</bdi></td></tr>" for label, words in rows
    )
    return f"<section><h3>{escape(title)}</h3><table>{body}</table></section>"


def data_url(payload, kind):
    """Bytes of a picture ('jpeg', 'png') as a data URL."""
    return f"data:image/{kind};base64,{base64.b64encode(payload).decode('ascii')}"


def _assets():
    style = STYLE + (_HERE / "report.css").read_text(encoding="utf-8")
    return style, (_HERE / "report.js").read_text(encoding="utf-8")


def _hash(text):
    return base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")


def _words(value):
    if value is None:
        return "–"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


DEFAULT_SOFTWARE = "Skyline Viewshed"


class Document(Protocol):
    """Where a page goes: `core.io.whole_file.ReportFile` spools it to disk."""

    def write(self, text: str) -> None:
        """Append to the body."""

    def finish(self, head: str, tail: str) -> None:
        """Put `head` before the body and `tail` behind it, and make the whole appear."""

    def discard(self) -> None:
        """Leave nothing behind."""


class PageWriter:
    """What all reports share: title, parameters, cards, and the end.

    Used as a context manager the page appears at the end of the block, and not at all after an error or a cancel.

    Parameters
    ----------
    document : Document
    title : str
    parameters : mapping or None
        Labels and values of the run; a mapping as value becomes a titled group ('DEM', 'Options').
    software : str
        Name and version of the program.
    created : datetime or None
        Printed under the title.
    say : callable
        Gives a fixed English word in the reader's language; see `draw_text`.
    """

    def __init__(self, document, title, parameters=None, *, software=DEFAULT_SOFTWARE, created=None, say=str):
        self._document, self._title, self._parameters = document, title, dict(parameters or {})
        self._software, self._created, self._say, self._open = software, created, say, True

    def __enter__(self):
        return self

    def __exit__(self, kind, value, traceback):
        if kind is None:
            self.close()
        else:
            self.discard()

    def close(self):
        """Finish the page and make it appear."""
        if self._open:
            self._open = False
            before, overview, after = self._frame()
            said = [*self._counts(), *([f"{self._created:%Y-%m-%d %H:%M}"] if self._created else []), self._software]
            counts = "".join(f"<span>{escape(words)}</span>" for words in said)
            mast = f'<h1>{escape(self._title)}</h1><div class="counts quiet">{counts}</div>'
            before, bar = before
            head = page_head(self._title, say=self._say)
            head += f'{before}<div class="page-head">{mast}</div>\n{bar}<div class="page">'
            head += parameter_panel(self._parameters, self._say) + overview
            self._document.finish(head, f"{after}</div>{page_tail(self._software, self._say)}")

    def discard(self):
        """Give the page up, leaving nothing behind."""
        if self._open:
            self._open = False
            self._document.discard()

    def _counts(self):
        """Words under the title."""
        return []

    def _frame(self):
        """((switches, bar), overview, end): HTML around the cards."""
        raise NotImplementedError
