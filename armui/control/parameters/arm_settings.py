"""Reads, sets, reads back and compares the arm's parameters (manual 1.0.7.4–1.0.7.6)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.arm.limits import JOINTS
from armui.arm.parameters import Batch, Group, Parameter, all_batches, reading_of
from armui.arm.quirks import why_not_by_firmware
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.context import Context, ControllerPart, why_not_asked
from armui.control.events import Notice
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, declare, operation
from armui.control.operations.started import Ending, Started, ending_of
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import (
    SETTING_NOT_TAKEN,
    Changes,
    batches_of,
    frame_values,
    not_taken,
    why_not,
)
from armui.control.parameters.setting_frames import INDEX, query_frames, setting_frames
from armui.control.requests.transactions import ReadBack, Transaction, TransactionQueue
from armui.protocol import commands
from armui.protocol.codes import SettingIndex
from armui.protocol.generation import Generation
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame

SETTING_NOT_KEPT = Reason(
    "setting_not_kept",
    "This arm's protocol (generation {generation}) has no such settings; generation 2 has.",
)
SETTINGS_SENT = Notice(
    "settings_sent", "Settings sent to the arm: {count}", Level.INFO, EventKind.COMMAND
)
SETTINGS_SAVED = Notice(
    "settings_saved", "Settings saved and read back: {settings}", Level.DONE, EventKind.RESULT
)
SETTINGS_REFUSED = Notice(
    "settings_refused",
    "{count} of {total} settings did not take effect. {reason}",
    Level.FAULT,
    EventKind.RESULT,
)
SETTINGS_RESET_SENT = Notice(
    "settings_reset_sent", "Restoring the factory values", Level.INFO, EventKind.COMMAND
)
SETTINGS_RESET = Notice(
    "settings_reset",
    "The arm has confirmed its factory values; the fields show what is read back.",
    Level.DONE,
    EventKind.RESULT,
)
SETTINGS_RESET_FAILED = Notice(
    "settings_reset_failed",
    "The arm has not confirmed its factory values. {reason}",
    Level.FAULT,
    EventKind.RESULT,
)


_JOINT_BATCHES: Final = tuple(
    Batch(group, joint)
    for joint in JOINTS
    for group in (Group.JOINT_LIMITS, Group.JOINT_ACCELERATION)
)


_SECOND_ONLY: Final = frozenset({Group.TEACHING, Group.DRAG_ASSISTANCE})
_UNREAD: Final = SettingCellState()


def why_no_settings(now: OperatingState) -> Refusal | None:
    """Return why parameters may not be set, or ``None``."""
    return why_not_asked(now) or now.occupied or now.why_pending("settings")


class ArmSettings(QObject, ControllerPart):
    """Follows the state of every parameter; :class:`ArmState` has the values last heard.

    Args:
        context: The context that the controller's parts share.
        transactions: Carries out commands that are answered.

    Signals:
        changed: The state of some parameter has changed.
        finished: All reading and saving has ended.
    """

    changed = Signal()
    finished = Signal()

    def __init__(
        self, context: Context, transactions: TransactionQueue, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._context = context
        self._transactions = transactions
        self._cells: dict[Parameter, SettingCellState] = {}
        self._open = 0
        self._saving: list[Parameter] = []
        self._started: Started | None = None

    @property
    def busy(self) -> bool:
        """True if something is being read or saved."""
        return self._open > 0

    def cell(self, parameter: Parameter) -> SettingCellState:
        """Return the state of a parameter between the program and the arm."""
        cell = self._cells.get(parameter, _UNREAD)
        if cell.state not in {CellState.READ, CellState.SAVED}:
            return cell
        # After the arm was away a value counts as unread until the arm has said it again (S15).
        return _UNREAD if reading_of(self._context.state(), parameter) is None else cell

    def everything(self) -> list[Batch] | Refusal:
        """Return the batches that a backup holds, or why they are not known now."""
        refusal = self._context.why_unknown()
        if refusal is not None:
            return refusal
        generation = self._context.connection.generation
        second = generation is Generation.TWO
        assistance = second and self.why_not_kept([Batch(Group.DRAG_ASSISTANCE)]) is None
        return list(all_batches(teaching=second, drag_assistance=assistance))

    def holds(self, parameter: Parameter, value: float) -> bool:
        """Return whether the arm reported this value last, as far as its frames can express it.

        It may be called only while a device is open.
        """
        state = self._context.state()
        codec = self._context.connection.codec
        return reading_of(state, parameter) is not None and not not_taken(
            codec, state, {parameter: value}
        )

    def why_not_kept(self, batches: Iterable[Batch]) -> Refusal | None:
        """Return why this arm has no such parameters: its generation, or its firmware, has none."""
        generation = self._context.connection.generation
        groups = {batch.group for batch in batches}
        if generation is Generation.ONE and groups & _SECOND_ONLY:
            return SETTING_NOT_KEPT(generation=int(generation))
        if generation is Generation.TWO and Group.DRAG_ASSISTANCE in groups:
            return why_not_by_firmware(self._context.state(), "has_drag_assistance")
        return None

    # What the operator wants ------------------------------------------------------------------

    @declare("settings.read", "Read parameters", why_not_asked)
    def read(self, batches: Iterable[Batch]) -> Refusal | None:
        """Ask the arm for batches; those being read or saved already are left alone.

        Returns:
            ``None`` if the arm was asked, or why not.
        """
        batches = list(batches)
        refusal = self._context.why_unknown() or self.why_not_kept(batches)
        if refusal is not None:
            return refusal
        for batch in batches:
            if not any(
                self.cell(parameter).state in {CellState.READING, CellState.SAVING}
                for parameter in batch.parameters()
            ):
                self._read(batch)
        self.changed.emit()
        return None

    @operation("settings.save", "Set parameters", why_no_settings, shown_first=True)
    def save(self, started: Started, changes: Changes) -> Refusal | None:
        """Set parameters and read back whether the arm has taken them.

        Only these are changed; the other fields of a frame are marked «leave unchanged» (generation
        2) or sent as they were read.

        Args:
            started: The record of the command.
            changes: New values in the operator's units.

        Returns:
            Why nothing was sent, or ``None``.
        """
        codec, state = self._context.connection.codec, self._context.state()
        refusal = (
            self._context.why_moving()
            or self.why_not_kept(batches_of(changes))
            or why_not(codec, state, changes)
        )
        if refusal is not None:
            return refusal
        values = tuple((each.name, each.joint, value) for each, value in changes.items())
        self._context.emit_event(SETTINGS_SENT, started, count=len(changes), values=values)
        self._saving, self._started = list(changes), started
        batches = batches_of(changes)
        self._submit(*(self._save(started, codec, batch, changes) for batch in batches))
        self.changed.emit()
        return None

    @operation(
        "settings.reset_end_limits",
        "Restore the factory limits of the end",
        why_no_settings,
        consent=Consent.PRESS,
    )
    def reset_end_limits(self, started: Started) -> Refusal | None:
        """【初始化】: restore the end's factory limits (0x477) and read them back."""
        return self._reset(started, commands.reset_end_limits, [Batch(Group.END_LIMITS)])

    @operation(
        "settings.reset_joint_limits",
        "Restore the factory limits of the joints",
        why_no_settings,
        consent=Consent.PRESS,
    )
    def reset_joint_limits(self, started: Started) -> Refusal | None:
        """Restore all joints' factory limits, speeds and accelerations (0x477)."""
        return self._reset(started, commands.reset_joint_limits, _JOINT_BATCHES)

    def settle(self, parameters: Iterable[Parameter]) -> None:
        """Forget the outcome of the last saving of parameters, which the operator has seen."""
        for parameter in parameters:
            if self.cell(parameter).state in {CellState.SAVED, CellState.REFUSED}:
                known = reading_of(self._context.state(), parameter)
                self._cells[parameter] = (
                    _UNREAD if known is None else SettingCellState(CellState.READ)
                )
        self.changed.emit()

    # Carrying out -----------------------------------------------------------------------------

    def _read(self, batch: Batch) -> None:
        self._mark(batch.parameters(), SettingCellState(CellState.READING))
        self._submit(
            Transaction((), partial(self._after_reading, batch), read_back=self._back(batch))
        )

    def _save(self, started: Started, codec: Codec, batch: Batch, changes: Changes) -> Transaction:
        values = frame_values(codec, self._context.state(), batch, changes)
        wanted = {parameter: changes[parameter] for parameter in values if parameter in changes}
        self._mark(wanted, SettingCellState(CellState.SAVING))
        return Transaction(
            setting_frames(codec, batch, values),
            partial(self._after_saving, wanted),
            INDEX[batch.group],
            started=started,
            read_back=self._back(batch, wanted),
            recheck=self._why_not_any_more,
            alters="settings",
        )

    def _back(self, batch: Batch, wanted: Changes | None = None) -> ReadBack:
        codec = self._context.connection.codec
        first = batch.parameters()[0]

        def heard_since(state: ArmState, since_s: float) -> bool:
            known = reading_of(state, first)
            return known is not None and known.at_s > since_s

        def against(state: ArmState) -> Refusal | None:
            return next(iter(not_taken(codec, state, wanted or {}).values()), None)

        return ReadBack(query_frames(codec, batch), heard_since, against)

    def _reset(
        self,
        started: Started,
        command: Callable[[Codec], Sequence[Frame]],
        batches: Sequence[Batch],
    ) -> Refusal | None:
        refusal = self._context.why_moving()
        if refusal is not None:
            return refusal
        for batch in batches:
            self._mark(batch.parameters(), SettingCellState(CellState.READING))
        self._context.emit_event(SETTINGS_RESET_SENT, started)
        self._submit(
            Transaction(
                command(self._context.connection.codec),
                partial(self._after_reset, started, batches),
                SettingIndex.PARAMETER_COMMAND,
                started=started,
                recheck=self._why_not_any_more,
                alters="settings",
            )
        )
        self.changed.emit()
        return None

    def _why_not_any_more(self) -> Refusal | None:
        """Return what has come up since the press against setting parameters."""
        return self._context.operating_state().occupied or self._context.why_moving()

    def _submit(self, *transactions: Transaction) -> None:
        self._open += len(transactions)
        self._transactions.submit(*transactions)

    # The end of a reading or saving -----------------------------------------------------------

    def _after_reading(self, batch: Batch, refusal: Refusal | None) -> None:
        state = CellState.READ if refusal is None else CellState.REFUSED
        self._mark(batch.parameters(), SettingCellState(state, refusal))
        self._closed()

    def _after_saving(self, wanted: Changes, refusal: Refusal | None) -> None:
        differing = {}
        if refusal is not None and refusal.reason == SETTING_NOT_TAKEN:
            codec = self._context.connection.codec
            differing = not_taken(codec, self._context.state(), wanted)
        for parameter in wanted:
            reason = differing.get(parameter) if differing else refusal
            state = CellState.SAVED if reason is None else CellState.REFUSED
            self._mark([parameter], SettingCellState(state, reason))
        self._closed()
        if not any(self.cell(each).state is CellState.SAVING for each in self._saving):
            self._emit_saved()

    def _after_reset(
        self, started: Started, batches: Sequence[Batch], refusal: Refusal | None
    ) -> None:
        if refusal is not None:
            self._context.close(started, ending_of(refusal), SETTINGS_RESET_FAILED, reason=refusal)
            for batch in batches:
                self._mark(batch.parameters(), SettingCellState(CellState.REFUSED, refusal))
        else:
            self._context.close(started, Ending.ANSWERED, SETTINGS_RESET)
            for batch in batches:
                self._read(batch)
        self._closed()

    def _emit_saved(self) -> None:
        reasons = [
            cell.refusal for each in self._saving if (cell := self.cell(each)).refusal is not None
        ]
        count = len(self._saving)
        settings = " ".join(f"{each.name}.{each.joint}" for each in self._saving)
        self._saving = []
        started, close = self._started, self._context.close
        if not reasons:
            close(started, Ending.DONE, SETTINGS_SAVED, count=count, settings=settings)
        else:
            figures = {"count": len(reasons), "total": count, "reason": reasons[0]}
            close(started, ending_of(reasons[0]), SETTINGS_REFUSED, **figures)

    def _closed(self) -> None:
        self._open -= 1
        self.changed.emit()
        if not self.busy:
            self.finished.emit()

    def _mark(self, parameters: Iterable[Parameter], cell: SettingCellState) -> None:
        for parameter in parameters:
            self._cells[parameter] = cell

    # A part of the controller -----------------------------------------------------------------

    def forget_arm(self) -> None:
        """Forget all states except refused ones, whose reasons must stay readable."""
        self._cells = {
            parameter: cell
            for parameter, cell in self._cells.items()
            if cell.state is CellState.REFUSED
        }
        self.changed.emit()
