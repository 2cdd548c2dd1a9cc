"""The pieces of HTML in `report.html`, filled with values: text is escaped, HTML is not."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

from ..figures.text import LONGEST_TEXT, escape

_FILE = Path(__file__).with_name("report.html")


class Html(str):
    """Text that is HTML already, so that `fill` takes it as it is."""

    __slots__ = ()


def fill(piece, **values):
    """Fill a piece of `report.html`.

    Parameters
    ----------
    piece : str
        Its name.
    **values
        For the names in braces. `Html` is put in as it is; anything else is escaped and cut to `LONGEST_TEXT`.

    Returns
    -------
    Html
    """
    safe = {name: value if isinstance(value, Html) else escape(value) for name, value in values.items()}
    return Html(_pieces()[piece].format(newline="\n", **safe))


def joined(parts):
    """Pieces one after the other."""
    return Html("".join(parts))


def long_text(text, longest=1000):
    """Escape a text that may be longer than `LONGEST_TEXT` characters."""
    return Html(escape(text, max(longest, LONGEST_TEXT)))


@lru_cache(maxsize=1)
def _pieces():
    named = re.findall(r"<!-- (\w+) -->\n(.*?)(?=\n\n<!--|\Z)", _FILE.read_text(encoding="utf-8"), re.DOTALL)
    return {name: body.replace("\n", "") for name, body in named}
