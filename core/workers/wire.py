"""Messages between the pool and its workers: pickles with their length in front, over the pipes of a process.

Only the two ends of one run talk to each other, so that reading a pickle executes nothing but this program.
"""

from __future__ import annotations

import pickle  # nosec B403 - only between this program's own processes
import struct

HEAD = struct.Struct(">Q")


def send(stream, message):
    """Write a message and flush it; raises `OSError` if the other end is gone."""
    content = pickle.dumps(message, protocol=pickle.HIGHEST_PROTOCOL)
    stream.write(HEAD.pack(len(content)))
    stream.write(content)
    stream.flush()


def receive(stream):
    """Read the next message; raises `EOFError` where the other end has closed, also within a message."""
    size = HEAD.unpack(_exactly(stream, HEAD.size))[0]
    return pickle.loads(_exactly(stream, size))  # nosec B301 - from our own process


def _exactly(stream, count):
    content = stream.read(count)
    if content is None or len(content) < count:
        raise EOFError
    return content
