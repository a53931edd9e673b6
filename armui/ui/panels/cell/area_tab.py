"""The tab of the work area: planes and boxes, typed or taken from the present tool pose."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, Final

from PySide6.QtWidgets import QCheckBox, QLabel, QMenu

from armui.arm.state import ArmState
from armui.cell.cell import Cell
from armui.cell.work_area import Area, AreaBox, AreaPlane, Zone, with_zone, without_zone
from armui.control.arm_controller import ArmController
from armui.ui import format as fmt
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command
from armui.ui.panels.cell.cell_tab import NARROW_PX, Answered, change_command, figures
from armui.ui.panels.cell.named_tab import EDGES, CellItem, NamedTab, TabTexts
from armui.ui.widgets.buttons import caption, enable_or_explain, give_menu, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.words.arm import ARM_PARTS
from armui.ui.words.text import Text
from armui.viewport.robot_shape import pose_rows

_IN_FRONT: Final = (450.0, 0.0, 50.0, 0.0, 0.0, 0.0)
"""The place proposed for the first zone: on a table in front of the arm."""


class AreaTab(NamedTab):
    """The work area of the chosen cell; see :class:`NamedTab`."""

    key = "area"
    part = "area"
    listed = "cell_area_zone"
    adds = ("plane", "box")
    title = Text("CellPanel", "Area")
    commands = (
        Command("cell.area_zone", Text("AreaTab", "Planes and boxes of the work area")),
        change_command("cell.area_switch", Text("AreaTab", "Switch a plane or box")),
        change_command(
            "cell.area_stops", Text("AreaTab", "Halt when others move it into the area")
        ),
    )
    changes = NamedTab.changes_of(
        "area",
        plane=Text("AreaTab", "Add a plane to the work area"),
        box=Text("AreaTab", "Add a box to the work area"),
        apply=Text("AreaTab", "Apply the figures of the area"),
        delete=Text("AreaTab", "Delete a plane or box"),
    )
    here = Act(
        "From tool",
        named="cell_area_here",
        tip="Fills in the present tool pose; a plane's Z axis is that of the tool.",
        whose=True,
        key="cell.area_here",
        title=Text("AreaTab", "Take the present tool pose"),
    )
    here.pressed(NamedTab.take_tool_pose)
    here.why_not(NamedTab.why_no_tool_pose)
    of_frame = Act(
        "From frame",
        named="cell_area_frame",
        tip="Fills in the pose of a user frame; its Z axis is that of the plane.",
        whose=True,
        key="cell.area_frame",
        title=Text("AreaTab", "Take the pose of a user frame"),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        super().__init__(controller, answered)
        self._nearness = text_label("cell_area_nearness", rank="muted", wraps=True)
        self._side = text_label("cell_area_side", rank="muted", wraps=True)
        self._on = named("cell_area_switch", QCheckBox())
        self._sizes = [self._figure(f"size_{edge}", 1, "mm") for edge in EDGES]
        self._margin_label = QLabel()
        self._margin = self._figure("margin", 1, "mm")
        self._margin_shown: float | None = None
        self._stops = named("cell_area_stops", QCheckBox())
        self._frames = QMenu(self.of_frame)
        give_menu(self.of_frame, self._frames)
        for button in (self.here, self.of_frame):
            button.setMinimumWidth(NARROW_PX)
        self._lay_out(
            (self._margin_label, [self._margin]),
            beside=([self._on], ()),
            below=[self._side, in_row((self.here, 1), (self.of_frame, 1), spacing=6)],
            last=[self._stops, self._nearness],
        )
        self._on.clicked.connect(self._on_switched)
        self._stops.clicked.connect(
            lambda on: self._change(self._with(replace(self._area, stops_others=on)), self._chosen)
        )
        self._frames.triggered.connect(lambda action: self.take_pose(action.data()))
        self.retranslate_ui()

    # -- actions ------------------------------------------------------------------------------

    @property
    def _area(self) -> Area:
        return self._cell.area

    @property
    def _items(self) -> Sequence[Zone]:
        return self._area.zones

    def _with(self, area: Area) -> Cell:
        return replace(self._cell, area=area)

    def _put(self, item: Any, instead_of: str = "") -> Cell:
        """Return the cell with a zone added or replaced, and with the margin as typed."""
        area = replace(self._area, margin_mm=figures([self._margin])[0])
        return self._with(with_zone(area, item, instead_of=instead_of))

    def _without(self, name: str) -> Cell:
        return self._with(without_zone(self._area, name))

    def _on_switched(self, on: bool) -> None:
        zone = self._item
        if zone is not None:
            switched = with_zone(self._area, replace(zone, on=on), instead_of=zone.name)
            self._change(self._with(switched), zone.name)

    def typed_zone(self) -> Zone | None:
        """Return the plane or box as typed, while the tab is visible and one is chosen or named."""
        named = self._item is not None or self._name.text().strip()
        nonsense = any(field.is_nonsense() for field in (*self._fields, *self._sizes))
        return self.typed() if self.isVisible() and named and not nonsense else None

    def typed(self) -> Zone:
        """Return the zone as typed: a plane if one is chosen, else a box."""
        name, pose, zone = self._name.text().strip(), figures(self._fields), self._item
        on = zone is None or zone.on
        if isinstance(zone, AreaPlane):
            return AreaPlane(name, pose, on)
        return self._box(on)

    def _box(self, on: bool = True) -> AreaBox:
        name, pose = self._name.text().strip(), figures(self._fields)
        return AreaBox(name, pose, figures(self._sizes), on)

    def _on_apply(self) -> None:
        if self._item is not None:
            super()._on_apply()
        else:
            self._change(self._with(replace(self._area, margin_mm=figures([self._margin])[0])), "")

    def _on_add(self, act: str) -> None:
        name, pose = self._name.text().strip(), figures(self._fields)
        zone = self._box() if act == "box" else AreaPlane(name, pose)
        self._change(self._put(zone), name)

    # -- appearance ---------------------------------------------------------------------------

    def show_cell(self, why_not: str) -> None:
        """Show the work area of the chosen cell."""
        if self._margin_shown != self._area.margin_mm:
            self._margin_shown = self._area.margin_mm
            self._margin.show_value(self._margin_shown)
        super().show_cell(why_not)
        zone = self._item
        self._on.setChecked(zone is not None and zone.on)
        self._stops.setChecked(self._area.stops_others)
        none = "" if zone is not None else self._texts().missing
        enable_or_explain(self._on, why_not or none, self.tr("Off: it counts for nothing."))
        use = self.tr("It is told in any case. A halt holds the arm where it is, powered.")
        enable_or_explain(self._stops, why_not, use)
        self._frames.clear()
        for frame in self._cell.frames:
            self._frames.addAction(frame.name).setData(frame.pose)

    def _entry(self, item: CellItem) -> str:
        kind = self.tr("Plane") if isinstance(item, AreaPlane) else self.tr("Box")
        off = "" if item.on else self.tr(" (off)")  # type: ignore[union-attr]  # it is a zone
        return f"{kind}: {item.name}{off}"

    def _fill(self, item: Any) -> None:
        """Fill the fields; for a new one a place in front of the arm is proposed."""
        if item is None:  # not at the zeros of the base class: a box there would enclose the base
            self._name.clear()
            self.take_pose(_IN_FRONT)
        else:
            super()._fill(item)
        sizes_mm = item.size_mm if isinstance(item, AreaBox) else AreaBox("").size_mm
        for field, value in zip(self._sizes, sizes_mm, strict=True):
            field.show_value(value)

    def show_state(self, state: ArmState) -> None:
        """Show what of the arm is how near."""
        text, seen = "", self._controller.area_guard.nearest_entries(state)
        if seen:
            text = self.tr("Nearest: {part}, {value} mm from “{name}”").format(
                part=ARM_PARTS.word(seen[0].part),
                name=seen[0].zone.name,
                value=fmt.number(seen[0].gap_mm, 0),
            )
        self._nearness.setText(text)
        AreaTab.here.show(self)

    @of_frame.why_not
    def _why_no_frame(self) -> str:
        return "" if self._cell.frames else self.tr("The cell has no user frame yet.")

    def _show_news(self) -> None:
        super()._show_news()
        nonsense = any(field.is_nonsense() for field in self._fields)
        self._side.setVisible(not isinstance(self._item, AreaBox) and not nonsense)
        if not nonsense:
            self._side.setText(self._forbidden(figures(self._fields)))

    def _forbidden(self, pose: Sequence[float]) -> str:
        """Return the forbidden side of a plane in words, by the nearest axis of the base."""
        toward = [-row for row in pose_rows(pose)[2::4]]
        most = max(range(len(toward)), key=lambda place: abs(toward[place]))
        axis = f"{'+' if toward[most] > 0 else '−'}{EDGES[most]}"
        names = {"−Z": self.tr("below it"), "+Z": self.tr("above it")}
        side = names.get(axis) or self.tr("beyond it, towards {axis} of the base").format(axis=axis)
        return self.tr("Forbidden side of the plane: {side}").format(side=side)

    def _is_changed(self, typed: CellItem) -> bool:
        return super()._is_changed(typed) or figures([self._margin])[0] != self._area.margin_mm

    def _next_step(self, *, new: bool, changed: bool) -> str:
        if new:
            return self.tr("Press Add plane or Add box: it holds for everything from then on.")
        if self._item is not None and not self._item.on:
            return self.tr("It is off and counts for nothing. Switch it on to put it in force.")
        if changed:
            return self.tr("Press Apply to put the new figures in force.")
        if self._item is not None:
            return self.tr("It is in force. Switch it off, or change its figures and press Apply.")
        return self.tr(
            "Type a name and a pose in the base. A plane keeps the arm on the side of its Z axis, "
            "a box keeps it out."
        )

    def _texts(self) -> TabTexts:
        return TabTexts(
            kind=self.tr("Area"),
            choice=self.tr("Plane or box"),
            name=self.tr("Name"),
            none=self.tr("— (a new one)"),
            missing=self.tr("Choose a plane or a box above first."),
            apply=self.tr("Puts these figures in force, and the margin with them."),
            add=[
                self.tr("The arm stays on the side to which the plane's Z axis points."),
                self.tr("The arm stays out of the box; X to RZ are those of its centre."),
            ],
            delete=self.tr("Deletes the chosen plane or box."),
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        super().retranslate_ui()
        self._name.setAccessibleName(self.tr("Name of the plane or box"))
        caption(self._on, self.tr("On"), whose=self.tr("Plane or box"))
        caption(self._stops, self.tr("Halt when a hand or another program enters"))
        self._size_label.setText(self.tr("Box, edges"))
        self._margin_label.setText(self.tr("Margin"))
        self._margin.setAccessibleName(self.tr("Margin of the work area"))
