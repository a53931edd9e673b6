"""Frames by identifier as a tree: a row for each, its signals below it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QAbstractItemModel, QModelIndex, QObject, Qt
from PySide6.QtCore import QCoreApplication as App

from armui.protocol.codec import Codec, InvalidFrame, Message
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.motion_frames import command_id
from armui.telemetry.bus_errors import errors_of
from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_statistics import Cycle, FrameRow
from armui.telemetry.quantities import quantity_key
from armui.ui import format as fmt
from armui.ui.watch.bus.cells import KEY_ROLE, Payload, TableCell, Tone
from armui.ui.widgets.table_model import RIGHT, Index, ViewColumn, ViewColumns
from armui.ui.words import frames
from armui.ui.words.frames import message_name, signal_name, signal_value

if TYPE_CHECKING:
    from armui.protocol.addressing import Addressing
    from armui.protocol.firmware_version import FirmwareVersion
    from armui.protocol.generation import Generation


LIT_S: Final = 1.0
"""The time for which a changed byte is highlighted."""

_OTHERS: Final = frozenset({Sender.OTHER, Sender.OTHER_ARM})
_LEADER: Final = frozenset({0x151, 0x155, 0x156, 0x157, 0x159})
"""The frames of a leader arm (0x470)."""
_NOT_OF_THE_ARM: Final = FrameFlag.EXTENDED | FrameFlag.REMOTE | FrameFlag.ERROR | FrameFlag.FD


@dataclass(frozen=True, slots=True)
class SignalText:
    """One signal of a frame, decoded.

    Attributes:
        name: Its name.
        value: The value with its unit, or its word.
        key: The key of its quantity; ``None`` if it is not kept.
    """

    name: str
    value: str
    key: str | None


class FrameTexts:
    """Formats frames by the arm's protocol.

    Attributes:
        codec: How frames are decoded; ``None`` before the first device. It is a codec of its own,
            not the one of the bus thread.
        interface: python-can's name of the back-end.
        leader: True if the other host is known to be a leader arm (0x470).
    """

    def __init__(self) -> None:
        self.codec: Codec | None = None
        self.interface = ""
        self.leader = False
        self._words: dict[tuple[int, int], str] = {}

    def speak(self, codec: Codec | None) -> bool:
        """Use another codec, and return whether it differs from the one before."""
        known, wanted = _spoken(self.codec), _spoken(codec)
        if known == wanted:
            return False
        self.codec = None if wanted is None else Codec(*wanted)
        self._words.clear()
        return True

    def retranslate(self) -> None:
        """Drop cached texts after a change of language."""
        self._words.clear()

    def message(self, arbitration_id: int, flags: int) -> str | None:
        """Return the name of a frame's message in the DBC files, or ``None``."""
        if flags & _NOT_OF_THE_ARM or self.codec is None:
            return None
        layout = self.codec.layout(arbitration_id)
        return None if layout is None else layout.name

    def name(self, arbitration_id: int, flags: int) -> str:
        """Return the displayed name of a frame: that of its message, or else its kind."""
        message = self.message(arbitration_id, flags)
        if message is not None:
            return message_name(message)
        return frames.frame_kind(arbitration_id, flags, self.codec)

    def words(self, row: FrameRow) -> str:
        """Return all text of a row that can be searched."""
        key = row.arbitration_id, row.flags
        found = self._words.get(key)
        if found is None:
            identifier = frames.frame_id(*key)
            found = f"{identifier} {self.message(*key) or ''} {self.name(*key)}"
            self._words[key] = found
        return found

    def sender(self, sender: Sender, arbitration_id: int) -> str:
        """Return the sender of a frame in words."""
        leads = self.leader and command_id(arbitration_id) in _LEADER
        return frames.frame_sender(sender, leader=leads)

    def signals(
        self, arbitration_id: int, flags: int, data: bytes, sender: Sender
    ) -> list[SignalText]:
        """Return the decoded signals of a frame; none if it can't be decoded."""
        codec = self.codec
        if codec is None or flags & _NOT_OF_THE_ARM:
            return []
        layout = codec.layout(arbitration_id)
        decoded = codec.decode(Frame(arbitration_id, data))
        message = decoded if isinstance(decoded, Message) else decoded.message
        if layout is None or message is None:
            return []
        return [
            SignalText(
                signal_name(name),
                signal_value(signal, message.signals[name]),
                quantity_key(sender, layout.name, name),
            )
            for name, signal in layout.signals.items()
            if name in message.signals
        ]

    def describe(self, frame: Frame) -> str:
        """Return the meaning of a frame to be sent, or why it is malformed."""
        codec, name = self.codec, self.name(frame.arbitration_id, 0)
        decoded = None if codec is None else codec.decode(frame)
        if codec is None or codec.layout(frame.arbitration_id) is None:
            return name
        says = signals_text(self.signals(frame.arbitration_id, 0, frame.data, Sender.OWN))
        if isinstance(decoded, InvalidFrame):
            why = frames.why_invalid(decoded, len(frame.data), codec)
            says = f"{why}   {says}".rstrip()
        return f"{name}: {says}" if says else name

    def trouble(self, row: FrameRow) -> str:
        """Return why frames of a row do not follow the protocol; "" if all of them do."""
        if row.flags & FrameFlag.ERROR:
            return frames.bus_errors(errors_of(row.arbitration_id, row.data, self.interface))
        if row.invalid is None:
            return ""
        if self.codec is None or row.flags or self.codec.layout(row.arbitration_id) is None:
            return frames.frame_kind(row.arbitration_id, row.flags, self.codec)
        return frames.why_invalid(row.invalid, row.invalid_length, self.codec)


