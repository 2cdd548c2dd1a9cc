"""No parameter without a tooltip: a newcomer reads nothing else."""

from __future__ import annotations

import re


def definitions(provider):
    """(algorithm, parameter) of all algorithms and models."""
    for algorithm in provider.algorithms():
        instance = algorithm.create()
        for definition in instance.parameterDefinitions():
            yield instance, definition


def test_every_parameter_of_every_algorithm_and_model_is_explained(provider):
    seen = [(it.name(), definition.name(), definition.help()) for it, definition in definitions(provider)]
    assert len(seen) > 200
    assert [(name, parameter) for name, parameter, text in seen if not text.endswith(".")] == []


def bare(words):
    return re.sub(r"\W+", " ", words.lower()).strip()


def test_tooltips_say_more_than_the_label(provider):
    assert [
        (it.name(), definition.name())
        for it, definition in definitions(provider)
        if bare(definition.help()) == bare(definition.description())
    ] == []
