"""The shape of the house that no other tool checks: names, sizes, and what calls itself pure."""

from __future__ import annotations

import ast
import re
import tomllib
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LONGEST_FILE = 400


def modules() -> Iterator[tuple[str, Path]]:
    for path in sorted((ROOT / "armui").rglob("*.py")):
        name = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        yield name.removesuffix(".__init__"), path


def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def test_no_two_public_classes_share_a_name():
    places: dict[str, list[str]] = defaultdict(list)
    for name, path in modules():
        for node in tree(path).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places[node.name].append(name)

    assert {name: where for name, where in places.items() if len(where) > 1} == {}


def test_files_stay_short():
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for folder in ("armui", "tests")
        for path in (ROOT / folder).rglob("*.py")
    }

    assert {path: lines for path, lines in lengths.items() if lines > LONGEST_FILE} == {}


def test_what_calls_itself_pure_is_held_to_it():
    house = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = house["tool"]["importlinter"]["contracts"]
    held = {
        module
        for contract in contracts
        if contract["name"].startswith("What calls itself pure")
        for module in contract["source_modules"]
    }
    pure = {
        name
        for name, path in modules()
        if re.search(r"\bpure\b", ast.get_docstring(tree(path)) or "", re.IGNORECASE)
    }

    assert pure == held
