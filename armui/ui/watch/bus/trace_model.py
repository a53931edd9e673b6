"""The last frames in order of time, as a table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Final

from PySide6.QtCore import QModelIndex, QObject, Qt

from armui.protocol.frame import FrameFlag
from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_trace import TracedFrame, TraceSnapshot
from armui.ui.watch.bus.cells import Payload, TableCell, Tone
from armui.ui.watch.bus.frame_model import FrameTexts, signals_text
from armui.ui.widgets.table_model import Index, TableModel, ViewColumn, ViewColumns
from armui.ui.words import frames

_ERROR_BIT: Final = 0x20000000
"""SocketCAN's flag of an error frame, as candump writes it."""
_OTHERS: Final = frozenset({Sender.OTHER, Sender.OTHER_ARM})


_Column = ViewColumn[Callable[["TraceModel", TracedFrame], TableCell]]


class TraceColumn(ViewColumns):
    """The columns; the content takes the rest of the width."""

    TIME = _Column(
        "Time",
        lambda model, frame: TableCell(model.clock_text(frame.at_s)),
        sample="00:00:00.000",
    )
    ID = _Column(
        "ID",
        lambda _, frame: TableCell(frames.frame_id(frame.arbitration_id, frame.flags)),
        sample="0x00000000",
    )
    NAME = _Column(
        "Message",
        lambda model, frame: TableCell(model.texts.name(frame.arbitration_id, frame.flags)),
        sample="Control mode, kind of motion, speed",
    )
    SENDER = _Column(
        "Sender",
        lambda model, frame: TableCell(
            model.texts.sender(frame.sender, frame.arbitration_id),
            Tone.NOTE if frame.sender in _OTHERS else Tone.PLAIN,
        ),
        sample="another host",
    )
    DATA = _Column("Data", lambda _, frame: TableCell(payload=Payload(frame.data, frame.changed)))
    SAYS = _Column(
        "Content",
        lambda model, frame: TableCell(
            signals_text(
                model.texts.signals(frame.arbitration_id, frame.flags, frame.data, frame.sender)
            )
        ),
    )


class TraceModel(TableModel):
    """Shows the trace, decoding only visible rows.

    Args:
        texts: Formats frames.
        clock_text: Returns the time of day at a monotonic time, as text.

    Attributes:
        texts, clock_text: As given.
    """

    _table = tuple(TraceColumn)
    _columns = len(TraceColumn)

    def __init__(
        self, texts: FrameTexts, clock_text: Callable[[float], str], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.texts: FrameTexts = texts
        self.clock_text: Callable[[float], str] = clock_text
        self._trace: TraceSnapshot | None = None
        self._read: tuple[int, TracedFrame] | None = None

    def show_trace(self, trace: TraceSnapshot | None) -> None:
        """Show other frames."""
        before, now = self.rowCount(), 0 if trace is None else len(trace)
        if now > before:
            self.beginInsertRows(QModelIndex(), before, now - 1)
            self._take(trace)
            self.endInsertRows()
        elif now < before:
            self.beginRemoveRows(QModelIndex(), now, before - 1)
            self._take(trace)
            self.endRemoveRows()
        else:
            self._take(trace)
        if now:
            self.dataChanged.emit(self.index(0, 0), self.index(now - 1, self._columns - 1))

    def _take(self, trace: TraceSnapshot | None) -> None:
        self._trace, self._read = trace, None

    def lines(self, places: Sequence[int], channel: str, zero_s: float) -> list[str]:
        """Return frames as candump writes them.

        Args:
            places: The rows.
            channel: The name of the bus.
            zero_s: The time of day, in seconds since 1970, at the zero of the frames' clock.
        """
        trace = self._trace
        if trace is None:
            return []
        picked = [trace.frame(place) for place in places]
        return [f"({zero_s + each.at_s:.6f}) {channel} {candump(each)}" for each in picked]

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: N802, B008 - Qt
        """Return the number of frames."""
        return 0 if parent.isValid() or self._trace is None else len(self._trace)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the content of a cell."""
        if not index.isValid() or self._trace is None:
            return None
        return self.cells(index)[index.column()].data(role)

    def cells(self, index: Index) -> list[TableCell]:
        """Return a whole row for painting."""
        frame = self._frame(index.row())
        return [column.read(self, frame) for column in self._table]

    def _frame(self, place: int) -> TracedFrame:
        if self._read is None or self._read[0] != place:
            assert self._trace is not None, "no frame is shown"  # noqa: S101
            self._read = place, self._trace.frame(place)
        return self._read[1]


def candump(frame: TracedFrame) -> str:
    """Return a frame as candump writes it: ID#DATA, #R for a remote frame, or an error's class."""
    arbitration_id, flags = frame.arbitration_id, frame.flags
    if flags & FrameFlag.ERROR:
        return f"{_ERROR_BIT | arbitration_id:08X}#{frame.data.hex().upper()}"
    identifier = frames.frame_id(arbitration_id, flags)[2:]
    data = "R" if flags & FrameFlag.REMOTE else frame.data.hex().upper()
    return f"{identifier}#{data}"
