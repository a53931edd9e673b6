"""Pictures of the whole program: ``python -m tests.gallery DIR [SCENE …]``; needs no display.

Writes a PNG of the main window in every state, of each panel and of each dialog, in both languages
and both themes, the window in two sizes, the workspace also on a screen of 3840×2160 at 200 %. The
program is the real one, the arm the simulated one.
Every scene has a program of its own, which has just opened; its clock stands still, so that two
galleries of the same program are the same pixel by pixel. ``--guide`` makes the pictures of the
user guide of them, and README's films of a run; ``--film`` these alone.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import tempfile
import traceback
from collections.abc import Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtGui import QFontDatabase, QGuiApplication

from tests.gallery_scenes import film, guide
from tests.gallery_scenes.comparison import differences
from tests.gallery_scenes.pictures import Looks, chosen, every_scene, prepare, take
from tests.gallery_scenes.scene import DialogScene, Scene

QUICK = Looks(("zh",), ("light",), ((1280, 800),))
FINE_SCALE = 2
FINE = (
    Looks(("zh",), ("light",), ((1920, 1080),)),
    Looks(("en",), ("dark",), ((1920, 1080),)),
)
"""The workspace on a screen of 3840×2160 at 200 %."""


def _kind(scene: Scene | DialogScene) -> str:
    return "window" if isinstance(scene, Scene) else "dialog"


def _take(place: int, folder: Path, looks: Sequence[Looks]) -> int:
    """Take one scene, in a process of the pool; the scene goes there by its place in the list."""
    return sum(take(every_scene()[place], folder, each) for each in looks)


def _take_all(
    scenes: list[Scene | DialogScene],
    folder: Path,
    looks: Sequence[Looks],
    processes: int,
    scale: int = 1,
) -> list[str]:
    """Take every scene, say how many pictures it gave; returns the names of those that failed."""
    failed = []
    total = 0
    with ProcessPoolExecutor(
        processes, multiprocessing.get_context("spawn"), initializer=prepare, initargs=(scale,)
    ) as pool:
        places = {scene: place for place, scene in enumerate(every_scene())}
        futures: dict[Future[int], Scene | DialogScene] = {
            pool.submit(_take, places[scene], folder, looks): scene for scene in scenes
        }
        for future in as_completed(futures):
            scene = futures[future]
            name = f"{_kind(scene)} {scene.name}"
            error = future.exception()
            if error is None:
                total += future.result()
                print(f"{name}: {future.result()}", flush=True)
            else:
                failed.append(name)
                print(f"{name}: FAILED", *traceback.format_exception(error), sep="\n", flush=True)
    print(f"{total} pictures in {folder}")
    return failed


def _compare(old: Path, new: Path) -> bool:
    """Name what differs; whether nothing does."""
    found = differences(old, new)
    for name, words in found.items():
        print(f"{name}: {words}")
    print(f"{len(found)} pictures differ from {old}")
    return not found


def _make_guide(processes: int) -> int:
    """Take the scenes that the user guide shows, and put them into its folder."""
    _warn_about_fonts()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        failed = _take_all(chosen(guide.scenes()), folder, (guide.LOOKS,), processes)
        if failed:
            return 1
        for path in guide.convert(folder):
            print(f"{path.name}: {path.stat().st_size} bytes")
    return _make_films(processes)


def _make_films(processes: int) -> int:
    """Film the main window for README, in each language; whether one is too large."""
    _warn_about_fonts()
    large = False
    with ProcessPoolExecutor(
        processes, multiprocessing.get_context("spawn"), initializer=prepare
    ) as pool:
        for path in pool.map(film.make, film.LANGUAGES):
            size = path.stat().st_size
            large |= size > film.MOST_BYTES
            print(f"{path.name}: {size} bytes", flush=True)
    return int(large)


def _warn_about_fonts() -> None:
    app = QGuiApplication(sys.argv[:1])
    if not QFontDatabase.families(QFontDatabase.WritingSystem.SimplifiedChinese):
        print(
            "gallery: no font with Chinese characters is installed; on Debian: "
            "apt install fonts-noto-cjk",
            file=sys.stderr,
        )
    app.shutdown()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m tests.gallery", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, metavar="DIR", help="where they go")
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="by name; default: all")
    parser.add_argument("--list", action="store_true", help="say the names of the scenes and end")
    parser.add_argument(
        "--quick", action="store_true", help="one language, one theme, one size of the window"
    )
    parser.add_argument(
        "--compare",
        type=Path,
        metavar="OLD_DIR",
        help="then name the pictures in DIR that differ from those of another gallery",
    )
    parser.add_argument(
        "--guide",
        action="store_true",
        help="make the pictures of the user guide and README's films anew, and end",
    )
    parser.add_argument("--film", action="store_true", help="make README's films anew, and end")
    parser.add_argument(
        "--processes", type=int, default=os.cpu_count() or 1, help="default: one a processor"
    )
    return parser


def main() -> int:
    """Read the command line and take the pictures.

    Returns:
        0; 1 if a scene failed or a picture differs; 2 if the command line makes no sense.
    """
    parser = _parser()
    asked = parser.parse_intermixed_args()
    if asked.list:
        for scene in every_scene():
            print(f"{_kind(scene)} {scene.name}")
        return 0
    if asked.guide:
        return _make_guide(asked.processes)
    if asked.film:
        return _make_films(asked.processes)
    if asked.folder is None:
        parser.error("name a folder for the pictures, or ask for --list")
    try:
        scenes = chosen(asked.scenes)
    except ValueError as error:
        parser.error(str(error))
    folder = asked.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    _warn_about_fonts()
    looks = QUICK if asked.quick else Looks()
    failed = _take_all(scenes, folder, (looks,), asked.processes)
    fine: list[Scene | DialogScene] = [
        each for each in scenes if isinstance(each, Scene) and each.fine
    ]
    if fine and not asked.quick:
        failed += _take_all(fine, folder, FINE, asked.processes, FINE_SCALE)
    for name in failed:
        print(f"failed: {name}", file=sys.stderr)
    same = asked.compare is None or _compare(asked.compare, folder)
    return 0 if same and not failed else 1


if __name__ == "__main__":
    raise SystemExit(main())
