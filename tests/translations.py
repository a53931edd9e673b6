"""The Qt Linguist files: ``python -m tests.translations`` brings them up to date with the code.

It also writes ``names.json`` anew: short Chinese texts with their English and their pinyin, for the
search of the command palette; and ``sentences.json``: the sentence of each reason and each event by
its id, as recordings and event files keep it. Ids that the code no longer has stay in it: older
files hold them. New strings come in as unfinished (translate them in Qt Linguist or any editor),
strings that the code no longer has go out, and the compiled ``.qm`` is written anew.

``python -m tests.translations columns`` writes every text of the program as two columns, Chinese
and English, to be read in one go.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Final, NamedTuple
from unittest.mock import patch

from armui import cli
from armui.arm.refusal import Reason
from armui.control.event_log.observed import Observed
from armui.control.events import Notice
from armui.control.safety.recovery_steps import ActionText, StepText
from armui.doctor.facts import OfArm, OfCan, OfProgram, OfScreen
from armui.doctor.report import ReportText
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.setting_fields import DECLARED
from armui.system import command_line
from armui.system.sentence import Sentence
from armui.trajectory.planning.findings import FindingKind
from armui.ui.words.frames import signal_word

ROOT = Path(__file__).resolve().parent.parent
TS = ROOT / "resources" / "i18n" / "armui_zh.ts"
NAMES = TS.with_name("names.json")
SENTENCES = TS.with_name("sentences.json")
LONGEST = 20
"""Characters of a Chinese text that may be a name; a longer one is a sentence."""


KINDS: Final[tuple[type[Sentence], ...]] = (
    *(Reason, FindingKind, ReportText, StepText, ActionText),
    *(OfProgram, OfScreen, OfCan, OfArm),
    *(Notice, Observed),
)
"""What says sentences: the classes whose constants stand beside what raises them."""
KEPT: Final[tuple[type[Sentence], ...]] = (Reason, Notice, Observed)
"""Those whose ids files keep."""


class Constant(NamedTuple):
    """A ``NAME = Reason("name", "sentence", …)`` of the code, or of another of `KINDS`.

    Attributes:
        path: The file.
        owner: The enumeration it is a member of; "" for a constant of the module.
        name: What it is called there.
        context: Of the translation.
        id: As files keep it.
        source: The sentence.
        more: Further texts of it.
    """

    path: Path
    owner: str
    name: str
    context: str
    id: str
    source: str
    more: tuple[str, ...]


@cache
def modules() -> tuple[tuple[Path, ast.Module], ...]:
    """Every file of the program, and what it says."""
    paths = sorted((ROOT / "armui").rglob("*.py"))
    return tuple((path, ast.parse(path.read_text(encoding="utf-8"))) for path in paths)


@cache
def constants() -> tuple[Constant, ...]:
    """Every sentence that stands beside what raises it."""
    contexts = {kind.__name__: kind.context for kind in KINDS}
    found = []
    for path, tree in modules():
        enums = [(each.name, each.body) for each in tree.body if isinstance(each, ast.ClassDef)]
        for owner, body in [("", tree.body), *enums]:
            for node in body:
                match node:
                    case ast.Assign(
                        targets=[ast.Name(id=name)],
                        value=ast.Call(func=ast.Name(id=kind), args=[_, _, *_] as given),
                    ) if kind in contexts:
                        said = [each.value for each in given if isinstance(each, ast.Constant)]
                        code, source, *more = (str(each) for each in said if each)
                        of = contexts[kind]
                        found.append(Constant(path, owner, name, of, code, source, tuple(more)))
    return tuple(found)


def sentences(kept: str) -> str:
    """Those of `KEPT` by context and id as JSON, with those of before that the code has no more."""
    rows: dict[str, dict[str, str]] = json.loads(kept)
    for context in (kind.context for kind in KEPT):
        said = {each.id: each.source for each in constants() if each.context == context}
        rows[context] = rows.get(context, {}) | said
    return json.dumps(rows, ensure_ascii=False, indent=0, sort_keys=True) + "\n"


def lupdate(ts: Path) -> None:
    """Collect the strings of the code into a .ts file, keeping the translations it has."""
    options = ["-locations", "none", "-no-obsolete", "-source-language", "en_US"]
    options += ["-tr-function-alias", "QT_TRANSLATE_NOOP+=Text"]
    with tempfile.TemporaryDirectory() as folder:
        tables = Path(folder) / "tables.py"
        trees = [tree for _, tree in modules()]
        of_trees = (text for tree in trees for of in (_of_tables, _of_acts) for text in of(tree))
        texts = [*_of_value_tables(), *_of_settings(), *of_trees]
        for each in constants():
            texts += [(each.context, text) for text in (each.source, *each.more)]
        texts += [(command_line.CONTEXT, text) for text in command_texts()]
        for context, kept in json.loads(SENTENCES.read_text("utf-8")).items():
            texts += [(context, text) for text in kept.values()]
        tables.write_text("\n".join(map(_marked, texts)), encoding="utf-8")
        of_code = [*(str(path) for path, _ in modules()), str(tables)]
        _run("lupdate", *options, "-target-language", "zh_CN", *of_code, "-ts", str(ts))


def command_texts() -> list[str]:
    """Every text of the command line: what helps ask for, and what is said of a wrong one."""
    asked = dict.fromkeys((*command_line.OF_ARGPARSE, *command_line.OF_SYSTEM))

    def note(text: str) -> str:
        if any(map(str.isalpha, text)):
            asked[text] = None
        return text

    parsers = cli.parsers()  # before: what they import takes `say` with it
    with patch.object(command_line, "say", note):
        for parser in parsers:
            parser.format_help()
    for _, tree in modules():
        for node in ast.walk(tree):
            match node:
                case ast.Call(
                    func=ast.Attribute(value=ast.Name(id="parser"), attr="error"),
                    args=[ast.Constant(value=str(text))],
                ):
                    asked[text] = None
                case ast.Call(
                    func=ast.Name(id="say" | "Told"), args=[ast.Constant(value=str(text))]
                ):
                    note(text)
    return list(asked)


def _of_tables(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Context and text of the tables like ``Texts("Refusal") | {…}`` and operations of a file."""
    for table in ast.walk(tree):
        match table:
            case ast.BinOp(
                left=ast.Call(func=ast.Name(id="Texts"), args=[ast.Constant(value=str(context))]),
                right=ast.Dict(values=texts),
            ):
                for text in texts:
                    if isinstance(text, ast.Constant):
                        yield context, str(text.value)
            case ast.Call(
                func=ast.Name(id="operation" | "declare"),
                args=[ast.Constant(), ast.Constant(value=str(title)), *_],
            ):
                yield "Operation", title


