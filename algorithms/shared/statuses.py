"""Which oriented photographs a later step uses: by default those whose heading is accepted or confirmed."""

from __future__ import annotations

from collections import Counter

from ...core.base.status import RELIABLE, STATUSES, known_status
from ...core.report.facts import status_word
from .i18n import marked, tr
from .parameters import CHOSEN_STATUSES

FIELD = "status"


def relied_on(algorithm, parameters, context, feedback, rows):
    """Rows whose photographs have a chosen status, after a sentence on those that are left out.

    Rows of a layer without a field `status`, and rows in which it holds something else than a status of ours, are all
    kept: nothing is known against a pose that somebody entered by hand.

    Parameters
    ----------
    algorithm, parameters, context, feedback
        As in `processAlgorithm`; the parameter `STATUSES` is read.
    rows : list of PointRow

    Returns
    -------
    list of PointRow
    """
    picked = algorithm.parameterAsEnums(parameters, "STATUSES", context)
    chosen = {CHOSEN_STATUSES[index] for index in picked} or set(RELIABLE)
    statuses = [status_of(row.feature) for row in rows]
    kept = [row for row, status in zip(rows, statuses) if status is None or status in chosen]
    left = Counter(status for status in statuses if status is not None and status not in chosen)
    if left:
        _tell(feedback, left, len(rows), bool(kept))
    return kept


def status_of(feature):
    """Return the status of a photo point, or None if it has none of ours."""
    index = feature.fields().lookupField(FIELD)
    return None if index < 0 else known_status(feature[index])


def status_counts(counts):
    """Write numbers of photographs by status, from best to worst."""
    return ", ".join(f"{counts[status]} {status_word(status, marked)}" for status in STATUSES if counts[status])


def tell_withheld(feedback, statuses, computed):
    """Say how many photographs of a run get no viewshed because of their status, and why.

    Parameters
    ----------
    feedback : QgsProcessingFeedback
    statuses : list of str
        Of all photographs of the run.
    computed : int
        Number of viewsheds.
    """
    left = Counter(status for status in statuses if status not in RELIABLE)
    if not left:
        return
    text = tr("{count} of {total} photos get no viewshed because of their status: {parts}.")
    sentences = [text.format(count=sum(left.values()), total=len(statuses), parts=status_counts(left))]
    if any(status in CHOSEN_STATUSES for status in left):
        sentences.append(
            tr(
                "Their headings are doubtful: check them in the report. To compute their viewsheds all the same, tick "
                '"Viewsheds of doubtful photos too" under Advanced (parameter DOUBTFUL).'
            )
        )
    if computed:
        feedback.pushWarning(" ".join(sentences))
    else:
        feedback.reportError(" ".join(sentences), False)


def _tell(feedback, left, total, some_kept):
    count, parts = sum(left.values()), status_counts(left)
    text = tr("{count} of {total} photos are left out because of their status: {parts}.")
    sentences = [text.format(count=count, total=total, parts=parts)]
    if not some_kept:
        sentences = [tr("No photo is used, so the result is empty. {reason}").format(reason=sentences[0])]
    if any(status in CHOSEN_STATUSES for status in left):
        sentences.append(
            tr(
                "Their headings are doubtful: check them in the report. To use them all the same, tick their statuses "
                'in "Photos by status" under Advanced (parameter STATUSES).'
            )
        )
    if left["failed"]:
        sentences.append(tr("Photos with the status failed have no heading and cannot be used."))
    if some_kept:
        feedback.pushWarning(" ".join(sentences))
    else:
        feedback.reportError(" ".join(sentences), False)
