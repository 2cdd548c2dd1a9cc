"""Sentences for the user, kept as template and facts so that they can be translated when they are shown."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any


class Message(str):
    """An English sentence that keeps the template and the facts from which it was made.

    The core has no translator. It writes ``Message("The DEM {path} does not exist.", path=path)``, and the shell
    puts the template into the user's language and fills in the same facts (`algorithms.shared.i18n`).
    `tools/make_translations.py` collects the templates; therefore the first argument must be a literal.

    A message is a `str`, so that the report, exceptions, JSON and comparisons use it as the plain sentence. Building a
    new string from it (``str()``, an f-string, ``+``, ``join``) gives the English sentence without its structure. Pass
    on the message itself instead, or make it a fact of another message. Equality and hash are those of the sentence.

    Parameters
    ----------
    template : str
        Sentence with the names of the facts in braces.
    **facts : str, int or Message
        Values by name. Format numbers with a fraction first; any other object, such as a path, becomes its `str()`.
    """

    __slots__ = ("_facts", "_template")
    _facts: dict[str, str | int]
    _template: str

    def __new__(cls, template: str, /, **facts: object) -> Message:
        """Fill in the template; raises `KeyError` if a fact that it names is missing."""
        kept = {name: fact if isinstance(fact, (str, int)) else str(fact) for name, fact in facts.items()}
        message = super().__new__(cls, template.format(**kept))
        message._template, message._facts = template, kept
        return message

    @classmethod
    def restored(cls, template: str, facts: dict[str, object]) -> Message:
        """Rebuild a message from a stored template and a dict of facts."""
        return cls(template, **facts)

    @property
    def template(self) -> str:
        """The sentence with the names of the facts in braces."""
        return self._template

    @property
    def facts(self) -> Mapping[str, str | int]:
        """Read-only mapping of the facts by their names."""
        return MappingProxyType(self._facts)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle and copy as template and facts."""
        return Message.restored, (self._template, self._facts)

    def __repr__(self) -> str:
        """Give the call that makes the message."""
        return f"Message({', '.join([repr(self._template), *(f'{k}={v!r}' for k, v in self._facts.items())])})"