def _of_acts(tree: ast.Module) -> Iterator[tuple[str, str]]:
    """Context and text of the acts and columns that the classes of a file declare."""
    for declared in (each for each in ast.walk(tree) if isinstance(each, ast.ClassDef)):
        for call in ast.walk(declared):
            match call:
                case ast.Call(
                    func=ast.Name(id="Act" | "ViewColumn" | "_Column"), args=args, keywords=more
                ):
                    tips = [each.value for each in more if each.arg == "tip"]
                    for said in (*args[:1], *tips):
                        if isinstance(said, ast.Constant) and said.value:
                            yield declared.name, str(said.value)


def _of_value_tables() -> list[tuple[str, str]]:
    """The same of the words in the DBC files that have no other name, as J1 or a message has."""
    messages = (each for generation in Generation for each in load_database(generation).messages)
    signals = (signal for message in messages for signal in message.signals)
    words = {str(word) for signal in signals for word in (signal.choices or {}).values()}
    return [("SignalWord", word) for word in sorted(words) if signal_word(word) == word]


def _of_settings() -> list[tuple[str, str]]:
    """The same of the settings."""
    said = (text for each in DECLARED.values() for text in (each.label, each.tip))
    return [("Setting", text) for text in said if text]


def _marked(text: tuple[str, str]) -> str:
    """It as lupdate finds it."""
    context, said = text
    return f'QT_TRANSLATE_NOOP("{context}", {json.dumps(said, ensure_ascii=False)})'


