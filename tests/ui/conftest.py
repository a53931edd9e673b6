"""A controller without an arm for every panel, bar and dialog."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication

from armui.ui.theme import Theme, apply_theme
from armui.ui.translation import Translator
from tests.ui.fake_controller import FakeController


@pytest.fixture
def controller(qapp: QApplication) -> Iterator[FakeController]:
    apply_theme(qapp, Theme.LIGHT)
    fake = FakeController()
    yield fake
    fake.deleteLater()


@pytest.fixture
def translator(qapp: QApplication) -> Iterator[Translator]:
    translator = Translator(qapp)
    yield translator
    translator.set_language("en")
