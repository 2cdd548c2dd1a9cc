"""The HTML templates in `report.html`, filled with values: text is escaped, HTML is not."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

from ..figures.text import LONGEST_TEXT, escape

_FILE = Path(__file__).with_name("report.html")


class Html(str):
    """Text that is already HTML, so that `fill` inserts it unchanged."""

    __slots__ = ()


def fill(piece, **values):
    """Fill a template of `report.html`.

    Parameters
    ----------
    piece : str
        Name of the template.
    **values
        Values for the names in braces. `Html` is inserted unchanged; anything else is escaped and cut to
        `LONGEST_TEXT`.

    Returns
    -------
    Html
    """
    safe = {name: value if isinstance(value, Html) else escape(value) for name, value in values.items()}
    return Html(_pieces()[piece].format(newline="\n", **safe))


def joined(parts):
    """Join filled templates, one after the other."""
    return Html("".join(parts))


def long_text(text, longest=1000):
    """Escape a text that may be longer than `LONGEST_TEXT` characters."""
    return Html(escape(text, max(longest, LONGEST_TEXT)))


@lru_cache(maxsize=1)
def _pieces():
    named = re.findall(r"<!-- (\w+) -->\n(.*?)(?=\n\n<!--|\Z)", _FILE.read_text(encoding="utf-8"), re.DOTALL)
    return {name: body.replace("\n", "") for name, body in named}
