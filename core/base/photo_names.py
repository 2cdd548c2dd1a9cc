"""Which photograph a name or path in a table or file means."""

from __future__ import annotations

from collections.abc import Iterable


def photo_key(photo: object) -> str:
    """Give the key by which photographs are matched: the file's name in lower case, without folders."""
    return str(photo).replace("\\", "/").rsplit("/", 1)[-1].lower()


def _stem(photo: object) -> str:
    return photo_key(photo).rsplit(".", 1)[0]


def _folders(photo: object) -> list[str]:
    """Folders of a path in lower case, the innermost first."""
    return [part for part in str(photo).replace("\\", "/").lower().split("/")[-2::-1] if part not in ("", ".")]


def _shared_folders(one: object, other: object) -> int:
    """Count the folders next to the file that two paths have in common."""
    count = 0
    for a, b in zip(_folders(one), _folders(other)):
        if a != b:
            break
        count += 1
    return count


def owners(references: Iterable[str], paths: Iterable[str]) -> dict[str, str | None]:
    """Find the photograph that each reference in a table or file names.

    Names are compared without regard to case, and without their extension if no photo has the same one. Folders count
    only where several photos have the same name, as in the folders of a camera that restarts its numbers.

    Parameters
    ----------
    references : iterable of str
        File names or paths, from any computer.
    paths : iterable of str
        Photographs of the run.

    Returns
    -------
    dict
        Path by reference; None if several photos fit equally. References that fit no photo are absent.
    """
    by_stem: dict[str, list[str]] = {}
    for path in dict.fromkeys(paths):
        by_stem.setdefault(_stem(path), []).append(path)
    found: dict[str, str | None] = {}
    for reference in dict.fromkeys(references):
        fits = [
            ((_shared_folders(reference, path), photo_key(reference) == photo_key(path)), path)
            for path in by_stem.get(_stem(reference), [])
        ]
        if fits:
            best = max(fit for fit, _ in fits)
            winners = [path for fit, path in fits if fit == best]
            found[reference] = winners[0] if len(winners) == 1 else None
    _settle_rivals(found)
    return found


def _settle_rivals(found: dict[str, str | None]) -> None:
    """Drop a reference that names another folder than its photo's if another reference fits that photo better.

    If none fits better, it is not known which of them means the photo.
    """
    claims: dict[str, list[str]] = {}
    for reference, path in found.items():
        if path is not None:
            claims.setdefault(path, []).append(reference)
    for path, claimants in claims.items():
        if len({tuple(_folders(reference)) for reference in claimants}) == 1:
            continue
        here = _folders(path)
        fits = [r for r in claimants if _shared_folders(r, path) == min(len(_folders(r)), len(here))]
        for reference in claimants:
            if not fits:
                found[reference] = None
            elif reference not in fits:
                del found[reference]
