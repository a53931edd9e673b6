"""Installs the .deb in a bare Debian, runs it there, updates, removes and purges it.

    python -m tests.packages.bare_root dist/armui_0.2.0-1_amd64.deb bookworm

An .rpm is unpacked there by this computer's rpm, without asking for what it depends on: Debian's
packages of the same libraries are there before. It is run and removed in the same way.

Wants root, mmdebstrap, Xvfb, xdotool and Debian's packages; takes some minutes, so it is no part of
CI. The bus is python-can's udp_multicast: the window, the simulated arm and the recording are
processes of their own in the bare root, and this one listens. A hand at the X server's keyboard
enables, jogs and stops; what it did is judged by the frames heard, and done again where a busy
computer has not heard it yet.
"""

import argparse
import contextlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Self

import can

from tests.posix import of_system

CHANNEL = f"239.74.{os.getpid() // 256 % 256}.{os.getpid() % 256}"
"""Of this run alone: the roots share this computer's network."""
BUS = ("--interface", "udp_multicast", "--channel", CHANNEL)
RECIPES = Path(__file__).resolve().parents[2] / "resources/packaging/linux"
USER = "visitor"
HOME = f"home/{USER}"
KEPT = f"{HOME}/.local/share/armui/trajectories/kept.log"
LEAST_FRAMES = 1000
RECORDED_S = 20
PATIENCE_S = 120.0
"""How long a busy computer is given for what takes seconds."""
EMERGENCY_STOP, JOINTS_1_2, ENABLE = 0x150, 0x155, 0x471
MEASURED_1_2 = 0x2A5
JOGGED = 200
"""Thousandths of a degree that J1 has to go."""
OTHERS = ("home", "proc", "sys", "dev", "tmp", "var/cache", "var/log", "var/lib/apt", "var/backups")
"""Where a purged package may be named: its user's, the system's, apt's."""


class Root:
    """A bare Debian in a folder, with the kernel's file systems mounted."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def run(self, command: str, *, user: str = "root", codes: tuple[int, ...] = (0,)) -> str:
        """Run a command there; what it printed."""
        done = subprocess.run(
            self.words(command, user), capture_output=True, text=True, check=False
        )
        if done.returncode not in codes:
            raise SystemExit(f"«{command}» ended with {done.returncode}:\n{done.stderr[-2000:]}")
        return done.stdout

    @contextlib.contextmanager
    def running(self, command: str) -> Iterator[subprocess.Popen[bytes]]:
        """Have the operator's program run meanwhile."""
        process = subprocess.Popen(
            self.words(f"exec {command}", USER), stdout=subprocess.DEVNULL, start_new_session=True
        )
        try:
            yield process
        finally:
            with contextlib.suppress(ProcessLookupError):
                of_system("killpg")(process.pid, signal.SIGTERM)
            process.wait(30)

    def words(self, command: str, user: str) -> list[str]:
        """Return the words that run a command there."""
        as_user = [] if user == "root" else ["setpriv", f"--reuid={user}", f"--regid={user}"]
        groups = [] if user == "root" else ["--init-groups"]
        home = "/root" if user == "root" else f"/home/{user}"
        environment = ["env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", f"HOME={home}"]
        words = ["chroot", str(self.folder), *as_user, *groups, *environment]
        return [*words, "DEBIAN_FRONTEND=noninteractive", "LANG=C.UTF-8", "sh", "-c", command]


@contextlib.contextmanager
def bare_root(suite: str) -> Iterator[Root]:
    """Make one, and take it away again."""
    with tempfile.TemporaryDirectory(prefix="armui-bare-") as place:
        folder = Path(place) / "root"
        subprocess.run(
            ["mmdebstrap", "-q", "--variant=apt", "--include=passwd", suite, str(folder)],
            check=True,
        )
        mounted = [folder / "proc", folder / "dev", folder / "dev/shm"]
        subprocess.run(["mount", "-t", "proc", "proc", mounted[0]], check=True)
        subprocess.run(["mount", "--bind", "/dev", mounted[1]], check=True)
        subprocess.run(["mount", "--bind", "/dev/shm", mounted[2]], check=True)
        try:
            yield Root(folder)
        finally:
            for each in reversed(mounted):
                subprocess.run(["umount", "-l", each], check=False)


class Listener(can.Listener):
    """Keeps what was on the bus: the identifiers with their last bytes, and how far J1 was."""

    def __init__(self) -> None:
        self.heard: dict[int, bytes] = {}
        self.j1: list[int] = []

    def on_message_received(self, message: can.Message) -> None:
        self.heard[message.arbitration_id] = bytes(message.data)
        if message.arbitration_id == MEASURED_1_2:
            self.j1.append(int.from_bytes(message.data[:4], "big", signed=True))

    def has_stopped(self) -> bool:
        return self.heard.get(EMERGENCY_STOP, b"\0")[0] == 1

    def has_jogged(self) -> bool:
        return max(self.j1) - min(self.j1) > JOGGED


