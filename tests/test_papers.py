"""What the papers name is there: links, files, rooms, commands; and README stays short."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image, ImageChops, ImageSequence

from armui import __version__
from tests.gallery_scenes import film

ROOT = Path(__file__).resolve().parents[1]
PAPERS = [
    ROOT / "README.md",
    ROOT / "README.zh.md",
    ROOT / "CHANGELOG.md",
    *sorted((ROOT / "resources" / "docs").rglob("*.md")),
    *sorted((ROOT / "resources" / "clients").rglob("*.md")),
    *sorted((ROOT / ".github").rglob("*.md")),
]
NAMES = [str(paper.relative_to(ROOT)) for paper in PAPERS]
MOST_WORDS = {"README.md": 599, "README.zh.md": 1100}
"""Of each language; a Chinese sign counts as one."""

LINK = re.compile(r"\]\(([^)\s]+)\)")
ELSEWHERE = re.compile(r"[a-z]+:")
PATH = re.compile(r"(?<![\w/.-])(?:armui|resources|tests|urdf|\.github|\.ci)/[\w/.*-]*[\w/*]")
ROOMS = sorted((ROOT / "resources" / "docs" / "design").glob("*.md"))
"""The pages behind the map of the design."""
QUOTED = re.compile(r"`([^`\n]+)`")
A_CLASS = re.compile(r"_?[A-Z]\w*[a-z]\w*(\.\w+)?")
A_NAME = re.compile(r"[a-z]+(_[a-z]+)+|[A-Z]+(_[A-Z]+)+")
OF_QT = re.compile(r"Q[A-Z]")
MODULE = re.compile(r"python -m ((?:tests|armui)[\w.]*)")


def anchors(paper: Path) -> set[str]:
    """The headings of a paper as links name them."""
    heads = re.findall(r"^#+ (.+)$", paper.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


@pytest.mark.parametrize("paper", PAPERS, ids=NAMES)
def test_every_relative_link_leads_somewhere(paper: Path) -> None:
    links = [
        link
        for link in LINK.findall(paper.read_text(encoding="utf-8"))
        if not ELSEWHERE.match(link)
    ]
    broken = []
    for link in links:
        name, _, anchor = link.partition("#")
        target = (paper.parent / name) if name else paper
        if not target.exists() or (anchor and anchor not in anchors(target)):
            broken.append(link)
    assert broken == []


@pytest.mark.parametrize("paper", PAPERS, ids=NAMES)
def test_every_path_named_is_there(paper: Path) -> None:
    named = set(PATH.findall(paper.read_text(encoding="utf-8")))
    assert {path for path in named if not any(ROOT.glob(path.rstrip("/")))} == set()


@pytest.mark.parametrize("paper", PAPERS, ids=NAMES)
def test_every_module_to_run_is_there(paper: Path) -> None:
    modules = set(MODULE.findall(paper.read_text(encoding="utf-8")))
    places = {module: ROOT.joinpath(*module.split(".")) for module in modules}
    gone = {
        module
        for module, place in places.items()
        if not place.with_suffix(".py").exists() and not (place / "__main__.py").exists()
    }
    assert gone == set()


@pytest.mark.parametrize("name", MOST_WORDS)
def test_readme_can_be_read_in_one_go(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    assert len(re.findall(r"[\u4e00-\u9fff]|[^\s\u4e00-\u9fff]+", text)) <= MOST_WORDS[name]


def test_readme_is_the_same_in_both_languages() -> None:
    """Each leads to the other, has the same sections, commands and links, and a film of its own."""
    own, other = ((ROOT / name).read_text(encoding="utf-8") for name in MOST_WORDS)
    assert "(README.zh.md)" in own
    assert "(README.md)" in other
    assert re.findall(r"^#+", own, re.MULTILINE) == re.findall(r"^#+", other, re.MULTILINE)
    assert own.split("```")[1::2] == other.split("```")[1::2]
    films = {"resources/pictures/window-en.webp", "resources/pictures/window-zh.webp"}
    readmes = set(MOST_WORDS)
    assert set(LINK.findall(own)) - films - readmes == set(LINK.findall(other)) - films - readmes


def test_readme_s_films_move_in_few_bytes() -> None:
    """There is no other picture; `python -m tests.gallery --film` makes them."""
    names = [f"window-{language}.webp" for language in film.LANGUAGES]
    assert sorted(path.name for path in film.FOLDER.iterdir()) == sorted(names)
    for readme, language in (("README.md", "en"), ("README.zh.md", "zh")):
        path = film.FOLDER / f"window-{language}.webp"
        assert f"({path.relative_to(ROOT)})" in (ROOT / readme).read_text(encoding="utf-8")
        assert path.stat().st_size <= film.MOST_BYTES
        with Image.open(path) as picture:
            frames = list(ImageSequence.all_frames(picture))
            seconds = sum(each.info["duration"] for each in frames) / 1e3
        assert 4.0 <= seconds <= 6.0
        moved = [
            ImageChops.difference(*(each.convert("L") for each in pair)).getbbox()
            for pair in pairwise(frames)
        ]
        assert all(moved)


def test_the_last_version_of_the_changes_is_the_program_s() -> None:
    """«Unreleased» stands above the versions; one of development is said to be after the newest."""
    heads = re.findall(r"^## (.+)$", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE)
    assert heads[0] == "Unreleased"
    versions = [re.fullmatch(r"(\d+\.\d+\.\d+) – \d{4}-\d\d-\d\d", head) for head in heads[1:]]
    assert [head for head, found in zip(heads[1:], versions, strict=True) if not found] == []
    assert versions[0] is not None
    if ".dev" in __version__:
        assert _number(__version__.partition(".dev")[0]) > _number(versions[0][1])
    else:
        assert versions[0][1] == __version__


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def test_every_room_has_its_line_in_the_design() -> None:
    design = (ROOT / "resources" / "docs" / "design.md").read_text(encoding="utf-8")
    plan = design.split("```")[1]
    rooms = {path.parent.name for path in (ROOT / "armui").glob("*/__init__.py")}
    assert {room for room in rooms if f" {room}/" not in plan} == set()
    assert {page.name for page in ROOMS if f"(design/{page.name})" not in design} == set()


@pytest.mark.parametrize(
    "page",
    [page for page in ROOMS if (ROOT / "armui" / page.stem).is_dir()],
    ids=lambda page: page.stem,
)
def test_every_folder_of_a_room_is_named_in_its_page(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    folders = {path.parent.name for path in (ROOT / "armui" / page.stem).glob("*/__init__.py")}
    assert {folder for folder in folders if f"`{folder}/`" not in text} - {"process"} == set()


def test_every_room_has_its_page() -> None:
    rooms = {path.parent.name for path in (ROOT / "armui").glob("*/__init__.py")}
    together = {"decode", "doctor", "export", "record"}  # commands.md
    assert rooms - together <= {page.stem for page in ROOMS}


@cache
def names_of_the_program() -> frozenset[str]:
    """Classes, functions, attributes and constants."""
    names: set[str] = set()
    for path in (ROOT / "armui").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef | ast.FunctionDef):
                names.add(node.name)
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                names.add(node.id)
            elif isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
                names.add(node.attr)
    return frozenset(names)


@pytest.mark.parametrize(
    "page", [ROOT / "resources" / "docs" / "design.md", *ROOMS], ids=lambda page: page.stem
)
def test_every_module_and_name_in_the_design_is_there(page: Path) -> None:
    """A module is named from the top, from `armui/`, or from the room that the page is about."""
    room = ROOT / "armui" / page.stem
    gone = []
    for quoted in QUOTED.findall(page.read_text(encoding="utf-8")):
        if quoted.endswith((".py", "/")):
            places = [ROOT / quoted, ROOT / "armui" / quoted, room / quoted]
            found = any(each.exists() for each in places) or any(room.rglob(quoted.rstrip("/")))
        elif A_CLASS.fullmatch(quoted) and not OF_QT.match(quoted):
            found = set(quoted.split(".")) <= names_of_the_program()
        elif A_NAME.fullmatch(quoted):
            found = quoted in names_of_the_program()
        else:
            continue
        if not found:
            gone.append(quoted)
    assert gone == []


def test_every_room_says_what_it_is_for() -> None:
    silent = [
        str(path.relative_to(ROOT))
        for path in (ROOT / "armui").rglob("__init__.py")
        if not path.read_text(encoding="utf-8").startswith('"""')
    ]
    assert silent == []


