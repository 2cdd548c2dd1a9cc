"""A text file whose beginning is known last, as a report's: written in passing, put together whole or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
import tempfile
from contextlib import suppress

from ..errors import OutputError


class ReportFile:
    """The `Document` of `core.report` on disk.

    What is written waits in a nameless temporary file in the same folder (it vanishes with the process, however that
    ends); `finish` joins head, body and tail and gives the file its name in one step.

    Parameters
    ----------
    path : str
        Of the HTML file to be; an older one stays as it is until the new one is whole.

    Raises
    ------
    OutputError
        From every method, where the folder is missing or read-only or the disk is full.
    """

    def __init__(self, path):
        self.path = os.fspath(path)
        self._folder = os.path.dirname(self.path) or "."
        try:
            self._body = tempfile.TemporaryFile(  # noqa: SIM115 - lives until finish or discard
                "w+", dir=self._folder, prefix=".skyline-", encoding="utf-8", newline="\n"
            )
        except OSError as error:
            raise self._output_error(error) from None

    def write(self, text):
        """Append to the body."""
        try:
            self._body.write(text)
        except OSError as error:
            raise self._output_error(error) from None

    def finish(self, head, tail):
        """Put `head` before the body and `tail` behind it, and make the whole appear."""
        part = os.path.join(self._folder, f".skyline-{secrets.token_hex(6)}.part")
        try:
            with open(part, "w", encoding="utf-8", newline="\n") as whole:
                whole.write(head)
                self._body.seek(0)
                shutil.copyfileobj(self._body, whole, 1 << 20)
                whole.write(tail)
            os.replace(part, self.path)
        except OSError as error:
            raise self._output_error(error) from None
        finally:
            with suppress(OSError):
                os.remove(part)
            self.discard()

    def discard(self):
        """Leave nothing behind."""
        with suppress(OSError):  # closing flushes, which fails once more on a full disk
            self._body.close()

    def _output_error(self, error):
        reason = error.strerror or str(error)
        if not os.path.isdir(self._folder):
            reason = f"the folder {self._folder} does not exist"
        return OutputError(
            f"The report {self.path} cannot be written: {reason}. Choose another folder or free some space."
        )
