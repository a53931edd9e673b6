#!/usr/bin/python3 -IS
"""Brings a CAN interface up, down, back from bus-off, and keeps its name and bit rate: as root.

The package puts it at /usr/libexec/armui-adapter; the window starts it by pkexec. It takes one of
five verbs and checks every word behind it itself, for whoever starts it may not be who should:

    up INTERFACE BITRATE            reset INTERFACE            down INTERFACE
    remember INTERFACE NAME BITRATE (or a serial port: remember ttyACM0)
    forget NAME (of a serial adapter: port-KEY, as its file is called)

It first says what it would do, as a line of JSON, and does it only when it reads «go»: an operator
can see the files before they are written, without being root, and the window looks at the arm once
more after the password was asked for. The last line says what came of it. It starts no shell, reads
no environment and no file of a user, and knows only the standard library of the system's Python.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import select
import stat
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

NET = Path("/sys/class/net")
TTY = Path("/sys/class/tty")
ETC = Path("/etc")
TOOL_FOLDERS = ("/usr/sbin", "/usr/bin", "/sbin", "/bin")
ROOT = 0
"""Who owns the folders it writes in."""
NO_LINK: int = getattr(os, "O_NOFOLLOW", 0)
FOLDER: int = getattr(os, "O_DIRECTORY", 0)
PATIENCE_S = 5.0
"""For each tool; a kernel that hangs is not waited for."""
GO_S = 60.0
BITRATES = (125_000, 250_000, 500_000, 1_000_000)
RESTART_MS = 100

_CAN = "280"
"""ARPHRD_CAN"""
_UP = 0x1
"""IFF_UP"""
_INTERFACE = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,14}")
_NAME = re.compile(r"[a-z][a-z0-9_]{0,14}")
_OF_KERNEL = re.compile(
    r"(can|vcan|vxcan|slcan|eth|wlan|wwan|usb|lo|tun|tap|br|bond|dummy|veth|en[opsx]\w+)\d*"
)
_PORT = re.compile(r"tty(ACM|USB)[0-9]{1,3}")
_KEPT_PORT = re.compile(r"port-[A-Za-z0-9_-]{1,64}")
_SERIAL = re.compile(r"[A-Za-z0-9._:+#@=-]{1,64}")
_USB_ID = re.compile(r"[0-9a-f]{4}")
_MARK = "# Written by armui for "


class RefusedError(Exception):
    """It is not done.

    Args:
        code: Why, for the window.
        text: What a tool or the system said.
    """

    def __init__(self, code: str, text: str = "") -> None:
        super().__init__(code, text)
        self.code = code
        self.text = text


def tool(name: str) -> str:
    """Where a program of the system is: never where an environment says."""
    for folder in TOOL_FOLDERS:
        path = f"{folder}/{name}"
        if os.access(path, os.X_OK):
            return path
    raise RefusedError("tool_missing", name)


def run(name: str, *words: str) -> str:
    """What a program of the system prints.

    Raises:
        RefusedError: It is not there, fails, or does not end in time.
    """
    environment = {"PATH": ":".join(TOOL_FOLDERS), "LC_ALL": "C"}
    process = subprocess.Popen(  # noqa: S603 - a tool of the system, words that were checked
        [tool(name), *words],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment,
        cwd="/",
    )
    try:
        out, err = process.communicate(timeout=PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()  # not waited for: one that hangs in the kernel does not end by that
        raise RefusedError("tool_hangs", name) from None
    if process.returncode:
        said = (err or out).decode("utf-8", "replace").strip()
        raise RefusedError("tool_failed", f"{name}: {said[-300:] or process.returncode}")
    return out.decode("utf-8", "replace")


# The interface ------------------------------------------------------------------------------


def can_interface(name: str) -> str:
    """The name, if it is one of a CAN interface that is there."""
    if not _INTERFACE.fullmatch(name) or name not in names_in(NET):
        raise RefusedError("no_interface", name[:40])
    if read(NET / name / "type") != _CAN:
        raise RefusedError("not_can", name)
    return name


def names_in(folder: Path) -> set[str]:
    """What lies in a folder of the kernel: a name out of it leads nowhere else."""
    return {each.name for each in folder.iterdir()}


def read(path: Path) -> str:
    """A line that the kernel tells of a device; "" where it tells none."""
    try:
        return path.read_text("ascii", "replace").strip()
    except OSError:
        return ""


def bit_rate(word: str) -> str:
    """A bit rate of the list."""
    if word not in map(str, BITRATES):
        raise RefusedError("bad_bitrate", word[:40])
    return word


def is_up(name: str) -> bool:
    """What the kernel says, not ip."""
    flags = read(NET / name / "flags")
    return bool(int(flags, 16) & _UP) if re.fullmatch("0x[0-9a-f]+", flags) else False


def link_info(name: str) -> dict[str, Any]:
    """Kind, bit rate and state of an interface."""
    try:
        (found,) = json.loads(run("ip", "-details", "-json", "link", "show", "dev", name))
        about = found.get("linkinfo", {})
        data = about.get("info_data", {})
        timing = data.get("bittiming", {})
    except (ValueError, AttributeError):
        raise RefusedError("tool_failed", "ip: no JSON") from None
    return {
        "kind": about.get("info_kind"),
        "bitrate": timing.get("bitrate"),
        "state": data.get("state"),
    }


def set_link(name: str, *words: str) -> None:
    """One change by ip."""
    run("ip", "link", "set", "dev", name, *words)


def set_up(name: str, bitrate: str | None) -> dict[str, Any]:
    """Down, set, up; then looked at.

    Args:
        name: A CAN interface.
        bitrate: ``None`` keeps it.
    """
    can_interface(name)  # once more: since it was checked, the adapter may have been changed
    before = link_info(name)
    was_up = is_up(name)
    hardware = before["kind"] != "vcan"
    if hardware and bitrate is None and not before["bitrate"]:
        raise RefusedError("no_bitrate", name)
    set_link(name, "down")
    restarts = False
    try:
        if hardware and bitrate is not None:
            set_link(name, "type", "can", "bitrate", bitrate, "listen-only", "off")
        if hardware:
            restarts = comes_back_by_itself(name)
        set_link(name, "up")
    except RefusedError:
        if was_up:
            set_link(name, "up")
        raise
    now = link_info(name)
    told = {**now, "up": is_up(name), "restarts": restarts}
    if not told["up"] or (hardware and bitrate is not None and str(now["bitrate"]) != bitrate):
        raise RefusedError("not_up", json.dumps(told))
    return told


def comes_back_by_itself(name: str) -> bool:
    """Whether the driver can return from bus-off without being told; some cannot."""
    try:
        set_link(name, "type", "can", "restart-ms", str(RESTART_MS))
    except RefusedError as refused:
        if refused.code != "tool_failed":
            raise
        return False
    return True


def set_down(name: str) -> dict[str, Any]:
    """Down; then looked at."""
    can_interface(name)
    set_link(name, "down")
    if is_up(name):
        raise RefusedError("not_down", name)
    return {"up": False}


# What is kept -------------------------------------------------------------------------------


def properties(path: Path) -> dict[str, str]:
    """What udev knows of a device."""
    lines = run("udevadm", "info", "--query=property", f"--path={path}").splitlines()
    return dict(line.split("=", 1) for line in lines if "=" in line)


def serial_of(name: str) -> str:
    """The serial number of an interface's adapter; "" where it tells none."""
    serial = properties(NET / name).get("ID_SERIAL_SHORT", "")
    if serial and not _SERIAL.fullmatch(serial):
        raise RefusedError("bad_serial", serial[:80])
    return serial


