"""A report on disk: one HTML file, for many photographs with a folder of pages beside it; whole or not at all."""

from __future__ import annotations

import os
import re
import secrets
import shutil
import tempfile
import time
from contextlib import suppress

from ..base.errors import OutputError
from ..base.messages import Message

ABANDONED_S = 24 * 3600.0
"""Age of the hidden folder of a report of the same name after which the run that wrote it must have been killed."""

_OURS = re.compile(r"cards-[0-9a-f]{12}")
"""Names of the folders that hold the pages of a report; nothing else in its folder is ever removed."""


class ReportFile:
    """The `Document` of `core.report.page` on disk.

    The body is written to an unnamed temporary file in the same folder, which the operating system removes however the
    process ends. `finish` joins head, body and tail, and renames the result to `path` atomically.

    Pages and pictures of a large report are collected in a hidden folder, which `finish` moves to
    `<name>_files/cards-<token>` just before the report gets its name. The report refers to this token, so a report and
    its pages always belong together, whenever a process is killed. Pages of an older report of the same name are then
    removed.

    Parameters
    ----------
    path : str
        Final path of the HTML file; an older file stays unchanged until the new one is complete.

    Raises
    ------
    OutputError
        By every method, if the folder is missing or read-only, or the disk is full.
    """

    def __init__(self, path):
        self.path = os.fspath(path)
        self._folder = os.path.dirname(self.path) or "."
        self._token, self._lengths, self._start = secrets.token_hex(6), [], 0
        self._stage = os.path.join(self._folder, f".skyline-{self._files()}-{self._token}")
        try:
            self._body = tempfile.TemporaryFile(dir=self._folder, prefix=".skyline-")  # noqa: SIM115 - until the end
        except OSError as error:
            raise self._output_error(error) from None

    @property
    def folder(self):
        """Where pages and pictures will lie, as the report's HTML refers to it."""
        return f"{self._files()}/cards-{self._token}"

    @property
    def home(self):
        """Path of the report, as a page in its folder refers to it."""
        return "../../" + os.path.basename(self.path)

    def write(self, text):
        """Append text to the body."""
        encoded = text.encode("utf-8")
        try:
            self._body.seek(0, os.SEEK_END)
            self._body.write(encoded)
        except OSError as error:
            raise self._output_error(error) from None
        self._lengths.append(len(encoded))

    def add(self, name, content):
        """Write bytes to a file in the folder beside the report."""
        try:
            os.makedirs(self._stage, exist_ok=True)
            with open(os.path.join(self._stage, name), "wb") as file:
                file.write(content)
        except OSError as error:
            raise self._output_error(error) from None

    def cut(self, count):
        """Take the first `count` texts off the body and return them as bytes."""
        length, self._lengths = sum(self._lengths[:count]), self._lengths[count:]
        try:
            self._body.seek(self._start)
            taken, self._start = self._body.read(length), self._start + length
            if sum(self._lengths) <= length:  # so that the file stays small, and little is copied
                rest = self._body.read()
                self._body.seek(0)
                self._body.truncate()
                self._body.write(rest)
                self._start = 0
        except OSError as error:
            raise self._output_error(error) from None
        return taken

    def finish(self, head, tail):
        """Put `head` before the body and `tail` after it, and give the file, and pages beside it, their names."""
        part = os.path.join(self._folder, f".skyline-{secrets.token_hex(6)}.part")
        pages = os.path.join(self._folder, *self.folder.split("/"))
        published = False
        try:
            with open(part, "wb") as whole:
                whole.write(head.encode("utf-8"))
                self._body.seek(self._start)
                shutil.copyfileobj(self._body, whole, 1 << 20)
                whole.write(tail.encode("utf-8"))
            if os.path.isdir(self._stage):
                os.makedirs(os.path.dirname(pages), exist_ok=True)
                os.replace(self._stage, pages)
            os.replace(part, self.path)
            published = True
        except OSError as error:
            raise self._output_error(error) from None
        finally:
            if not published:
                shutil.rmtree(pages, ignore_errors=True)
                with suppress(OSError):  # fails if there is no such folder, or it still holds anything
                    os.rmdir(os.path.dirname(pages))
            with suppress(OSError):
                os.remove(part)
            self.discard()
        self._remove_older_pages()

    def discard(self):
        """Remove what was written so far."""
        shutil.rmtree(self._stage, ignore_errors=True)
        with suppress(OSError):  # closing flushes, which fails again on a full disk
            self._body.close()

    def _files(self):
        return os.path.splitext(os.path.basename(self.path))[0] + "_files"

    def _remove_older_pages(self):
        """Remove the pages of reports that this one replaced; what cannot be removed now, the next report removes."""
        files, hidden = os.path.join(self._folder, self._files()), f".skyline-{self._files()}-"
        for name in _names(self._folder):
            stage, token = os.path.join(self._folder, name), name[len(hidden) :]
            if name.startswith(hidden) and _OURS.fullmatch(f"cards-{token}") and _age_s(stage) > ABANDONED_S:
                shutil.rmtree(stage, ignore_errors=True)
        for name in _names(files):
            if _OURS.fullmatch(name) and name != f"cards-{self._token}":
                shutil.rmtree(os.path.join(files, name), ignore_errors=True)
        with suppress(OSError):  # fails if there is no such folder, or it still holds anything
            os.rmdir(files)

    def _output_error(self, error):
        reason = error.strerror or str(error)
        if not os.path.isdir(self._folder):
            reason = Message("the folder {folder} does not exist", folder=self._folder)
        return OutputError(
            Message(
                "The report {path} cannot be written: {reason}. Choose another folder or free some space.",
                path=self.path,
                reason=reason,
            )
        )


def _names(folder):
    try:
        return os.listdir(folder)
    except OSError:
        return []


def _age_s(path):
    try:
        return time.time() - os.stat(path).st_mtime
    except OSError:
        return 0.0
