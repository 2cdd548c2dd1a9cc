"""Fenced code blocks of Markdown pages, as a reader would copy them."""

from __future__ import annotations

import re
from dataclasses import dataclass

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NOT_RUN = re.compile(r"<!-- not run by the tests: [^\n]+ -->\n$")


@dataclass(frozen=True)
class Block:
    """One block: page and line for messages, language, code, and whether the page excludes it from running."""

    page: str
    line: int
    language: str
    code: str
    run: bool

    def __str__(self):
        return f"{self.page}:{self.line}"


def fenced_blocks(path):
    """All fenced blocks of a page, in order."""
    text = path.read_text(encoding="utf-8")
    blocks = []
    for match in FENCE.finditer(text):
        before = text[: match.start()]
        run = NOT_RUN.search(before) is None
        blocks.append(Block(path.name, before.count("\n") + 2, match.group(1), match.group(2), run))
    return blocks