def new_name(name: str, interface: str) -> str:
    """A name that the kernel does not give and no other interface has."""
    if not _NAME.fullmatch(name) or _OF_KERNEL.fullmatch(name) or name in {"all", "default"}:
        raise RefusedError("bad_name", name[:40])
    if name != interface and name in names_in(NET):
        raise RefusedError("name_taken", name)
    return name


def networkd_runs() -> bool:
    """Whether systemd-networkd looks after interfaces here."""
    try:
        run("systemctl", "is-active", "--quiet", "systemd-networkd.service")
        tool("networkctl")
    except RefusedError as refused:
        if refused.code == "tool_hangs":
            raise
        return False
    return True


def files_of_interface(interface: str, name: str, bitrate: str) -> dict[Path, str]:
    """What keeps name and bit rate of an adapter, by path: texts."""
    serial = serial_of(interface)
    if not serial:
        raise RefusedError("no_serial", interface)
    channel = read(NET / interface / "dev_id")
    if not re.fullmatch("0x[0-9a-f]{1,4}", channel):
        raise RefusedError("no_channel", interface)
    mark = f"{_MARK}{serial} {channel}\n"
    match = f'SUBSYSTEM=="net", ACTION=="add", ATTR{{type}}=="{_CAN}"'
    if networkd_runs():
        several = [each for each in other_interfaces(interface) if serial_of(each) == serial]
        wanted = f"ID_SERIAL_SHORT={serial}" + (f" ARMUI_DEV_ID={channel}" if several else "")
        files = {
            ETC / f"systemd/network/70-armui-{name}.link": (
                f"{mark}[Match]\nProperty={wanted}\n\n[Link]\nName={name}\n"
            ),
            ETC / f"systemd/network/70-armui-{name}.network": (
                f"{mark}[Match]\nName={name}\n\n[Link]\nRequiredForOnline=no\n\n"
                f"[CAN]\nBitRate={bitrate}\nRestartSec={RESTART_MS}ms\n"
            ),
        }
        if several:
            rule = f'{mark}{match}, ENV{{ARMUI_DEV_ID}}="$attr{{dev_id}}"\n'
            files[ETC / f"udev/rules.d/76-armui-{name}.rules"] = rule
        return files
    tool("systemctl")
    unit = f"armui-can-{name}.service"
    up = f"{tool('ip')} link set dev {name} up type can bitrate {bitrate} restart-ms {RESTART_MS}"
    return {
        ETC / f"udev/rules.d/76-armui-{name}.rules": (
            f'{mark}{match}, ENV{{ID_SERIAL_SHORT}}=="{serial}", ATTR{{dev_id}}=="{channel}", '
            f'NAME="{name}", TAG+="systemd", ENV{{SYSTEMD_WANTS}}+="{unit}"\n'
        ),
        ETC / f"systemd/system/{unit}": (
            f"{mark}[Unit]\nDescription=CAN adapter {name}\n\n"
            f"[Service]\nType=oneshot\nExecStart={up}\n"
        ),
    }


