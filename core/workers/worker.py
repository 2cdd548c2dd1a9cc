"""What runs in a worker process: it receives a job, then tasks one by one, and sends back what each gives."""

from __future__ import annotations

import os
import pickle  # nosec B403 - only between this program's own processes
import queue
import signal
import sys
import threading
import time
import traceback

from ..base.errors import Cancelled
from ..base.threads import use_one_thread
from .wire import receive, send

REPORTS_PER_S = 5.0


def serve():
    """Work until the pipe from the pool closes; then this process ends at once."""
    use_one_thread()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C reaches all processes of a terminal; the pool decides
    requests = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints must not get between the messages
    waiting: queue.SimpleQueue = queue.SimpleQueue()
    threading.Thread(target=_listen, args=(requests, waiting), daemon=True).start()
    try:
        work = waiting.get()()
    except Exception as error:  # the pool tells the user, and does the work itself
        send(answers, ("refused", None, _portable(error), traceback.format_exc()))
        return
    send(answers, ("ready", None, None, ""))
    while True:
        index, argument = waiting.get()
        send(answers, (*_done(work, index, argument, answers), ""))


def _listen(requests, waiting):
    try:
        while True:
            waiting.put(receive(requests))
    except Exception:  # the end of the pipe, or a message that this program cannot read: nobody waits for an answer
        os._exit(0)


def _done(work, index, argument, answers):
    try:
        return "done", index, work(argument, _Reporter(answers, index))
    except (Exception, Cancelled) as error:
        error = _portable(error)
        error.details = traceback.format_exc()
        return "raised", index, error


def _portable(error):
    """Give the error itself if the other process can read it, and else its text."""
    try:
        pickle.loads(pickle.dumps(error))  # nosec B301 - made one call before
        return error
    except Exception:
        return RuntimeError(f"{type(error).__name__}: {error}")


class _Reporter:
    """The `Progress` of one task; the pool ends the process when the user cancels, so nothing asks here."""

    def __init__(self, answers, index):
        self.answers, self.index, self._next = answers, index, 0.0

    def report(self, fraction):
        """Send the fraction done, but not more often than a progress bar shows."""
        now = time.monotonic()
        if now >= self._next:
            self._next = now + 1 / REPORTS_PER_S
            send(self.answers, ("progress", self.index, fraction, ""))

    def cancelled(self):
        """Return False: see the class."""
        return False
