"""An editor open on three points."""

import pytest

from tests.operator.editor.actions import BACK, OUT, UP, Editor, to


@pytest.fixture
def editor(app_driver):
    return Editor(app_driver, to(OUT, note="out"), to(BACK, note="back"), to(UP, note="up"))
