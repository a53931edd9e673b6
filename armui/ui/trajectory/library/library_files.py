"""导入文件 and 导出文件: files chosen in windows that hold the emergency stop."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QFileDialog, QWidget

from armui.control.arm_controller import ArmController
from armui.system.atomic import write_whole
from armui.system.files import error_text
from armui.trajectory import files
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library.file_names import file_stem
from armui.trajectory.library.store import Library, LibraryError
from armui.ui.dialogs.files import FileDialog, choose_file

_PATTERNS: Final = "*.log *.csv *.json *.npz *.txt"

Problem = tuple[str, str]
"""The name of a file or trajectory, and what is wrong with it in the system's words."""


def choose_imports(
    parent: QWidget, controller: ArmController, on_chosen: Callable[[list[Path]], object]
) -> FileDialog:
    """Let the operator choose files to import, several at once."""
    kinds = QCoreApplication.translate("LibraryFiles", "Trajectories")
    every = QCoreApplication.translate("LibraryFiles", "All files")
    dialog = FileDialog(
        controller,
        parent,
        title=QCoreApplication.translate("LibraryFiles", "Import files"),
        name_filter=f"{kinds} ({_PATTERNS});;{every} (*)",
    )
    dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
    dialog.filesSelected.connect(lambda names: on_chosen([Path(name) for name in names]))
    dialog.show()
    return dialog


def choose_export(
    parent: QWidget,
    controller: ArmController,
    name: str,
    suffix: str,
    on_chosen: Callable[[Path], object],
) -> FileDialog:
    """Let the operator say to which file one trajectory is written."""
    return choose_file(
        parent,
        controller,
        title=QCoreApplication.translate("LibraryFiles", "Export file"),
        name_filter=f"{suffix} (*{suffix})",
        on_chosen=on_chosen,
        new_file=file_stem(name) + suffix,
    )


def choose_folder(
    parent: QWidget, controller: ArmController, on_chosen: Callable[[Path], object]
) -> FileDialog:
    """Let the operator say into which folder several trajectories are written."""
    dialog = FileDialog(
        controller,
        parent,
        title=QCoreApplication.translate("LibraryFiles", "Export files into a folder"),
        name_filter="*",
    )
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly, on=True)
    dialog.fileSelected.connect(lambda chosen: on_chosen(Path(chosen)))
    dialog.show()
    return dialog


def write_one(content: Content, path: Path) -> Problem | None:
    """Write a trajectory to a file, whole or not at all: ``None``, or what the system says."""
    try:
        write_whole(path, files.to_bytes(content, path.suffix))
    except (OSError, ValueError) as error:
        return path.name, error_text(error)
    return None


Failure = Problem | LibraryError | TrajectoryFileError
"""Why one of several trajectories was not written."""


def write_all(
    library: Library, names: Sequence[str], path_of: Callable[[str], Path]
) -> tuple[list[str], list[Failure]]:
    """Write trajectories of the library to files, each by itself.

    Returns:
        The names of the files written, and what speaks against the others.
    """
    written: list[str] = []
    failures: list[Failure] = []
    for name in names:
        try:
            content = library.load(name)
        except (LibraryError, TrajectoryFileError) as error:
            failures.append(error)
            continue
        path = path_of(name)
        problem = write_one(content, path)
        if problem is None:
            written.append(path.name)
        else:
            failures.append(problem)
    return written, failures


def free_path(folder: Path, name: str, suffix: str) -> Path:
    """Where a trajectory can be written in a folder without writing over anything."""
    stem = file_stem(name)
    path, number = folder / f"{stem}{suffix}", 1
    while path.exists():
        number += 1
        path = folder / f"{stem} {number}{suffix}"
    return path
