"""The words of a page and of the way back to it follow the language wherever the pages stand."""

import pytest
from PySide6.QtCore import QCoreApplication

from armui.control.events import Level
from armui.ui.translation import Translator
from armui.ui.widgets.message_line import MessageLine


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


def test_what_was_done_is_not_told_in_a_language_of_before(pages, translator):
    editor = pages.open_editor()
    message = editor.findChild(MessageLine, "editor_message")
    translator.set_language("zh")
    editor.save()
    assert message.text() == "已保存。"
    translator.set_language("en")
    for _ in range(3):
        QCoreApplication.processEvents()
    assert message.text() == ""
    editor.save()
    assert message.text() == "Saved."


def test_a_message_that_is_said_anew_in_the_other_language_stays(qtbot, translator):
    line = MessageLine()
    qtbot.addWidget(line)
    line.show_message("Done", Level.DONE)
    translator.set_language("zh")
    line.show_message("完成", Level.DONE)  # by its window, which hears of the change first
    QCoreApplication.processEvents()
    assert line.text() == "完成"
    line.show_message("太多", Level.WARNING)
    translator.set_language("en")
    QCoreApplication.processEvents()
    assert line.text() == ""
    translator.set_language("zh")
    line.show_message("故障", Level.FAULT)
    translator.set_language("en")
    QCoreApplication.processEvents()
    assert line.text() == "故障"  # what is wrong is not forgotten
