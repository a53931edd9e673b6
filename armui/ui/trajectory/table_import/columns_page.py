"""Import of an unknown table: the operator sets the quantity and the unit of each column."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path, PurePath
from typing import Final

from PySide6.QtCore import QCoreApplication, QObject, QThread, Signal
from PySide6.QtWidgets import QLabel, QLineEdit, QWidget

from armui.cell.tools import NO_TOOL
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.protocol.codes import MoveMode
from armui.trajectory import columns
from armui.trajectory.columns import ColumnMapping, ColumnQuantity, TableFile
from armui.trajectory.columns.apply import COLUMNS_MISSING
from armui.trajectory.columns.model import JOINTS, POSE
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.points.program import check_name
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.table_import.columns_table import ColumnsTable
from armui.ui.trajectory.table_import.dialect_bar import DialectBar
from armui.ui.widgets.buttons import drop_down, named, push_button, spin_box
from armui.ui.widgets.flow import in_flow, pair
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.page import Page
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import joined


class TableImport(QThread):
    """Reads one table in a thread: 180,000 rows take seconds, in which the window must respond.

    The thread opens the library itself, as another program would, because it is for one thread.

    Args:
        table: The file.
        mapping: The meaning of the columns.
        name: The name of the result.
        library: The library: its folder, and the sub-folder that new ones go to, are taken over.
        parent: The parent object.

    Attributes:
        name: As given.
        error: The reason of a failure, when it has finished; the library is unchanged then.
        done: True if it was imported; if it was interrupted there is neither this nor an error.
    """

    def __init__(
        self, table: TableFile, mapping: ColumnMapping, name: str, library: Library, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._table = table
        self._mapping = mapping
        self.name = name
        self._folder, self._new_in = library.folder, library.new_in
        self.error: TrajectoryFileError | LibraryError | None = None
        self.done = False
        if (app := QCoreApplication.instance()) is not None:
            app.aboutToQuit.connect(self._end)

    def run(self) -> None:
        """Import the table; the attributes hold the result."""
        table, name = self._table, self.name
        try:
            content = columns.apply(table.text, table.sheet, self._mapping, name)
            if self.isInterruptionRequested():
                return
            library = Library(self._folder)
            library.new_in = self._new_in
            library.save(content)
            self.done = True
        except (TrajectoryFileError, LibraryError) as error:
            self.error = error

    def _end(self) -> None:
        """Cancel the import, because the program ends; saving that has begun is completed."""
        self.requestInterruption()
        self.wait()


_FIELD_PX: Final = 34
_MOVES: Final = (None, MoveMode.MOVE_J, MoveMode.MOVE_P, MoveMode.MOVE_L)
"""The possible results: a recording, or points of a motion."""
_ANSWERS: Final = {
    "rad": "radians",
    "°": "degrees",
    "0.1°": "tenths",
    "mrad": "milliradians",
    "0.001°": "thousandths",
}
"""The units of angles that are asked for, and the names of their buttons."""


class ColumnsPage(Page):
    """Imports a table of figures as a recording or a trajectory.

    Args:
        library: The library; unchanged until the button is pressed.
        table: The file.
        controller: Knows the tool and the user frames that poses may be of.

    Signals:
        imported: The name of the imported content.
    """

    imported = Signal(str)

    def __init__(self, library: Library, table: TableFile, controller: ArmController) -> None:
        super().__init__("columns")
        self._controller = controller
        self._library = library
        self._file = table
        self._table = ColumnsTable(table.sheet)
        self._dialect_bar = DialectBar()
        self._misread = ""
        self._move_chosen = False
        self._work: TableImport | None = None
        self._make_widgets()
        self._lay_out()
        self._dialect_bar.show_table(table)
        self._name.setText(PurePath(table.file_name).stem)
        self._moves.setCurrentIndex(_MOVES.index(self._likely_move()))
        self._connect()
        self._list_origins()
        self.retranslate_ui()
        self._name.setFocus()

    def _make_widgets(self) -> None:
        self._source = text_label("columns_source", rank="muted", wraps=True, plain=True)
        self._moves = drop_down("columns_move")
        self._moves.addItems([""] * len(_MOVES))
        self._speed = named("columns_speed", spin_box(1, 100, " %"))
        self._speed.setValue(columns.SPEED_PERCENT)
        self._of = drop_down("columns_of")
        self._in = drop_down("columns_in")
        self._name = named("columns_name", QLineEdit())
        self._move_label, self._speed_label, self._name_label = (QLabel() for _ in range(3))
        self._of_label = QLabel()
        self._message = named("columns_message", MessageLine(keeps_room=False))
        self._units = {
            unit: push_button(f"columns_{name}", on_enter=False) for unit, name in _ANSWERS.items()
        }
        self.import_button = push_button("columns_import", primary=True, on_enter=True)
        self._cancel = push_button("columns_cancel", on_enter=False)

    def _lay_out(self) -> None:
        pairs = (
            (self._name_label, self._name),
            (self._move_label, self._moves),
            (self._speed_label, self._speed),
            (self._of_label, self._of),
        )
        for label, field in pairs:
            label.setBuddy(field)
            field.setFixedHeight(_FIELD_PX)
        choices = in_flow(*(pair(label, field) for label, field in pairs), self._in, spacing_px=10)
        said = in_row((self._message, 1), *self._units.values())
        fill(self.body, self._source, self._dialect_bar, choices, (self._table, 1), said)
        fill(self.footer, STRETCH, self._cancel, self.import_button)

    def _connect(self) -> None:
        self._table.changed.connect(self._show_usable)
        self._dialect_bar.changed.connect(self._read_anew)
        self._moves.currentIndexChanged.connect(self._show_usable)
        self._moves.activated.connect(self._on_move)
        self._name.textChanged.connect(self._show_usable)
        for unit, button in self._units.items():
            button.clicked.connect(
                lambda _checked=False, unit=unit: self._table.set_unit(self._angles, unit)
            )
        self.import_button.clicked.connect(self._import)
        self._cancel.clicked.connect(self.leave)
        self._controller.cell_changed.connect(self._list_origins)

    # The mapping ------------------------------------------------------------------------------

    @property
    def mapping(self) -> ColumnMapping:
        """The meaning of the columns as set by the operator."""
        move = _MOVES[self._moves.currentIndex()]
        tool, frame = self._of.currentData() or NO_TOOL, self._in.currentData() or ""
        return ColumnMapping(self._table.columns, move, self._speed.value(), tool, frame)

    def _list_origins(self, *_: object) -> None:
        """List tools and frames for poses; those in force are selected, as in other views."""
        if self.busy:
            return
        control = self._controller.cell
        tool, cell = control.holding().tool, control.in_force
        chosen = [tool.pose, "" if cell is None else cell.frame]
        if self._of.count():
            chosen = [self._of.currentData(), self._in.currentData()]
        self._of.clear()
        if any(tool.pose):
            name = self.tr("the tool “{name}”").format(name=tool.name)
            self._of.addItem(name if tool.name else self.tr("the tool"), tool.pose)
        self._of.addItem(self.tr("the flange"), NO_TOOL)
        self._in.clear()
        self._in.addItem(self.tr("in the base frame"), "")
        for frame in () if cell is None else cell.all_frames:
            self._in.addItem(self.tr("in “{name}”").format(name=frame.name), frame.name)
        for box, data in zip((self._of, self._in), chosen, strict=True):
            there = [box.itemData(place) for place in range(box.count())]
            box.setCurrentIndex(there.index(data) if data in there else 0)
        self._show_origins()

    def _show_origins(self) -> None:
        """Show the choice of tool and frame if poses are imported, and there is more than one."""
        poses = self.mapping.move in (MoveMode.MOVE_P, MoveMode.MOVE_L)
        for widget in (self._of_label, self._of, self._in):
            widget.setVisible(poses and self._of.count() + self._in.count() > 2)

    def _likely_move(self) -> MoveMode | None:
        """Return the first result for which the columns suffice, else the one of most columns.

        Joint angles without time become points, poses points of MOVE P.
        """
        fitting = self._fitting()
        if fitting:
            return fitting[0]
        found = {column.quantity for column in self.mapping.columns if column is not None}
        poses = len(found.intersection(POSE)) > len(found.intersection(JOINTS))
        return MoveMode.MOVE_P if poses else None

    def _fitting(self) -> list[MoveMode | None]:
        """Return the possible results for which the present columns suffice."""
        mapping = self.mapping
        return [one for one in _MOVES if not columns.check_mapping(replace(mapping, move=one))]

    @property
    def _angles(self) -> tuple[ColumnQuantity, ...]:
        """The angles among the quantities to be imported."""
        return JOINTS if self.mapping.move in (None, MoveMode.MOVE_J) else POSE[3:]

    def _on_move(self) -> None:
        """Note the operator's choice, so that it is not guessed any more."""
        self._move_chosen = True

    def _read_anew(self) -> None:
        """Read the file again by the chosen dialect; show the reason if that is not possible."""
        bar = self._dialect_bar
        try:
            self._file = self._file.read_anew(bar.encoding, bar.dialect)
        except TrajectoryFileError as error:
            self._misread = words.file_error(error)
        else:
            self._misread = ""
            self._show_file()
        self._show_usable()

    def _show_file(self) -> None:
        """Show the file; the operator's choices stay while the number of columns is the same."""
        sheet, old = self._file.sheet, self._table
        chosen = old.chosen if len(old.columns) == sheet.width else {}
        self._table = ColumnsTable(sheet, chosen)
        self._table.changed.connect(self._show_usable)
        self.body.replaceWidget(old, self._table)
        old.setParent(None)
        old.deleteLater()
        self._dialect_bar.show_table(self._file)
        if not self._move_chosen:
            self._moves.setCurrentIndex(_MOVES.index(self._likely_move()))
        self._source.setText(self._describe())

    def _reason_against(self) -> str:
        """Return why the table cannot be imported with these choices; "" if it can."""
        if self._misread:
            return self._misread
        reason = columns.check_mapping(self.mapping)
        if reason is not None and reason.reason == COLUMNS_MISSING:
            return joined(words.refusal(reason), self._other_way())
        reason = reason or check_name(self._name.text().strip())
        if reason is not None:
            return words.refusal(reason)
        asked, units = self._table.in_doubt(self._angles)
        if not asked:
            return ""
        if units == ("rad", "°"):
            text = self.tr("Columns {columns} may be radians or degrees: choose which.")
        elif units == ("°", "%"):
            text = self._beyond(asked) + self.tr(
                "Columns {columns} may be normalised figures (−100 to 100), or another robot's: "
                "convert those to degrees first. If they are degrees, say so."
            )
        elif units == ("°",):
            text = self._beyond(asked) + self.tr(
                "Columns {columns} may be another robot's, or in another unit: convert those to "
                "degrees first. If they are degrees, say so."
            )
        else:
            text = self.tr("Columns {columns} may be in {units}: choose which.")
        return text.format(columns=fmt.listed(map(str, asked)), units=fmt.listed(units))

    def _beyond(self, numbers: Sequence[int]) -> str:
        """Name the figure that lies farthest beyond its joint's range, if it is in degrees."""
        asked = [(each, self.mapping.columns[each - 1]) for each in numbers]
        by_deg, *figures, number, joint = max(
            (*columns.farthest(column.quantity, self._file.sheet.guesses[number - 1]), number,
             column.quantity)
            for number, column in asked if column
        )  # fmt: skip
        value, low, high = map(fmt.short_angle, figures)
        text = self.tr("Column {number} holds {value}; {joint} turns from {low} to {high}.") + " "
        told = text.format(number=number, joint=joint, value=value, low=low, high=high)
        return told if by_deg > 0.0 else ""

    def _other_way(self) -> str:
        """Return a text on what else the table can become."""
        fitting = [self._moves.itemText(_MOVES.index(move)) for move in self._fitting()]
        if fitting:
            text = self.tr("Or choose “{choice}” under “{becomes}”: the columns suffice for that.")
            return text.format(choice=fitting[0], becomes=self._move_label.text())
        text = self.tr("What is needed depends on “{becomes}”.")
        return text.format(becomes=self._move_label.text())

    def _mixed_units(self) -> str:
        """Say that angles of one kind are in different units; it may be meant."""
        angles = [each for each in self.mapping.columns if each and each.quantity in self._angles]
        if len({each.unit for each in angles}) < 2:
            return ""
        text = self.tr("The angles are in different units: {columns}. Check that this is meant.")
        return text.format(columns=fmt.listed(f"{each.quantity} {each.unit}" for each in angles))

    def _show_usable(self) -> None:
        """Show what is wrong with the choices, in the place of any older message."""
        text = self._reason_against()
        self._message.show_message(text or self._mixed_units(), Level.WARNING)
        asks = bool(text) and not columns.check_mapping(self.mapping)
        units = self._table.in_doubt(self._angles)[1] if asks else ()
        for unit, button in self._units.items():
            button.setVisible(unit in units)
        self.import_button.setEnabled(not text)
        self.import_button.setToolTip(text)
        for widget in (self._speed_label, self._speed):
            widget.setEnabled(self.mapping.move is not None)
        self._show_origins()

    # Import -----------------------------------------------------------------------------------

    @property
    def busy(self) -> bool:
        """True if the table is being imported."""
        return self._work is not None

    def _import(self) -> None:
        name = self._name.text().strip()
        self._work = TableImport(self._file, self.mapping, name, self._library, self)
        self._work.finished.connect(self._on_finished)
        self._let_choose(False)
        text = self.tr("Importing {count} rows…").format(count=fmt.count(self._file.sheet.count))
        self._message.show_message(text)
        self._work.start()

    def _on_finished(self) -> None:
        work, self._work = self._work, None
        if work is None:
            return
        work.wait()  # the signal comes a moment before the thread has ended
        work.deleteLater()
        self._let_choose(True)
        if work.error is not None:
            self._refuse(work.error)
        else:
            if work.done:
                self.imported.emit(work.name)
            super().leave()

    def _refuse(self, error: TrajectoryFileError | LibraryError) -> None:
        if isinstance(error, LibraryError):
            reason = words.refusal(error.refusal)
        else:
            reason = words.file_error(error)
        said = self.tr("Not imported. {reason}").format(reason=reason)
        self._message.show_message(said, Level.FAULT)

    def _let_choose(self, can: bool) -> None:
        """Disable all choices during an import; the emergency stop always works."""
        fields = (self._name, self._moves, self._of, self._in, self.import_button)
        for widget in (self._dialect_bar, self._table, *fields):
            widget.setEnabled(can)
        self._speed.setEnabled(can and self.mapping.move is not None)

    def take_focus(self) -> None:
        """Focus the name."""
        self._name.setFocus()

    def leave(self) -> None:
        """Close the page; a running import is cancelled first, without a partial result."""
        if self._work is None:
            super().leave()
        else:
            self._work.requestInterruption()
            self._message.show_message(self.tr("Cancelling the import…"))

    # Texts ------------------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Import by columns"))
        self._source.setText(self._describe())
        self._name_label.setText(self.tr("Name"))
        self._move_label.setText(self.tr("Import as"))
        texts = (self.tr("Recording"), *(f"MOVE {move}" for move in "JPL"))
        for place, text in enumerate(texts):
            points = self.tr("Points, {move}").format(move=text)
            self._moves.setItemText(place, points if _MOVES[place] is not None else text)
        self._of_label.setText(self.tr("Poses of"))
        self._in.setAccessibleName(self.tr("Frame of the poses"))
        self._list_origins()
        self._speed_label.setText(self.tr("Speed"))
        self._speed.setToolTip(self.tr("For points whose speed is in no column"))
        self.import_button.setText(self.tr("Import"))
        self._cancel.setText(self.tr("Cancel"))
        for unit, button in self._units.items():
            button.setText({"rad": self.tr("Radians"), "°": self.tr("Degrees")}.get(unit, unit))
        self._show_usable()

    def _describe(self) -> str:
        """Return how large the table is, and how much of it is shown."""
        sheet = self._file.sheet
        text = self.tr("{file}: {count} columns, {rows} rows; the first rows are shown")
        text = text.format(
            file=self._file.file_name, count=sheet.width, rows=fmt.count(sheet.count)
        )
        hidden = self._table.hidden_count
        if hidden:
            more = self.tr("; {count} further columns are left out").format(count=fmt.count(hidden))
            text += more
        return text


