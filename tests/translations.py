"""The Qt Linguist files: ``python -m tests.translations`` brings them up to date with the code.

New strings come in as unfinished (translate them in Qt Linguist or any editor), strings that the
code no longer has go out, and the compiled ``.qm`` is written anew.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TS = ROOT / "resources" / "i18n" / "armui_zh.ts"


def lupdate(ts: Path) -> None:
    """Collect the strings of the code into a .ts file, keeping the translations it has."""
    sources = sorted(str(path) for path in (ROOT / "armui").rglob("*.py"))
    options = ["-locations", "none", "-no-obsolete", "-source-language", "en_US"]
    _run("lupdate", *options, "-target-language", "zh_CN", *sources, "-ts", str(ts))


def lrelease(ts: Path, qm: Path) -> None:
    """Compile a .ts file."""
    _run("lrelease", str(ts), "-qm", str(qm))


def _run(tool: str, *arguments: str) -> None:
    # the tools come with PySide6-Essentials, wherever that is installed
    call = f"from PySide6.scripts.pyside_tool import {tool}; {tool}()"
    subprocess.run([sys.executable, "-c", call, *arguments], check=True, capture_output=True)


def main() -> None:
    """Update and compile."""
    lupdate(TS)
    lrelease(TS, TS.with_suffix(".qm"))
    unfinished = TS.read_text(encoding="utf-8").count('type="unfinished"')
    print(f"{TS.relative_to(ROOT)}: {unfinished} left to translate")


if __name__ == "__main__":
    main()
