"""The words of a page and of the way back to it follow the language wherever the pages stand."""

import pytest
from PySide6.QtCore import QCoreApplication

from armui.ui.translation import Translator


@pytest.fixture
def translator(qapp):
    translator = Translator(qapp)
    yield translator
    translator.set_language("en")


@pytest.mark.parametrize("taken_out", [False, True])
def test_the_way_back_is_called_as_the_page_it_leads_to(pages, translator, taken_out):
    if taken_out:
        pages.open_library()
        pages.take_out()
    pages.open_editor()
    for language, path in (
        ("zh", "轨迹库 › one"),
        ("en", "Trajectory library › one"),
        ("zh", "轨迹库 › one"),
    ):
        translator.set_language(language)
        for _ in range(3):
            QCoreApplication.processEvents()
        assert pages.path() == path
        assert path.split(" › ", maxsplit=1)[0] in pages.driver.find("page_back").toolTip()