def other_interfaces(interface: str) -> list[str]:
    """The other CAN interfaces there are."""
    names = [each for each in sorted(names_in(NET)) if _INTERFACE.fullmatch(each)]
    return [each for each in names if each != interface and read(NET / each / "type") == _CAN]


def is_port(name: str) -> bool:
    """Whether a word names a serial port of the USB that may be there."""
    return _PORT.fullmatch(name) is not None


def files_of_port(name: str) -> dict[Path, str]:
    """What lets whoever sits at this computer open a serial adapter."""
    if not is_port(name) or name not in names_in(TTY):
        raise RefusedError("no_interface", name[:40])
    found = properties(TTY / name)
    ids = [found.get(each, "") for each in ("ID_VENDOR_ID", "ID_MODEL_ID")]
    serial = found.get("ID_SERIAL_SHORT", "")
    if found.get("ID_BUS") != "usb" or not all(_USB_ID.fullmatch(each) for each in ids):
        raise RefusedError("not_usb", name)
    if serial and not _SERIAL.fullmatch(serial):
        raise RefusedError("bad_serial", serial[:80])
    key = re.sub("[^A-Za-z0-9]", "_", serial) or "-".join(ids)
    by_serial = f', ENV{{ID_SERIAL_SHORT}}=="{serial}"' if serial else ""
    return {
        ETC / f"udev/rules.d/70-armui-port-{key}.rules": (
            f"{_MARK}{':'.join(ids)} {serial}\n"
            f'SUBSYSTEM=="tty", ENV{{ID_VENDOR_ID}}=="{ids[0]}", '
            f'ENV{{ID_MODEL_ID}}=="{ids[1]}"{by_serial}, TAG+="uaccess"\n'
        )
    }


