"""QGIS with Processing and our provider, and a feedback that remembers."""

from __future__ import annotations

import pytest
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsProject


@pytest.fixture
def algorithm(provider):
    """Give an algorithm of ours by its id."""

    def find(name):
        found = QgsApplication.processingRegistry().algorithmById(f"skylineviewshed:{name}")
        assert found is not None, f"{name} is not in the registry"
        return found.create()

    return find


class Listener(QgsProcessingFeedback):
    """Feedback that remembers what it was told, and may cancel at a given progress."""

    def __init__(self, cancel_at=None):
        super().__init__(False)
        self.infos, self.warnings, self.errors, self.texts, self.fractions = [], [], [], [], []
        self.details = []
        self.cancel_at = cancel_at
        self.progressChanged.connect(self._moved)

    def _moved(self, percent):
        self.fractions.append(percent)
        if self.cancel_at is not None and percent >= self.cancel_at:
            self.cancel()

    def pushInfo(self, info):
        self.infos.append(info)

    def pushDebugInfo(self, info):
        self.details.append(info)

    def pushWarning(self, warning):
        self.warnings.append(warning)

    def reportError(self, error, fatalError=False):
        self.errors.append(error)

    def setProgressText(self, text):
        self.texts.append(text)


@pytest.fixture
def listener():
    """Make a fresh listener."""
    return Listener


@pytest.fixture
def run(provider):
    """Run an algorithm of ours in process: (results, feedback); layers stay alive in the context."""
    import processing

    def call(name, parameters, feedback=None, context=None):
        feedback = feedback or Listener()
        context = context or QgsProcessingContext()
        context.setProject(QgsProject.instance())
        results = processing.run(
            f"skylineviewshed:{name}", parameters, feedback=feedback, context=context, is_child_algorithm=False
        )
        return results, feedback

    return call


@pytest.fixture
def refusal(algorithm):
    """Message with which `checkParameterValues` refuses parameters, or '' where it accepts them."""

    def ask(name, parameters):
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        passed, message = algorithm(name).checkParameterValues(parameters, context)
        return "" if passed else message

    return ask
