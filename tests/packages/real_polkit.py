"""The helper's policy under the real polkit, in a bare Debian: refused, wrong password, allowed.

    python -m tests.packages.real_polkit bookworm

Wants root, mmdebstrap and Debian's packages; takes some minutes, so it is no part of CI. System bus
and polkitd run in the bare root. There is no seat there, so what polkit says to a user who sits at
the computer is read from `pkaction`, and the password is asked for at a terminal.
"""

import argparse
import contextlib
import os
import pty
import select
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from tests.packages.bare_root import USER, Root, bare_root
from tests.posix import of_system

LINUX = Path(__file__).resolve().parents[2] / "resources/packaging/linux"
HELPER = "/usr/libexec/armui-adapter"
ACTION = "org.armui.adapter"
PKEXEC = "pkexec --disable-internal-agent"
KEPT = "etc/systemd/network/70-armui-arm_left.link"
RULES = "etc/polkit-1/rules.d/10-try.rules"
PASSWORD = "for this trial"
NOT_AUTHORISED = 127
PATIENCE_S = 60.0


def install(root: Root) -> None:
    """Put helper and policy where the package puts them."""
    root.run(
        "apt-get update -qq && apt-get install -y -qq --no-install-recommends"
        " polkitd pkexec dbus python3 iproute2 udev >/dev/null"
    )
    root.run(f"id {USER} 2>/dev/null || useradd -m {USER}")
    for name, place, mode in (
        ("adapter_helper.py", HELPER, 0o755),
        (f"{ACTION}.policy", f"/usr/share/polkit-1/actions/{ACTION}.policy", 0o644),
    ):
        target = root.folder / place[1:]
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(LINUX / name, target)
        target.chmod(mode)
    root.run(f"echo 'root:{PASSWORD}' | chpasswd")


@contextlib.contextmanager
def daemons(root: Root) -> Iterator[None]:
    """System bus and polkitd."""
    started = []
    (root.folder / "run/dbus").mkdir(parents=True, exist_ok=True)
    try:
        for words in (
            ["dbus-daemon", "--system", "--nofork", "--nopidfile"],
            ["/usr/lib/polkit-1/polkitd", "--no-debug"],
        ):
            started.append(subprocess.Popen(["chroot", str(root.folder), *words]))
            time.sleep(2)
            assert started[-1].poll() is None, words
        yield
    finally:
        for each in reversed(started):
            each.terminate()
            each.wait()


def ended(root: Root, command: str, user: str = USER) -> int:
    """The exit code of a command that is told to go."""
    words = root.words(f"echo go | {command}", user)
    return subprocess.run(words, check=False, timeout=PATIENCE_S).returncode


def with_password(root: Root, password: str) -> tuple[int, str]:
    """What comes of it where an agent asks at a terminal, as the desktop's does in a window."""
    asks = "pkttyagent --process $$ & sleep 3"
    command = f"{asks}; echo go | {PKEXEC} {HELPER} forget arm_left; said=$?; kill $!; exit $said"
    pid, terminal = of_system("fork", pty)()
    if pid == 0:
        words = root.words(command, USER)
        os.execvp(words[0], words)
    said, typed, until = "", False, time.monotonic() + PATIENCE_S
    while time.monotonic() < until:
        if not select.select([terminal], [], [], 1.0)[0]:
            continue
        try:
            said += os.read(terminal, 1000).decode("utf-8", "replace")
        except OSError:
            break  # the child has ended
        if "assword:" in said and not typed:
            typed = True
            os.write(terminal, password.encode() + b"\n")
    _, status = os.waitpid(pid, 0)
    os.close(terminal)
    return os.waitstatus_to_exitcode(status), said


def plant(root: Root) -> Path:
    """A file of ours, which only root can take away."""
    kept = root.folder / KEPT
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text("# Written by armui for AB12 0x0\n")
    return kept


def try_policy(root: Root) -> None:
    """Ask polkit in each way."""
    kept = plant(root)
    with daemons(root):
        told = root.run(f"pkaction --verbose --action-id {ACTION}")
        for line in ("implicit active:   auth_admin_keep", "implicit any:      auth_admin"):
            assert line in told, told
        assert f"org.freedesktop.policykit.exec.path -> {HELPER}" in told, told

        assert ended(root, f"{PKEXEC} {HELPER} forget arm_left") == NOT_AUTHORISED
        code, said = with_password(root, "wrong")
        assert (code, "FAILED" in said) == (NOT_AUTHORISED, True), said
        assert kept.exists()
        code, said = with_password(root, PASSWORD)
        assert (code, kept.exists()) == (0, False), said

        # allowed, as by a password still remembered: for the helper, and for nothing else
        (root.folder / RULES).write_text(
            "polkit.addRule(function(action, subject) {\n"
            f'  if (action.id == "{ACTION}" && subject.user == "{USER}")\n'
            "    return polkit.Result.YES;\n});\n"
        )
        time.sleep(3)  # polkitd reads its rules again
        plant(root)
        hostile = "PYTHONPATH=/home/visitor PYTHONHOME=/tmp PATH=/home/visitor:$PATH"
        trap = root.folder / "home/visitor/json.py"
        trap.write_text("raise SystemExit(9)\n")
        assert ended(root, f"env {hostile} {PKEXEC} {HELPER} forget arm_left") == 0
        assert not kept.exists()
        assert ended(root, f"{PKEXEC} {HELPER} up lo 1000000") == 1
        assert ended(root, f"{PKEXEC} {HELPER} 'up;id' lo") == 2
        assert ended(root, f"{PKEXEC} /usr/bin/id") == NOT_AUTHORISED
        # without root it plans, and cannot do
        plant(root)
        assert ended(root, f"{HELPER} forget arm_left") == 1
        assert kept.exists()


def main(suite: str) -> int:
    """Make the bare root and try; 0, or it ends with what went wrong."""
    with bare_root(suite) as root:
        install(root)
        try_policy(root)
    sys.stdout.write(f"{suite}: refused, wrong password, password, allowed: as the policy says\n")
    return 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("suite", choices=("bookworm", "trixie"))
    raise SystemExit(main(parser.parse_args().suite))