class ColumnsOffer(HasActs, QObject):
    """A button, while there are files, that opens the page for one after the other.

    Args:
        work: Reads the files; its library receives the imported content.
        controller: Knows what poses may be of.
        owner: The page that holds it.

    Signals:
        page_made: A :class:`ColumnsPage`, before it wants to be shown.
        imported: The name of the imported content.
        refused: The reason why a file cannot be opened any more, as a text.
    """

    page_made = Signal(object)
    imported = Signal(str)
    refused = Signal(str)
    button = Act("Import by columns…", named="library_by_columns", key="library.by_columns")

    def __init__(self, work: LibraryWork, controller: ArmController, owner: QWidget) -> None:
        super().__init__(owner)
        self._work = work
        self._controller = controller
        self._opening = self._goes_on = False
        self._paths: list[Path] = []
        self._page: ColumnsPage | None = None

    @property
    def paths(self) -> Sequence[Path]:
        """The files offered, the next one first."""
        return tuple(self._paths)

    def show_for(self, paths: Sequence[Path]) -> None:
        """Offer exactly these files."""
        self._paths = list(paths)
        self.show_acts()

    @button.pressed
    def lead(self) -> None:
        """Open the page for the next file; after its import, for the one after it."""
        if self._page is not None:
            self._page.open()
            return
        if self._opening:
            return
        path = self._paths[0]
        self._opening = True
        self._work.do(lambda: columns.open_table(path), partial(self._show, path), self._on_refused)

    def _on_refused(self, text: str) -> None:
        self._opening = False
        left = self._paths[1:]
        self.refused.emit(text)
        self.show_for(left)

    def _show(self, path: Path, table: columns.TableFile) -> None:
        self._opening = False
        page = self._page = ColumnsPage(self._work.library, table, self._controller)
        page.imported.connect(partial(self._on_imported, path))
        page.closed.connect(self._on_closed)
        self.page_made.emit(page)
        page.open()

    def _on_imported(self, path: Path, name: str) -> None:
        self._paths = [other for other in self._paths if other != path]
        self._goes_on = True
        self.imported.emit(name)

    def _on_closed(self) -> None:
        if self._page is not None:
            self._page.deleteLater()
            self._page = None
        goes_on, self._goes_on = self._goes_on and bool(self._paths), False
        if goes_on:
            self.lead()

    @button.there
    def _has_files(self) -> bool:
        return bool(self._paths)

    @button.tip
    def _tip(self) -> str:
        return "\n".join(path.name for path in self._paths)
