"""The Qt Linguist files: ``python -m tests.translations`` brings them up to date with the code.

It also writes ``names.json`` anew: short Chinese texts with their English and their pinyin, for the
search of the command palette. New strings come in as unfinished (translate them in Qt Linguist or
any editor), strings that the code no longer has go out, and the compiled ``.qm`` is written anew.
"""

from __future__ import annotations

import ast
import json
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

from pypinyin import lazy_pinyin

ROOT = Path(__file__).resolve().parent.parent
TS = ROOT / "resources" / "i18n" / "armui_zh.ts"
NAMES = TS.with_name("names.json")
LONGEST = 20
"""Characters of a Chinese text that may be a name; a longer one is a sentence."""


def lupdate(ts: Path) -> None:
    """Collect the strings of the code into a .ts file, keeping the translations it has."""
    sources = sorted((ROOT / "armui").rglob("*.py"))
    options = ["-locations", "none", "-no-obsolete", "-source-language", "en_US"]
    with tempfile.TemporaryDirectory() as folder:
        tables = Path(folder) / "tables.py"
        marks = (mark for path in sources for mark in _marks(path))
        tables.write_text("\n".join(marks), encoding="utf-8")
        of_code = [*map(str, sources), str(tables)]
        _run("lupdate", *options, "-target-language", "zh_CN", *of_code, "-ts", str(ts))


def _marks(source: Path) -> Iterator[str]:
    """The texts of tables like ``Texts("Refusal") | {…}`` in a file, marked as lupdate wants it."""
    for table in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
        match table:
            case ast.BinOp(
                left=ast.Call(func=ast.Name(id="Texts"), args=[ast.Constant(value=str(context))]),
                right=ast.Dict(values=texts),
            ):
                for text in texts:
                    if isinstance(text, ast.Constant):
                        said = json.dumps(text.value, ensure_ascii=False)
                        yield f'QT_TRANSLATE_NOOP("{context}", {said})'


def lrelease(ts: Path, qm: Path) -> None:
    """Compile a .ts file."""
    _run("lrelease", str(ts), "-qm", str(qm))


def names(ts: Path) -> str:
    """The names of a .ts file as JSON: of each Chinese one its pinyin and its English texts."""
    found: dict[str, tuple[str, set[str]]] = {}
    for message in ET.parse(ts).iter("message"):
        english, chinese = (message.findtext(tag) or "" for tag in ("source", "translation"))
        has_hanzi = any("\u4e00" <= letter <= "\u9fff" for letter in chinese)
        if has_hanzi and len(chinese) <= LONGEST and not set("{}\n。") & set(chinese):
            found.setdefault(chinese, (_spelled(chinese), set()))[1].add(english)
    rows = (
        f"{json.dumps(chinese, ensure_ascii=False)}: "
        f"{json.dumps([pinyin, sorted(texts)], ensure_ascii=False)}"
        for chinese, (pinyin, texts) in sorted(found.items())
    )
    return "{\n" + ",\n".join(rows) + "\n}\n"


def _spelled(chinese: str) -> str:
    """Its syllables without tones, with spaces between; what is not Chinese only as far as said."""
    parts = ("".join(filter(str.isalnum, part)).lower() for part in lazy_pinyin(chinese))
    return " ".join(filter(None, parts))


def _run(tool: str, *arguments: str) -> None:
    # the tools come with PySide6-Essentials, wherever that is installed
    call = f"from PySide6.scripts.pyside_tool import {tool}; {tool}()"
    subprocess.run([sys.executable, "-c", call, *arguments], check=True, capture_output=True)


def main() -> None:
    """Update and compile."""
    lupdate(TS)
    lrelease(TS, TS.with_suffix(".qm"))
    NAMES.write_text(names(TS), encoding="utf-8")
    unfinished = TS.read_text(encoding="utf-8").count('type="unfinished"')
    print(f"{TS.relative_to(ROOT)}: {unfinished} left to translate")


if __name__ == "__main__":
    main()
