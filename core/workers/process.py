"""A worker as the pool sees it: a Python process, the pipes to it, and the tasks that it was given."""

from __future__ import annotations

import json
import os
import queue
import subprocess  # nosec B404 - starts this program's own Python
import sys
import threading
from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import Any

from .wire import receive, send

START = (
    "import sys, json; "
    "sys.exit(3) if sys.version_info[:2] != ({major}, {minor}) else None; "
    "sys.path[:] = json.loads(sys.stdin.buffer.readline()); "
    "{before}import {module} as worker; worker.serve()"
)
NO_QGIS = "sys.modules['qgis'] = None; "
"""Advice on missing packages differs inside QGIS, and must not depend on the process that gives it."""

ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)


class Worker:
    """A process, the tasks in its hands (the first is the one it computes), and the key of the last one."""

    def __init__(self, command, job, inbox):
        self.tasks: deque = deque()
        self.key, self.started, self._inbox = None, False, inbox
        root = __name__.split(".core.")[0]
        module = f"{__package__}.worker"
        version = {"major": sys.version_info[0], "minor": sys.version_info[1]}
        code = START.format(module=module, before=NO_QGIS if "qgis" in sys.modules else "", **version)
        self.process = subprocess.Popen(  # nosec B603 - a list of our own arguments, no shell
            [command, "-c", code],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, **ONE_THREAD},
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
        self._first: Any = queue.Queue()
        with suppress(OSError):
            self.process.stdin.write(  # type: ignore[union-attr]
                json.dumps(_path_with(root)).encode("ascii") + b"\n"
            )
            send(self.process.stdin, job)
        threading.Thread(target=self._listen, daemon=True).start()

    def first(self, seconds):
        """Wait for the answer to the job; raises `EOFError` or `queue.Empty`."""
        message = self._first.get(timeout=seconds)
        if message is None:
            raise EOFError
        return message

    def _listen(self):
        try:
            answer = receive(self.process.stdout)
            self._first.put(answer)
            self.started = answer[0] == "ready"
            while True:
                self._inbox.put((self, receive(self.process.stdout)))
        except Exception:  # the end of the pipe, or half a message: the process is gone
            self._first.put(None)
            self._inbox.put((self, None))


def _path_with(root):
    """`sys.path` as strings, beginning with the folder in which this package lies."""
    package = next(iter(sys.modules[root].__path__)) if root in sys.modules else Path(__file__).parents[2]
    return list(dict.fromkeys([str(Path(package).parent), *(str(entry) for entry in sys.path if entry)]))


def end(workers):
    """End processes and wait until they have ended."""
    for worker in filter(None, workers):
        with suppress(OSError):
            worker.process.kill()
    for worker in filter(None, workers):
        with suppress(subprocess.TimeoutExpired):
            worker.process.wait(10)
        for stream in (worker.process.stdin, worker.process.stdout):
            with suppress(OSError, ValueError):
                stream.close()
