"""Runs README's two commands, word for word, in a bare Debian; or wheel and source archive by pip.

    python -m tests.packages.bare_source bookworm            # or trixie; as root
    python -m tests.packages.bare_source bookworm --made dist

The committed sources are unpacked there, and the first command has to show the window with the
simulated arm. Of the second, which runs all checks, it is seen that it installs what it wants,
passes what is checked before the tests, and that tests pass; then it is ended (`--whole` waits for
its end). With `--made` the wheel and the source archive in a folder are installed by pip and by
pipx as well, each in an environment of its own, and started.

Wants what `tests.packages.bare_root` wants, and Python's index. pip there trusts whom this computer
trusts.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from tests.packages.bare_root import Root, Screen, bare_root, told, wait

ROOT = Path(__file__).resolve().parents[2]
CERTIFICATES = Path("/etc/ssl/certs/ca-certificates.crt")
PATIENCE_S = 2400.0
SOME_TESTS = re.compile(r"\[ +[1-9]\d*%\]")
PLATFORM = "QT_QPA_PLATFORM=offscreen"


def commands() -> tuple[str, str]:
    """README's two commands."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    first, second = re.findall(r"```sh\n(.+)\n```", text)
    return first, second


def unpack(root: Root) -> None:
    """Put the committed sources there, and what lets pip reach its index."""
    place = root.folder / "root/armui"
    place.mkdir()
    archive = subprocess.run(
        ["git", "-C", ROOT, "archive", "HEAD"], check=True, stdout=subprocess.PIPE
    ).stdout
    subprocess.run(["tar", "-x", "-C", place], check=True, input=archive)
    (root.folder / "root/certificates.crt").write_bytes(CERTIFICATES.read_bytes())


def begin(root: Root, command: str, display: str) -> subprocess.Popen[str]:
    """Begin a command of README's as root, who is asked for no password."""
    words = f"cd /root/armui && DISPLAY={display} PIP_CERT=/root/certificates.crt exec {command}"
    return subprocess.Popen(
        root.words(words, "root"),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )


def end(process: subprocess.Popen[str]) -> None:
    """End it with all that it has begun."""
    subprocess.run(["pkill", "-KILL", "-s", str(process.pid)], check=False)
    process.wait()


def try_window(root: Root, command: str) -> None:
    """The first command shows the window."""
    began = time.monotonic()
    with Screen() as screen:
        process = begin(root, command, screen.display)
        try:
            wait(lambda: screen.shows("armui") or process.poll() is not None, "window", PATIENCE_S)
            assert process.poll() is None, process.communicate()[0][-3000:]
        finally:
            end(process)
    told(f"«{command}»: window shown", began)


def try_check(root: Root, command: str, *, whole: bool) -> None:
    """The second command installs what it wants, and tests pass."""
    began = time.monotonic()
    process = begin(root, command, ":none")
    lines: list[str] = []
    try:
        assert process.stdout is not None
        for line in process.stdout:
            lines.append(line)
            if line.startswith("$ "):
                told(line.strip(), began)
            if not whole and SOME_TESTS.search(line):
                assert "F" not in line, line
                break
        else:
            assert process.wait() == 0, "".join(lines[-60:])
    finally:
        end(process)
    told(f"«{command}»: {lines[-1].strip()}", began)


def try_made(root: Root, folder: Path) -> None:
    """Wheel and source archive are installed by pip and pipx, and what they bring starts."""
    root.run("apt-get install -y --no-install-recommends pipx python3-venv")
    home = root.folder / "root"
    for kind in ("*.whl", "armui-*.tar.gz"):
        (made,) = folder.glob(kind)
        shutil.copy(made, home / made.name)
        began = time.monotonic()
        name = "wheel" if made.suffix == ".whl" else "sdist"
        pip = f"PIP_CERT=/root/certificates.crt /root/{name}/bin/pip install -q /root/{made.name}"
        root.run(f"python3 -m venv /root/{name} && {pip}")
        assert root.run(f"/root/{name}/bin/armui --version").startswith("armui ")
        start(root, f"/root/{name}/bin/armui --sim")
        told(f"{made.name} by pip, started", began)
        shutil.rmtree(home / name)
    began = time.monotonic()
    (wheel,) = home.glob("*.whl")
    root.run(f"PIP_CERT=/root/certificates.crt pipx install /root/{wheel.name}")
    start(root, "/root/.local/bin/armui --sim")
    told(f"{wheel.name} by pipx, started", began)


def start(root: Root, command: str) -> None:
    """Have a program stand for some seconds without a display, then end as it is told to."""
    said = root.run(f"{PLATFORM} timeout -s TERM 15 {command}", codes=(0, 124, 143))
    assert "Traceback" not in said, said


def main(arguments: list[str] | None = None) -> int:
    """Run what is asked for; returns 0, or ends with what went wrong."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("suite")
    parser.add_argument("--made", type=Path, help="a folder with a wheel and a source archive")
    parser.add_argument("--whole", action="store_true", help="wait for the end of the checks")
    options = parser.parse_args(arguments)
    first, second = commands()
    with bare_root(options.suite) as root:
        root.run("apt-get update -qq")
        unpack(root)
        if options.made is not None:
            libraries = (ROOT / "resources/run").read_text(encoding="utf-8")
            named = re.search(r"libraries=\((.*?)\)", libraries, re.DOTALL)
            assert named is not None
            root.run(f"apt-get install -y {' '.join(named[1].split())}")
            try_made(root, options.made)
        else:
            try_window(root, first)
            try_check(root, second, whole=options.whole)
    return 0


if __name__ == "__main__":
    os.environ.pop("PYTHONPATH", None)
    sys.exit(main())
