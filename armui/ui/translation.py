"""The language of the program, which can change while it runs."""

from __future__ import annotations

from pathlib import Path
from typing import Final, Literal, get_args

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from armui.system import paths

Language = Literal["zh", "en"]
"""The languages the operator can choose."""

LANGUAGES: Final[tuple[Language, ...]] = get_args(Language)
_OWN: Final = "armui"
_QT: Final = "qtbase"
_QT_LOCALES: Final = {"zh": "zh_CN"}


def shown_language() -> Language:
    """Return the present language of the texts."""
    # Translators: the code of the language that is shown, "zh" for Chinese
    return "zh" if QCoreApplication.translate("GuidePage", "en") == "zh" else "en"


class TranslationMissingError(RuntimeError):
    """A translation that belongs to the program cannot be loaded."""


class Translator:
    """Installs the texts of one language and removes those of the last.

    The source strings are English, so English needs no file. Qt's own texts (file chooser, context
    menus of edit fields) come with Qt. Widgets learn of a change by ``QEvent.LanguageChange``.

    Args:
        app: The application.
        folder: The folder of ``armui_zh.qm``.

    Attributes:
        language: The language chosen last.
    """

    def __init__(self, app: QCoreApplication, folder: Path = paths.RESOURCES / "i18n") -> None:
        self._app = app
        self._folder = folder
        self._installed: list[QTranslator] = []
        self.language: Language = "en"

    def set_language(self, language: Language) -> None:
        """Show the program in a language at once.

        Raises:
            TranslationMissingError: The file is missing; the language is unchanged.
        """
        wanted = self._load(language)
        # install the new ones first: otherwise English would appear for a moment
        for translator in wanted:
            self._app.installTranslator(translator)
        for translator in self._installed:
            self._app.removeTranslator(translator)
            translator.deleteLater()
        self._installed = wanted
        self.language = language

    def _load(self, language: Language) -> list[QTranslator]:
        if language == "en":
            return []
        own = QTranslator(self._app)
        if not own.load(f"{_OWN}_{language}", str(self._folder)):
            raise TranslationMissingError(f"no {_OWN}_{language}.qm in {self._folder}")
        qt = QTranslator(self._app)
        folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
        # Qt packaged by a system may lack it: its few texts then stay English
        return [qt, own] if qt.load(QLocale(_QT_LOCALES[language]), _QT, "_", folder) else [own]
