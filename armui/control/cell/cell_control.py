"""The cell in force: chosen by the operator, confirmed at each connection, changed while at rest.

While no cell is chosen, the tool of the settings applies and nothing is to be confirmed.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.models import STANDING, Rising
from armui.arm.refusal import Refusal
from armui.cell.cell import Cell, check_cell
from armui.cell.cell_in_force import CellInForce, cell_in_force
from armui.cell.checks import CELL_NAME_TAKEN
from armui.cell.tools import NO_TOOL, Tool
from armui.control.cell.arm_evidence import ArmEvidence, Likeness, evidence_of
from armui.control.cell.cell_reasons import (
    CAPTURE_MOVING,
    CAPTURE_STALE,
    CELL_ALREADY_CONFIRMED,
    CELL_GONE,
    CELL_HOLDING_NOT_CONFIRMED,
    CELL_NONE,
    CELL_NOT_CONFIRMED,
    CELL_NOT_READ,
    CELL_WHILE_MOVING,
    HELD_IN_HAND,
)
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import why_unreachable
from armui.control.motion.motion_command import End
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from armui.arm.device import Device
    from armui.arm.held_shape import HeldShape
    from armui.cell.user_frames import UserFrame
    from armui.control.cell.cell_keeper import CellKeeper
    from armui.control.context import Context
    from armui.control.motion.cartesian import Cartesian
    from armui.control.operating_state import OperatingState

CELL_CHOSEN = Notice("cell_chosen", "Cell in force: {name}", Level.INFO, EventKind.COMMAND)
CELL_LEFT = Notice("cell_left", "No cell is in force", Level.INFO, EventKind.COMMAND)
CELL_CHANGED = Notice("cell_changed", "Cell changed: {name}", Level.INFO, EventKind.COMMAND)
CELL_RENAMED = Notice("cell_renamed", "Cell renamed: {name}", Level.INFO, EventKind.COMMAND)
CELL_DELETED = Notice("cell_deleted", "Cell deleted: {name}", Level.INFO, EventKind.COMMAND)
CELL_CONFIRMED = Notice("cell_confirmed", "Cell confirmed: {name}", Level.INFO, EventKind.COMMAND)
HELD_NOW = Notice(
    "held_now", "From here on the gripper holds “{name}”.", Level.INFO, EventKind.COMMAND
)
HELD_NOTHING = Notice(
    "held_nothing", "From here on the gripper holds nothing.", Level.INFO, EventKind.COMMAND
)
CELL_STAYS = Notice(
    "cell_stays",
    "The same arm answers after {seconds} s of silence: the cell “{name}” stays in force.",
    Level.INFO,
    EventKind.STATUS,
    Asker.PROGRAM,
)
HELD_OPENED = Notice(
    "held_opened",
    "The gripper has opened to {value} mm. “{name}” counts as held until it is let go under Cell, "
    "Held.",
    Level.WARNING,
    EventKind.STATUS,
    Asker.PROGRAM,
)
CELL_PROBLEM = Notice("cell_problem", "Cell: {reason}", Level.WARNING, EventKind.PROGRAM)


_OPENED_MM: Final = 5.0
"""A gripper that opens this much further than it was with something in it may have let go."""


def why_not_change(now: OperatingState) -> Refusal | None:
    """Return why cells may not be changed: a motion was checked with the one in force."""
    return now.occupied or (CELL_WHILE_MOVING() if now.moving else None)


class CellControl(ControllerPart):
    """Holds the cells and the one in force.

    Args:
        context: The context that the controller's parts share.
        cartesian: Gets the tool in force.
        announce: Called after every change, with this object's :attr:`cell`.

    Attributes:
        store: Keeps the cells; ``None`` if they end with the program, as in a replay.
        candidate: A user frame that is shown before it is taken; nothing moves by it.
        arms: Grows with each arm that comes and has not shown that it is the one before: what was
            measured of one says nothing of another.
    """

    def __init__(
        self, context: Context, cartesian: Cartesian, announce: Callable[[object], object]
    ) -> None:
        self._context = context
        self._cartesian = cartesian
        self._announce = announce
        self._cells: dict[str, Cell] = {}
        self._broken: dict[str, Refusal] = {}
        self._name = ""
        self._confirmed = False
        self._evidence: ArmEvidence | None = None
        self._came_s: float | None = None
        """When an arm came after a silence; ``None`` once it is known to be the same or not."""
        self._device: Device | None = None
        self._own_tool: tuple[float, ...] = NO_TOOL
        self._wanted_tool: tuple[float, ...] = NO_TOOL
        self._least_mm: float | None = None
        self._opened = False
        self.arms = 0
        self.store: CellKeeper | None = None
        self.candidate: UserFrame | None = None

    # State ----------------------------------------------------------------------------------

    @property
    def cells(self) -> Mapping[str, Cell]:
        """All cells by name."""
        return self._cells

    @property
    def broken(self) -> Mapping[str, Refusal]:
        """The reasons against the files that were refused, by the name of the cell."""
        return self._broken

    @property
    def cell(self) -> Cell | None:
        """The chosen cell, also while it is not confirmed; ``None`` without one."""
        return self._cells.get(self._name)

    @property
    def in_force(self) -> Cell | None:
        """The chosen cell once it is confirmed for this connection, or while none is open."""
        return self.cell if self.confirmed else None

    @property
    def confirmed(self) -> bool:
        """True if nothing is to be confirmed: no cell, an empty one, or no open device."""
        return self.unconfirmed is None

    @property
    def unconfirmed(self) -> Refusal | None:
        """The reason against a motion as long as the cell is not confirmed, or ``None``."""
        if self._device is None or not self._name or self._confirmed:
            return None
        if self.cell is None:
            return CELL_NOT_READ(name=self._name)
        if self.cell.held:
            return CELL_HOLDING_NOT_CONFIRMED(name=self._name, held=self.cell.held)
        return None if self.cell.is_empty else CELL_NOT_CONFIRMED(name=self._name)

    def holding(self) -> CellInForce:
        """Return the parts of the cell in force; without a cell the tool of the settings."""
        cell = self.in_force
        return CellInForce(tool=Tool("", self._own_tool)) if cell is None else cell_in_force(cell)

    @property
    def tool_name(self) -> str:
        """The name of the tool in force; "" without a cell or a tool."""
        return "" if self.in_force is None else self.in_force.tool

    @property
    def rising(self) -> Rising:
        """The tilt of the base in the room, before the cell is confirmed, too."""
        return STANDING if self.cell is None else self.cell.placement.rising

    @property
    def held_shape(self) -> HeldShape | None:
        """The shape of what the hand holds, or ``None``; it counts before it is confirmed, too."""
        held = None if self.cell is None else self.cell.held_object
        if held is None:
            return None
        from armui.cell.held_shape import held_shape  # noqa: PLC0415 - numpy

        return held_shape(held)

    # Changes by the program -----------------------------------------------------------------

    def use_own_tool(self, tool: tuple[float, ...]) -> None:
        """Take the tool of the settings, which holds while no cell is in force; at rest."""
        self._wanted_tool = tool
        if self._context.rests:
            self._own_tool = tool
            self._take_effect()

    def take_loaded(self, cells: Mapping[str, Cell | Refusal]) -> None:
        """Take the cells that were read, with the reasons against those that are broken.

        A cell that this program has made or changed meanwhile stays.
        """
        for name, cell in cells.items():
            if isinstance(cell, Refusal):
                self._broken[name] = cell
                self._context.emit_event(CELL_PROBLEM, reason=cell)
            else:
                self._cells.setdefault(name, cell)
        self._take_effect()

    def give_name(self, name: str, other: str) -> None:
        """Give a cell another name, or its former one because its file could not be renamed."""
        if name in self._cells:
            self._cells[other] = replace(self._cells.pop(name), name=other)
            self._name = other if self._name == name else self._name
            self._take_effect()

    def report_problem(self, reason: Refusal) -> None:
        """Tell the operator why a cell could not be saved or deleted."""
        self._context.emit_event(CELL_PROBLEM, reason=reason)

    def propose(self, frame: UserFrame | None) -> None:
        """Show a user frame as a candidate before it is taken; ``None`` shows none any more."""
        if frame != self.candidate:
            self.candidate = frame
            self._announce(self.cell)

    def begin_device(self, device: Device) -> None:
        """Choose the cell kept for a device being opened; nothing moves before it is confirmed."""
        self._device = device
        self._name = "" if self.store is None else self.store.kept(device.arm_key())
        self.forget_arm()

    def end_device(self) -> None:
        """Note that the operator has closed the device; the cell stays chosen."""
        self._device = None
        self.use_own_tool(self._wanted_tool)

    def forget_arm(self) -> None:
        """Require the cell to be confirmed again: the next arm heard may be another one."""
        self._confirmed, self._evidence, self._came_s = False, None, None
        self.arms += 1
        self._take_effect()

    def arm_came(self) -> None:
        """Require the cell to be confirmed again, unless the arm proves to be the former one.

        Nothing moves until the arm has answered.
        """
        in_force = self.confirmed or self._came_s is not None
        self._confirmed, self._came_s = False, None
        if in_force and self._evidence is not None:
            self._came_s = self._context.clock()
        else:
            self.arms += 1
        self._take_effect()

    def _recognise(self) -> None:
        """Keep what the arm of the cell shows of itself; after a silence compare it."""
        connection, state = self._context.connection, self._context.state()
        if self._came_s is None or self._evidence is None:
            if self.confirmed and connection.arm is not None:
                self._evidence = evidence_of(state, connection.handshake)
            return
        before_s, waits = self._evidence.heard_s, self.unconfirmed is not None
        likeness = self._evidence.likeness(state, connection.handshake, self._came_s)
        if likeness is Likeness.NOT_KNOWN:
            return
        silent_s, self._came_s = self._came_s - before_s, None
        if likeness is Likeness.OTHER:
            self._evidence = None
            self.arms += 1
            return
        self._confirmed = True
        self._take_effect()
        if waits:
            self._context.emit_event(CELL_STAYS, name=self._name, seconds=round(silent_s, 1))
            self._context.refresh()

    # What the operator does -----------------------------------------------------------------

    @operation("cell.take", "Make or import a cell", why_not_change)
    def take(self, started: Started, cell: Cell, *, replacing: bool = False) -> Refusal | None:
        """Add a cell, and put it in force.

        Args:
            started: The record of the command.
            cell: The cell.
            replacing: True if it may take the place of one of its name; a file of that name that
                could not be read is put aside.
        """
        others = {*self._cells, *self._broken} - ({cell.name} if replacing else set())
        taken = cell.name.casefold() in map(str.casefold, others)
        same = CELL_NAME_TAKEN(value=cell.name) if taken else None
        if refusal := check_cell(cell) or same or self._why_holding_for(cell):
            return refusal
        notice = CELL_CHANGED if cell.name in self._cells else CELL_CHOSEN
        self._broken.pop(cell.name, None)
        self._save(cell)
        self._put_in_force(cell.name)
        self._done(started, notice, cell.name)
        return None

    @operation("cell.choose", "Choose the cell", why_not_change)
    def choose(self, started: Started, name: str) -> Refusal | None:
        """Put a cell in force, by the operator's choice; "" for none."""
        unknown = None
        if name and name not in self._cells:
            unknown = self._broken.get(name) or CELL_GONE(name=name)
        if refusal := unknown or self._why_holding():
            return refusal
        self._put_in_force(name)
        notice = CELL_CHOSEN if name else CELL_LEFT
        self._done(started, notice, name)
        return None

    @operation("cell.confirm", "Confirm the cell", why_not_change)
    def confirm(self, started: Started) -> Refusal | None:
        """Confirm that the kept cell is that of the connected arm."""
        waits = self.unconfirmed
        unread = waits if self.cell is None else None
        if refusal := CELL_ALREADY_CONFIRMED() if waits is None else unread:
            return refusal
        self._put_in_force(self._name)
        self._done(started, CELL_CONFIRMED, self._name)
        return None

    @operation("cell.change", "Change the cell", why_not_change)
    def change(self, started: Started, cell: Cell) -> Refusal | None:
        """Replace the chosen cell by a changed one of the same name."""
        other = CELL_GONE(name=cell.name) if cell.name != self._name else None
        holding = None if cell.held else self._why_holding()
        none = CELL_NONE() if self.cell is None else None
        if refusal := self.unconfirmed or none or other or holding or check_cell(cell):
            return refusal
        self._save(cell)
        self._confirmed, self._came_s = True, None
        self._take_effect()
        self._done(started, CELL_CHANGED, cell.name)
        return None

    @operation("cell.rename", "Rename the cell", why_not_change)
    def rename(self, started: Started, name: str) -> Refusal | None:
        """Give the chosen cell and its file another name; it stays in force."""
        cell = self.cell
        if cell is None:
            return CELL_NONE()
        taken = name.casefold() in map(str.casefold, {*self._cells, *self._broken} - {self._name})
        same = CELL_NAME_TAKEN(value=name) if taken or name == self._name else None
        renamed = check_cell(replace(cell, name=name))
        if refusal := self.unconfirmed or same or renamed:
            return refusal
        self._confirmed = True
        self.give_name(cell.name, name)
        self._done(started, CELL_RENAMED, name)
        if self.store is not None:
            self.store.rename(cell.name, self._cells[name])
        return None

    @operation("cell.delete", "Delete the cell", why_not_change)
    def delete(self, started: Started) -> Refusal | None:
        """Delete the chosen cell and its file; none is in force then."""
        name = self._name
        if refusal := self._why_holding() if name else CELL_NONE():
            return refusal
        self._cells.pop(name, None)
        self._broken.pop(name, None)
        if self.store is not None:
            self.store.delete(name)
        self._put_in_force("")
        self._done(started, CELL_DELETED, name)
        return None

    @operation("cell.hold", "Say what the gripper holds", why_not_change)
    def hold(self, started: Started, name: str) -> Refusal | None:
        """Count an object as held from now on, or nothing for ""; also before it is confirmed."""
        cell = self.cell
        refusal = CELL_NONE() if cell is None else check_cell(replace(cell, held=name))
        if refusal is not None:
            return refusal
        self._hold(name)
        self._done(started, HELD_NOW if name else HELD_NOTHING, name)
        return None

    def note_held(self, name: str) -> None:
        """Take what a point of a run says of the hand; the run was checked with it."""
        if self.cell is not None and name != self.cell.held:
            self._hold(name)
            self._context.emit_event(
                HELD_NOW if name else HELD_NOTHING, **({"name": name} if name else {})
            )

    def _hold(self, name: str) -> None:
        if self.cell is not None:
            self._save(replace(self.cell, held=name))
            self._least_mm, self._opened = None, False
            self._take_effect()

    def follow_arm(self) -> None:
        """Follow other programs' choice of the cell, the arm's identity, and the gripper."""
        self._follow_kept()
        if self._wanted_tool != self._own_tool:
            self.use_own_tool(self._wanted_tool)
        self._recognise()
        self._follow_gripper()

    def _follow_gripper(self) -> None:
        """Warn when the gripper has opened although an object is marked as held."""
        cell, gripper = self.cell, self._context.state().gripper
        opening_mm = None if gripper is None else gripper.value.opening_mm
        if cell is None or not cell.held or opening_mm is None:
            return
        if self._least_mm is None or opening_mm < self._least_mm:
            self._least_mm = opening_mm
        elif not self._opened and opening_mm > self._least_mm + _OPENED_MM:
            self._opened = True
            self._context.emit_event(HELD_OPENED, name=cell.held, value=round(opening_mm))

    def _follow_kept(self) -> None:
        """Take the cell that another program keeps for this adapter, unless one was chosen here."""
        if self._device is None or self._confirmed or self.store is None:
            return
        name = self.store.kept(self._device.arm_key())
        if name != self._name and why_not_change(self._context.operating_state()) is None:
            self._name = name
            self._take_effect()

    def why_not_capture(self) -> Refusal | None:
        """Return why the pose of the flange cannot be taken for the cell now, or ``None``."""
        return CELL_NONE() if self.cell is None else self.why_no_pose()

    def why_no_pose(self) -> Refusal | None:
        """Return why the pose of the flange cannot be taken now, or ``None``.

        Only a measured pose counts, of an arm that is heard and at rest.
        """
        context = self._context
        now = context.operating_state()
        if (unreachable := why_unreachable(now.link)) is not None:
            return unreachable
        state, now_s = context.state(), context.clock()
        heard = (*state.pose, *state.joints_deg)
        if any(each is not None and not each.fresh(now_s) for each in heard):
            return CAPTURE_STALE()
        moving = None if context.authority.at_rest else CAPTURE_MOVING()
        return self._cartesian.why_unknown() or moving

    def capture(self) -> tuple[float, ...] | Refusal:
        """Return the measured pose of the flange, or why it cannot be taken."""
        self._context.refresh()
        refusal = self.why_not_capture()
        pose = self._context.state().end_pose()
        if refusal is not None or pose is None:
            return self._context.refuse(refusal or CAPTURE_STALE())
        return tuple(pose)

    def _why_holding(self) -> Refusal | None:
        """Return why another cell may not be chosen: the held object would no longer count."""
        held = "" if self.in_force is None else self.in_force.held
        return HELD_IN_HAND(name=held) if held else None

    def _why_holding_for(self, cell: Cell) -> Refusal | None:
        """Return why a cell may not take the place of the one in force, and of that of its name."""
        marked = self._cells.get(cell.name)
        if marked is not None and marked.held and not cell.held:
            return HELD_IN_HAND(name=marked.held)
        same = self.in_force is not None and cell.name == self._name
        return None if same else self._why_holding()

    def _save(self, cell: Cell) -> None:
        self._cells[cell.name] = cell
        if self.store is not None:
            self.store.save(cell)

    def _put_in_force(self, name: str) -> None:
        self._name, self._confirmed, self._came_s = name, True, None
        if self._device is not None and self.store is not None:
            self.store.keep(self._device.arm_key(), name)
        self._take_effect()

    def _done(self, started: Started, notice: Notice, name: str) -> None:
        started.close(Ending.DONE)
        figures = {"name": name} if name else {}
        self._context.emit_event(notice, started, **figures)
        self._context.refresh()

    def _take_effect(self) -> None:
        """Pass on the tool; if it has changed, no step starts from our last target any more."""
        holding = self.holding()
        tool = holding.tool.pose
        self._cartesian.tool_radius_mm = holding.tool.radius_mm
        self._cartesian.frame = holding.frame
        if tool != self._cartesian.tool:
            self._cartesian.tool = tool
            self._context.authority.end_command(End.TOOL_CHANGED)
        self._context.authority.unconfirmed_cell = self.unconfirmed
        self._announce(self.cell)
