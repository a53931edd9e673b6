"""S1 on a real X server: Xvfb, and a mouse and keyboard that are the server's own (xdotool)."""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
GIVE_UP_S = 60
MISSING = [name for name in ("Xvfb", "xdotool") if shutil.which(name) is None]
SCREEN = "1400x1000x24"

pytestmark = [
    pytest.mark.timeout(300),
    pytest.mark.skipif(
        bool(MISSING) and not os.environ.get("CI"),
        reason=f"not installed: {', '.join(MISSING)} (Debian packages xvfb, xdotool)",
    ),
]


class Screen:
    """An X server with the program on it, and a hand at its mouse and keyboard."""

    def __init__(self) -> None:
        reading, writing = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", SCREEN, "-nolisten", "tcp"],
            pass_fds=[writing],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(writing)
        with os.fdopen(reading) as pipe:
            display = f":{pipe.readline().strip()}"
        self._environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "PYTHONPATH": str(ROOT),
        }
        self._program = subprocess.Popen(
            [sys.executable, "-m", "tests.safety.x_operator"],
            cwd=ROOT,
            env=self._environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self._read() == "ready"

    def ask(self, *words):
        """Have the program do something; its answer."""
        self._program.stdin.write(" ".join(words) + "\n")
        self._program.stdin.flush()
        return self._read()

    def _read(self):
        line = self._program.stdout.readline()
        assert line, "the program has ended"
        return json.loads(line)

    def hand(self, *words) -> None:
        """Move the mouse, press buttons and keys: xdotool's words."""
        subprocess.run(
            ["xdotool", *map(str, words)], env=self._environment, check=True, timeout=GIVE_UP_S
        )

    def point_at(self, place) -> None:
        self.hand("mousemove", *place)

    def click(self, place, button=1) -> None:
        self.point_at(place)
        self.hand("click", button)

    def until(self, **wanted):
        """Wait until the program's counts are these."""
        end_s = time.monotonic() + GIVE_UP_S
        while True:
            counts = self.ask("counts")
            if all(counts[name] == value for name, value in wanted.items()):
                return
            assert time.monotonic() < end_s, f"{wanted} never came: {counts}"

    def open_popup(self, place, button=1) -> None:
        """Click until a popup is open: the second of two quick clicks may be a double click."""
        end_s = time.monotonic() + GIVE_UP_S
        while self.ask("counts")["popup"] is None:
            assert time.monotonic() < end_s, "no popup came"
            self.click(place, button)
            look_s = time.monotonic() + 1.0
            while self.ask("counts")["popup"] is None and time.monotonic() < look_s:
                pass

    def close(self) -> None:
        self._program.stdin.close()
        try:
            self._program.wait(GIVE_UP_S)
        finally:
            self._program.kill()
            self._program.stdout.close()
            self._server.terminate()
            self._server.wait(GIVE_UP_S)


@pytest.fixture(scope="module")
def server():
    assert not MISSING, f"CI must have them: {MISSING}"
    screen = Screen()
    yield screen
    screen.close()


@pytest.fixture
def screen(server):
    server.ask("close_all")
    yield server
    server.hand("mouseup", 1)
    server.ask("close_all")


def combo_box(screen):
    screen.open_popup(screen.ask("combo_box"))


def context_menu(screen):
    screen.open_popup(screen.ask("text_field"), button=3)


def menu_of_the_file_dialog(screen):
    """Qt's own file dialog, its list of endings open."""
    screen.open_popup(screen.ask("file_dialog"))


def tool_tip(screen):
    assert screen.ask("tool_tip")


def file_dialog(screen):
    screen.ask("file_dialog")


def text_being_edited(screen):
    screen.click(screen.ask("text_field"))
    screen.hand("type", "7")


OPEN = [
    combo_box,
    context_menu,
    menu_of_the_file_dialog,
    tool_tip,
    file_dialog,
    text_being_edited,
]


@pytest.mark.parametrize("open_it", OPEN, ids=lambda each: each.__name__)
@pytest.mark.parametrize(("name", "counted"), [("stop_button", "stops"), ("halt_button", "halts")])
def test_the_first_press_acts_before_it_is_let_go(screen, open_it, name, counted):
    open_it(screen)
    screen.point_at(screen.ask("place", name))
    screen.hand("mousedown", 1)
    screen.until(**{counted: 1})
    screen.hand("mouseup", 1)
    assert screen.ask("counts") == {"stops": 0, "halts": 0, "popup": None, counted: 1}


@pytest.mark.parametrize(
    "open_it", [combo_box, menu_of_the_file_dialog], ids=lambda each: each.__name__
)
def test_the_stop_of_the_dialog_itself(screen, open_it):
    open_it(screen)
    screen.point_at(screen.ask("dialog_stop"))
    screen.hand("mousedown", 1)
    screen.until(stops=1)
    screen.hand("mouseup", 1)
    assert screen.ask("counts")["stops"] == 1


@pytest.mark.parametrize(
    ("key", "counted"), [("F12", "stops"), ("Pause", "stops"), ("F9", "halts")]
)
@pytest.mark.parametrize("open_it", OPEN, ids=lambda each: each.__name__)
def test_the_keys(screen, open_it, key, counted):
    open_it(screen)
    screen.hand("keydown", key)
    screen.until(**{counted: 1})
    screen.hand("keyup", key)


@pytest.mark.parametrize("key", ["F12", "Pause"])
def test_the_keys_in_the_middle_of_a_drag(screen, key):
    x, y = screen.ask("draggable")
    screen.point_at((x, y))
    screen.hand("mousedown", 1)
    for step in range(1, 8):
        screen.point_at((x + 6 * step, y + 8 * step))
    screen.hand("keydown", key)
    screen.until(stops=1)
    screen.hand("keyup", key)
    screen.hand("mouseup", 1)
