"""What the tests of the event log may use."""

import pytest

from armui.ui.translation import Translator


@pytest.fixture
def translated(qapp):
    """Puts the words into a language; the next test reads English."""
    translator = Translator(qapp)
    yield translator.set_language
    translator.set_language("en")
