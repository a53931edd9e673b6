"""The Linguist files agree with the code, and the language changes while the program runs."""

from __future__ import annotations

import ast
import re
import shutil
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import NamedTuple

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QTranslator
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from armui.session.frames import Damage
from armui.system.files import error_text
from armui.system.sentence import Told
from armui.ui.translation import TranslationMissingError, Translator
from armui.ui.words.text import localized, sentence
from tests.moments import now
from tests.translations import NAMES, TS, lupdate, modules, names

pytestmark = pytest.mark.usefixtures("trees_end_with_the_module")


class Entry(NamedTuple):
    """One string to translate: where it is used, its English, what tells it from others."""

    context: str
    source: str
    comment: str


def entries(ts: Path) -> dict[Entry, ET.Element]:
    found = {}
    for context in ET.parse(ts).iter("context"):
        for message in context.iter("message"):
            key = Entry(
                context.findtext("name", ""),
                message.findtext("source", ""),
                message.findtext("comment", ""),
            )
            translation = message.find("translation")
            assert translation is not None
            found[key] = translation
    return found


@pytest.fixture(scope="module")
def committed() -> dict[Entry, ET.Element]:
    return entries(TS)


# The files ----------------------------------------------------------------------------------------


def test_everything_is_translated(committed: dict[Entry, ET.Element]) -> None:
    for entry, translation in committed.items():
        assert translation.get("type") is None, f"{entry}: {translation.get('type')}"
        assert (translation.text or "").strip(), f"{entry}: empty"


def test_the_file_has_every_string_of_the_code_and_no_other(
    committed: dict[Entry, ET.Element], tmp_path: Path
) -> None:
    fresh = tmp_path / TS.name
    shutil.copy(TS, fresh)
    lupdate(fresh)

    in_code = entries(fresh).keys()
    assert sorted(in_code - committed.keys()) == [], "run: python -m tests.translations"
    assert sorted(committed.keys() - in_code) == [], "run: python -m tests.translations"


def test_the_collector_overlooks_no_call_of_the_code(committed: dict[Entry, ET.Element]) -> None:
    """Qt's own collector passes over a text in brackets of its own, and says nothing of it."""
    sources = {entry.source for entry in committed}
    calls = 0
    for path, tree in modules():
        for node in ast.walk(tree):
            match node:
                case ast.Call(func=ast.Attribute(attr="tr"), args=[ast.Constant(str(text)), *_]):
                    pass
                case ast.Call(
                    func=ast.Attribute(attr="translate"),
                    args=[ast.Constant(str(_)), ast.Constant(str(text)), *_],
                ):
                    pass
                case _:
                    continue
            calls += 1
            assert text in sources, f"{path}: {text}"
    assert calls > 1000


def test_the_names_are_those_of_the_file() -> None:
    assert NAMES.read_text(encoding="utf-8") == names(TS), "run: python -m tests.translations"


def test_the_compiled_file_says_what_the_source_file_says(
    qapp: QApplication, committed: dict[Entry, ET.Element]
) -> None:
    compiled = QTranslator()
    assert compiled.load(str(TS.with_suffix(".qm")))

    for entry, translation in committed.items():
        said = compiled.translate(entry.context, entry.source, entry.comment or None)
        assert said == translation.text, f"{entry}: run: python -m tests.translations"


def test_translations_keep_the_figures_of_their_source(committed: dict[Entry, ET.Element]) -> None:
    figures = re.compile(r"\{\w*\}|%n|%\d")
    for entry, translation in committed.items():
        of_source = sorted(figures.findall(entry.source))
        assert sorted(figures.findall(translation.text or "")) == of_source, entry


ONE_WORD = {
    "重命名": "改名",
    "重放": "回放",
    "所有关节": "全部关节",
    "模拟故障": "仿真故障",
    "最高速度": "最大速度",
}
"""Other words for the same, and the one that is used."""
OF_A_COMMAND = re.compile(r"pip install '[^']+'|(?: [^\w\s])+ ")
"""What is typed, and the signs that a name must not have."""


def test_chinese_has_one_word_for_a_thing_and_one_kind_of_quotes(
    committed: dict[Entry, ET.Element],
) -> None:
    for entry, translation in committed.items():
        text = translation.text or ""
        assert not [word for word in ONE_WORD if word in text], entry
        assert "其它" not in text.replace("其它异常", ""), entry  # the protocol's own word
        plain = OF_A_COMMAND.sub("", text)
        assert not set("\"'「」『』") & set(plain) or not re.search("[一-鿿]", plain), (
            entry,
            plain,
        )


def test_source_strings_are_english(committed: dict[Entry, ET.Element]) -> None:
    for entry in committed:
        assert not re.search(r"[\u4e00-\u9fff]", entry.source), entry


@pytest.mark.parametrize(
    "label",
    [
        *("在线", "离线", "运动控制", "使能", "失能", "急停", "恢复", "回零", "装载", "发送"),
        *("灯光控制", "关节序号", "灯珠序号", "R 通道", "G 通道", "B 通道", "效果", "确认"),
        *("连接机械臂", "连接", "断开", "使用帮助", "视角还原", "设置"),
    ],
)
def test_the_manuals_labels_are_there_to_the_letter(
    committed: dict[Entry, ET.Element], label: str
) -> None:
    assert label in {translation.text for translation in committed.values()}


# While running ------------------------------------------------------------------------------------


class Ear(QObject):
    """Counts how often the widget it watches is told of a new language."""

    def __init__(self) -> None:
        super().__init__()
        self.heard = 0

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        self.heard += event.type() == QEvent.Type.LanguageChange
        return False


def test_the_language_changes_and_changes_back(translator: Translator) -> None:
    assert QCoreApplication.translate("ArmStatus", "Normal") == "Normal"
    translator.set_language("zh")
    assert now(translator.language) == "zh"
    assert QCoreApplication.translate("ArmStatus", "Normal") == "正常"
    translator.set_language("en")
    assert now(translator.language) == "en"
    assert QCoreApplication.translate("ArmStatus", "Normal") == "Normal"


def test_setting_it_twice_and_once_back_leaves_nothing_behind(translator: Translator) -> None:
    translator.set_language("zh")
    translator.set_language("zh")
    translator.set_language("en")

    assert QCoreApplication.translate("ArmStatus", "Normal") == "Normal"


def test_qts_own_words_change_too(translator: Translator) -> None:
    translator.set_language("zh")

    assert QCoreApplication.translate("QPlatformTheme", "Cancel") == "取消"


def test_widgets_are_told(qtbot: QtBot, translator: Translator) -> None:
    widget, ear = QWidget(), Ear()
    qtbot.addWidget(widget)
    widget.show()
    widget.installEventFilter(ear)

    translator.set_language("zh")
    QCoreApplication.processEvents()
    assert ear.heard > 0


def test_a_missing_file_leaves_the_language_as_it_was(qapp: QApplication, tmp_path: Path) -> None:
    translator = Translator(qapp, tmp_path)

    with pytest.raises(TranslationMissingError, match=r"armui_zh\.qm"):
        translator.set_language("zh")
    assert translator.language == "en"


def test_a_sentence_says_a_text_of_the_system_in_its_language(translator):
    missing = error_text(FileNotFoundError(2, "No such file or directory"))
    assert sentence("Refusal", "{text}", {"text": missing}) == "No such file or directory"
    translator.set_language("zh")
    assert sentence("Refusal", "{text}", {"text": missing}) == "文件或文件夹不存在"
    assert localized(Damage(Told("line {line}", line=3), "'x'", 0).text()) == "第 3 行无法读取：'x'"
