"""One photo's result as attributes: the fields that orientation adds, and their meaning."""

from __future__ import annotations

from dataclasses import replace

from ...core.base import attributes
from .i18n import in_users_language, marked


def oriented_specs():
    """Fields in their order; the names are a contract."""
    return attributes.oriented_fields(marked)


def oriented_values(oriented, max_distance_m):
    """Attributes of a result in the order of `oriented_specs`, the message in the user's language; None if unknown.

    Parameters
    ----------
    oriented : OrientedPhoto
    max_distance_m : float
        Range that the run used [m].
    """
    values = attributes.oriented_values(in_readers_language(oriented), max_distance_m)
    return [values[spec.name] for spec in oriented_specs()]


def in_readers_language(oriented):
    """The photo with what the core says about it translated."""
    answer = oriented.orientation
    notes = tuple(map(in_users_language, answer.notes))
    return replace(oriented, orientation=replace(answer, message=in_users_language(answer.message), notes=notes))
