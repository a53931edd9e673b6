"""The tab of the user frames: by three points or typed, chosen, renamed and deleted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

from armui.arm.state import ArmState
from armui.cell.cell import Cell, with_frame, without_frame
from armui.cell.user_frames import UserFrame
from armui.control.arm_controller import ArmController
from armui.control.cell.cell_control import CellControl
from armui.control.operations.operation import operation_of
from armui.ui.actions.command import Command, Target
from armui.ui.panels.cell.cell_tab import Answered, figures
from armui.ui.panels.cell.frame_by_points import FrameByPoints
from armui.ui.panels.cell.named_tab import NamedTab, Thing
from armui.ui.widgets.buttons import caption, enable_or_explain, push_button
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_CHANGE: Final = operation_of(CellControl.change)


class FramesTab(NamedTab):
    """The user frames of the chosen cell; see :class:`NamedTab`."""

    key = "frames"
    part = "frame"
    title = Text("CellPanel", "Frames")
    commands = (
        Command("cell.frame", Text("FramesTab", "Frame in force")),
        Command("cell.frame_by_points", Text("FramesTab", "Frame by three points")),
        Command("cell.frame_here", Text("FramesTab", "Frame from the present tool pose")),
        Command(
            "cell.frame_apply",
            Text("FramesTab", "Apply the figures of the frame"),
            _CHANGE,
            leads=True,
        ),
        Command("cell.frame_add", Text("FramesTab", "Add as a new frame"), _CHANGE, leads=True),
        Command(
            "cell.frame_delete",
            Text("FramesTab", "Delete the frame"),
            _CHANGE,
            leads=True,
            risky=True,
        ),
    )

    def __init__(self, controller: ArmController, answered: Answered) -> None:
        by_points = FrameByPoints(controller, answered)
        super().__init__(controller, answered, by_points)
        self._by_points = by_points
        self._here = push_button("cell_frame_here")
        self._here.clicked.connect(self._on_here)
        by_points.applied.connect(
            lambda pose, anew: self._take_found(pose, self.tr("Frame {number}"), anew=anew)
        )
        self._of_base = text_label("cell_frame_of_base", rank="muted", wraps=True)
        self._lay_out(below=[self._of_base, self._here])
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {**super().command_targets(), "cell.frame_here": self._here}

    @property
    def _things(self) -> Sequence[Thing]:
        return self._cell.frames

    @property
    def _chosen(self) -> UserFrame | None:
        return self._cell.chosen_frame

    def _choosing(self, name: str) -> Cell:
        return replace(self._cell, frame=name)

    def _put(self, thing: Any, instead_of: str = "") -> Cell:
        return with_frame(self._cell, thing, instead_of=instead_of)

    def _without(self, name: str) -> Cell:
        return without_frame(self._cell, name)

    def _live(self) -> None:
        self._by_points.show_live()

    def typed(self) -> UserFrame:
        """Return the frame as typed; an empty field counts as 0, a text as itself."""
        return UserFrame(self._name.text().strip(), figures(self._fields))

    def _on_here(self) -> None:
        pose = self._controller.cartesian.tool_pose(self._controller.state)
        if pose is not None:
            for field, value in zip(self._fields, pose, strict=True):
                field.show_value(value)
            self._show_news()

    # -- appearance ---------------------------------------------------------------------------

    def show_state(self, state: ArmState) -> None:
        """Show whether the present tool pose can be filled in."""
        super().show_state(state)
        unknown = self._controller.cartesian.tool_pose(state) is None
        why_not = self.tr("The arm has not told its pose.") if unknown else ""
        use = self.tr("Fills in the present tool pose, with the axes of the tool.")
        enable_or_explain(self._here, why_not, use)

    def show_cell(self, why_not: str) -> None:
        """Show the frames of the chosen cell."""
        self._list_things(self.tr("— (base)"), why_not)
        uses = (
            self.tr(
                "Puts these figures in the place of those of the chosen frame. Points of "
                "trajectories that belong to it move with it; their way is checked anew."
            ),
            self.tr("Adds a frame of this name and chooses it."),
            self.tr(
                "Deletes the chosen frame; the base is chosen then. Trajectories with points that "
                "belong to it are not run until they have another frame."
            ),
        )
        self._allow(why_not, self.tr("No frame is chosen. Add one, or choose one above."), uses)
        self._by_points.show_frame(self._chosen, why_not)
        self.show_state(self._controller.state)
        self._show_news()

    def _next_step(self, *, new: bool, changed: bool) -> str:
        if self._controller.cell.cell is None:
            return self.tr("There is no cell yet: type its name above and press New.")
        if self._shown is None and not new:
            return self.tr(
                "Press By three points: the tool's tip shows where the frame is. Or type a name "
                "and the frame's pose in the base, then press Add."
            )
        if new and self._shown is None:
            return self.tr("Press Add: poses are shown and typed in this frame from then on.")
        if new:
            return self.tr("Press Add for a further frame, or Apply to rename the chosen one.")
        if changed:
            return self.tr("Press Apply: the frame moves, and what belongs to it moves with it.")
        return self.tr("Poses are shown and typed in this frame. Choose another one, or the base.")

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = (self.tr("Frame in force"), self.tr("Frame's name"))
        ways = (self.tr("Type it"), self.tr("By three points"))
        self._caption(texts, ways, self.tr("Frame"))
        self._of_base.setText(self.tr("The frame's own pose, in the base (mm, °)"))
        caption(self._here, self.tr("From the present tool pose"))
        self.show_cell("")
