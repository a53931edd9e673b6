"""The layout of every page in every window: ``python -m tests.layout [PLACE …]``.

Shows each panel, page, tab of the drawer and dialog that the program declares, in each size and
language, with and without the drawer, and prints what breaks a rule of `tests.layout_rules`. The
test takes the pairs of these, the command all of them, and 150 % in a process that is so scaled.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Final

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication, QEvent, qInstallMessageHandler
from PySide6.QtWidgets import QApplication, QToolButton, QWidget

from armui.protocol.generation import Generation
from armui.setting_checks import Language
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.shortcut_list import ShortcutList
from armui.ui.dialogs.adapter_line import AdapterLine, KeepDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.gamepad.gamepad_dialog import GamepadDialog
from armui.ui.panels.light_panel import ColorDialog
from armui.ui.panels.parameters.levels_panel import DragAssistanceDialog
from armui.ui.shell import operation_area
from armui.ui.shell.page_entry import Home
from armui.ui.shell.pages import PAGES
from armui.ui.theme import make_application
from armui.ui.trajectory.library.bin_dialog import BinDialog
from armui.ui.trajectory.library.library_exchange import ImportReport
from armui.ui.trajectory.table_import.columns_page import ColumnsPage
from armui.ui.watch.replay.replay_window import ReplayWindow
from armui.viewport.client import PictureClient
from tests.app_driver import AppDriver
from tests.gallery_scenes import dialogs, firmware, library, panels, trajectories
from tests.layout_rules import ACCEPTED, Finding, covering, findings, shown_dialogs

SIZES: Final[Mapping[str, tuple[int, int]]] = {
    "1280x800": (1280, 800),
    "1440x900": (1440, 900),
    "1920x1080": (1920, 1080),
    "150 %": (1280, 720),
}
"""Of the window, in Qt's pixels; the last is 1920×1080 of which each is one and a half."""
_SCALED: Final = "150 %"
_SCALE: Final = 1.5
_SCREEN: Final = {"name": "scaled", "x": 0, "y": 0, "width": 1920, "height": 1080}
"""Of the window that is so scaled, in its own pixels: that of the platform has 800×800."""
LANGUAGES: Final[tuple[Language, ...]] = ("en", "zh")


def _colors(driver: AppDriver) -> object:
    driver.click("menu_light")
    return panels.pick_color(driver)


def _gamepad(driver: AppDriver) -> object:
    driver.window.pages.show("settings")
    driver.dialog(PAGES["settings"].kind()).gamepad_button.click()  # type: ignore[type-var]
    return None


def _kept_adapter(driver: AppDriver) -> object:
    driver.window.pages.show("connect")
    driver.dialog(ConnectDialog).findChild(AdapterLine).choose(("remember", "can0", "1000000"))
    return None


def _guide(driver: AppDriver) -> object:
    driver.window.window_actions.open_guide()
    page = driver.page(PAGES["guide"].kind())  # type: ignore[type-var]
    driver.wait(lambda: page.shown != "")
    return None


_PREPARED: Final[Mapping[str, Callable[[AppDriver], object]]] = {
    "library": trajectories.library,
    "editor": trajectories.editor,
    "recording": trajectories.recording,
    "guide": _guide,
}
"""The declared pages that show something of a subject, and how it comes there."""

MORE: Final[Mapping[str, tuple[type[QWidget], Callable[[AppDriver], object]]]] = {
    "columns": (ColumnsPage, trajectories.columns),
    "palette": (CommandPalette, dialogs.palette),
    "shortcuts": (ShortcutList, dialogs.shortcut_list),
    "question": (ConfirmDialog, dialogs.confirm_disable),
    "bin": (BinDialog, library.bin_),
    "import_report": (ImportReport, library.report),
    "colors": (ColorDialog, _colors),
    "drag_assistance": (DragAssistanceDialog, firmware.drag_assistance),
    "gamepad": (GamepadDialog, _gamepad),
    "kept_adapter": (KeepDialog, _kept_adapter),
}
"""The pages and dialogs that another page opens: that none is missing is a test."""

PANELS: Final = {entry.key: entry.kind for entry in operation_area.PANELS}
"""The class of each panel of the menu, by its key."""
PLACES: Final = (*(f"menu_{key}" for key in PANELS), *PAGES, *MORE)


@dataclass(frozen=True)
class Look:
    """How a place is shown.

    Attributes:
        size: Of the window, by its name in `SIZES`.
        language: Of the program.
        drawer: Whether the drawer is open; its own pages are in windows of their own without it.
    """

    size: str
    language: Language
    drawer: bool

    def __str__(self) -> str:
        """Return it in words."""
        return f"{self.size} {self.language}{' drawer' if self.drawer else ''}"


LOOKS: Final = tuple(
    Look(size, language, drawer)
    for language, size, drawer in product(LANGUAGES, SIZES, (False, True))
)


class _NoPicture(PictureClient):
    """Draws nothing: the picture has its place all the same."""

    def start(self) -> None:
        """Start no process."""


