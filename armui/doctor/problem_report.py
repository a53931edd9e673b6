"""Collects the report of a problem, one zip file, which the operator sees before it is saved.

Nothing is sent anywhere. Qt is not needed, and packages that are missing leave their part out.
"""

from __future__ import annotations

import json
import platform
import sys
import time
import zipfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Final

from armui import __version__
from armui.arm.refusal import Reason, Refusal
from armui.system.atomic import WholeFile
from armui.system.command_process import is_packaged
from armui.system.files import error_text, read_file

REPORT_EXISTS = Reason(
    "report_exists", "{path} exists already, and is left as it is. Choose another name."
)
REPORT_NOT_SAVED = Reason(
    "report_not_saved",
    "The report could not be saved as {path}: {text}. Free some room or choose another folder.",
)

BUS_FILE: Final = "bus/last-minutes.log"
"""Frames as `candump -L` writes them; the program replays it."""
_MOST_LOG_BYTES: Final = 5_000_000
_LOG_S: Final = 14 * 86_400.0
"""The greatest age of a log: older ones do not help with a present problem."""


@dataclass(frozen=True, slots=True)
class ReportFile:
    """A file of the report.

    Attributes:
        name: Its place in the zip file.
        data: Its bytes: text in UTF-8.
    """

    name: str
    data: bytes


def doctor_files(text: str, as_json: str) -> list[ReportFile]:
    """Return the findings of the doctor: for people, and with their codes."""
    return [
        ReportFile("doctor.txt", without_home(text).encode()),
        ReportFile("doctor.json", without_home(as_json).encode()),
    ]


def collect(
    found: Sequence[ReportFile], settings: Path | None = None, logs: Path | None = None
) -> tuple[ReportFile, ...]:
    """Return the findings with versions, settings and logs as files; waits for the disk.

    Args:
        found: The findings of the doctor.
        settings: The program's file of settings; its usual place by default.
        logs: The folder of the program's logs; its usual place by default.
    """
    versions = ReportFile("versions.txt", versions_text().encode())
    return (*found, versions, _settings_file(settings), *_log_files(logs))


def versions_text() -> str:
    """Return the versions of the program, of Python, of the system and of all Python packages."""
    way = "installed package" if is_packaged() else "Python's packages, or the source"
    installed = sorted(
        {f"{each.metadata['Name']} {each.version}" for each in metadata.distributions()},
        key=str.lower,
    )
    lines = [
        f"armui {__version__} ({way})",
        f"Python {sys.version.split()[0]} ({platform.python_implementation()})",
        f"{platform.system()} {platform.release()} {platform.version()} {platform.machine()}",
        *_distribution(),
        "",
        *installed,
    ]
    return "\n".join(lines) + "\n"


def _distribution() -> Iterator[str]:
    try:
        yield platform.freedesktop_os_release().get("PRETTY_NAME", "")
    except OSError:  # not Linux, or an odd one
        return


def without_home(text: str) -> str:
    """Return a text in which the user's folder, whose name is private, is called ~."""
    home = str(Path.home())
    if len(home) < 2:  # a home of "/" would match everywhere
        return text
    return text.replace(json.dumps(home)[1:-1], "~").replace(home, "~")


def _settings_file(path: Path | None) -> ReportFile:
    """Return the settings that the program knows; the rest of the file is not passed on."""
    name = "settings.json"
    try:
        from armui.setting_fields import DECLARED  # noqa: PLC0415 - beside what may be missing
        from armui.settings import default_path  # noqa: PLC0415 - filelock

        entries = json.loads(read_file(path or default_path(), 1_000_000))
        kept = {key: value for key, value in entries.items() if key in DECLARED}
    except FileNotFoundError:
        return ReportFile(name, b"{}\n")
    except (OSError, ValueError, ImportError, AttributeError, RecursionError) as error:
        return ReportFile(name, f"could not be read: {error_text(error)}\n".encode())
    text = json.dumps(kept, indent=2, ensure_ascii=False) + "\n"
    return ReportFile(name, without_home(text).encode("utf-8", "replace"))


def _log_files(folder: Path | None) -> list[ReportFile]:
    """Return the logs of the last two weeks, the newest first, up to a limit."""
    left = _MOST_LOG_BYTES
    files = []
    try:
        from armui.system.paths import logs  # noqa: PLC0415 - platformdirs

        paths = (folder or logs()).glob("armui*.log*")
        found = [(each.stat().st_mtime, each) for each in paths]
    except (OSError, ImportError) as error:
        return [ReportFile("log/unread.txt", f"{error_text(error)}\n".encode())]
    for at_s, path in sorted(found, reverse=True):
        if time.time() - at_s > _LOG_S or left <= 0:
            break
        try:
            text = read_file(path).decode("utf-8", "replace")
        except OSError as error:
            text = f"could not be read: {error_text(error)}\n"
        data = without_home(text).encode()[-left:]
        left -= len(data)
        files.append(ReportFile(f"log/{path.name}", data))
    return files


def save(path: Path, files: Sequence[ReportFile]) -> Path | Refusal:
    """Write the zip file, whole or not at all; no file is ever replaced. Waits for the disk.

    Returns:
        The file, or why there is none.
    """
    try:
        with WholeFile(path, replace=False) as whole:
            with zipfile.ZipFile(whole.stream, "w", zipfile.ZIP_DEFLATED) as archive:
                for each in files:
                    archive.writestr(each.name, each.data)
            whole.finish()
    except FileExistsError:
        return REPORT_EXISTS(path=str(path))
    except (OSError, ValueError) as error:
        return REPORT_NOT_SAVED(path=str(path), text=error_text(error))
    return path
