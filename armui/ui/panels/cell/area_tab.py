"""The tab of the work area: planes and boxes, typed or taken from the present tool pose."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QLineEdit, QMenu

from armui.arm.state import ArmState
from armui.cell.cell import Cell
from armui.cell.checks import LONGEST_NAME
from armui.cell.work_area import Area, AreaBox, AreaPlane, Zone, with_zone, without_zone
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.operations.operation import operation_of
from armui.kinematics.axes import AXES
from armui.ui import format as fmt
from armui.ui.actions.command import Command, Target
from armui.ui.panels.cell.cell_tab import Answered, CellTab, figures, pose_grid
from armui.ui.widgets.buttons import (
    caption,
    enable_or_explain,
    give_menu,
    named,
    push_button,
    show_primary,
)
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import empty_grid, in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_CHANGE = operation_of(CellControl.change)
_EDGES: Final = "XYZ"
_NOWHERE: Final = (0.0,) * 6
_NARROW_PX: Final = 56


class AreaTab(CellTab):
    """The work area of the chosen cell; see :class:`CellTab`."""

    key = "area"
    title = Text("CellPanel", "Area")
    commands = (
        Command("cell.area_zone", Text("AreaTab", "Planes and boxes of the work area")),
        Command(
            "cell.area_plane", Text("AreaTab", "Add a plane to the work area"), _CHANGE, leads=True
        ),
        Command(
            "cell.area_box", Text("AreaTab", "Add a box to the work area"), _CHANGE, leads=True
        ),
        Command(
            "cell.area_apply", Text("AreaTab", "Apply the figures of the area"), _CHANGE, leads=True
        ),
        Command("cell.area_switch", Text("AreaTab", "Switch a plane or box"), _CHANGE, leads=True),
        Command(
            "cell.area_delete",
            Text("AreaTab", "Delete a plane or box"),
            _CHANGE,
            leads=True,
            risky=True,
        ),
        Command(
            "cell.area_stops",
            Text("AreaTab", "Stop who else enters the work area"),
            _CHANGE,
            leads=True,
        ),
        Command("cell.area_here", Text("AreaTab", "Take the present tool pose")),
        Command("cell.area_frame", Text("AreaTab", "Take the pose of a user frame")),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._shown: tuple[str, Area] | None = None
        self._chosen = ""
        self._next = text_label("cell_area_next", wraps=True)
        self._nearness = text_label("cell_area_nearness", rank="muted", wraps=True)
        self._choice_label = QLabel()
        self._choice = named("cell_area_box", QComboBox())
        self._choice_label.setBuddy(self._choice)
        self._on = named("cell_area_on", QCheckBox())
        self._name_label = QLabel()
        self._name = named("cell_area_name", QLineEdit())
        self._name.setMaxLength(LONGEST_NAME)
        self._name_label.setBuddy(self._name)
        self._fields = [named(f"cell_area_{axis}", FigureField(fmt.DECIMALS)) for axis in AXES]
        self._size_label = QLabel()
        self._sizes = [named(f"cell_area_size_{edge}", FigureField(1, "mm")) for edge in _EDGES]
        self._margin_label = QLabel()
        self._margin = named("cell_area_margin", FigureField(1, "mm"))
        self._margin_label.setBuddy(self._margin)
        self._stops = named("cell_area_stops", QCheckBox())
        self._here = push_button("cell_area_here")
        self._frame = push_button("cell_area_frame")
        self._frames = QMenu(self._frame)
        give_menu(self._frame, self._frames)
        self._apply = push_button("cell_area_apply")
        self._add_plane = push_button("cell_area_add_plane")
        self._add_box = push_button("cell_area_add_box")
        self._delete = push_button("cell_area_delete")
        self._lay_out()
        self._choice.activated.connect(self._on_chosen)
        self._on.clicked.connect(self._on_switched)
        self._stops.clicked.connect(
            lambda on: self._change(replace(self._area, stops_others=on), self._chosen)
        )
        for field in (self._name, self._margin, *self._fields, *self._sizes):
            field.textEdited.connect(lambda _text: self._show_news())
        self._here.clicked.connect(self._on_here)
        self._frames.triggered.connect(lambda action: self.take_pose(action.data()))
        self._apply.clicked.connect(self._on_apply)
        self._add_plane.clicked.connect(lambda: self._add(self._typed_plane()))
        self._add_box.clicked.connect(lambda: self._add(self._typed_box()))
        self._delete.clicked.connect(self._on_delete)
        self.retranslate_ui()

    def _lay_out(self) -> None:
        grid = empty_grid(gaps=(8, 6), margins=0)
        grid.addWidget(self._choice_label, 0, 0)
        grid.addLayout(in_row((self._choice, 1), self._on, spacing=6), 0, 1)
        grid.addWidget(self._name_label, 1, 0)
        grid.addLayout(in_row((self._name, 1), self._here, self._frame, spacing=6), 1, 1)
        grid.addWidget(self._margin_label, 2, 0)
        grid.addLayout(in_row(self._margin, (self._nearness, 1), spacing=6), 2, 1)
        grid.setColumnStretch(1, 1)
        sizes = in_row(*((field, 1) for field in self._sizes), spacing=6)
        adds = in_row((self._add_plane, 1), (self._add_box, 1), spacing=6)
        changes = in_row((self._apply, 1), (self._delete, 1), spacing=6)
        buttons = (self._add_plane, self._add_box, self._apply, self._delete, self._here)
        for each in (self._choice, self._name, *self._sizes, *buttons):
            each.setMinimumWidth(_NARROW_PX)
        parts = (
            self._next,
            grid,
            pose_grid(self._fields),
            self._size_label,
            sizes,
            adds,
            changes,
            self._stops,
        )
        in_column(*parts, on=self, spacing=8, margins=0)

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            "cell.area_zone": self._choice,
            "cell.area_plane": self._add_plane,
            "cell.area_box": self._add_box,
            "cell.area_apply": self._apply,
            "cell.area_switch": self._on,
            "cell.area_delete": self._delete,
            "cell.area_here": self._here,
            "cell.area_frame": self._frame,
            "cell.area_stops": self._stops,
        }

    # -- actions ------------------------------------------------------------------------------

    @property
    def _area(self) -> Area:
        cell = self._controller.cell.cell
        return Area() if cell is None else cell.area

    @property
    def _zone(self) -> Zone | None:
        return self._area.named(self._chosen)

    def _change(self, area: Area, chosen: str) -> None:
        before, self._chosen = self._chosen, chosen
        cell = self._controller.cell.cell or Cell("")
        if not self._answered(self._controller.cell.change(replace(cell, area=area))):
            self._chosen = before
            self._show_zone(force=False)

    def _on_chosen(self, place: int) -> None:
        self._chosen = self._choice.itemData(place) or ""
        self.show_cell(self._why_not)

    def _on_switched(self, on: bool) -> None:
        zone = self._zone
        if zone is not None:
            self._change(
                with_zone(self._area, replace(zone, on=on), instead_of=zone.name), zone.name
            )

    def _on_here(self) -> None:
        """Fill in the tool's pose; a plane's allowed side is behind the tool."""
        pose = self._controller.cartesian.tool_pose(self._controller.state)
        if pose is not None:
            self.take_pose(pose)

    def typed_zone(self) -> Zone | None:
        """Return the plane or box as typed while the tab is seen and one is chosen or named."""
        named = self._zone is not None or self._name.text().strip()
        nonsense = any(field.is_nonsense() for field in (*self._fields, *self._sizes))
        if not self.isVisible() or not named or nonsense:
            return None
        is_plane = isinstance(self._zone, AreaPlane)
        return self._typed_plane() if is_plane else self._typed_box()

    def take_pose(self, pose: Sequence[float]) -> None:
        """Fill in a pose; it is applied by a press."""
        for field, value in zip(self._fields, pose, strict=True):
            field.show_value(value)
        self._show_news()

    def _on_apply(self) -> None:
        area, zone = replace(self._area, margin_mm=self._typed_margin()), self._zone
        if zone is None:
            self._change(area, "")
            return
        typed = self._typed_like(zone)
        self._change(with_zone(area, typed, instead_of=zone.name), typed.name)

    def _add(self, zone: Zone) -> None:
        area = replace(self._area, margin_mm=self._typed_margin())
        self._change(with_zone(area, zone), zone.name)

    def _on_delete(self) -> None:
        if self._zone is not None:
            self._change(without_zone(self._area, self._chosen), "")

    def _typed_plane(self) -> AreaPlane:
        return AreaPlane(self._name.text().strip(), figures(self._fields))

    def _typed_box(self) -> AreaBox:
        return AreaBox(self._name.text().strip(), figures(self._fields), figures(self._sizes))

    def _typed_like(self, zone: Zone) -> Zone:
        """Return what is typed in the place of a plane or a box."""
        typed = self._typed_plane() if isinstance(zone, AreaPlane) else self._typed_box()
        return replace(typed, on=zone.on)

    def _typed_margin(self) -> float:
        return figures([self._margin])[0]

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the work area of the chosen cell."""
        self._why_not = why_not
        self._choice.clear()
        self._choice.addItem(self.tr("— (a new one)"), "")
        for zone in self._area.zones:
            kind = self.tr("Plane") if isinstance(zone, AreaPlane) else self.tr("Box")
            off = "" if zone.on else self.tr(" (off)")
            self._choice.addItem(f"{kind}: {zone.name}{off}", zone.name)
        if self._zone is None:
            self._chosen = ""
        now = (self._chosen, self._area)
        self._show_zone(force=now != self._shown)
        self._shown = now
        none = "" if self._zone else self.tr("Choose a plane or a box above first.")
        use = self.tr("The arm stays on the side to which the plane's Z axis points.")
        enable_or_explain(self._add_plane, why_not, use)
        use = self.tr("The arm stays out of the box; X to RZ are those of its centre.")
        enable_or_explain(self._add_box, why_not, use)
        use = self.tr("Puts these figures in force, and the margin with them.")
        enable_or_explain(self._apply, why_not, use)
        use = self.tr("Deletes the chosen plane or box.")
        enable_or_explain(self._delete, why_not or none, use)
        enable_or_explain(self._on, why_not or none, self.tr("Off: it counts for nothing."))
        use = self.tr("It is told in any case. A stop holds the arm where it is, powered.")
        enable_or_explain(self._stops, why_not, use)
        frames = () if self._controller.cell.cell is None else self._controller.cell.cell.frames
        self._frames.clear()
        for frame in frames:
            self._frames.addAction(frame.name).setData(frame.pose)
        none = "" if frames else self.tr("The cell has no user frame yet.")
        use = self.tr("Fills in the pose of a user frame; its Z axis is that of the plane.")
        enable_or_explain(self._frame, none, use)
        self._choice.setEnabled(self._controller.cell.cell is not None)
        self._show_news()

    def show_state(self, state: ArmState) -> None:
        """Show how near the arm is."""
        text, seen = "", self._controller.area_guard.look(state)
        if seen:
            text = self.tr("Nearest: “{name}”, {value} mm")
            text = text.format(name=seen[0].zone.name, value=fmt.number(seen[0].gap_mm, 0))
        self._nearness.setText(text)
        pose = self._controller.cartesian.tool_pose(state)
        unknown = "" if pose is not None else self.tr("The arm has not reported its pose yet.")
        use = self.tr("Fills in the present tool pose; a plane's Z axis is that of the tool.")
        enable_or_explain(self._here, unknown, use)

    def _show_zone(self, *, force: bool) -> None:
        """Fill the fields with the chosen one; what is typed stays while it is the same."""
        self._choice.setCurrentIndex(max(0, self._choice.findData(self._chosen)))
        zone = self._zone
        self._on.setChecked(zone is not None and zone.on)
        self._stops.setChecked(self._area.stops_others)
        if not force:
            return
        self._margin.show_value(self._area.margin_mm)
        if zone is not None:
            self._name.setText(zone.name)
            for field, value in zip(self._fields, zone.pose, strict=True):
                field.show_value(value)
        sizes_mm = zone.size_mm if isinstance(zone, AreaBox) else AreaBox("").size_mm
        for field, value in zip(self._sizes, sizes_mm, strict=True):
            field.show_value(value)

    def _show_news(self) -> None:
        """Say what is to be done next, and light its button."""
        for field in (*self._fields, *self._sizes, self._margin):
            field.show_attention(wanted=field.is_nonsense())
        name, zone = self._name.text().strip(), self._zone
        new = bool(name) and self._area.named(name) is None
        for button in (self._add_plane, self._add_box):
            show_primary(button, wanted=button.isEnabled() and new)
        moved = self._typed_margin() != self._area.margin_mm
        changed = moved or (zone is not None and self._typed_like(zone) != zone)
        show_primary(self._apply, wanted=self._apply.isEnabled() and changed and not new)
        self._next.setText(self._next_step(new=new, changed=changed, chosen=zone is not None))

    def _next_step(self, *, new: bool, changed: bool, chosen: bool) -> str:
        if self._controller.cell.cell is None:
            return self.tr("There is no cell yet: type its name above and press New.")
        if new:
            return self.tr("Press Add plane or Add box: it holds for everything from then on.")
        if changed:
            return self.tr("Press Apply to put the new figures in force.")
        if chosen:
            return self.tr("It is in force. Switch it off, or change its figures and press Apply.")
        return self.tr(
            "Type a name and a pose in the base, or take the tool's. A plane keeps the arm on the "
            "side of its Z axis (all 0: above the table); a box keeps it out."
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._choice_label.setText(self.tr("Plane or box"))
        self._choice.setAccessibleName(self.tr("Plane or box"))
        self._name_label.setText(self.tr("Name"))
        self._name.setAccessibleName(self.tr("Name of the plane or box"))
        caption(self._on, self.tr("On"), whose=self.tr("Plane or box"))
        for axis, field in zip(AXES, self._fields, strict=True):
            field.setAccessibleName(self.tr("Area {axis}").format(axis=axis))
        text = self.tr("Stop when a hand or another program enters")
        caption(self._stops, text)
        self.show_state(self._controller.state)
        self._size_label.setText(self.tr("Box, edges"))
        for edge, field in zip(_EDGES, self._sizes, strict=True):
            field.setAccessibleName(self.tr("Edge of the box along {axis}").format(axis=edge))
        self._margin_label.setText(self.tr("Margin"))
        self._margin.setAccessibleName(self.tr("Margin of the work area"))
        caption(self._here, self.tr("From tool"), whose=self.tr("Area"))
        caption(self._frame, self.tr("From frame"), whose=self.tr("Area"))
        caption(self._apply, self.tr("Apply"), whose=self.tr("Area"))
        caption(self._add_plane, self.tr("Add plane"))
        caption(self._add_box, self.tr("Add box"))
        caption(self._delete, self.tr("Delete"), whose=self.tr("Area"))
        self.show_cell("")
