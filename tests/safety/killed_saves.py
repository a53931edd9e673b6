"""``python -m tests.safety.killed_saves WHAT FOLDER``: kills a save before each call of the system.

One child after another begins the same save and is killed one call later than the one before; each
time what is left is read as by the next start of the program. POSIX only.
"""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path
from types import FrameType
from typing import Any

from armui.cell.cell import Cell
from armui.cell.cell_folder import CellFolder
from armui.cell.tools import Tool
from armui.settings import SettingsStore
from tests.posix import kill, of_system

OF_SYSTEM = {"posix", "_io"}
"""The modules whose functions call the system: they open, write, rename, delete."""
OLD = Cell("bench", (Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0)),), "pen")
NEW = replace(OLD, tool="")


def killed_before(call: int, work: Callable[[], object]) -> None:
    """Do a piece of work, but for the calls of the system from this one on."""
    left = call

    def look(_frame: FrameType, event: str, called: Any) -> None:
        nonlocal left
        if event != "c_call":
            return
        kind = type(getattr(called, "__self__", None)).__module__
        if called.__module__ in OF_SYSTEM or kind in OF_SYSTEM:
            left -= 1
            if left == 0:
                kill(os.getpid())

    sys.setprofile(look)
    try:
        work()
    finally:
        sys.setprofile(None)


@dataclass(frozen=True)
class Save:
    """A save that is killed.

    Attributes:
        prepare: Makes the folder as it is before, and returns the save.
        look: Returns what the next start finds there, as a short text.
    """

    prepare: Callable[[Path], Callable[[], object]]
    look: Callable[[Path], str]


def keep_cell(folder: Path) -> Callable[[], object]:
    """An arm's cell is chosen anew, beside another program's."""
    path = folder / "settings.json"
    SettingsStore(path).change(theme="dark", cells={"a": "old", "b": "theirs"})
    store = SettingsStore(path)
    return lambda: store.keep("cells", {"a": "new"})


def look_at_settings(folder: Path) -> str:
    """Read the settings, and change them once more."""
    store = SettingsStore(folder / "settings.json")
    cells = store.settings.cells
    problem = store.keep("cells", {"c": "later"})
    if store.problems or problem or cells.get("b") != "theirs" or store.settings.theme != "dark":
        return f"lost: {store.problems} {problem} {cells}"
    return cells["a"]


def renew_broken(folder: Path) -> Callable[[], object]:
    """Settings are saved where the file has become no JSON."""
    path = folder / "settings.json"
    store = SettingsStore(path)
    store.change(theme="dark")
    path.write_text("{ was ours", encoding="utf-8")

    def save() -> None:
        store.keep("cells", {"a": "new"})
        store.follow()

    return save


def look_at_renewed(folder: Path) -> str:
    """Find the broken file, wherever it is."""
    texts = [each.read_text(encoding="utf-8") for each in folder.glob("settings.json*")]
    if "{ was ours" not in texts:
        return f"lost: {texts}"
    return "new" if SettingsStore(folder / "settings.json").settings.cells else "old"


def cells_in(folder: Path) -> CellFolder:
    """Return the folder as a program knows it that has read it."""
    cells = CellFolder(folder)
    cells.read()
    return cells


def change_cell(folder: Path) -> Callable[[], object]:
    """A cell is changed."""
    CellFolder(folder).save(OLD)
    cells = cells_in(folder)
    return lambda: cells.save(NEW)


def look_at_cells(folder: Path) -> str:
    """Say which cells there are, and save one."""
    cells = CellFolder(folder)
    found = cells.read()
    names: dict[object, str] = {OLD: "old", NEW: "new", replace(OLD, name="stand"): "stand"}
    told = [names.get(each, f"lost: {each}") for each in found.values()]
    problem = cells.save(replace(OLD, held=""))
    return f"lost: {problem}" if problem else " and ".join(sorted(told))


def rename_cell(folder: Path) -> Callable[[], object]:
    """A cell gets another name."""
    CellFolder(folder).save(OLD)
    cells = cells_in(folder)
    return lambda: cells.rename("bench", replace(OLD, name="stand"))


def delete_cell(folder: Path) -> Callable[[], object]:
    """A cell is deleted."""
    CellFolder(folder).save(OLD)
    cells = cells_in(folder)
    return lambda: cells.delete("bench")


def restore_cell(folder: Path) -> Callable[[], object]:
    """A backup takes the place of a cell that cannot be read."""
    folder.mkdir(exist_ok=True)
    (folder / "bench.armui-cell").write_text("{ was ours", encoding="utf-8")
    cells = cells_in(folder)
    return lambda: cells.save(NEW)


def look_at_restored(folder: Path) -> str:
    """Find the broken file, wherever it is, and what stands in its place."""
    texts = [each.read_text(encoding="utf-8") for each in folder.glob("bench.*")]
    found = CellFolder(folder).read().get("bench")
    if "{ was ours" not in texts:
        return f"lost: {texts}"
    return "new" if found == NEW else "put aside" if found is None else "old"


SAVES = {
    "settings": Save(keep_cell, look_at_settings),
    "broken settings": Save(renew_broken, look_at_renewed),
    "cell": Save(change_cell, look_at_cells),
    "cell's name": Save(rename_cell, look_at_cells),
    "cell's end": Save(delete_cell, look_at_cells),
    "cell's backup": Save(restore_cell, look_at_restored),
}


def main(what: str, place: Path) -> None:
    """Kill one save after another; print what was found after each, as JSON."""
    save, found = SAVES[what], []
    os.fsync = lambda fd: None  # a kill is no power cut: what was written is there
    for call in count(1):
        folder = place / str(call)
        folder.mkdir()
        work = save.prepare(folder)
        child = of_system("fork")()
        if child == 0:
            killed_before(call, work)
            os._exit(0)
        _, status = os.waitpid(child, 0)
        found.append(save.look(folder))
        shutil.rmtree(folder)
        if status == 0:
            break
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
