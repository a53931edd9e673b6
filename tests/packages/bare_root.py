"""Installs the .deb in a bare Debian, runs it there, updates, removes and purges it.

    python -m tests.packages.bare_root dist/armui_0.2.0-1_amd64.deb bookworm

Wants root, mmdebstrap, Xvfb, xdotool and Debian's packages; takes some minutes, so it is no part of
CI. The bus is python-can's udp_multicast: the window, the simulated arm and the recording are
processes of their own in the bare root. Everything is judged by exit codes and by the frames heard.
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
from collections.abc import Iterator
from pathlib import Path

from tests.posix import of_system

BUS = ("--interface", "udp_multicast", "--channel", "239.74.163.27")
USER = "visitor"
HOME = f"home/{USER}"
KEPT = f"{HOME}/.local/share/armui/trajectories/kept.log"
LEAST_FRAMES = 1000
ARM_S, WINDOW_S, HEARD_S = 3.0, 12.0, 3.0
"""How long each is given on a busy computer before it is asked for more."""


class Root:
    """A bare Debian in a folder, with the kernel's file systems mounted."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def run(self, command: str, *, user: str = "root", codes: tuple[int, ...] = (0,)) -> str:
        """Run a command there; what it printed."""
        done = subprocess.run(
            self._words(command, user), capture_output=True, text=True, check=False
        )
        if done.returncode not in codes:
            raise SystemExit(f"«{command}» ended with {done.returncode}:\n{done.stderr[-2000:]}")
        return done.stdout

    @contextlib.contextmanager
    def running(self, command: str) -> Iterator[subprocess.Popen[bytes]]:
        """Have the operator's program run meanwhile."""
        process = subprocess.Popen(
            self._words(f"exec {command}", USER), stdout=subprocess.DEVNULL, start_new_session=True
        )
        try:
            yield process
        finally:
            with contextlib.suppress(ProcessLookupError):
                of_system("killpg")(process.pid, signal.SIGTERM)
            process.wait(30)

    def _words(self, command: str, user: str) -> list[str]:
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
        subprocess.run(["mmdebstrap", "-q", "--variant=apt", suite, str(folder)], check=True)
        mounted = [folder / "proc", folder / "dev", folder / "dev/shm"]
        subprocess.run(["mount", "-t", "proc", "proc", mounted[0]], check=True)
        subprocess.run(["mount", "--bind", "/dev", mounted[1]], check=True)
        subprocess.run(["mount", "--bind", "/dev/shm", mounted[2]], check=True)
        try:
            yield Root(folder)
        finally:
            for each in reversed(mounted):
                subprocess.run(["umount", "-l", each], check=False)


@contextlib.contextmanager
def screen() -> Iterator[str]:
    """An X server of this system; what is in the bare root reaches it over the loopback."""
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1600x1000x24"],
        pass_fds=[writing],
        stderr=subprocess.DEVNULL,
    )
    os.close(writing)
    try:
        with os.fdopen(reading) as pipe:
            yield f":{pipe.readline().strip()}"
    finally:
        server.terminate()
        server.wait()


def older(package: Path, place: Path) -> Path:
    """The same package with the number of an older version."""
    unpacked = place / "older"
    subprocess.run(["dpkg-deb", "-R", package, unpacked], check=True)
    control = unpacked / "DEBIAN/control"
    lines = control.read_text().splitlines()
    told = ["Version: 0.0.1-1" if line.startswith("Version:") else line for line in lines]
    control.write_text("\n".join(told) + "\n")
    made = place / "armui_0.0.1-1.deb"
    subprocess.run(["dpkg-deb", "-q", "-Znone", "-b", unpacked, made], check=True)
    shutil.rmtree(unpacked)
    return made


def install(root: Root, package: Path) -> None:
    """As an operator would by a double click; asks for nothing but what is declared."""
    shutil.copy(package, root.folder / "tmp/armui.deb")
    root.run("apt-get install -y --no-install-recommends /tmp/armui.deb")
    (root.folder / "tmp/armui.deb").unlink()


def use(root: Root) -> None:
    """Window and simulated arm on one bus; a stop from the keyboard is heard in the recording."""
    home = root.folder / HOME
    said = root.run(
        "armui doctor --no-listen --lang en", user=USER, codes=(0, 1)
    )  # 1: no arm answers
    assert "FAIL" not in said, said
    with screen() as display, root.running(f"armui sim {' '.join(BUS)}"):
        time.sleep(ARM_S)
        command = (
            f"armui record {' '.join(BUS)} --folder /{HOME}/logs --name run --duration 30 --quiet"
        )
        with root.running(f"env DISPLAY={display} armui {' '.join(BUS)} --lang en") as window:
            recording = root.running(command)
            with recording as recorder:
                time.sleep(WINDOW_S)
                assert window.poll() is None, "the window has ended"
                shown = ["xdotool", "search", "--sync", "--onlyvisible", "--name", "armui"]
                environment = {**os.environ, "DISPLAY": display}
                number = subprocess.check_output(shown, env=environment, text=True).split()[0]
                subprocess.run(["xdotool", "windowfocus", number], env=environment, check=True)
                subprocess.run(["xdotool", "key", "F12"], env=environment, check=True)
                time.sleep(HEARD_S)
                recorder.wait(60)
    (log,) = home.glob("logs/*.blf")
    told = root.run(f"armui decode /{log.relative_to(root.folder)}", user=USER)
    lines = told.splitlines()
    assert len(lines) > LEAST_FRAMES, f"{len(lines)} frames were recorded"
    stops = [line for line in lines if "0x150" in line or " 150 " in line]
    assert stops, "no emergency stop was heard"
    sys.stdout.write(f"{len(lines)} frames; the stop: {stops[0]}\n")
    for kind in ("csv", "mcap", "parquet"):
        target = f"/{HOME}/exports-{kind}"
        root.run(f"armui export /{log.relative_to(root.folder)} --to {kind} -o {target}", user=USER)


def main(package: Path, suite: str) -> int:
    """Go through its life; returns 0, or ends with what went wrong."""
    with tempfile.TemporaryDirectory(prefix="armui-older-") as place, bare_root(suite) as root:
        root.run(f"useradd -m {USER}")
        root.run("apt-get update -qq")
        install(root, older(package, Path(place)))
        assert "0.0.1-1" in root.run("dpkg -s armui")
        kept = root.folder / KEPT
        root.run(f"mkdir -p $(dirname /{KEPT}) && echo mine > /{KEPT}", user=USER)
        install(root, package)
        assert "0.0.1-1" not in root.run("dpkg -s armui")
        sys.stdout.write(root.run("armui --version && du -sm /usr/lib/armui"))
        root.run("man -w armui 2>/dev/null || test -f /usr/share/man/man1/armui.1.gz")
        use(root)
        root.run("apt-get remove -y armui")
        assert not (root.folder / "usr/bin/armui").is_symlink()
        root.run("apt-get purge -y armui")
        assert not (root.folder / "usr/lib/armui").exists()
        assert kept.read_text() == "mine\n"
    sys.stdout.write(f"{suite}: installed, updated, run, removed, purged\n")
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("package", type=Path)
    parser.add_argument("suite", choices=("bookworm", "trixie"))
    options = parser.parse_args()
    raise SystemExit(main(options.package, options.suite))
