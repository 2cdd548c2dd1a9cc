"""The frame of a report: one self-contained HTML file that forbids itself to load anything.

A Content-Security-Policy lists the hashes of our own style sheet and script and allows pictures from data URLs. Even if
a hostile text passed the escaping, a browser would neither run nor fetch it.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from ..figures.svg import STYLE
from .pieces import Html, fill, joined, long_text

_HERE = Path(__file__).parent


def parameter_panel(parameters, say=str):
    """Collapsible list of a run's parameters; a mapping inside the mapping becomes a group of its own."""
    if not parameters:
        return Html()
    loose = {label: value for label, value in parameters.items() if not isinstance(value, Mapping)}
    groups = [(say("Run"), loose)] if loose else []
    groups += [(label, value) for label, value in parameters.items() if isinstance(value, Mapping)]
    tables = joined(fact_table(title, [(a, _words(b)) for a, b in group.items()]) for title, group in groups)
    return fill("panel", title=say("Parameters, DEM and software"), body=fill("numbers", tables=tables))


def fact_table(title, rows):
    """A titled two-column table of plain text, escaped here."""
    cells = joined(fill("fact_row", label=label, words=long_text(words, 2000)) for label, words in rows)
    return fill("fact_table", title=title, rows=cells)


def data_url(payload, kind):
    """Bytes of a picture ('jpeg', 'png') as a data URL."""
    return Html(f"data:image/{kind};base64,{base64.b64encode(payload).decode('ascii')}")


def _assets(name):
    """Return the style sheet, the script, and the policy that allows only these two, and pictures.

    The index of many photographs has its own script, more style, and pictures in files beside it.
    """
    index = name == "index"
    style = STYLE + _read("report.css") + (_read("index.css") if index else "")
    script, pictures = _read(f"{name}.js"), "data: 'self' file:" if index else "data:"
    policy = (
        f"default-src 'none'; img-src {pictures}; style-src 'sha256-{_hash(style)}'; "
        f"script-src 'sha256-{_hash(script)}'; base-uri 'none'; form-action 'none'"
    )
    return {"style": Html(style), "script": Html(script), "policy": Html(policy)}


def _read(name):
    return (_HERE / name).read_text(encoding="utf-8")


def _hash(text):
    return base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")


def _words(value):
    if value is None:
        return "–"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


DEFAULT_SOFTWARE = "Skyline Viewshed"


class Document(Protocol):
    """The destination of a page: `core.io.report_file.ReportFile` spools it to disk."""

    folder: str
    home: str

    def write(self, text: str) -> None:
        """Append to the body."""

    def cut(self, count: int) -> bytes:
        """Take the first `count` texts off the body."""

    def add(self, name: str, content: bytes) -> None:
        """Put a file into the folder beside the page."""

    def finish(self, head: str, tail: str) -> None:
        """Put `head` before the body and `tail` after it, and publish the complete file."""

    def discard(self) -> None:
        """Leave no file behind."""


@dataclass(frozen=True)
class Frame:
    """What surrounds the cards of a page; HTML.

    Attributes
    ----------
    switches, bar, overview : str
        Before the cards.
    end : str
        After them.
    title : str
        Title of the page, if it is not that of the report.
    name : str
        Name of the script: 'report', or 'index' for the index of many photographs.
    """

    switches: str = Html()
    bar: str = Html()
    overview: str = Html()
    end: str = Html()
    title: str = ""
    name: str = "report"


class PageWriter:
    """The common parts of all reports: title, parameters, cards, and the end.

    If the writer is used as a context manager, the page appears at the end of the block, and not after an error or a
    cancel.

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
        Translates a fixed English word into the reader's language; see `core.figures.text`.
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
        """Finish the page and publish it."""
        if self._open:
            self._open = False
            try:
                head, tail = self._around(self._frame(), self._counts(), self._parameters)
            except BaseException:
                self._document.discard()
                raise
            self._document.finish(head, tail)

    def _around(self, frame, counts, parameters=None):
        """HTML before and after the cards of a page.

        Parameters
        ----------
        frame : Frame
        counts : list of str
            Texts under the title.
        parameters : mapping or None
            As for the class.

        Returns
        -------
        head, tail : str
        """
        say, assets = self._say, _assets(frame.name)
        said = [*counts, *([f"{self._created:%Y-%m-%d %H:%M}"] if self._created else []), self._software]
        head = fill(
            "page_head",
            language=say("language code: en").split()[-1],  # each catalogue names its own
            policy=assets["policy"],
            style=assets["style"],
            title=frame.title or self._title,
            counts=joined(fill("count", words=words) for words in said),
            parameters=parameter_panel(parameters, say),
            switches=frame.switches,
            bar=frame.bar,
            overview=frame.overview,
        )
        words = long_text(self._closing_words(frame.name), 2000)
        return head, fill("page_tail", end=frame.end, words=words, script=assets["script"])

    def _closing_words(self, name):
        say = self._say
        made_by = say("Made by {software}.").format(software=self._software) + " " if self._software else ""
        if name == "index":
            return made_by + say(
                "The cards are in the folder {folder} beside this page: keep both together. They load nothing from "
                "the network."
            ).format(folder=self._document.folder.split("/")[0])
        return made_by + say(
            "This page is self-contained and loads nothing from the network. Keys: j for the next photo, k "
            "for the previous one."
        )

    def discard(self):
        """Abandon the page and leave no file behind."""
        if self._open:
            self._open = False
            self._document.discard()

    def _counts(self):
        """Text under the title."""
        return []

    def _frame(self):
        """Return the `Frame` around the cards."""
        raise NotImplementedError