def lrelease(ts: Path, qm: Path) -> None:
    """Compile a .ts file."""
    _run("lrelease", str(ts), "-qm", str(qm))


def names(ts: Path) -> str:
    """The names of a .ts file as JSON: of each Chinese one its pinyin and its English texts.

    The synonyms of the command palette are among them, without an English text.
    """
    found: dict[str, tuple[str, set[str]]] = {}
    contexts = ET.parse(ts).iter("context")
    shown = (each for each in contexts if each.findtext("name") != command_line.CONTEXT)
    for message in (message for each in shown for message in each.iter("message")):
        english, chinese = (message.findtext(tag) or "" for tag in ("source", "translation"))
        has_hanzi = any("\u4e00" <= letter <= "\u9fff" for letter in chinese)
        if has_hanzi and len(chinese) <= LONGEST and not set("{}\n。") & set(chinese):
            found.setdefault(chinese, (_spelled(chinese), set()))[1].add(english)
    for word in _synonyms():
        found.setdefault(word, (_spelled(word), set()))
    rows = (
        f"{json.dumps(chinese, ensure_ascii=False)}: "
        f"{json.dumps([pinyin, sorted(texts)], ensure_ascii=False)}"
        for chinese, (pinyin, texts) in sorted(found.items())
    )
    return "{\n" + ",\n".join(rows) + "\n}\n"


def _synonyms() -> Iterator[str]:
    """Yield the Chinese synonyms of the commands: what stands in ``also(…)``."""
    for _, tree in modules():
        for each in ast.walk(tree):
            match each:
                case ast.Call(func=ast.Name(id="also"), args=[ast.Constant(value=str(text))]):
                    yield from (word for word in text.split() if not word.isascii())


def _spelled(chinese: str) -> str:
    """Its syllables without tones, with spaces between; what is not Chinese only as far as said."""
    from pypinyin import lazy_pinyin  # noqa: PLC0415 - its tables cost every collection of tests

    parts = ("".join(filter(str.isalnum, part)).lower() for part in lazy_pinyin(chinese))
    return " ".join(filter(None, parts))


def _run(tool: str, *arguments: str) -> None:
    # the tools come with PySide6-Essentials, wherever that is installed
    call = f"from PySide6.scripts.pyside_tool import {tool}; {tool}()"
    subprocess.run([sys.executable, "-c", call, *arguments], check=True, capture_output=True)


def columns(ts: Path) -> Iterator[str]:
    """Every text of a .ts file, a line each: its context, the Chinese and the English."""
    for context in ET.parse(ts).iter("context"):
        for message in context.iter("message"):
            texts = (context.findtext("name"), message.findtext("translation"))
            line = "\t".join(text or "" for text in (*texts, message.findtext("source")))
            yield line.replace("\n", "⏎")


def main(arguments: Sequence[str]) -> None:
    """Update and compile, or write the columns."""
    if arguments == ["columns"]:
        print("\n".join(columns(TS)))
        return
    SENTENCES.write_text(sentences(SENTENCES.read_text(encoding="utf-8")), encoding="utf-8")
    lupdate(TS)
    lrelease(TS, TS.with_suffix(".qm"))
    NAMES.write_text(names(TS), encoding="utf-8")
    unfinished = TS.read_text(encoding="utf-8").count('type="unfinished"')
    print(f"{TS.relative_to(ROOT)}: {unfinished} left to translate")


if __name__ == "__main__":
    main(sys.argv[1:])
