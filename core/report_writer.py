"""Writing a page whose overview stands first and is known last: card by card, whole or not at all."""

from __future__ import annotations

from typing import Protocol

from .draw_text import escape
from .report_page import page_head, page_tail, parameter_panel

DEFAULT_SOFTWARE = "Skyline Viewshed"


class Document(Protocol):
    """Where a page goes: `core.io.report_file.ReportFile` spools it to disk, `MemoryDocument` keeps it."""

    def write(self, text: str) -> None:
        """Append to the body."""

    def finish(self, head: str, tail: str) -> None:
        """Put `head` before the body and `tail` behind it, and make the whole appear."""

    def discard(self) -> None:
        """Leave nothing behind."""


class MemoryDocument:
    """A `Document` that ends as `text`."""

    def __init__(self):
        self._parts, self.text = [], ""

    def write(self, text):
        """See `Document`."""
        self._parts.append(text)

    def finish(self, head, tail):
        """See `Document`."""
        self.text = "".join([head, *self._parts, tail])

    def discard(self):
        """See `Document`."""
        self._parts.clear()


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