def signals_text(signals: Sequence[SignalText]) -> str:
    """Return the signals of a frame in one line."""
    return "   ".join(f"{each.name} {each.value}" for each in signals)


def _spoken(codec: Codec | None) -> tuple[Generation, Addressing, FirmwareVersion | None] | None:
    """Return what decides how a codec decodes frames, for comparison with another codec."""
    return None if codec is None else (codec.generation, codec.addressing, codec.firmware)


class _Node:
    """A row that is shown.

    Attributes:
        row: The counts.
        place: The index among the rows shown.
        details: The number of rows below it.
    """

    __slots__ = ("_read", "_says", "_signals", "details", "place", "row")

    def __init__(self, row: FrameRow) -> None:
        self.row = row
        self.place = 0
        self.details = 0
        self._read: FrameRow | None = None
        self._signals: list[SignalText] = []
        self._says: str | None = None

    def signals(self, texts: FrameTexts) -> list[SignalText]:
        """Return the signals, decoded once for each payload."""
        row = self.row
        if self._read is None or self._read is not row:
            self._signals = texts.signals(row.arbitration_id, row.flags, row.data, row.sender)
            self._read, self._says = row, None
        return self._signals

    def says(self, texts: FrameTexts) -> str:
        """Return the signals in one line; computed only for visible rows."""
        signals = self.signals(texts)
        if self._says is None:
            self._says = signals_text(signals)
        return self._says

    def forget(self) -> None:
        """Drop the cached texts."""
        self._read = None


_Column = ViewColumn[Callable[["FrameModel", FrameRow], str]]


class FrameColumn(ViewColumns):
    """The columns; `cells` fills in bytes and content, and the content takes the rest."""

    ID = _Column(
        "ID",
        lambda _, row: frames.frame_id(row.arbitration_id, row.flags),
        tip="The identifier on the bus, offsets of 0x470 included",
        sample="0x00000000",
    )
    NAME = _Column(
        "Message",
        lambda model, row: model.texts.name(row.arbitration_id, row.flags),
        tip="What the frame is; its signals are below it",
        sample="Driver of J1, slow values",
    )
    SENDER = _Column(
        "Sender",
        lambda model, row: model.texts.sender(row.sender, row.arbitration_id),
        tip="Judged by the identifier: a frame that is neither this program's nor an arm's is "
        "another host's",
        sample="another host",
    )
    DATA = _Column(
        "Data", lambda *_: "", tip="Bytes that have changed within the last second are lit"
    )
    SAYS = _Column("Content", lambda *_: "", tip="What the last frame said, in physical units")
    RATE = _Column(
        "Rate, Hz",
        lambda model, row: model.rate(row),
        tip="Over the last 3 s, and at least 8 cycles",
        sample="Rate, Hz 0",
        figures=True,
    )
    JITTER = _Column(
        "Jitter, ms",
        lambda model, row: model.jitter(row),
        tip="How far the cycles of the last 3 s are from their mean on average / the longest "
        "cycle since the counting began",
        sample="±00.00 / 00.00",
        figures=True,
    )
    COUNT = _Column(
        "Count",
        lambda _, row: fmt.count(row.count),
        tip="Since the counting began",
        sample="00,000,000",
        figures=True,
    )
    LAST = _Column(
        "Last",
        lambda model, row: model.clock_text(row.last_s),
        tip="When the last frame came",
        sample="00:00:00.000",
    )


_COLUMNS: Final = tuple(FrameColumn)


