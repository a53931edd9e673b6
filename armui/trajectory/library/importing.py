"""Files that are brought into the library, each under a name that is free there."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from armui.arm.refusal import Reason, Refusal
from armui.cell.parts import part_named
from armui.kinematics.poses import Pose, apart
from armui.trajectory import columns, files
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import OF_FLANGE, PosesOf, Trajectory, Values, frames_in

if TYPE_CHECKING:
    from armui.cell.cell import Cell


TOOL_NOT_HERE = Reason(
    "tool_not_here",
    "{file} has poses of the tool “{name}”, which the cell does not have. The flange goes where it "
    "did there; the table shows the figures of the tool in force.",
)
TOOL_OTHERWISE = Reason(
    "tool_otherwise",
    "{file} has poses of the tool “{name}”, whose figures are others here. The flange goes where "
    "it did there, the tip elsewhere.",
)
FRAME_NOT_HERE = Reason(
    "frame_not_here",
    "{file} has points in the user frame “{name}”, which the cell does not have. They do not run "
    "until it is there, or they are given another frame.",
)
FRAME_ELSEWHERE = Reason(
    "frame_elsewhere",
    "{file} has points in the user frame “{name}”, which stands elsewhere here, by {distance} mm "
    "and {turned}°. The points go with it.",
)


@dataclass(frozen=True, slots=True)
class Imported:
    """The result of importing a file.

    Attributes:
        path: The file.
        name: The name of its content in the library; "" if it was not imported.
        requested: The name given in the file.
        error: The reason why it was not imported.
        is_table: True if it is in none of our formats but holds rows of figures.
        was_there: True if the library already had the same content under this name.
        poses_of: What its poses were of in the file, for the tool and the frames of its writer.
        frames: The user frames that its points name.
    """

    path: Path
    name: str = ""
    requested: str = ""
    error: TrajectoryFileError | LibraryError | None = None
    is_table: bool = False
    was_there: bool = False
    poses_of: PosesOf = OF_FLANGE
    frames: tuple[str, ...] = ()

    def differences(self, tool: Values, cell: Cell | None) -> Sequence[Refusal]:
        """Return the differences in tool and frames between here and where the file was written.

        Args:
            tool: The tool in force.
            cell: The cell that is chosen.
        """
        found: list[Refusal] = []
        theirs = self.poses_of.tool
        if theirs is not None:
            here = None if cell is None else part_named(cell.tools, theirs.name)
            pose = tool if here is None and not theirs.name else None if here is None else here.pose
            if pose is None:
                found.append(TOOL_NOT_HERE(file=self.path.name, name=theirs.name))
            elif pose != theirs.pose:
                name = theirs.name or "–"
                found.append(TOOL_OTHERWISE(file=self.path.name, name=name))
        stood = {frame.name: frame.pose for frame in self.poses_of.frames}
        for name in self.frames:
            frame = None if cell is None else part_named(cell.all_frames, name)
            if frame is None:
                found.append(FRAME_NOT_HERE(file=self.path.name, name=name))
            elif name in stood and stood[name] != frame.pose:
                off_mm, off_deg = apart(Pose(*stood[name]), Pose(*frame.pose))
                figures = {"distance": round(off_mm, 1), "turned": round(off_deg, 1)}
                found.append(FRAME_ELSEWHERE(file=self.path.name, name=name, **figures))
        return found


def find_or_import(folder: Path, path: Path, new_in: str = "") -> Imported:
    """Import a file, unless the library already has the same content under its name.

    Args:
        folder: The library's folder.
        path: The file; it may be one of the library's own.
        new_in: The sub-folder that it goes to, as `Library.new_in`.
    """
    library = Library(folder)
    library.new_in = new_in
    with contextlib.suppress(TrajectoryFileError, LibraryError):
        content, _poses_of = _load(path)
        kept = library.load(content.name)
        if replace(content, modified=kept.modified) == kept:
            return Imported(path, kept.name, kept.name, was_there=True)
    return _import_file(library, path)


def import_files(folder: Path, paths: Sequence[Path], new_in: str = "") -> list[Imported]:
    """Import the valid ones among some files.

    Args:
        folder: The library's folder.
        paths: The files.
        new_in: The sub-folder that they go to, as `Library.new_in`.

    Returns:
        One result for each file, in their order.
    """
    library = Library(folder)
    library.new_in = new_in
    return [_import_file(library, path) for path in paths]


def _load(path: Path) -> tuple[Content, PosesOf]:
    """Return the content of a file, ours or of another program, and what its poses are of.

    Raises:
        TrajectoryFileError: It is not read, or only as the operator says.
    """
    try:
        return files.load_with_origin(path)
    except TrajectoryFileError:
        with contextlib.suppress(TrajectoryFileError):
            found = columns.told_by_names(path, path.stem)
            if found is not None:
                return found, OF_FLANGE
        raise


def _import_file(library: Library, path: Path) -> Imported:
    try:
        content, poses_of = _load(path)
    except TrajectoryFileError as error:
        told, is_table = columns.look_closer(path, error)
        return Imported(path, error=told, is_table=is_table)
    try:
        name = library.free_name(content.name)
        library.save(replace(content, name=name))
    except LibraryError as error:
        return Imported(path, requested=content.name, error=error)
    points = content.points if isinstance(content, Trajectory) else ()
    return Imported(path, name, content.name, poses_of=poses_of, frames=frames_in(points))