class Shown:
    """The program with a simulated arm that is enabled, and each place of it, one after another.

    Args:
        app: Qt's application.
        folder: For settings and trajectories.
    """

    def __init__(self, app: QApplication, folder: Path) -> None:
        self.driver = AppDriver(
            *(app, f"layout {os.getpid()} {id(self)}", folder / "settings.json", Generation.TWO),
            pictures=_NoPicture(),
        )
        self.driver.repeat_nothing()
        self.driver.program.view.setVisible(True)
        self.driver.ready()

    def close(self) -> None:
        """End the program."""
        self.driver.close()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)

    def faults(self, place: str, look: Look) -> list[Finding]:
        """Show a place, and return what breaks a rule there."""
        driver, window = self.driver, self.driver.window
        if driver.store.settings.language != look.language:
            driver.store.change(language=look.language)
        window.resize(*SIZES[look.size])
        _settle()
        self._show(place, look)
        _settle()
        assert any(map(QWidget.isVisible, window.findChildren(kind_at(place)))), f"no {place}"
        found = findings(window)
        for dialog in shown_dialogs():
            found += findings(dialog)
            if not isinstance(dialog, ReplayWindow):
                found += covering(dialog, window)
        self._leave(place)
        return found

    def _show(self, place: str, look: Look) -> None:
        driver = self.driver
        if place.startswith("menu_"):
            driver.click(place)
        is_tab = place in PAGES and PAGES[place].home is Home.DRAWER
        if look.drawer and not is_tab:
            driver.window.pages.show("events")
        if place in MORE:
            MORE[place][1](driver)
        elif place in PAGES:
            _PREPARED.get(place, lambda it: it.window.pages.show(place))(driver)
        if is_tab and not look.drawer:
            driver.click("drawer_take_out")
        driver.run(0.1)

    def _leave(self, place: str) -> None:
        """Close what was opened, so that the next place is shown as if nothing had been."""
        window = self.driver.window
        for dialog in shown_dialogs():
            put_back = dialog.findChild(QToolButton, "page_put_back")
            if put_back is None:
                dialog.close()
            else:
                put_back.click()
        driver = self.driver
        if driver.find("drawer").isVisible():
            driver.click("drawer_fold")
        for _ in range(3):
            page = window._page_area.current
            if page is not None:
                page.leave()
        for dialog in shown_dialogs():
            dialog.close()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


def kind_at(place: str) -> type[QWidget]:
    """Return the class of what is shown at a place."""
    if place in PAGES:
        return PAGES[place].kind()
    return MORE[place][0] if place in MORE else PANELS[place.removeprefix("menu_")]


def _settle() -> None:
    """Let the layouts be as they will stay."""
    for _ in range(3):
        QCoreApplication.processEvents()


def full(places: list[str], sizes: list[str]) -> Iterator[tuple[str, Look, Finding]]:
    """Yield what breaks a rule, of all the combinations of places and looks."""
    qInstallMessageHandler(lambda *_: None)  # the off-screen platform regrets what it can't do
    app = make_application([])
    with tempfile.TemporaryDirectory() as folder:
        shown = Shown(app, Path(folder))
        try:
            for look in LOOKS:
                if look.size in sizes:
                    for place in places:
                        for each in shown.faults(place, look):
                            yield place, look, each
        finally:
            shown.close()


def _scaled(places: list[str], sizes: list[str], scale: float = 1.0) -> int:
    """Look at some sizes in a process whose pixels are so many of the screen's; its result."""
    command = [sys.executable, "-m", "tests.layout", *places, "--sizes", *sizes]
    environment = {**os.environ, "QT_SCALE_FACTOR": str(scale)}
    with tempfile.TemporaryDirectory() as folder:
        if scale != 1.0:
            screens = Path(folder) / "screens.json"
            screens.write_text(json.dumps({"screens": [_SCREEN]}), encoding="utf-8")
            environment["QT_QPA_PLATFORM"] = f"offscreen:configfile={screens}"
        return subprocess.run(command, check=False, env=environment).returncode


def main() -> int:
    """Print what was found, and how often; returns 1 if there is anything."""
    parser = argparse.ArgumentParser(prog="python -m tests.layout", description=__doc__)
    parser.add_argument("places", nargs="*", metavar="PLACE", help=f"of {', '.join(PLACES)}")
    parser.add_argument("--sizes", nargs="*", choices=SIZES, default=list(SIZES))
    asked = parser.parse_args()
    if _SCALED in asked.sizes and asked.sizes != [_SCALED]:
        others = [each for each in asked.sizes if each != _SCALED]
        return max(_scaled(asked.places, [_SCALED], _SCALE), _scaled(asked.places, others))
    began_s = time.monotonic()
    counted: dict[Finding, list[str]] = {}
    used: Counter[tuple[str, str]] = Counter()
    for place, look, each in full(asked.places or list(PLACES), asked.sizes):
        if each.exception is not None:
            used[each.exception] += 1
        else:
            counted.setdefault(each, []).append(f"{place} {look}")
    for finding, seen in counted.items():
        print(f"{finding}  [{len(seen)}, first {seen[0]}]")
    rules = Counter(each.rule for each in counted)
    print(", ".join(f"{count} {rule}" for rule, count in rules.items()) or "nothing found")
    print(f"{len(ACCEPTED)} accepted: {dict(used)}; {time.monotonic() - began_s:.0f} s")
    return 1 if counted else 0


if __name__ == "__main__":
    raise SystemExit(main())