class FrameModel(QAbstractItemModel):
    """The counts for each identifier and sender.

    Args:
        texts: Formats frames.
        clock_text: Returns the time of day at a monotonic time, as text.

    Attributes:
        texts, clock_text: As given.
    """

    def __init__(
        self, texts: FrameTexts, clock_text: Callable[[float], str], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.texts: FrameTexts = texts
        self.clock_text: Callable[[float], str] = clock_text
        self._nodes: list[_Node] = []
        self._by_number: dict[int, _Node] = {}
        self._cycles: dict[int, tuple[FrameRow, Cycle | None]] = {}
        self._now_s = 0.0

    # What is shown ----------------------------------------------------------------------------

    def show_rows(self, rows: Sequence[FrameRow], now_s: float) -> None:
        """Show sorted rows; those shown already stay expanded."""
        self._now_s = now_s
        wanted = {row.number for row in rows}
        for place in range(len(self._nodes) - 1, -1, -1):
            if self._nodes[place].row.number not in wanted:
                self.beginRemoveRows(QModelIndex(), place, place)
                node = self._nodes.pop(place)
                del self._by_number[node.row.number]
                self._number_places(place)
                self.endRemoveRows()
        for place, row in enumerate(rows):
            if place < len(self._nodes) and self._nodes[place].row.number == row.number:
                self._nodes[place].row = row
            else:
                self.beginInsertRows(QModelIndex(), place, place)
                node = _Node(row)
                node.details = self._wanted_details(node)
                self._nodes.insert(place, node)
                self._by_number[row.number] = node
                self._number_places(place)
                self.endInsertRows()
        for node in self._nodes:
            self._fit_details(node)
        if self._nodes:
            last = self.index(len(self._nodes) - 1, len(_COLUMNS) - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    def clear(self) -> None:
        """Clear the rows, because they will be numbered again."""
        self.beginResetModel()
        self._nodes.clear()
        self._by_number.clear()
        self._cycles.clear()
        self.endResetModel()

    def retranslate(self) -> None:
        """Update all texts after a change of language or codec."""
        for node in self._nodes:
            node.forget()
            self._fit_details(node)
        self.headerDataChanged.emit(Qt.Orientation.Horizontal, 0, len(_COLUMNS) - 1)
        self.layoutChanged.emit()

    def _number_places(self, first: int) -> None:
        for place in range(first, len(self._nodes)):
            self._nodes[place].place = place

    def _wanted_details(self, node: _Node) -> int:
        row = node.row
        trouble = self.texts.trouble(row)
        said = trouble == self.texts.name(row.arbitration_id, row.flags)
        return len(node.signals(self.texts)) + bool(trouble and not said)

    def _fit_details(self, node: _Node) -> None:
        """Insert or remove rows below a row, to match its signals and its fault."""
        before, wanted = node.details, self._wanted_details(node)
        if wanted == before:
            return
        parent = self.index(node.place, 0)
        if wanted > before:
            self.beginInsertRows(parent, before, wanted - 1)
            node.details = wanted
            self.endInsertRows()
        else:
            self.beginRemoveRows(parent, wanted, before - 1)
            node.details = wanted
            self.endRemoveRows()

    def row_of(self, index: Index) -> FrameRow:
        """Return the frame of a cell."""
        return self._node(index).row

    def keys_of(self, index: Index) -> list[str]:
        """Return the keys of a row's quantities: of a frame, all of its signals."""
        node = self._node(index)
        if index.internalId():
            key = self._key(index)
            return [key] if key else []
        keys = [signal.key for signal in node.signals(self.texts) if signal.key]
        return list(dict.fromkeys(keys))

    # The model's interface for Qt -------------------------------------------------------------

    def _node(self, index: Index) -> _Node:
        number = index.internalId()
        return self._by_number[number - 1] if number else self._nodes[index.row()]

    def index(self, row: int, column: int, parent: Index = QModelIndex()) -> QModelIndex:  # noqa: B008 - Qt's own default
        """Return the index of a frame, or of one of its signals."""
        if not self.hasIndex(row, column, parent):
            return QModelIndex()
        number = self._nodes[parent.row()].row.number + 1 if parent.isValid() else 0
        return self.createIndex(row, column, number)

    def parent(self, index: Index = QModelIndex()) -> Any:  # noqa: B008
        """Return the frame of a signal."""
        if not index.isValid() or not index.internalId():
            return QModelIndex()
        node = self._by_number.get(index.internalId() - 1)
        return QModelIndex() if node is None else self.createIndex(node.place, 0, 0)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: N802, B008 - Qt
        """Return the number of frames, or of a frame's details."""
        if not parent.isValid():
            return len(self._nodes)
        if parent.internalId() or parent.column():
            return 0
        return self._nodes[parent.row()].details

    def columnCount(self, _parent: Index = QModelIndex()) -> int:  # noqa: N802, B008 - Qt
        """Return the number of columns, the same for every row."""
        return len(_COLUMNS)

    def headerData(  # noqa: N802 - the name Qt calls
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        """Return the title of a column."""
        across = orientation is Qt.Orientation.Horizontal
        return _COLUMNS[section].header(role) if across else None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the content of a cell."""
        if not index.isValid():
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return RIGHT if _COLUMNS[index.column()].declared.figures else None
        if role == KEY_ROLE:
            return self._key(index)
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._tip(index)
        return self.cells(index)[index.column()].data(role)

    def _key(self, index: Index) -> str | None:
        """Return the key of the quantity as which a signal can be drawn, or ``None``."""
        signals = self._node(index).signals(self.texts) if index.internalId() else []
        return signals[index.row()].key if index.row() < len(signals) else None

    def _tip(self, index: Index) -> str:
        if not index.internalId():
            node = self._node(index)
            if index.column() == FrameColumn.SAYS:
                return "\n".join(f"{e.name}: {e.value}" for e in node.signals(self.texts))
            return self.texts.trouble(node.row) or self.texts.words(node.row)
        if index.column() == FrameColumn.ID and self._key(index) is not None:
            return App.translate("BusMonitor", "Show as curve")
        return self.cells(index)[index.column()].text

    def cells(self, index: Index) -> list[TableCell]:
        """Return a whole row for painting."""
        node = self._node(index)
        if index.internalId():
            return self._detail_cells(node, index.row())
        row = node.row
        tones = self._tones(row)
        cells = [
            TableCell(column.read(self, row), tones[column], column.declared.figures)
            for column in _COLUMNS
        ]
        cells[FrameColumn.DATA] = TableCell("", tones[FrameColumn.DATA], payload=self._payload(row))
        cells[FrameColumn.SAYS] = TableCell(node.says(self.texts), tones[FrameColumn.SAYS])
        return cells

    def _payload(self, row: FrameRow) -> Payload:
        since_s = self._now_s - LIT_S
        return Payload(row.data, tuple(each > since_s for each in row.changed_s))

    def _tones(self, row: FrameRow) -> dict[FrameColumn, Tone]:
        """Return the tone of each column of a row."""
        if row.is_silent(self._now_s):
            return dict.fromkeys(_COLUMNS, Tone.MUTED)
        tones = dict.fromkeys(_COLUMNS, Tone.PLAIN)
        if row.invalid_count:
            tones[FrameColumn.ID] = tones[FrameColumn.NAME] = Tone.TROUBLE
        if row.sender in _OTHERS:
            tones[FrameColumn.SENDER] = Tone.NOTE
        return tones

    def _cycle(self, row: FrameRow) -> Cycle | None:
        """Return the cycle time, computed once for each update of a row."""
        known = self._cycles.get(row.number)
        if known is None or known[0] is not row:
            known = self._cycles[row.number] = row, row.cycle()
        return known[1]

    def rate(self, row: FrameRow) -> str:
        """Return how often it comes, in hertz."""
        cycle = self._cycle(row)
        if cycle is None:
            return fmt.NOTHING
        if row.is_silent(self._now_s):
            return App.translate("BusMonitor", "silent")
        return fmt.number(cycle.rate_hz, 1 if cycle.rate_hz < 100 else 0)

    def jitter(self, row: FrameRow) -> str:
        """Return the mean deviation of the cycles, and the longest gap, in milliseconds."""
        cycle = self._cycle(row)
        if cycle is None:
            return fmt.NOTHING
        longest_s = math.nan if row.max_gap_s is None else row.max_gap_s
        return f"±{_ms(cycle.deviation_s)} / {_ms(longest_s)}"

    def _detail_cells(self, node: _Node, place: int) -> list[TableCell]:
        """Return the cells of a row's signal, or below the signals those of its fault."""
        cells = [TableCell()] * len(_COLUMNS)
        signals = node.signals(self.texts)
        if place < len(signals):
            cells[FrameColumn.NAME] = TableCell(signals[place].name)
            cells[FrameColumn.SAYS] = TableCell(signals[place].value)
            return cells
        cells[FrameColumn.NAME] = TableCell(self.texts.trouble(node.row), Tone.TROUBLE)
        if node.row.invalid_count:
            cells[FrameColumn.COUNT] = TableCell(
                str(node.row.invalid_count), Tone.TROUBLE, right=True
            )
            cells[FrameColumn.LAST] = TableCell(self.clock_text(node.row.invalid_s), Tone.TROUBLE)
        return cells


def _ms(seconds: float) -> str:
    ms = 1e3 * seconds
    if not math.isfinite(ms):
        return fmt.NOTHING
    return fmt.number(ms, 2 if ms < 10 else 1 if ms < 100 else 0)