def test_ci_runs_the_command_that_readme_tells() -> None:
    """`.ci/run` takes the line of README that runs the check; the workflow runs `.ci/run`."""
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    assert "bash resources/run check" in lines
    assert "grep -m 1 'run check$' README.md" in (ROOT / ".ci" / "run").read_text("utf-8")
    assert "-m tests.check" in (ROOT / "resources" / "run").read_text(encoding="utf-8")
    workflow = (ROOT / ".github" / "workflows" / "check.yml").read_text(encoding="utf-8")
    assert "bash .ci/run" in workflow
    for version in ("3.11", "3.12", "3.13"):
        assert f'"{version}"' in workflow


@pytest.mark.parametrize("command", ["", "decode", "doctor", "export", "record", "replay", "sim"])
def test_the_options_of_every_command_are_listed(command: str) -> None:
    asked = subprocess.run(
        [sys.executable, "-m", "armui", *command.split(), "--help"],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT), "COLUMNS": "200"},
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=True,
    )
    there = set(re.findall(r"^  (--[a-z]+[a-z-]*)", asked.stdout, re.MULTILINE))
    table = (ROOT / "resources" / "docs" / "commands.md").read_text(encoding="utf-8")
    start = f"| `armui {command}".rstrip()
    rows = [line for line in table.splitlines() if line.startswith(start)]
    if not command:
        rows = [row for row in rows if re.match(r"\| `armui(?: -|`)", row)]
    listed = set(re.findall(r"--[a-z]+[a-z-]*", " ".join(row.split(" | ")[0] for row in rows)))
    assert listed == there
