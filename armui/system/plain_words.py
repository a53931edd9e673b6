"""Finds and speaks the operator's language where Qt may be missing, or takes too long to load."""

from __future__ import annotations

import json
import locale
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final, Literal, get_args
from xml.etree import ElementTree as ET

from armui.system.files import read_file

Language = Literal["zh", "en"]
LANGUAGES: Final[tuple[Language, ...]] = get_args(Language)
_SAY_NOTHING: Final = frozenset({"", "c", "posix"})
"""The locales of a system whose language was never chosen."""

Translate = Callable[[str, str], str]
"""A function that translates a text of a context, as Qt's own does."""


def translation(language: Language, only: str = "") -> Translate:
    """Return a function that translates into a language; reads the file of the translations.

    Args:
        language: The language.
        only: The one context to read, in a tenth of the time; "" for all.
    """
    if language == "en":
        return lambda _context, source: source
    content = read_file(_resources() / "i18n" / "armui_zh.ts")
    if only:
        begin = content.find(b"<context>\n    <name>%s</name>" % only.encode())
        end = content.find(b"</context>", begin)
        content = b"<TS>%s</context></TS>" % content[begin:end] if begin >= 0 else b"<TS/>"
    root = ET.fromstring(content)  # noqa: S314 - our own
    texts = {
        (context.findtext("name"), message.findtext("source")): message.findtext("translation")
        for context in root.iter("context")
        for message in context.iter("message")
    }
    return lambda context, source: texts.get((context, source)) or source


def _resources() -> Path:
    """Return the folder of resources; `armui.system.paths` needs a package that may be missing."""
    package = Path(__file__).resolve().parents[1]
    installed = package / "resources"
    return installed if installed.is_dir() else package.parent / "resources"


def settings_file() -> Path | None:
    """Return the file of settings; ``None`` where the package that knows its place is missing."""
    try:
        from armui.system.paths import settings_file as known  # noqa: PLC0415 - may be missing
    except ImportError:
        return None
    return known()


def language_of_system(
    settings: Path | None = None, interface: Sequence[str] | None = None
) -> Language:
    """Return the language chosen in the program, else the system's: Chinese or English.

    Args:
        settings: The file of the operator's settings; by default only the system is asked.
        interface: The languages of the system's user interface, the preferred one first, where Qt
            knows them; by default the environment is asked.
    """
    if settings is not None:
        try:
            chosen = json.loads(read_file(settings)).get("language")
        except (OSError, ValueError, AttributeError):
            chosen = None
        if chosen == "zh":
            return "zh"
        if chosen == "en":
            return "en"
    names = (os.environ.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    spoken = next((name for name in (*names, *(interface or ())) if name), "")
    return language_named(spoken or (locale.getlocale()[0] or ""))


def language_named(name: str) -> Language:
    """Return the language for a system's locale: Chinese for Chinese and where it says nothing.

    Args:
        name: Its name, as ``zh_CN.UTF-8``, ``en-US``, ``Chinese (Simplified)_China``, ``C``.
    """
    plain = name.partition(".")[0].lower()
    silent = plain in _SAY_NOTHING
    return "zh" if silent or plain.startswith(("zh", "chinese")) else "en"
