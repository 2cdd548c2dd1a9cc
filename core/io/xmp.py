"""Read simple properties from the XMP packet of a picture, in whatever format the picture is."""

from __future__ import annotations

import mmap
import re

BEGIN, END = b"<x:xmpmeta", b"</x:xmpmeta>"
SEARCHED_BYTES = 2**20
"""Number of bytes at either end of the file in which the packet is looked for, and the most that is read of it: longer
packets hold previews and masks of an editing program."""


def xmp_properties(path, prefixes):
    """Give the simple properties of some XMP namespaces, from one look at the file.

    Parameters
    ----------
    path : str
        Picture of any format; the packet is plain text in all of them.
    prefixes : sequence of str
        Usual prefixes of the namespaces, for example "GPano".

    Returns
    -------
    dict
        Text by property name, for each prefix; empty dicts if the file has no such packet.
    """
    text = _packet(path).decode("utf-8", "replace")
    return {prefix: _properties(text, prefix) for prefix in prefixes}


def _properties(text, prefix):
    name = r"\b" + re.escape(prefix) + r":(\w+)"
    found = re.findall(name + r"\s*=\s*[\"']([^\"'<>]*)[\"']", text)
    found += re.findall("<" + name + r"(?:\s[^<>]*)?>([^<>]*)</", text)
    return {key: value.strip() for key, value in found}


def _packet(path):
    try:
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            begin = content.find(BEGIN, 0, SEARCHED_BYTES)
            if begin < 0:
                begin = content.find(BEGIN, max(len(content) - SEARCHED_BYTES, 0))
            if begin < 0:
                return b""
            end = content.find(END, begin, begin + SEARCHED_BYTES)
            return content[begin : end if end >= 0 else begin + SEARCHED_BYTES]
    except (OSError, ValueError):  # an empty file cannot be mapped
        return b""
