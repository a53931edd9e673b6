"""Why something was refused stands there in whichever language is chosen now."""

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QWidget

from armui.ui.translation import Translator


def test_in_the_library_and_in_the_editor(qapp, pages):
    library = pages.open_library()
    library._run_bar.refused.emit(library._controller.operating_state.cannot_run)
    message = library.findChild(QWidget, "library_message")
    english = message.text()
    translator = Translator(qapp)
    translator.set_language("zh")
    try:
        for _ in range(3):
            QCoreApplication.processEvents()
        assert message.text()
        assert message.text() != english
    finally:
        translator.set_language("en")
    for _ in range(3):
        QCoreApplication.processEvents()
    assert message.text() == english