def places_of(name: str) -> list[Path]:
    """Where files of a name can lie."""
    if _KEPT_PORT.fullmatch(name):
        return [ETC / f"udev/rules.d/70-armui-{name}.rules"]
    return [
        ETC / f"systemd/network/70-armui-{name}.link",
        ETC / f"systemd/network/70-armui-{name}.network",
        ETC / f"systemd/system/armui-can-{name}.service",
        ETC / f"udev/rules.d/76-armui-{name}.rules",
    ]


def superseded(files: Mapping[Path, str]) -> list[Path]:
    """Our files for the same adapter under another name."""
    marks = {each.splitlines()[0] for each in files.values()}
    patterns = (
        "systemd/network/70-armui-*",
        "systemd/system/armui-can-*",
        "udev/rules.d/7?-armui-*",
    )
    there = [each for pattern in patterns for each in sorted(ETC.glob(pattern))]
    return [each for each in there if each not in files and mark_of(each) in marks]


def mark_of(path: Path) -> str:
    """The first line of a file of ours; "" if it is none, or no file at all."""
    try:
        text = look_at(path)
    except OSError:
        return ""
    first = text.splitlines()[0] if text else ""
    return first if first.startswith(_MARK) else ""


def look_at(path: Path) -> str:
    """The text of a regular file; links are not followed."""
    with opened(path.parent) as folder:
        number = os.open(path.name, os.O_RDONLY | NO_LINK, dir_fd=folder.number)
        with os.fdopen(number, "rb") as file:
            if not stat.S_ISREG(os.fstat(number).st_mode):
                raise OSError(f"{path} is no file")
            return file.read(10_000).decode("utf-8", "replace")


class opened:  # noqa: N801 - a context manager
    """A folder below /etc, reached without a link and changed by nobody but its owner.

    Args:
        folder: Its path.
        make: It is made where it is missing.
    """

    def __init__(self, folder: Path, *, make: bool = False) -> None:
        self.number = os.open(ETC, os.O_RDONLY | FOLDER)
        try:
            for part in folder.relative_to(ETC).parts:
                self._enter(part, make=make)
        except OSError:
            os.close(self.number)
            raise

    def _enter(self, part: str, *, make: bool) -> None:
        if make:
            with contextlib.suppress(FileExistsError):
                os.mkdir(part, 0o755, dir_fd=self.number)
        deeper = os.open(part, os.O_RDONLY | FOLDER | NO_LINK, dir_fd=self.number)
        os.close(self.number)
        self.number = deeper
        found = os.fstat(deeper)
        if found.st_uid != ROOT or found.st_mode & (stat.S_IWGRP | stat.S_IWOTH):
            raise PermissionError(f"others may write in {part}")

    def __enter__(self) -> opened:
        return self

    def __exit__(self, *error: object) -> None:
        os.close(self.number)


def write(path: Path, text: str) -> None:
    """A file at once, with all its text or not at all; a link there is replaced, not followed."""
    with opened(path.parent, make=True) as folder:
        draft = f".armui-{os.getpid()}"
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | NO_LINK
        number = os.open(draft, flags, 0o644, dir_fd=folder.number)
        try:
            with os.fdopen(number, "wb") as file:
                file.write(text.encode())
                file.flush()
                os.fsync(file.fileno())
            os.rename(draft, path.name, src_dir_fd=folder.number, dst_dir_fd=folder.number)
        except OSError:
            os.unlink(draft, dir_fd=folder.number)
            raise


def remove(path: Path) -> None:
    """A file of ours."""
    with opened(path.parent) as folder:
        os.unlink(path.name, dir_fd=folder.number)


def keep(files: Mapping[Path, str], outdated: Sequence[Path]) -> None:
    """Write all of them or none, then take away what they replace."""
    foreign = [str(each) for each in files if os.path.lexists(each) and not mark_of(each)]
    if foreign:
        raise RefusedError("not_ours", foreign[0])
    written = []
    try:
        for path, text in files.items():
            write(path, text)
            written.append(path)
    except OSError:
        for each in written:
            remove(each)
        raise
    for each in outdated:
        remove(each)