@contextlib.contextmanager
def listening() -> Iterator[Listener]:
    """Listen to the bus of the bare root, which shares this computer's network."""
    listener = Listener()
    with can.Bus(interface="udp_multicast", channel=CHANNEL) as bus:
        notifier = can.Notifier(bus, [listener])
        try:
            yield listener
        finally:
            notifier.stop()


class Screen:
    """An X server of this system; what is in the bare root reaches it by its abstract socket."""

    def __init__(self) -> None:
        reading, writing = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-noreset", "-displayfd", str(writing), "-screen", "0", "1600x1000x24"],
            pass_fds=[writing],
            stderr=subprocess.DEVNULL,
        )
        os.close(writing)
        with os.fdopen(reading) as pipe:
            self.display = f":{pipe.readline().strip()}"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self._server.terminate()
        self._server.wait()

    def hand(self, *words: object) -> str:
        """Move the keyboard: xdotool's words."""
        environment = {**os.environ, "DISPLAY": self.display}
        done = subprocess.run(
            ["xdotool", *map(str, words)],
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        return done.stdout

    def shows(self, title: str) -> bool:
        return bool(self.hand("search", "--onlyvisible", "--name", title))

    def focus(self, title: str) -> None:
        number = self.hand("search", "--onlyvisible", "--name", title).split()[0]
        self.hand("windowfocus", number)

    def command(self, name: str, pause_s: float) -> None:
        """Find a command by its name and press Enter."""
        self.hand("key", "Escape")
        self.focus("armui")
        self.hand("key", "ctrl+k")
        time.sleep(pause_s)
        self.hand("type", "--delay", "50", name)
        time.sleep(pause_s)
        self.hand("key", "Return")
        time.sleep(pause_s)

    def jog(self, _pause_s: float) -> None:
        """Turn jogging by keys on, or off again, and hold a key."""
        self.command("Keyboard jogging", _pause_s)
        self.hand("keydown", "space")
        time.sleep(0.5)
        self.hand("keydown", "q")
        time.sleep(2 + _pause_s)
        self.hand("keyup", "q")
        self.hand("keyup", "space")


def wait(condition: Callable[[], bool], what: str, seconds: float = PATIENCE_S) -> None:
    """Wait until something is so."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            raise SystemExit(f"{what}: not within {seconds:.0f} s")
        time.sleep(0.1)


def until(condition: Callable[[], bool], act: Callable[[float], object], what: str) -> None:
    """Act, ever more slowly, until it has had its effect on the bus."""
    for pause_s in (1.0, 2.0, 4.0, 8.0, 16.0):
        act(pause_s)
        with contextlib.suppress(SystemExit):
            wait(condition, what, 3.0 + pause_s)
            return
    raise SystemExit(f"{what}: not heard on the bus")


def told(text: str, since: float) -> None:
    sys.stdout.write(f"{text}: {time.monotonic() - since:.1f} s\n")
    sys.stdout.flush()


def older(package: Path, place: Path) -> Path:
    """The same package with the number of an older version."""
    unpacked = place / "older"
    subprocess.run(["dpkg-deb", "-R", package, unpacked], check=True)
    control = unpacked / "DEBIAN/control"
    lines = control.read_text().splitlines()
    told = ["Version: 0.0.1-1" if line.startswith("Version:") else line for line in lines]
    control.write_text("\n".join(told) + "\n")
    made = place / "armui_0.0.1-1.deb"
    subprocess.run(
        ["dpkg-deb", "-Znone", "-b", unpacked, made], stdout=subprocess.DEVNULL, check=True
    )
    shutil.rmtree(unpacked)
    return made


def install(root: Root, package: Path) -> None:
    """As an operator would by a double click; asks for nothing but what is declared."""
    shutil.copy(package, root.folder / "tmp/armui.deb")
    root.run("apt-get install -y --no-install-recommends /tmp/armui.deb")
    (root.folder / "tmp/armui.deb").unlink()


def use(root: Root) -> None:
    """Window and simulated arm on one bus: enabled, jogged, stopped, recorded, and read."""
    home = root.folder / HOME
    bus = " ".join(BUS)
    recording = f"armui record {bus} --folder /{HOME}/logs --name run --quiet"
    with Screen() as screen, listening() as bus_heard, root.running(f"armui sim {bus}"):
        doctor = f"DISPLAY={screen.display} armui doctor --no-listen --lang en"
        said = root.run(doctor, user=USER, codes=(0, 1))  # 1: it was not to listen
        assert "FAIL" not in said, said
        wait(lambda: MEASURED_1_2 in bus_heard.heard, "the simulated arm")
        began = time.monotonic()
        window_command = f"env DISPLAY={screen.display} armui {bus} --lang en"
        with root.running(recording) as recorder, root.running(window_command) as window:
            wait(lambda: screen.shows("armui"), "the window")
            told("window shown", began)
            screen.focus("armui")
            until(
                lambda: ENABLE in bus_heard.heard,
                lambda s: screen.command("Enable or", s),
                "enabled",
            )
            until(bus_heard.has_jogged, screen.jog, "jogged")
            until(bus_heard.has_stopped, lambda _s: screen.hand("key", "F12"), "stopped")
            assert window.poll() is None, "the window has ended"
            # not SIGINT: what a shell begins in the background ignores it
            recorder.send_signal(signal.SIGTERM)
            recorder.wait(PATIENCE_S)
    (log,) = (home / "logs").glob("*.blf")
    path = f"/{log.relative_to(root.folder)}"
    lines = root.run(f"armui decode {path}", user=USER).splitlines()
    assert len(lines) > LEAST_FRAMES, f"{len(lines)} frames were recorded"
    stops = [line for line in lines if " 150 " in line or "0x150" in line]
    assert stops, "no emergency stop was recorded"
    sys.stdout.write(f"{len(lines)} frames; the stop: {stops[0]}\n")
    for kind in ("csv", "mcap", "parquet"):
        root.run(f"armui export {path} --to {kind} -o /{HOME}/exports-{kind}", user=USER)
        assert any((home / f"exports-{kind}").rglob("*")) or (home / f"exports-{kind}").is_file()
    with (
        Screen() as screen,
        root.running(f"env DISPLAY={screen.display} armui replay {path} --lang en"),
    ):
        wait(lambda: screen.shows("Replay"), "the window of the replay")


def left_of(root: Root) -> list[str]:
    """What bears the program's name, outside what is the user's or the system's own."""
    pruned = " -o ".join(f"-path /{each}" for each in OTHERS)
    return root.run(f"find / \\( {pruned} \\) -prune -o -name '*armui*' -print").split()


def try_rpm(package: Path, suite: str) -> int:
    """Put what an .rpm holds into a bare Debian, use it, and remove it."""
    began = time.monotonic()
    text = (RECIPES / "libraries.toml").read_text(encoding="utf-8")
    named = [name for part in tomllib.loads(text).values() for name in part.values()]
    wanted = sorted({name.split("|")[0].split("(")[0].strip() for name in named})
    with bare_root(suite) as root:
        root.run(f"useradd -m {USER}")
        root.run("apt-get update -qq")
        root.run(
            f"apt-get install -y --no-install-recommends fonts-wqy-microhei {' '.join(wanted)}"
        )
        told("bare root with the libraries", began)
        rpm = ["rpm", "--root", str(root.folder)]
        subprocess.run([*rpm, "--initdb"], check=True)
        since = time.monotonic()
        subprocess.run([*rpm, "--install", "--nodeps", package], check=True)
        told("unpacked", since)
        sys.stdout.write(f"{1e-6 * package.stat().st_size:.1f} MB packed\n")
        subprocess.run([*rpm, "--verify", "--nodeps", "armui"], check=True)
        since = time.monotonic()
        use(root)
        told("used", since)
        subprocess.run([*rpm, "--erase", "--nodeps", "armui"], check=True)
        assert left_of(root) == [], left_of(root)
        assert (root.folder / HOME / "logs").is_dir()
    told(f"{suite}: unpacked by rpm, run, removed", began)
    return 0


def main(package: Path, suite: str) -> int:
    """Go through its life; returns 0, or ends with what went wrong."""
    if package.suffix == ".rpm":
        return try_rpm(package, suite)
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="armui-older-") as place, bare_root(suite) as root:
        root.run(f"useradd -m {USER}")
        root.run("apt-get update -qq")
        told("bare root", began)
        since = time.monotonic()
        install(root, older(package, Path(place)))
        assert "0.0.1-1" in root.run("dpkg -s armui")
        told("an older version packed and installed with what it asks for", since)
        kept = root.folder / KEPT
        root.run(f"mkdir -p $(dirname /{KEPT}) && echo mine > /{KEPT}", user=USER)
        since = time.monotonic()
        install(root, package)
        assert "0.0.1-1" not in root.run("dpkg -s armui")
        told("updated", since)
        sys.stdout.write(root.run("armui --version && du -sm /usr/lib/armui"))
        sys.stdout.write(f"{1e-6 * package.stat().st_size:.1f} MB packed\n")
        root.run("test -f /usr/share/man/man1/armui.1.gz -o -f /etc/dpkg/dpkg.cfg.d/excludes")
        since = time.monotonic()
        use(root)
        told("used", since)
        root.run("apt-get remove -y armui")
        assert not (root.folder / "usr/bin/armui").is_symlink()
        root.run("dpkg --purge armui")  # apt no longer knows a package that no list has
        assert left_of(root) == [], left_of(root)
        assert kept.read_text() == "mine\n"
        assert (root.folder / HOME / "logs").is_dir()
    told(f"{suite}: installed, updated, run, removed, purged", began)
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("package", type=Path)
    parser.add_argument("suite", choices=("bookworm", "trixie"))
    options = parser.parse_args()
    raise SystemExit(main(options.package, options.suite))
