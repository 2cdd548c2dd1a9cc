"""Time zones as users write them: +05:45, -3, or Asia/Kathmandu."""

from __future__ import annotations

import re
from datetime import datetime, timedelta, timezone

from ..base.messages import Message
from .track import TrackError

OFFSET = re.compile(r"(?:UTC|GMT)?\s*([+-]?)(\d{1,2})(?::?([0-5]\d))?$", re.IGNORECASE)


def zone_of(text):
    """Read a time zone; None for an empty text.

    Returns
    -------
    datetime.tzinfo or None

    Raises
    ------
    TrackError
        The text names no time zone that is known here.
    """
    text = (text or "").strip()
    if not text:
        return None
    if text.upper() in ("UTC", "GMT", "Z"):
        return timezone.utc
    match = OFFSET.match(text)
    if match and int(match[2]) <= 14:
        minutes = 60 * int(match[2]) + int(match[3] or 0)
        return timezone(timedelta(minutes=-minutes if match[1] == "-" else minutes))
    try:
        from zoneinfo import ZoneInfo

        return ZoneInfo(text)
    except Exception:  # an unknown name, or no list of zones on this computer
        raise TrackError(
            Message("The time zone {text} is not known. Write it as +05:45 or as Asia/Kathmandu.", text=text)
        ) from None


def seconds_utc(taken_at, zone):
    """Convert a camera's local time to seconds since 1970, UTC.

    Parameters
    ----------
    taken_at : datetime
        Without a zone of its own.
    zone : datetime.tzinfo
    """
    return (taken_at.replace(tzinfo=zone) - datetime(1970, 1, 1, tzinfo=timezone.utc)).total_seconds()