def reload(port: str = "") -> dict[str, Any]:
    """Tell udev and systemd; what has been written holds from the next start even if they fail."""
    said = []
    commands = [("udevadm", "control", "--reload"), ("systemctl", "daemon-reload")]
    if networkd_runs():
        commands.append(("networkctl", "reload"))
    if port:
        commands.append(("udevadm", "trigger", "--action=change", f"/sys/class/tty/{port}"))
    for command in commands:
        try:
            run(*command)
        except RefusedError as refused:
            said.append(f"{command[0]}: {refused.code}")
    return {"not_told": said}


# The verbs ----------------------------------------------------------------------------------

Plan = tuple[dict[str, Any], Callable[[], dict[str, Any]]]
"""What is said of it beforehand, and what does it."""


def plan_up(words: Sequence[str]) -> Plan:
    """Switch an interface on with a bit rate."""
    interface, bitrate = words
    can_interface(interface)
    bit_rate(bitrate)
    return {}, lambda: set_up(interface, bitrate)


def plan_down(words: Sequence[str]) -> Plan:
    """Switch an interface off."""
    (interface,) = words
    can_interface(interface)
    return {}, lambda: set_down(interface)


def plan_reset(words: Sequence[str]) -> Plan:
    """Take an interface back from bus-off."""
    (interface,) = words
    can_interface(interface)
    return {}, lambda: set_up(interface, None)


def plan_remember(words: Sequence[str]) -> Plan:
    """Keep name and bit rate of an adapter, or who may open a serial one."""
    if len(words) == 1:
        port, files = words[0], files_of_port(words[0])
    else:
        port = ""
        interface, name, bitrate = words
        can_interface(interface)
        new_name(name, interface)
        files = files_of_interface(interface, name, bit_rate(bitrate))
    outdated = superseded(files)
    marks = {"", *(each.splitlines()[0] for each in files.values())}
    if any(mark_of(each) not in marks for each in files):
        raise RefusedError("name_taken", words[-2] if port == "" else port)
    told = {str(path): text for path, text in files.items()}

    def do() -> dict[str, Any]:
        keep(files, outdated)
        return reload(port)

    return {"files": told, "removed": [str(each) for each in outdated]}, do


def plan_forget(words: Sequence[str]) -> Plan:
    """Take away what was kept."""
    (name,) = words
    if not (_NAME.fullmatch(name) or _KEPT_PORT.fullmatch(name)):
        raise RefusedError("bad_name", name[:40])
    ours = [each for each in places_of(name) if mark_of(each)]
    if not ours:
        raise RefusedError("not_kept", name)

    def do() -> dict[str, Any]:
        for each in ours:
            remove(each)
        return reload()

    return {"removed": [str(each) for each in ours]}, do


PLANS: dict[str, tuple[Callable[[Sequence[str]], Plan], tuple[int, ...]]] = {
    "up": (plan_up, (2,)),
    "down": (plan_down, (1,)),
    "reset": (plan_reset, (1,)),
    "remember": (plan_remember, (1, 3)),
    "forget": (plan_forget, (1,)),
}


def say(word: str, content: Mapping[str, Any]) -> None:
    """A line for the window."""
    sys.stdout.write(json.dumps({word: content}) + "\n")
    sys.stdout.flush()


def told_to_go() -> bool:
    """Whether «go» comes in time."""
    ready, _, _ = select.select([sys.stdin], [], [], GO_S)
    return bool(ready) and sys.stdin.readline(10).strip() == "go"


def main(words: Sequence[str]) -> int:
    """Do what a verb says; returns the exit code: 0 done, 1 not done, 2 not understood."""
    os.umask(0o022)
    verb, *rest = words or [""]
    plan, lengths = PLANS.get(verb, (plan_up, ()))
    if len(rest) not in lengths:
        say("refused", {"code": "bad_words", "text": verb[:40]})
        return 2
    try:
        told, do = plan(rest)
        say("plan", told)
        if not told_to_go():
            return 1
        say("done", do())
    except RefusedError as refused:
        say("refused", {"code": refused.code, "text": refused.text})
        return 1
    except OSError as error:
        say("refused", {"code": "system", "text": str(error)[-300:]})
        return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
